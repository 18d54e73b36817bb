// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/options.hpp"

#include "quadcut/base/option_field.hpp"

namespace quadcut {

bool drops_uncrossed(const SegmentOptions& options) {
    if (options.uncrossed == Uncrossed::by_preset) return options.preset == Preset::paper;
    return options.uncrossed == Uncrossed::dropped;
}

void add_fields(SegmentOptions& options, std::vector<OptionField>& fields) {
    fields.push_back({"preset", "", 0, 0,
                      "rooms: as people see them; paper: the method as published", "",
                      choice(options.preset, {"rooms", "paper"})});
    fields.push_back({"uncrossed", "", 0, 0,
                      "rooms that the robot's way does not cross, when it is known: dropped are no "
                      "part of the map; by_preset: the paper drops them",
                      "", choice(options.uncrossed, {"by_preset", "kept", "dropped"})});
    add_fields(options.rooms, fields);
    add_fields(options.paper, fields);
    fields.push_back({"seed", "", 0, 1e15, "seed of the clusterings' starts", "", &options.seed});
}

}  // namespace quadcut
