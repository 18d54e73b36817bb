// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/font.hpp"

// Defined in font.S.in, which takes the font file in at build time.
extern "C" {
extern const unsigned char kQuadcutLabelFont[];
extern const unsigned int kQuadcutLabelFontSize;
}

namespace quadcut::draw {

std::span<const unsigned char> label_font() { return {kQuadcutLabelFont, kQuadcutLabelFontSize}; }

}  // namespace quadcut::draw
