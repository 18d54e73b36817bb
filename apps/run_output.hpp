// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/file_batch.hpp"
#include "io/run_info.hpp"
#include "project/snapshot.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/follow/options.hpp"
#include "quadcut/segment/result.hpp"

namespace quadcut {

/// What files say of a run: program, options, threads; without its input. Of the options of scans
/// and following they name what is not as by default. `options` is read when they are written.
[[nodiscard]] io::RunInfo run_info_of(FollowOptions& options, const RunOptions& run);

/// The files that come of following a robot.
[[nodiscard]] std::vector<std::string> followed_files();

/// The rooms as they are now, with a report of them and of why there are none; `warnings` go
/// before.
[[nodiscard]] Segmentation followed_rooms(const Snapshot& building, const SegmentOptions& options,
                                          std::vector<std::string> warnings);

/// "12 rooms"
[[nodiscard]] std::string num_rooms_text(std::size_t num_rooms);

/// Adds them: the map, its rooms, and the lines of updates.jsonl. Errors as io::add_results().
void add_followed(io::FileBatch& output, const Snapshot& building, const Segmentation& rooms,
                  const io::RunInfo& info);

}  // namespace quadcut
