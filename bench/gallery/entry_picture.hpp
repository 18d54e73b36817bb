// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string>

#include "bench/gallery/exhibit.hpp"
#include "bench/gallery/index_page.hpp"
#include "draw/canvas.hpp"

namespace quadcut::gallery {

/// Writes the picture of a comparison with its caption to `output / image`.
[[nodiscard]] Entry write_pair(const Exhibit& exhibit, const std::string& note,
                               const std::filesystem::path& output, const std::string& image);

/// The same with a third picture of what is wrong: beside the two, or, of long buildings, below
/// them. The entry's note has the cuts that are wrong.
[[nodiscard]] Entry write_with_faults(const Exhibit& exhibit, const std::filesystem::path& output,
                                      const std::string& image);

/// Writes the floor plan of a result that nothing is known to compare with.
[[nodiscard]] Entry write_alone(const std::string& name, const std::string& note,
                                const GridMap& map, const Segmentation& rooms,
                                const std::filesystem::path& output, const std::string& image);

/// Writes a PNG, and makes its folder if need be.
void write_canvas(const draw::Canvas& canvas, const std::filesystem::path& path);

}  // namespace quadcut::gallery
