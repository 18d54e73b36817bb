// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>

#include "quadcut/map/raster.hpp"

namespace quadcut::test {

/// A label image, row 0 the lowest.
using Labels = Raster<std::uint16_t>;

/// Reads a grey image as it is, by our own decoder.
Labels read_labels(const std::filesystem::path& path);

/// For each label but 0, in how many parts it falls (4 neighbours).
std::map<std::uint16_t, int> num_parts_by_label(const Labels& labels);

}  // namespace quadcut::test
