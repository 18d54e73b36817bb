// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>

#include "io/image.hpp"

namespace quadcut::io {

/// Whether the bytes begin like a BMP or a GIF.
[[nodiscard]] bool is_picture(std::string_view bytes);

/// Decodes them as parse_image() says: colours of 8 bits, of a GIF the first picture. The whole
/// image is held.
ParsedImage parse_picture(std::string_view bytes, const std::string& name,
                          const ImageRowSink& sink);

}  // namespace quadcut::io
