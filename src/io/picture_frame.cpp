// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/picture_frame.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "io/image_checks.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

[[noreturn]] void fail_short(const std::string& name, const char* kind, std::size_t num_bytes) {
    throw InputError(name + ": byte " + std::to_string(num_bytes) + ": damaged " + kind +
                     ": the file ends early");
}

/// Reads numbers of a file one after the other.
class ByteCursor {
public:
    ByteCursor(std::string_view bytes, const std::string& name, const char* kind)
        : bytes_(bytes), name_(name), kind_(kind) {}

    [[nodiscard]] std::size_t position() const { return position_; }

    void move_to(std::uint64_t position) {
        if (position > bytes_.size()) fail_short(name_, kind_, bytes_.size());
        position_ = static_cast<std::size_t>(position);
    }
    void skip(std::uint64_t count) { move_to(position_ + count); }

    unsigned byte() {
        skip(1);
        return static_cast<unsigned char>(bytes_[position_ - 1]);
    }
    /// The lowest byte first.
    std::uint32_t little(int num_bytes) {
        std::uint32_t value = 0;
        for (int i = 0; i < num_bytes; ++i) value |= static_cast<std::uint32_t>(byte()) << (8 * i);
        return value;
    }

private:
    std::string_view bytes_;
    const std::string& name_;
    const char* kind_;
    std::size_t position_ = 0;
};

/// Of what a byte stands for: `max_ratio` bytes of `promised` at most.
void check_promise(const PromisedImage& promised, const std::string& name, std::size_t num_bytes,
                   std::uint64_t max_ratio) {
    check_size(promised, name + ": ", kMaxPicturePixels);
    check_fits(promised, name, num_bytes, max_ratio);
}

constexpr std::uint32_t kOldBmpHeader = 12;
constexpr std::uint64_t kBmpFileHeader = 14;

struct BmpForm {
    std::uint64_t offset = 0;  ///< of the first pixel
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    unsigned bits = 0;
    std::uint64_t num_colors = 0;  ///< of the palette

    [[nodiscard]] std::uint64_t row_bytes() const { return (width * bits + 31) / 32 * 4; }
};

BmpForm read_form(std::string_view bytes, const std::string& name) {
    constexpr std::size_t kFirstNumber = 10;
    ByteCursor cursor(bytes, name, "BMP");
    cursor.move_to(kFirstNumber);
    BmpForm form;
    form.offset = cursor.little(4);
    const std::uint64_t header_bytes = cursor.little(4);
    const bool is_old = header_bytes == kOldBmpHeader;
    form.width = cursor.little(is_old ? 2 : 4);
    const std::uint32_t height = cursor.little(is_old ? 2 : 4);
    // A negative height says that the top row comes first.
    form.height = static_cast<std::uint64_t>(
        std::abs(static_cast<std::int64_t>(static_cast<std::int32_t>(height))));
    cursor.skip(2);
    form.bits = cursor.little(2);
    const std::uint64_t before_palette = kBmpFileHeader + header_bytes;
    if (form.offset > before_palette) {
        form.num_colors = (form.offset - before_palette) / (is_old ? 3 : 4);
    }
    return form;
}

/// The decoder does not ask whether the palette has the colour of a pixel.
void check_palette(const BmpForm& form, std::string_view pixels, const std::string& name) {
    if (form.bits == 0 || 8 % form.bits != 0) return;  // None, or refused by the decoder.
    const unsigned mask = (1U << form.bits) - 1U;
    if (form.num_colors > mask) return;
    for (std::uint64_t first = 0; first < pixels.size(); first += form.row_bytes()) {
        for (std::uint64_t bit = 0; bit < form.width * form.bits; bit += form.bits) {
            const auto byte = static_cast<unsigned char>(pixels[first + bit / 8]);
            if ((byte >> (8 - form.bits - bit % 8) & mask) < form.num_colors) continue;
            throw InputError(name + ": damaged BMP: a pixel's colour is not among the " +
                             std::to_string(form.num_colors) + " of the palette");
        }
    }
}

}  // namespace

bool is_bmp(std::string_view bytes) {
    constexpr std::uint32_t kLongestHeader = 124;
    // Two letters may begin a text; the length of a header does not come in one.
    if (!bytes.starts_with("BM") || bytes.size() < kBmpFileHeader + 4) return false;
    const std::string no_name;
    ByteCursor cursor(bytes, no_name, "BMP");
    cursor.skip(kBmpFileHeader);
    const std::uint32_t header_bytes = cursor.little(4);
    return header_bytes >= kOldBmpHeader && header_bytes <= kLongestHeader;
}

bool is_gif(std::string_view bytes) {
    return bytes.starts_with("GIF87a") || bytes.starts_with("GIF89a");
}

std::size_t end_of_bmp(std::string_view bytes, const std::string& name) {
    const BmpForm form = read_form(bytes, name);
    check_promise({"BMP", form.width, form.height, std::max(form.bits, 1U)}, name, bytes.size(), 1);
    const std::uint64_t num_bytes = form.height * form.row_bytes();
    const bool fits = form.offset <= bytes.size() && num_bytes <= bytes.size() - form.offset;
    if (!fits) fail_short(name, "BMP", bytes.size());
    const auto end = static_cast<std::size_t>(form.offset + num_bytes);
    check_palette(form, bytes.substr(form.offset, num_bytes), name);
    return end;
}

std::size_t end_of_gif(std::string_view bytes, const std::string& name) {
    constexpr unsigned kPicture = 0x2C;
    constexpr unsigned kExtension = 0x21;
    const auto table_bytes = [](unsigned flags) {
        return (flags & 0x80U) == 0 ? 0U : 3U << ((flags & 7U) + 1U);
    };
    ByteCursor cursor(bytes, name, "GIF");
    // 12 bits stand for the longest string of pixels at most.
    constexpr std::uint64_t kMaxRatio = 4096;
    cursor.skip(6);
    const std::uint64_t width = cursor.little(2);
    const std::uint64_t height = cursor.little(2);
    check_promise({"GIF", width, height, 8}, name, bytes.size(), kMaxRatio);
    const unsigned flags = cursor.byte();
    cursor.skip(2 + table_bytes(flags));
    while (true) {
        const unsigned block = cursor.byte();
        if (block == kPicture) {
            cursor.skip(8);
            const unsigned picture_flags = cursor.byte();
            cursor.skip(table_bytes(picture_flags));
        } else if (block != kExtension) {
            return cursor.position();  // The end, or what the decoder will refuse.
        }
        cursor.skip(1);
        for (unsigned length = cursor.byte(); length != 0; length = cursor.byte()) {
            cursor.skip(length);
        }
    }
}

}  // namespace quadcut::io
