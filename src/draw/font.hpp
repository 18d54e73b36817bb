// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>

namespace quadcut::draw {

/// The TrueType font of the labels in pictures (DejaVu Sans): the bytes of the whole font file,
/// part of the program itself, so no file is read and nothing can fail. Cost: none.
[[nodiscard]] std::span<const unsigned char> label_font();

}  // namespace quadcut::draw
