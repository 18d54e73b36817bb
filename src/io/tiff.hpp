// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>

#include "io/image.hpp"

namespace quadcut::io {

/// Whether the bytes begin like a TIFF, also one of more than 4 GiB (BigTIFF).
[[nodiscard]] bool is_tiff(std::string_view bytes);

/// Decodes the first page of a TIFF as parse_image() says: grey (black or white is 0), palette or
/// RGB, with or without alpha, of 1, 2, 4, 8 or 16 bits, in strips or tiles, in any compression
/// that libtiff reads; 1, 2 and 4 bits are expanded to 8. Throws InputError that names what is not
/// read: floating point, CMYK, colours in planes.
ParsedImage parse_tiff(std::string_view bytes, const std::string& name, const ImageRowSink& sink);

}  // namespace quadcut::io
