// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/image_checks.hpp"

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

std::string size_text(const PromisedImage& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels";
}

}  // namespace

void check_size(const PromisedImage& image, const std::string& place, std::uint64_t max_pixels) {
    if (image.width == 0 || image.height == 0) {
        throw InputError(place + "the image has " + size_text(image) + ", expected at least one");
    }
    // Divided, since the product of two 64-bit numbers may pass the largest.
    if (image.height <= max_pixels / image.width) return;
    throw InputError(place + "the image has " + size_text(image) + ", more than the " +
                     std::to_string(max_pixels) + " that are read at most" +
                     (max_pixels < kMaxImagePixels ? " of a " + std::string(image.kind) : ""));
}

void check_fits(const PromisedImage& image, const std::string& name, std::uint64_t num_bytes,
                std::uint64_t max_ratio) {
    constexpr std::uint64_t kBitsPerByte = 8;
    const std::uint64_t needed = image.width * image.height * image.pixel_bits / kBitsPerByte;
    if (needed <= max_ratio * num_bytes) return;
    throw InputError(name + ": the " + std::string(image.kind) + "'s header promises " +
                     size_text(image) + ", more than " + std::to_string(num_bytes) +
                     " bytes can hold");
}

std::vector<std::string> warnings_of_surplus(std::size_t num_bytes) {
    if (num_bytes == 0) return {};
    return {"the file goes on after the image for " + std::to_string(num_bytes) +
            (num_bytes == 1 ? " byte, which is" : " bytes, which are") + " ignored"};
}

}  // namespace quadcut::io
