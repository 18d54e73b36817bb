// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/jpeg.hpp"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <jerror.h>
#include <jpeglib.h>

#include "io/image_checks.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

// libjpeg reports an error by a function that may not return: a longjmp, which must not pass over
// an object with a destructor. So each call into it goes through attempt(), as with libpng.

constexpr int kMaxByte = 255;

struct Decoder {
    jpeg_decompress_struct info{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf landing{};
    std::array<char, JMSG_LENGTH_MAX> message{};

    Decoder() = default;
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { jpeg_destroy_decompress(&info); }
};

[[noreturn]] void keep_message(j_common_ptr info) {
    auto* decoder = static_cast<Decoder*>(info->client_data);
    info->err->format_message(info, decoder->message.data());
    std::longjmp(decoder->landing, 1);  // NOLINT(cert-err52-cpp): libjpeg's way.
}

/// Of what the library gets over, data that are missing or damaged are an error here.
void judge_message(j_common_ptr info, int level) {
    const int code = info->err->msg_code;
    const bool is_damage =
        code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE;
    if (level < 0 && is_damage) keep_message(info);
}

void print_nothing(j_common_ptr) {}

/// A few bytes can ask for all pixels to be gone over again.
void limit_scans(j_common_ptr info) {
    constexpr int kMaxScans = 200;
    const auto* decoder = static_cast<Decoder*>(info->client_data);
    if (decoder->info.input_scan_number <= kMaxScans) return;
    info->err->msg_code = JERR_BAD_PROGRESSION;
    keep_message(info);
}

/// Whether `call` returned rather than jumped. @pre its captures are trivial to destroy.
template <typename Call>
bool attempt(Decoder& decoder, const Call& call) {
    if (setjmp(decoder.landing) != 0) return false;  // NOLINT(cert-err52-cpp): libjpeg's way.
    call();
    return true;
}

[[noreturn]] void fail(const Decoder& decoder, const std::string& name) {
    throw InputError(name + ": damaged JPEG: " + decoder.message.data());
}

void open(Decoder& decoder, std::string_view bytes, const std::string& name) {
    decoder.info.err = jpeg_std_error(&decoder.errors);
    decoder.errors.error_exit = keep_message;
    decoder.errors.emit_message = judge_message;
    decoder.errors.output_message = print_nothing;
    decoder.info.client_data = &decoder;
    decoder.progress.progress_monitor = limit_scans;
    Decoder* const state = &decoder;
    const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
    const unsigned long size = bytes.size();
    const bool done = attempt(decoder, [state, data, size] {
        jpeg_create_decompress(&state->info);
        state->info.progress = &state->progress;
        jpeg_mem_src(&state->info, data, size);
        jpeg_read_header(&state->info, TRUE);
    });
    if (!done) fail(decoder, name);
}

void check(const Decoder& decoder, const std::string& name, std::size_t num_bytes) {
    // A byte holds the codes of eight blocks of 64 pixels at most.
    constexpr std::uint64_t kMaxRatio = 1024;
    const PromisedImage promised{"JPEG", decoder.info.image_width, decoder.info.image_height, 8};
    check_size(promised, name + ": ", kMaxPicturePixels);
    check_fits(promised, name, num_bytes, kMaxRatio);
    if (decoder.info.num_components == 1 || decoder.info.num_components == 3) return;
    throw InputError(name + ": the JPEG has colours that are neither grey nor RGB, which are not " +
                     "read; save it as a PNG of 8 bits");
}

}  // namespace

bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xFF\xD8\xFF"); }

ParsedImage parse_jpeg(std::string_view bytes, const std::string& name, const ImageRowSink& sink) {
    Decoder decoder;
    open(decoder, bytes, name);
    check(decoder, name, bytes.size());
    Decoder* const state = &decoder;
    const bool is_grey = decoder.info.num_components == 1;
    decoder.info.out_color_space = is_grey ? JCS_GRAYSCALE : JCS_RGB;
    if (!attempt(decoder, [state] { jpeg_start_decompress(&state->info); })) fail(decoder, name);

    const ImageHeader header{static_cast<std::int32_t>(decoder.info.output_width),
                             static_cast<std::int32_t>(decoder.info.output_height), is_grey ? 1 : 3,
                             kMaxByte};
    std::vector<JSAMPLE> packed(header.row_samples());
    std::vector<std::uint16_t> samples(header.row_samples());
    JSAMPLE* row = packed.data();
    JSAMPLE** const rows = &row;
    for (std::int32_t y = 0; y < header.height; ++y) {
        const bool is_read =
            attempt(decoder, [state, rows] { jpeg_read_scanlines(&state->info, rows, 1); });
        if (!is_read) fail(decoder, name);
        std::copy(packed.begin(), packed.end(), samples.begin());
        sink(header, y, samples);
    }
    if (!attempt(decoder, [state] { jpeg_finish_decompress(&state->info); })) fail(decoder, name);
    return {header, warnings_of_surplus(decoder.info.src->bytes_in_buffer)};
}

}  // namespace quadcut::io
