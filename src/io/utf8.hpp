// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>
#include <string_view>

namespace quadcut::io {

/// Stands for bytes that are no text.
inline constexpr char32_t kReplacementCharacter = 0xFFFD;

/// The code points of a text. Bytes that are not well-formed UTF-8 (also: surrogates, overlong
/// forms, beyond U+10FFFF) become kReplacementCharacter, one for each byte.
[[nodiscard]] std::u32string decode_utf8(std::string_view bytes);

/// Appends one code point. @pre it is one that decode_utf8 returns.
void append_utf8(std::string& text, char32_t code_point);

}  // namespace quadcut::io
