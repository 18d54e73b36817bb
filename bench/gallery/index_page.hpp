// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/gallery/comparison.hpp"

namespace quadcut::gallery {

/// A picture of the gallery, and what is said of it.
struct Entry {
    std::string name;
    /// Relative to the page.
    std::string image;
    /// "" or what sort of input it is.
    std::string note;
    std::size_t num_rooms = 0;
    std::size_t num_doors = 0;
    /// Only where there is a truth.
    std::optional<Comparison> comparison;
};

/// A heading with its pictures.
struct Section {
    std::string title;
    std::vector<Entry> entries;
};

/// "PQ 93.9", and more of the kind, as they stand beside a picture.
[[nodiscard]] std::string figures_text(const Comparison& comparison);

/// A static page that needs nothing but the pictures: of each section a table of figures, then the
/// pictures, by PQ ascending; those without a truth keep their order.
[[nodiscard]] std::string index_page(std::vector<Section> sections);

}  // namespace quadcut::gallery
