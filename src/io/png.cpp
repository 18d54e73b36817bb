// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <new>
#include <stdexcept>
#include <utility>

#include <png.h>

#include "io/image.hpp"
#include "io/image_checks.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

// libpng reports an error by longjmp, which must not pass over an object with a destructor. So
// each call into it goes through attempt(), with arguments and frames that are trivial, and the
// error becomes an exception only after the jump has landed.

constexpr std::size_t kMaxMessage = 200;
constexpr int kMaxByte = 255;
constexpr int kMaxWord = 65535;

struct Decoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    const char* bytes = nullptr;
    std::size_t size = 0;
    std::size_t position = 0;
    std::array<char, kMaxMessage> message{};

    Decoder() = default;
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void keep_message(png_structp png, png_const_charp text) {
    auto* decoder = static_cast<Decoder*>(png_get_error_ptr(png));
    std::strncpy(decoder->message.data(), text, kMaxMessage - 1);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep data, std::size_t count) {
    auto* decoder = static_cast<Decoder*>(png_get_io_ptr(png));
    if (count > decoder->size - decoder->position) png_error(png, "the file ends early");
    std::memcpy(data, decoder->bytes + decoder->position, count);
    decoder->position += count;
}

/// Whether `call` returned rather than jumped. @pre its captures are trivial to destroy.
template <typename Call>
bool attempt(png_structp png, const Call& call) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;  // NOLINT(cert-err52-cpp): libpng's way.
    call();
    return true;
}

[[noreturn]] void fail(const Decoder& decoder, const std::string& name) {
    throw InputError(name + ": byte " + std::to_string(decoder.position) +
                     ": damaged PNG: " + decoder.message.data());
}

void check_header(const Decoder& decoder, const std::string& name) {
    constexpr std::uint64_t kMaxDeflateRatio = 1032;
    const PromisedImage promised{
        "PNG", png_get_image_width(decoder.png, decoder.info),
        png_get_image_height(decoder.png, decoder.info),
        static_cast<std::uint64_t>(png_get_bit_depth(decoder.png, decoder.info)) *
            png_get_channels(decoder.png, decoder.info)};
    check_size(promised, name + ": ");
    check_fits(promised, name, decoder.size, kMaxDeflateRatio);
}

/// Every colour type and depth becomes 1 to 4 channels of 8 bits, or of 16 in native order.
void ask_for_plain_samples(const Decoder& decoder) {
    png_set_expand(decoder.png);
    if constexpr (std::endian::native == std::endian::little) png_set_swap(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
}

ImageHeader plain_header(const Decoder& decoder) {
    return {static_cast<std::int32_t>(png_get_image_width(decoder.png, decoder.info)),
            static_cast<std::int32_t>(png_get_image_height(decoder.png, decoder.info)),
            png_get_channels(decoder.png, decoder.info),
            png_get_bit_depth(decoder.png, decoder.info) == 16 ? kMaxWord : kMaxByte};
}

void open(Decoder& decoder, const std::string& name) {
    decoder.png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, keep_message, ignore_warning);
    if (decoder.png == nullptr) throw std::bad_alloc();
    decoder.info = png_create_info_struct(decoder.png);
    if (decoder.info == nullptr) throw std::bad_alloc();
    Decoder* const state = &decoder;
    const bool done = attempt(decoder.png, [state] {
        png_set_read_fn(state->png, state, take_bytes);
        png_set_user_limits(state->png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_read_info(state->png, state->info);
    });
    if (!done) fail(decoder, name);
}

void read_row(Decoder& decoder, png_bytep row, const std::string& name) {
    const png_structp png = decoder.png;
    if (!attempt(png, [png, row] { png_read_row(png, row, nullptr); })) fail(decoder, name);
}

void widen(const std::vector<png_byte>& packed, bool wide, std::vector<std::uint16_t>& samples) {
    if (wide) {
        std::memcpy(samples.data(), packed.data(), samples.size() * sizeof(std::uint16_t));
    } else {
        std::copy_n(packed.begin(), samples.size(), samples.begin());
    }
}

/// Calls `sink` for each row. The passes of an interlaced image fill all rows before the first is
/// complete, so such an image is held as a whole.
void read_rows(Decoder& decoder, const ImageHeader& header, int num_passes, const std::string& name,
               const ImageRowSink& sink) {
    const bool wide = header.max_value == kMaxWord;
    const std::size_t row_bytes = png_get_rowbytes(decoder.png, decoder.info);
    std::vector<std::uint16_t> samples(header.row_samples());
    std::vector<png_byte> row(row_bytes);
    std::vector<std::vector<png_byte>> rows;
    if (num_passes > 1) rows.assign(static_cast<std::size_t>(header.height), row);
    for (int pass = 1; pass < num_passes; ++pass) {
        for (std::vector<png_byte>& partial : rows) read_row(decoder, partial.data(), name);
    }
    for (std::int32_t y = 0; y < header.height; ++y) {
        std::vector<png_byte>& target = rows.empty() ? row : rows[static_cast<std::size_t>(y)];
        read_row(decoder, target.data(), name);
        widen(target, wide, samples);
        sink(header, y, samples);
    }
}

}  // namespace

ParsedImage parse_png(std::string_view bytes, const std::string& name, const ImageRowSink& sink) {
    Decoder decoder;
    decoder.bytes = bytes.data();
    decoder.size = bytes.size();
    open(decoder, name);
    check_header(decoder, name);

    int num_passes = 1;
    Decoder* const state = &decoder;
    int* const passes = &num_passes;
    const bool prepared = attempt(decoder.png, [state, passes] {
        *passes = png_set_interlace_handling(state->png);
        ask_for_plain_samples(*state);
    });
    if (!prepared) fail(decoder, name);
    const ImageHeader header = plain_header(decoder);
    read_rows(decoder, header, num_passes, name, sink);

    const bool finished = attempt(decoder.png, [state] { png_read_end(state->png, nullptr); });
    if (!finished) fail(decoder, name);
    return {header, warnings_of_surplus(decoder.size - decoder.position)};
}

}  // namespace quadcut::io
