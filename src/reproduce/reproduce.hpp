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
#include <vector>

#include "io/file_batch.hpp"
#include "reproduce/report.hpp"
#include "reproduce/world.hpp"

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

/// The files of each report; its pictures have names of their own.
[[nodiscard]] std::vector<std::string> main_files();
/// Adds them and the pictures, the page last. Errors as FileBatch::add().
void add_files(io::FileBatch& files, const Report& report);

}  // namespace quadcut::reproduce
