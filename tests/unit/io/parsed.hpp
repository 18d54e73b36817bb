// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/image.hpp"

namespace quadcut::io::test {

/// An image as parse_image() gives it.
struct Parsed {
    ImageHeader header;
    std::vector<std::uint16_t> samples;
    std::vector<std::string> warnings;
};

inline Parsed parse(const std::string& bytes, const std::string& name) {
    Parsed parsed;
    ParsedImage image = parse_image(bytes, name, [&](const ImageHeader&, std::int32_t, auto row) {
        parsed.samples.insert(parsed.samples.end(), row.begin(), row.end());
    });
    parsed.header = image.header;
    parsed.warnings = std::move(image.warnings);
    return parsed;
}

}  // namespace quadcut::io::test
