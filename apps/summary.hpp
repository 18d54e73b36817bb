// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <vector>

#include "apps/run_flags.hpp"
#include "quadcut/segment/segmentation.hpp"

namespace quadcut {

/// Prints what a segmentation found, how long the run took and where the files are.
void print_summary(const Segmentation& rooms, double elapsed_ms, const std::string& folder,
                   const std::vector<std::string>& files, SummaryStyle style);

}  // namespace quadcut
