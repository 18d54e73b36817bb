// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/gallery/exhibit.hpp"
#include "bench/gallery/pair_picture.hpp"

namespace quadcut::gallery {

/// Several comparisons on one page, two a row, each with a line of text above it.
class Montage {
public:
    void add(const Exhibit& exhibit, const std::string& note);
    void write(const std::filesystem::path& path) const;

private:
    struct Item {
        PairPicture picture;
        std::string title;
        std::string figure;
    };
    std::vector<Item> items_;
};

/// Writes before.png, the map as map_server draws it, and after.png, its floor plan, as parts of
/// the same size.
void write_before_and_after(const Side& side, const std::filesystem::path& folder);

}  // namespace quadcut::gallery
