// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/map_yaml.hpp"
#include "io/palette.hpp"
#include "quadcut/base/option_field.hpp"
#include "quadcut/follow/track.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/segment/result.hpp"
#include "quadcut/zones/independence.hpp"

namespace quadcut::io {

/// What a report says beside the result itself.
struct RunInfo {
    /// Of the program.
    std::string version;
    /// The file that was read, as the user named it, and the hash of its bytes.
    std::string input;
    std::uint64_t input_hash = 0;
    /// The options used; what they are bound to is read when the report is written.
    std::vector<OptionField> options;
    /// Keys of the map that was read, for the files that carry them on.
    MapKeys map_keys;
    /// When ids were taken from an earlier result: what became of its rooms, and their colours.
    std::optional<std::vector<RoomEvent>> events;
    std::map<RoomId, Rgb> previous_colors;
    /// When an earlier result is written again: its regions of other granularities
    /// (StoredResult::regions).
    std::vector<std::string> regions;
    /// Where the scans were taken, in order, for the files that tell it.
    std::vector<Pose> poses;
    /// How independent the zones and the rooms are, where there are zones and scans.
    std::optional<IndependenceReport> independence;
    /// Threads that prepare the files; the bytes do not depend on it.
    int num_threads = 1;
};

/// A hash as report.json has it: JSON numbers are too coarse for 64 bits.
[[nodiscard]] std::string hash_text(std::uint64_t hash);

}  // namespace quadcut::io
