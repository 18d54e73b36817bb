// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <stdexcept>

#include <zlib.h>

#include "io/authorship.hpp"
#include "io/image.hpp"

namespace quadcut::io {
namespace {

// libpng compresses an image in one go. Here bands of rows are, each on its own, as many at a time
// as there are threads: what one stream of zlib gives ends on a byte after Z_SYNC_FLUSH, and such
// pieces may be put one behind the other.

constexpr int kMaxByte = 255;
constexpr int kMaxWord = 65535;
constexpr std::size_t kRowsPerBand = 64;
/// Fewer rows where they are very long.
constexpr std::size_t kMostBandBytes = std::size_t{1} << 26U;
/// Maps, labels and plans are large areas of one value: filters shrink them little, and so do
/// levels from 4 on, which take twice the time.
constexpr int kLevel = 3;

void append_word(std::string& bytes, std::uint32_t word) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<char>(word >> static_cast<unsigned>(shift) & 0xFFU));
    }
}

const Bytef* bytes_of(const char* text) { return reinterpret_cast<const Bytef*>(text); }

void append_chunk(std::string& png, std::string_view type, std::string_view data) {
    append_word(png, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = png.size();
    png.append(type).append(data);
    append_word(png, static_cast<std::uint32_t>(
                         crc32_z(0, bytes_of(png.data()) + begin, png.size() - begin)));
}

std::string header_chunk(const ImageHeader& header) {
    constexpr std::array<char, 4> kColorTypes = {0, 4, 2, 6};
    std::string data;
    append_word(data, static_cast<std::uint32_t>(header.width));
    append_word(data, static_cast<std::uint32_t>(header.height));
    data.push_back(header.max_value == kMaxWord ? 16 : 8);
    data.push_back(kColorTypes.at(static_cast<std::size_t>(header.channels - 1)));
    data.append(3, '\0');  // Deflate, the standard filters, not interlaced.
    return data;
}

/// A compressor of one band, without the header and the sum of a zlib stream.
class Deflater {
public:
    Deflater() {
        constexpr int kRawWindow = -15;
        constexpr int kMemory = 8;
        if (deflateInit2(&stream_, kLevel, Z_DEFLATED, kRawWindow, kMemory, Z_DEFAULT_STRATEGY) !=
            Z_OK) {
            throw std::bad_alloc();
        }
    }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;
    ~Deflater() { deflateEnd(&stream_); }

    std::string deflate_all(std::string_view bytes, int flush) {
        constexpr std::size_t kPiece = std::size_t{1} << 15U;
        stream_.next_in = const_cast<Bytef*>(bytes_of(bytes.data()));
        stream_.avail_in = static_cast<uInt>(bytes.size());
        std::string result;
        do {
            const std::size_t size = result.size();
            result.resize(size + kPiece);
            stream_.next_out = reinterpret_cast<Bytef*>(result.data()) + size;
            stream_.avail_out = kPiece;
            deflate(&stream_, flush);
            result.resize(size + kPiece - stream_.avail_out);
        } while (stream_.avail_out == 0);
        return result;
    }

private:
    z_stream stream_{};
};

struct Band {
    std::string compressed;
    uLong sum = 0;
    std::size_t num_bytes = 0;
};

void check_encodable(const ImageHeader& header) {
    const bool known_depth = header.max_value == kMaxByte || header.max_value == kMaxWord;
    if (header.width <= 0 || header.height <= 0 || header.channels < 1 || header.channels > 4 ||
        !known_depth) {
        throw std::logic_error("encode_png: expected a size, 1 to 4 channels, 8 or 16 bits");
    }
}

/// With the byte in front that names the filter: 0, none.
std::size_t row_bytes_of(const ImageHeader& header) {
    return 1 + header.row_samples() * (header.max_value == kMaxWord ? 2 : 1);
}

std::size_t rows_per_band(const ImageHeader& header) {
    return std::clamp<std::size_t>(kMostBandBytes / row_bytes_of(header), 1, kRowsPerBand);
}

}  // namespace

std::string encode_png_bands(const ImageHeader& header, const ImageBandSource& source,
                             const Executor& executor) {
    check_encodable(header);
    const std::size_t row_bytes = row_bytes_of(header);
    const auto height = static_cast<std::size_t>(header.height);
    const std::size_t num_rows = rows_per_band(header);
    std::vector<Band> bands((height + num_rows - 1) / num_rows);
    parallel_for(executor, height, num_rows, [&](std::size_t first, std::size_t last) {
        std::string rows((last - first) * row_bytes, '\0');
        source({static_cast<std::int32_t>(first), static_cast<std::int32_t>(last),
                reinterpret_cast<std::uint8_t*>(rows.data()) + 1, row_bytes});
        Band& band = bands[first / num_rows];
        band.compressed = Deflater().deflate_all(rows, last == height ? Z_FINISH : Z_SYNC_FLUSH);
        band.sum = adler32_z(adler32_z(0, nullptr, 0), bytes_of(rows.data()), rows.size());
        band.num_bytes = rows.size();
    });

    constexpr std::string_view kSignature = "\x89PNG\r\n\x1A\n";
    constexpr std::string_view kStreamHeader = "\x78\x5E";
    std::string png(kSignature);
    append_chunk(png, "IHDR", header_chunk(header));
    append_chunk(png, "tEXt", kAuthorChunk);
    uLong sum = adler32_z(0, nullptr, 0);
    bands.front().compressed.insert(0, kStreamHeader);
    for (std::size_t i = 0; i < bands.size(); ++i) {
        Band& band = bands[i];
        sum = adler32_combine(sum, band.sum, static_cast<z_off_t>(band.num_bytes));
        if (i + 1 == bands.size()) append_word(band.compressed, static_cast<std::uint32_t>(sum));
        append_chunk(png, "IDAT", band.compressed);
        band.compressed = {};
    }
    append_chunk(png, "IEND", {});
    return png;
}

std::string encode_png(const ImageHeader& header, const ImageRowSource& source,
                       const Executor& executor) {
    const auto fill_band = [&](const ImageBand& band) {
        std::vector<std::uint16_t> samples(header.row_samples());
        for (std::int32_t y = band.first; y < band.last; ++y) {
            source(y, samples);
            std::uint8_t* to = band.row(y);
            if (header.max_value == kMaxByte) {
                std::transform(samples.begin(), samples.end(), to, [](std::uint16_t value) {
                    return static_cast<std::uint8_t>(value);
                });
                continue;
            }
            for (const std::uint16_t value : samples) {
                *to++ = static_cast<std::uint8_t>(value >> 8U);
                *to++ = static_cast<std::uint8_t>(value & 0xFFU);
            }
        }
    };
    return encode_png_bands(header, fill_band, executor);
}

}  // namespace quadcut::io
