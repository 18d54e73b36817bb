// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <vector>

#include "io/file_batch.hpp"
#include "io/run_info.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// What files say of a run: program, options, threads; without its input. `options` is read when
/// the files are written.
[[nodiscard]] io::RunInfo run_info_of(SegmentOptions& options, const RunOptions& run);

/// The files that come of following a robot.
[[nodiscard]] std::vector<std::string> followed_files();

/// The rooms as they are now, with a report of them and of why there are none; `warnings` go
/// before.
[[nodiscard]] Segmentation followed_rooms(const Follower& follower, const SegmentOptions& options,
                                          std::vector<std::string> warnings);

/// Adds them: the map, its rooms, and the lines of updates.jsonl. Errors as io::add_results().
void add_followed(io::FileBatch& output, const GridMap& map, const Segmentation& rooms,
                  const std::string& updates, const io::RunInfo& info);

}  // namespace quadcut
