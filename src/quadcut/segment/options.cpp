// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/options.hpp"

#include "quadcut/base/option_field.hpp"

namespace quadcut {

void add_fields(SegmentOptions& options, std::vector<OptionField>& fields) {
    fields.push_back({"preset", "", 0, 0,
                      "rooms: as people see them; paper: the method as published", "",
                      choice(options.preset, {"rooms", "paper"})});
    add_fields(options.rooms, fields);
    add_fields(options.paper, fields);
    fields.push_back({"seed", "", 0, 1e15, "seed of the clusterings' starts", "", &options.seed});
}

}  // namespace quadcut
