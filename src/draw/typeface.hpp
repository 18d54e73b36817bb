// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "quadcut/base/geometry.hpp"

namespace quadcut::draw {

/// The letters of the label font as lengths and lines. The size is that of the font (about 1.4
/// times the height of a capital); lengths are in the same unit as the size.
class Typeface {
public:
    Typeface();
    Typeface(Typeface&&) noexcept;
    Typeface& operator=(Typeface&&) noexcept;
    ~Typeface();

    /// How far a line of text (UTF-8) reaches.
    [[nodiscard]] double width(std::string_view text, double size) const;
    /// The same in two steps, for one text in several sizes: its length in the font's own units.
    [[nodiscard]] int length_units(std::string_view text) const;
    [[nodiscard]] double width(int length_units, double size) const;
    /// The height of capitals and digits.
    [[nodiscard]] double cap_height(double size) const;
    /// The letters' outlines, curves as short straight pieces. The text begins at (0, 0) on its
    /// base line; x to the right, y DOWN.
    [[nodiscard]] std::vector<std::vector<Point>> outlines(std::string_view text,
                                                           double size) const;

private:
    struct Font;
    std::unique_ptr<Font> font_;
};

}  // namespace quadcut::draw
