// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/options.hpp"

#include "quadcut/base/option_field.hpp"

namespace quadcut {

void add_fields(RoomsOptions& options, std::vector<OptionField>& fields) {
    fields.push_back({"granularity", "", 0.0, 1.0,
                      "how readily a narrowing becomes a cut: 0 few large rooms, 1 many small ones",
                      "", &options.granularity});
    fields.push_back({"door_width", "m", 0.3, 100.0,
                      "the widest opening that can separate two rooms", "", &options.door_width_m});
    fields.push_back({"rooms.min_component", "m^2", 0.0, 1e6,
                      "connected free space smaller than this is left out", "",
                      &options.min_component_m2});
    fields.push_back({"rooms.max_furniture", "m^2", 0.0, 100.0,
                      "isolated obstacles below this size do not count when widths are measured",
                      "", &options.max_furniture_m2});
    fields.push_back({"rooms.pieces", "", 0, 0,
                      "what is fused into rooms: basins of the clearance, or what the spectral cut "
                      "of their graph makes of them",
                      "eq. (5)", choice(options.pieces, {"basins", "spectral"})});
    fields.push_back({"rooms.min_room", "m^2", 0.0, 1e6,
                      "smaller regions join the neighbour with the widest opening", "",
                      &options.min_room_m2});
    fields.push_back({"rooms.min_passable", "m", 0.0, 100.0,
                      "free space that is nowhere as wide as this is no room", "",
                      &options.min_passable_m});
}

}  // namespace quadcut
