// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>

#include "io/image.hpp"

namespace quadcut::io {

/// Whether the bytes begin like a JPEG.
[[nodiscard]] bool is_jpeg(std::string_view bytes);

/// Decodes a JPEG of grey or of colours as parse_image() says. One that ends early or whose codes
/// are damaged is refused, though the library would fill in grey.
ParsedImage parse_jpeg(std::string_view bytes, const std::string& name, const ImageRowSink& sink);

}  // namespace quadcut::io
