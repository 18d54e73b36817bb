// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/format.hpp"
#include "io/file_batch.hpp"

namespace quadcut::formats {

/// All that there are, first what people look at.
[[nodiscard]] std::span<const Format> all_formats();

using Formats = std::vector<Format>;

/// Those that tell one of the parts.
[[nodiscard]] Formats formats_of(std::initializer_list<Part> parts);

/// Those of the names, "svg,geojson". Throws InputError for any other name; it says which there
/// are.
[[nodiscard]] Formats find_formats(std::string_view names);

[[nodiscard]] std::vector<std::string> files_of(const Formats& formats);

/// Makes all their files, as many at a time as the result has threads, and adds them to a batch.
/// Errors as FileBatch::add().
void add_files(io::FileBatch& batch, const Formats& formats, const Result& result);

/// A batch of the files of a segmentation, its rooms and report, and nothing else, into a folder
/// that is made if need be.
void write_results(const std::filesystem::path& folder, const GridMap& map,
                   const Segmentation& segmentation, const io::RunInfo& info);

}  // namespace quadcut::formats
