// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "bench/reproduce/report.hpp"
#include "bench/reproduce/world.hpp"

namespace quadcut::reproduce {

struct Options {
    /// The folder with logs/ and rooms/; without it all worlds are simulated.
    std::optional<std::filesystem::path> data;
    std::size_t num_threads = 2;
    std::uint64_t seed = 1;
    Size size = Size::full;
    /// As it was given; stands in the report.
    std::string command;
};

/// Told what begins, and how many of how many parts are done.
using OnPart =
    std::function<void(std::string_view part, std::size_t num_done, std::size_t num_parts)>;

/// The paper's experiments, measured. Minutes for full worlds, seconds for small ones.
/// Throws InputError when a file of the data is missing or cannot be read.
[[nodiscard]] Report measure(const Options& options, const OnPart& on_part = {});

/// Writes index.html, reproduce.json and the pictures into `folder`, which is made if need be. All
/// are prepared under other names and put in place together, the page last. Throws InputError that
/// names what cannot be written.
void write(const Report& report, const std::filesystem::path& folder);

}  // namespace quadcut::reproduce
