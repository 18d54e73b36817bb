// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/label_image.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "io/file.hpp"
#include "io/image.hpp"

namespace quadcut::io {
namespace {

constexpr int kMaxByte = 255;
constexpr int kMaxWord = 65535;

/// The first three channels in one number; grey as it is. Deep colours count by their high bytes.
std::uint32_t region_value(const ImageHeader& header, std::span<const std::uint16_t> samples,
                           std::int32_t x) {
    const std::size_t first =
        static_cast<std::size_t>(x) * static_cast<std::size_t>(header.channels);
    if (header.channels < 3) return samples[first];
    const unsigned shift = header.max_value > kMaxByte ? 8U : 0U;
    const std::uint32_t red = static_cast<std::uint32_t>(samples[first]) >> shift;
    const std::uint32_t green = static_cast<std::uint32_t>(samples[first + 1]) >> shift;
    const std::uint32_t blue = static_cast<std::uint32_t>(samples[first + 2]) >> shift;
    return red | green << 8U | blue << 16U;
}

/// 0..255: ITU-R 601 luma in 16-bit fixed point, rounded.
std::uint32_t grey_level(const ImageHeader& header, std::span<const std::uint16_t> samples,
                         std::int32_t x) {
    const std::size_t first =
        static_cast<std::size_t>(x) * static_cast<std::size_t>(header.channels);
    const auto max_value = static_cast<std::uint32_t>(header.max_value);
    const auto level = [&](std::size_t i) { return samples[i] * std::uint32_t{255} / max_value; };
    if (header.channels < 3) return level(first);
    return (level(first) * 19595U + level(first + 1) * 38470U + level(first + 2) * 7471U +
            0x8000U) >>
           16U;
}

std::vector<std::string> named(std::vector<std::string> warnings, const std::string& name) {
    for (std::string& warning : warnings) warning.insert(0, name + ": ");
    return warnings;
}

}  // namespace

LabelImage number_regions(std::int32_t width, std::int32_t height,
                          const std::vector<std::uint32_t>& values, std::size_t ignored_pixels) {
    if (values.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        throw std::logic_error("number_regions: values do not fill the image");
    }
    std::vector<std::uint32_t> distinct;
    for (std::size_t i = 0; i < values.size(); ++i) {
        // Neighbouring pixels are mostly equal: this keeps the list short before it is sorted.
        if (values[i] != 0 && (i == 0 || values[i] != values[i - 1])) distinct.push_back(values[i]);
    }
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());

    LabelImage image{width, height, 0, std::vector<std::uint32_t>(values.size())};
    std::vector<std::size_t> num_pixels(distinct.size() + 1);
    std::uint32_t value = 0;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != value) {
            value = values[i];
            const auto place = std::lower_bound(distinct.begin(), distinct.end(), value);
            number = value == 0 ? 0 : static_cast<std::uint32_t>(place - distinct.begin()) + 1;
        }
        image.values[i] = number;
        ++num_pixels[number];
    }

    std::vector<std::uint32_t> kept_number(distinct.size() + 1);
    for (std::size_t i = 1; i < kept_number.size(); ++i) {
        if (num_pixels[i] > ignored_pixels) kept_number[i] = ++image.num_regions;
    }
    for (std::uint32_t& region : image.values) region = kept_number[region];
    return image;
}

LabelImage read_label_image(const std::filesystem::path& path) {
    std::vector<std::uint32_t> values;
    const InputFile file = read_image_input(path);
    const ParsedImage parsed = parse_image(
        file.bytes, file.name,
        [&](const ImageHeader& header, std::int32_t, std::span<const std::uint16_t> samples) {
            for (std::int32_t x = 0; x < header.width; ++x) {
                values.push_back(region_value(header, samples, x));
            }
        });
    LabelImage image = number_regions(parsed.header.width, parsed.header.height, values);
    image.warnings = named(parsed.warnings, file.name);
    return image;
}

FreeMask read_free_mask(const std::filesystem::path& path, std::uint32_t darkest_grey) {
    FreeMask mask;
    const InputFile file = read_image_input(path);
    const ParsedImage parsed = parse_image(
        file.bytes, file.name,
        [&](const ImageHeader& header, std::int32_t, std::span<const std::uint16_t> samples) {
            for (std::int32_t x = 0; x < header.width; ++x) {
                mask.is_free.push_back(grey_level(header, samples, x) > darkest_grey ? 1 : 0);
            }
        });
    mask.width = parsed.header.width;
    mask.height = parsed.header.height;
    mask.warnings = named(parsed.warnings, file.name);
    return mask;
}

std::string encode_label_png(const Raster<std::uint16_t>& labels) {
    const ImageHeader header{labels.width, labels.height, 1, kMaxWord};
    return encode_png(header, [&](std::int32_t y, std::span<std::uint16_t> samples) {
        const auto row = static_cast<std::size_t>(labels.height - 1 - y);
        std::copy_n(labels.values.begin() +
                        static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(labels.width)),
                    labels.width, samples.begin());
    });
}

}  // namespace quadcut::io
