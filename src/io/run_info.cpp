// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/run_info.hpp"

#include <string_view>

namespace quadcut::io {

std::string hash_text(std::uint64_t hash) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "fnv1a64:";
    for (int shift = 60; shift >= 0; shift -= 4) text += kDigits[(hash >> shift) & 15U];
    return text;
}

}  // namespace quadcut::io
