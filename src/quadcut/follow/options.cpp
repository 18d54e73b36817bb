// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/options.hpp"

#include "quadcut/base/option_field.hpp"

namespace quadcut {

void add_fields(FollowOptions& options, std::vector<OptionField>& fields) {
    add_fields(options.segment, fields);
    add_fields(options.zones, fields);
    add_fields(options.integrate, fields);
    fields.push_back({"resolution", "m", 0.001, 10.0, "side of a cell", "", &options.resolution_m});
    fields.push_back({"follow.min_change", "m^2", 0.0, 1e6,
                      "rooms are cut again when so much free space has changed", "",
                      &options.min_change_m2});
    fields.push_back({"follow.max_wait", "m^2 scans", 0.0, 1e9,
                      "less is cut when it has waited long: what has changed times the scans since "
                      "the last cut",
                      "", &options.max_wait_m2_scans});
    fields.push_back({"follow.first_cut", "m^2", 0.0, 1e6,
                      "the first cut waits for so much free space", "", &options.first_cut_m2});
    fields.push_back({"follow.min_patch", "m^2", 0.0, 1e6,
                      "what has changed by less stays as it is until the end", "",
                      &options.min_patch_m2});
}

FollowOptions with_preset(FollowOptions options) {
    if (options.segment.preset == Preset::paper) {
        options.integrate = latest_scan_wins(options.integrate);
    }
    return options;
}

}  // namespace quadcut
