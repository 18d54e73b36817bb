// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/font.hpp"

// Defined in font.S.in, which takes the font file in at build time.
extern "C" {
extern const unsigned char quadcut_label_font[];
extern const unsigned int quadcut_label_font_size;
}

namespace quadcut::io {

std::span<const unsigned char> label_font() {
    return {quadcut_label_font, quadcut_label_font_size};
}

}  // namespace quadcut::io
