// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/options.hpp"

#include "quadcut/base/option_field.hpp"
#include "quadcut/map/room.hpp"

namespace quadcut {

void add_fields(ZoneOptions& options, std::vector<OptionField>& fields) {
    fields.push_back(
        {"zones", "", 1, kMaxRoomId,
         "parts of the building, sets of rooms: how many, or auto, by the largest eigengap",
         "G_submap", CountOrWord{&options.count, {{"none", kNoZones}, {"auto", 0}}}});
    fields.push_back(
        {"zones.weights", "", 0, 0,
         "what joins two rooms: the conductance of their doors, or scans that see both", "G_submap",
         choice(options.weights, {"conductance", "covisibility"})});
}

}  // namespace quadcut
