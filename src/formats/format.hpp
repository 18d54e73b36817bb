// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/result.hpp"

namespace quadcut::formats {

/// What of a result a format tells. Not every result has all: the map only where it was made of
/// scans, updates only where a robot was followed; a report is of the run that cut it. Poses are
/// written when they are asked for, of a result that has zones.
enum class Part : std::uint8_t { rooms, report, map, updates, poses };

/// The bytes of files, of one at first.
[[nodiscard]] inline std::vector<std::string> contents(std::string bytes) {
    std::vector<std::string> all;
    all.push_back(std::move(bytes));
    return all;
}

/// One way to write a result. Each has a file of its own in this folder, and a line in
/// registry.cpp: all commands that write results walk the registry.
struct Format {
    std::string_view name;  ///< for `export --as`
    std::string_view text;  ///< one line for people
    Part part = Part::rooms;
    std::vector<std::string> files;
    /// The bytes of its files, in their order; the same on any number of threads, times aside.
    std::vector<std::string> (*write)(const Result& result) = nullptr;
};

}  // namespace quadcut::formats
