// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/markup.hpp"

#include "io/utf8.hpp"

namespace quadcut::io {

std::string escaped(std::string_view text) {
    std::string result;
    for (const char32_t code_point : decode_utf8(text)) {
        if (code_point == U'&') {
            result += "&amp;";
        } else if (code_point == U'<') {
            result += "&lt;";
        } else if (code_point == U'>') {
            result += "&gt;";
        } else if (code_point == U'"') {
            result += "&quot;";
        } else if (code_point >= 0x20 && code_point != 0xFFFE && code_point != 0xFFFF) {
            append_utf8(result, code_point);
        }
    }
    return result;
}

}  // namespace quadcut::io
