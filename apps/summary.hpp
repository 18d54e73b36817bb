// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/run_flags.hpp"
#include "quadcut/segment/segmentation.hpp"
#include "quadcut/segment/track.hpp"

namespace quadcut {

/// Prints what a segmentation found, what became of the rooms of an earlier one if there was one,
/// how long the run took and where the files are.
void print_summary(const Segmentation& rooms, const std::optional<std::vector<RoomEvent>>& events,
                   double elapsed_ms, const std::string& folder,
                   const std::vector<std::string>& files, SummaryStyle style);

}  // namespace quadcut
