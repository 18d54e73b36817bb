// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/utf8.hpp"

#include <array>
#include <bit>
#include <cstddef>

namespace quadcut::io {
namespace {

constexpr unsigned kBitsPerContinuation = 6;
constexpr unsigned char kContinuationMask = 0x3F;

/// A sequence of bytes that stands for one code point; length 0: none does here.
struct Sequence {
    char32_t code_point = kReplacementCharacter;
    std::size_t length = 0;
};

Sequence read_sequence(std::string_view bytes) {
    const auto first = static_cast<unsigned char>(bytes[0]);
    if (first < 0x80) return {first, 1};
    const auto length = static_cast<std::size_t>(std::countl_one(first));
    if (length < 2 || length > 4 || bytes.size() < length) return {};
    char32_t code_point = first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        if ((byte & 0xC0U) != 0x80U) return {};
        code_point = code_point << kBitsPerContinuation | (byte & kContinuationMask);
    }
    constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code_point >= 0xD800 && code_point <= 0xDFFF;
    if (code_point < kLeast.at(length) || code_point > 0x10FFFF || surrogate) return {};
    return {code_point, length};
}

}  // namespace

std::u32string decode_utf8(std::string_view bytes) {
    std::u32string text;
    while (!bytes.empty()) {
        const Sequence sequence = read_sequence(bytes);
        text += sequence.code_point;
        bytes.remove_prefix(sequence.length == 0 ? 1 : sequence.length);
    }
    return text;
}

void append_utf8(std::string& text, char32_t code_point) {
    if (code_point < 0x80) {
        text += static_cast<char>(code_point);
        return;
    }
    const std::size_t length = code_point < 0x800 ? 2 : code_point < 0x10000 ? 3 : 4;
    const auto marker = static_cast<unsigned char>(0xF00U >> length);
    for (std::size_t i = 0; i < length; ++i) {
        const auto shift = static_cast<unsigned>(length - 1 - i) * kBitsPerContinuation;
        const auto bits = static_cast<unsigned char>(code_point >> shift);
        text += static_cast<char>(i == 0 ? marker | bits : 0x80U | (bits & kContinuationMask));
    }
}

}  // namespace quadcut::io
