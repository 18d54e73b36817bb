// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/tiff.hpp"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <optional>

#include <tiffio.h>

#include "io/image_checks.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

using namespace std::string_view_literals;

constexpr unsigned kMaxByte = 255;
constexpr unsigned kMaxWord = 65535;

/// The file as libtiff sees it, and the first that it complained of.
struct Source {
    std::string_view bytes;
    std::uint64_t position = 0;
    std::array<char, 200> message{};
};

Source& source_of(thandle_t handle) { return *static_cast<Source*>(handle); }

tmsize_t take_bytes(thandle_t handle, void* data, tmsize_t count) {
    Source& source = source_of(handle);
    const std::uint64_t left = source.bytes.size() - source.position;
    const auto taken = std::min(static_cast<std::uint64_t>(count), left);
    std::memcpy(data, source.bytes.data() + source.position, taken);
    source.position += taken;
    return static_cast<tmsize_t>(taken);
}

tmsize_t write_nothing(thandle_t, void*, tmsize_t) { return 0; }

toff_t move_to(thandle_t handle, toff_t offset, int from) {
    Source& source = source_of(handle);
    if (from == SEEK_CUR) offset += source.position;
    if (from == SEEK_END) offset += source.bytes.size();
    source.position = std::min<std::uint64_t>(offset, source.bytes.size());
    return source.position;
}

int close_nothing(thandle_t) { return 0; }

toff_t size_of(thandle_t handle) { return source_of(handle).bytes.size(); }

/// libtiff reads in place.
int map_bytes(thandle_t handle, void** base, toff_t* size) {
    const std::string_view bytes = source_of(handle).bytes;
    *base = const_cast<char*>(bytes.data());  // It is opened for reading only.
    *size = bytes.size();
    return 1;
}

void unmap_nothing(thandle_t, void*, toff_t) {}

int keep_message(TIFF*, void* user, const char*, const char* format, va_list values) {
    auto& message = static_cast<Source*>(user)->message;
    if (message[0] == '\0') std::vsnprintf(message.data(), message.size(), format, values);
    return 1;
}

int ignore_message(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct CloseTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using OpenTiff = std::unique_ptr<TIFF, CloseTiff>;

struct FreeOptions {
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

[[noreturn]] void fail(const Source& source, const std::string& name) {
    throw InputError(name + ": damaged TIFF: " +
                     (source.message[0] == '\0' ? "no reason given" : source.message.data()));
}

OpenTiff open(Source& source, const std::string& name) {
    constexpr tmsize_t kMaxBlockBytes = tmsize_t{1} << 28U;
    const std::unique_ptr<TIFFOpenOptions, FreeOptions> options(TIFFOpenOptionsAlloc());
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMaxBlockBytes);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, &source);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_message, nullptr);
    OpenTiff tiff(TIFFClientOpenExt("", "r", &source, take_bytes, write_nothing, move_to,
                                    close_nothing, size_of, map_bytes, unmap_nothing,
                                    options.get()));
    if (!tiff) fail(source, name);
    return tiff;
}

/// How the pixels lie in the file.
struct TiffForm {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint16_t bits = 1;
    std::uint16_t samples = 1;  ///< of a pixel
    std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
    std::uint16_t planes = PLANARCONFIG_CONTIG;
    std::uint16_t format = SAMPLEFORMAT_UINT;
    std::uint16_t compression = COMPRESSION_NONE;
    bool has_alpha = false;
};

bool has_alpha(TIFF* tiff) {
    std::uint16_t count = 0;
    std::uint16_t* kinds = nullptr;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &count, &kinds);
    return count > 0 && kinds[0] != EXTRASAMPLE_UNSPECIFIED;
}

TiffForm read_form(TIFF* tiff) {
    TiffForm form;
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &form.width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &form.height);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &form.bits);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &form.samples);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &form.planes);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &form.format);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_COMPRESSION, &form.compression);
    if (TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &form.photometric) == 0 && form.samples >= 3) {
        form.photometric = PHOTOMETRIC_RGB;
    }
    form.has_alpha = has_alpha(tiff);
    if (form.photometric == PHOTOMETRIC_YCBCR && form.compression == COMPRESSION_JPEG) {
        TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
        form.photometric = PHOTOMETRIC_RGB;
    }
    return form;
}

bool is_grey(const TiffForm& form) {
    return form.photometric == PHOTOMETRIC_MINISBLACK || form.photometric == PHOTOMETRIC_MINISWHITE;
}

int num_colors(const TiffForm& form) { return is_grey(form) ? 1 : 3; }

/// What cannot be read of a TIFF of this form; empty when all can.
std::string_view find_obstacle(const TiffForm& form) {
    if (form.format == SAMPLEFORMAT_IEEEFP) return "floating-point numbers";
    if (form.format != SAMPLEFORMAT_UINT && form.format != SAMPLEFORMAT_VOID) {
        return "numbers with a sign";
    }
    constexpr std::array<unsigned, 5> kBits{1, 2, 4, 8, 16};
    if (std::find(kBits.begin(), kBits.end(), form.bits) == kBits.end()) {
        return "samples that have not 1, 2, 4, 8 or 16 bits";
    }
    const bool is_palette = form.photometric == PHOTOMETRIC_PALETTE && form.bits <= 8;
    if (!is_grey(form) && !is_palette && form.photometric != PHOTOMETRIC_RGB) {
        return "colours that are neither grey nor RGB nor a palette";
    }
    if (form.planes != PLANARCONFIG_CONTIG && form.samples > 1) return "colours in planes";
    const int needed = is_palette ? 1 : num_colors(form);
    return form.samples < needed ? "too few samples for a pixel" : ""sv;
}

void check(const TiffForm& form, const std::string& name, std::size_t num_bytes) {
    const PromisedImage promised{"TIFF", form.width, form.height,
                                 std::uint64_t{form.bits} * form.samples};
    check_size(promised, name + ": ");
    // The best that a row of fax or a block of a later compression can do.
    constexpr std::uint64_t kMaxRatio = std::uint64_t{1} << 15U;
    check_fits(promised, name, num_bytes, form.compression == COMPRESSION_NONE ? 1 : kMaxRatio);
    const std::string_view obstacle = find_obstacle(form);
    if (obstacle.empty()) return;
    throw InputError(name + ": the TIFF has " + std::string(obstacle) +
                     ", which are not read; save it as a PNG of 8 bits");
}

/// Turns the bytes of a row into samples.
class RowDecoder {
public:
    RowDecoder(TIFF* tiff, const TiffForm& form) : form_(form) {
        header_.width = static_cast<std::int32_t>(form.width);
        header_.height = static_cast<std::int32_t>(form.height);
        header_.channels = num_colors(form) + (form.has_alpha ? 1 : 0);
        header_.max_value = static_cast<int>(form.bits == 16 ? kMaxWord : kMaxByte);
        if (form.photometric == PHOTOMETRIC_PALETTE) read_palette(tiff);
    }

    [[nodiscard]] const ImageHeader& header() const { return header_; }
    [[nodiscard]] bool is_whole() const {
        return form_.photometric != PHOTOMETRIC_PALETTE || !palette_.empty();
    }

    void decode(std::span<const std::uint8_t> bytes, std::span<std::uint16_t> samples) const {
        std::size_t to = 0;
        for (std::size_t pixel = 0; pixel < form_.width; ++pixel) {
            const std::size_t first = pixel * form_.samples;
            int num_done = 1;
            if (palette_.empty()) {
                for (num_done = 0; num_done < num_colors(form_); ++num_done) {
                    samples[to++] = color(raw(bytes, first + static_cast<std::size_t>(num_done)));
                }
            } else {
                for (const std::uint16_t part : palette_[raw(bytes, first)]) samples[to++] = part;
            }
            if (form_.has_alpha) {
                samples[to++] = scaled(raw(bytes, first + static_cast<std::size_t>(num_done)));
            }
        }
    }

private:
    /// Sample number `i` of a row. Those of fewer than 8 bits begin with the highest.
    [[nodiscard]] unsigned raw(std::span<const std::uint8_t> bytes, std::size_t i) const {
        if (form_.bits == 8) return bytes[i];
        if (form_.bits == 16) {
            std::uint16_t word = 0;
            std::memcpy(&word, &bytes[2 * i], sizeof(word));
            return word;
        }
        const std::size_t bit = i * form_.bits;
        const auto shift = static_cast<unsigned>(8 - form_.bits - bit % 8);
        return static_cast<unsigned>(bytes[bit / 8]) >> shift & ((1U << form_.bits) - 1U);
    }
    [[nodiscard]] std::uint16_t scaled(unsigned value) const {
        const unsigned largest = (1U << form_.bits) - 1U;
        return static_cast<std::uint16_t>(form_.bits < 8 ? value * (kMaxByte / largest) : value);
    }
    [[nodiscard]] std::uint16_t color(unsigned value) const {
        const std::uint16_t sample = scaled(value);
        if (form_.photometric != PHOTOMETRIC_MINISWHITE) return sample;
        return static_cast<std::uint16_t>(header_.max_value - sample);
    }

    void read_palette(TIFF* tiff) {
        std::array<std::uint16_t*, 3> parts{};
        if (TIFFGetField(tiff, TIFFTAG_COLORMAP, &parts[0], &parts[1], &parts[2]) == 0) return;
        const std::size_t count = std::size_t{1} << form_.bits;
        // The parts have 16 bits; some programs write 8 all the same.
        const bool is_deep = std::any_of(parts.begin(), parts.end(), [&](const std::uint16_t* p) {
            return std::any_of(p, p + count, [](unsigned part) { return part > kMaxByte; });
        });
        for (std::size_t i = 0; i < count; ++i) {
            std::array<std::uint16_t, 3>& entry = palette_.emplace_back();
            for (std::size_t c = 0; c < entry.size(); ++c) {
                entry[c] = static_cast<std::uint16_t>(is_deep ? parts[c][i] >> 8U : parts[c][i]);
            }
        }
    }

    TiffForm form_;
    ImageHeader header_;
    std::vector<std::array<std::uint16_t, 3>> palette_;
};

/// The bytes of the rows, from the top down, of strips or of tiles.
class RowSource {
public:
    RowSource(TIFF* tiff, const TiffForm& form) : tiff_(tiff), form_(form) {
        row_bytes_ = (std::uint64_t{form.width} * pixel_bits() + 7) / 8;
        if (TIFFIsTiled(tiff) == 0) {
            is_usable_ = TIFFScanlineSize64(tiff) == row_bytes_;
            rows_.resize(is_usable_ ? row_bytes_ : 0);
            return;
        }
        TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &tile_width_);
        TIFFGetField(tiff, TIFFTAG_TILELENGTH, &tile_height_);
        tile_row_bytes_ = std::uint64_t{tile_width_} * pixel_bits() / 8;
        const std::uint64_t tile_bytes = tile_row_bytes_ * tile_height_;
        constexpr std::uint64_t kMaxBandBytes = std::uint64_t{1} << 30U;
        // 16 divides the sides of a tile, which therefore begins with a byte of its own.
        is_usable_ = tile_width_ > 0 && tile_height_ > 0 && tile_width_ % 16 == 0 &&
                     TIFFTileSize64(tiff) == tile_bytes &&
                     tile_bytes <= kMaxBandBytes / num_tiles_across();
        if (is_usable_) tiles_.resize(tile_bytes * num_tiles_across());
        rows_.resize(is_usable_ ? tile_row_bytes_ * num_tiles_across() : 0);
    }

    [[nodiscard]] bool is_usable() const { return is_usable_; }

    /// Row `y`, the one after the last; nothing when it is damaged.
    [[nodiscard]] std::optional<std::span<const std::uint8_t>> row(std::uint32_t y) {
        if (tile_width_ == 0) {
            if (TIFFReadScanline(tiff_, rows_.data(), y, 0) < 0) return std::nullopt;
            return rows_;
        }
        if (y % tile_height_ == 0 && !read_tiles(y)) return std::nullopt;
        for (std::uint64_t tile = 0; tile < num_tiles_across(); ++tile) {
            const std::uint64_t from = (tile * tile_height_ + y % tile_height_) * tile_row_bytes_;
            std::memcpy(&rows_[tile * tile_row_bytes_], &tiles_[from], tile_row_bytes_);
        }
        return rows_;
    }

private:
    [[nodiscard]] std::uint64_t pixel_bits() const {
        return std::uint64_t{form_.bits} * form_.samples;
    }
    [[nodiscard]] std::uint64_t num_tiles_across() const {
        return (std::uint64_t{form_.width} + tile_width_ - 1) / tile_width_;
    }
    bool read_tiles(std::uint32_t y) {
        const std::uint64_t tile_bytes = tile_row_bytes_ * tile_height_;
        for (std::uint64_t tile = 0; tile < num_tiles_across(); ++tile) {
            const auto x = static_cast<std::uint32_t>(tile * tile_width_);
            if (TIFFReadTile(tiff_, &tiles_[tile * tile_bytes], x, y, 0, 0) < 0) return false;
        }
        return true;
    }

    TIFF* tiff_;
    TiffForm form_;
    std::uint64_t row_bytes_ = 0;
    bool is_usable_ = false;
    std::uint32_t tile_width_ = 0;  ///< 0: strips
    std::uint32_t tile_height_ = 0;
    std::uint64_t tile_row_bytes_ = 0;
    std::vector<std::uint8_t> tiles_;  ///< of as many rows as a tile has
    std::vector<std::uint8_t> rows_;   ///< one row
};

std::vector<std::string> warnings_of(TIFF* tiff) {
    std::vector<std::string> warnings;
    if (TIFFLastDirectory(tiff) == 0) {
        warnings.emplace_back("the TIFF has several pages, of which the first is read");
    }
    std::uint16_t orientation = ORIENTATION_TOPLEFT;
    TIFFGetFieldDefaulted(tiff, TIFFTAG_ORIENTATION, &orientation);
    if (orientation != ORIENTATION_TOPLEFT) {
        warnings.emplace_back("the TIFF asks to be shown turned or mirrored, which is not done");
    }
    return warnings;
}

}  // namespace

bool is_tiff(std::string_view bytes) {
    return bytes.starts_with("II*\0"sv) || bytes.starts_with("MM\0*"sv) ||
           bytes.starts_with("II+\0"sv) || bytes.starts_with("MM\0+"sv);
}

ParsedImage parse_tiff(std::string_view bytes, const std::string& name, const ImageRowSink& sink) {
    Source source{bytes, 0, {}};
    const OpenTiff tiff = open(source, name);
    const TiffForm form = read_form(tiff.get());
    check(form, name, bytes.size());
    RowSource rows(tiff.get(), form);
    const RowDecoder decoder(tiff.get(), form);
    if (!rows.is_usable()) throw InputError(name + ": damaged TIFF: rows or tiles of no size");
    if (!decoder.is_whole()) throw InputError(name + ": damaged TIFF: no palette");

    std::vector<std::uint16_t> samples(decoder.header().row_samples());
    for (std::uint32_t y = 0; y < form.height; ++y) {
        const std::optional<std::span<const std::uint8_t>> row = rows.row(y);
        if (!row) fail(source, name);
        decoder.decode(*row, samples);
        sink(decoder.header(), static_cast<std::int32_t>(y), samples);
    }
    return {decoder.header(), warnings_of(tiff.get())};
}

}  // namespace quadcut::io
