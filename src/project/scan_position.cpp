// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/scan_position.hpp"

namespace quadcut {

std::vector<std::string> warnings_of(const ScanPosition& position) {
    if (position.num_left_out == 0) return {};
    return {"scans left out: " + std::to_string(position.num_left_out) +
            "; the first: " + position.first_left_out};
}

}  // namespace quadcut
