// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <stdexcept>

#include "io/authorship.hpp"
#include "io/image.hpp"
#include "io/image_checks.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr int kMaxSample = 65535;
constexpr int kMaxByte = 255;
constexpr std::int64_t kMaxNumber = 2'147'483'647;

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Walks over the numbers, the white space and the comments of a PGM.
class PgmCursor {
public:
    PgmCursor(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    [[nodiscard]] std::size_t position() const { return position_; }

    [[noreturn]] void fail(const std::string& what) const { throw InputError(place() + what); }
    [[nodiscard]] std::string place() const {
        return name_ + ": byte " + std::to_string(position_) + ": ";
    }

    void move_to(std::size_t position) { position_ = position; }

    std::int64_t read_number(const char* what) {
        skip_blanks();
        if (position_ >= bytes_.size()) {
            fail(std::string("the file ends where ") + what + " was expected");
        }
        if (!is_digit(bytes_[position_])) {
            fail(std::string("expected ") + what + ", a whole number");
        }
        std::int64_t value = 0;
        for (; position_ < bytes_.size() && is_digit(bytes_[position_]); ++position_) {
            // Held at the cap, which no valid field reaches.
            value = std::min(value * 10 + (bytes_[position_] - '0'), kMaxNumber);
        }
        return value;
    }

    void skip_blanks() {
        while (position_ < bytes_.size()) {
            if (bytes_[position_] == '#') {
                while (position_ < bytes_.size() && bytes_[position_] != '\n') ++position_;
            } else if (is_space(bytes_[position_])) {
                ++position_;
            } else {
                return;
            }
        }
    }

private:
    std::string_view bytes_;
    const std::string& name_;
    std::size_t position_ = 0;
};

ImageHeader parse_header(PgmCursor& cursor) {
    cursor.move_to(2);
    const std::int64_t width = cursor.read_number("the width of the PGM");
    const std::int64_t height = cursor.read_number("the height of the PGM");
    const std::int64_t max_value = cursor.read_number("the largest grey value of the PGM");
    const PromisedImage promised{"PGM", static_cast<std::uint64_t>(width),
                                 static_cast<std::uint64_t>(height), 8};
    check_size(promised, cursor.place());
    if (max_value < 1 || max_value > kMaxSample) {
        cursor.fail("the largest grey value is " + std::to_string(max_value) +
                    ", expected 1 to 65535");
    }
    return {static_cast<std::int32_t>(width), static_cast<std::int32_t>(height), 1,
            static_cast<int>(max_value)};
}

void check_length(const PgmCursor& cursor, std::size_t expected, std::size_t found,
                  const char* what) {
    if (found < expected) {
        cursor.fail("expected " + std::to_string(expected) + what + ", found " +
                    std::to_string(found));
    }
}

void check_sample(const PgmCursor& cursor, const ImageHeader& header, std::int64_t value,
                  std::size_t x, std::int32_t y) {
    if (value > header.max_value) {
        cursor.fail("the pixel in column " + std::to_string(x) + ", row " + std::to_string(y) +
                    " is " + std::to_string(value) + ", over the header's largest value " +
                    std::to_string(header.max_value));
    }
}

void parse_text_rows(PgmCursor& cursor, std::size_t num_bytes, const ImageHeader& header,
                     const ImageRowSink& sink) {
    const std::size_t num_pixels = header.row_samples() * static_cast<std::size_t>(header.height);
    // Each pixel takes a digit and a white space, the last one a digit.
    check_length(cursor, 2 * num_pixels - 1, num_bytes - cursor.position(),
                 " or more bytes of pixels after the PGM's header");
    std::vector<std::uint16_t> row(header.row_samples());
    for (std::int32_t y = 0; y < header.height; ++y) {
        for (std::size_t x = 0; x < row.size(); ++x) {
            const std::int64_t value = cursor.read_number("a pixel of the PGM");
            check_sample(cursor, header, value, x, y);
            row[x] = static_cast<std::uint16_t>(value);
        }
        sink(header, y, row);
    }
    cursor.skip_blanks();
}

/// Where the pixels may begin when the largest value ends at `end`: by the standard after one white
/// space, but there are files with a line end of two bytes, or with lines of comment.
std::vector<std::size_t> possible_starts(std::string_view bytes, std::size_t end) {
    constexpr std::size_t kMaxStarts = 16;
    std::vector<std::size_t> starts;
    const std::string_view rest = bytes.substr(std::min(end, bytes.size()));
    if (!rest.empty() && is_space(rest[0])) starts.push_back(end + 1);
    if (rest.starts_with("\r\n") || rest.starts_with(" \n")) starts.push_back(end + 2);
    std::size_t next = starts.empty() ? end : starts.back();
    while (next < bytes.size() && bytes[next] == '#' && starts.size() < kMaxStarts) {
        const std::size_t line_end = bytes.find('\n', next);
        if (line_end == std::string_view::npos) break;
        next = line_end + 1;
        starts.push_back(next);
    }
    return starts;
}

/// Whether bytes that may be pixels read like a comment, as no row of a map does.
bool is_comment(std::string_view bytes) {
    const auto is_text = [](char c) { return c >= ' ' || is_space(c); };
    return bytes.find('#') != std::string_view::npos &&
           std::all_of(bytes.begin(), bytes.end(), is_text);
}

/// Where the `num_bytes` of the pixels begin. What then ends where the file ends is right; a file
/// that is longer or shorter is judged by what stands before.
std::size_t find_raster(const PgmCursor& cursor, std::string_view bytes, std::size_t num_bytes) {
    const std::size_t end = cursor.position();
    const std::vector<std::size_t> starts = possible_starts(bytes, end);
    if (starts.empty()) cursor.fail("expected one white space before the pixels of the PGM");
    for (const std::size_t start : starts) {
        if (bytes.size() - start == num_bytes) return start;
    }
    const bool has_wide_ends = bytes.substr(0, end).find("\r\n") != std::string_view::npos;
    std::size_t likely = starts.front();
    for (const std::size_t start : starts) {
        const std::string_view before = bytes.substr(end, start - end);
        if (is_comment(before) || (has_wide_ends && before == "\r\n")) likely = start;
    }
    return likely;
}

void parse_binary_rows(PgmCursor& cursor, std::string_view bytes, const ImageHeader& header,
                       const ImageRowSink& sink) {
    const std::size_t sample_bytes = header.max_value > kMaxByte ? 2 : 1;
    const std::size_t num_bytes =
        header.row_samples() * static_cast<std::size_t>(header.height) * sample_bytes;
    cursor.move_to(find_raster(cursor, bytes, num_bytes));
    check_length(cursor, num_bytes, bytes.size() - cursor.position(),
                 " bytes of pixels after the PGM's header");
    std::vector<std::uint16_t> row(header.row_samples());
    const char* next = bytes.data() + cursor.position();
    for (std::int32_t y = 0; y < header.height; ++y) {
        for (std::size_t x = 0; x < row.size(); ++x) {
            unsigned value = static_cast<unsigned char>(*next++);
            if (sample_bytes == 2) value = value << 8U | static_cast<unsigned char>(*next++);
            row[x] = static_cast<std::uint16_t>(value);
            check_sample(cursor, header, row[x], x, y);
        }
        sink(header, y, row);
    }
    cursor.move_to(cursor.position() + num_bytes);
}

}  // namespace

ParsedImage parse_pgm(std::string_view bytes, const std::string& name, const ImageRowSink& sink) {
    if (bytes.size() < 2) throw InputError(name + ": expected a PGM (P2, P5)");
    PgmCursor cursor(bytes, name);
    const ImageHeader header = parse_header(cursor);
    if (bytes[1] == '2') {
        parse_text_rows(cursor, bytes.size(), header, sink);
    } else {
        parse_binary_rows(cursor, bytes, header, sink);
    }
    return {header, warnings_of_surplus(bytes.size() - cursor.position())};
}

std::uint64_t max_pgm_bytes(std::string_view beginning, const std::string& name) {
    constexpr std::uint64_t kBytesPerPixel = 8;  // Five digits, and a line end of two bytes.
    constexpr std::uint64_t kMore = std::uint64_t{1} << 20U;
    PgmCursor cursor(beginning, name);
    const ImageHeader header = parse_header(cursor);
    return kMore +
           kBytesPerPixel * header.row_samples() * static_cast<std::uint64_t>(header.height);
}

std::string encode_pgm(const ImageHeader& header, const ImageRowSource& source) {
    if (header.width <= 0 || header.height <= 0 || header.channels != 1 || header.max_value < 1 ||
        header.max_value > kMaxSample) {
        throw std::logic_error("encode_pgm: expected one channel, a size and a largest value");
    }
    const bool wide = header.max_value > kMaxByte;
    std::string bytes = "P5\n# ";
    bytes.append(kAuthorComment).append("\n");
    bytes += std::to_string(header.width) + " " + std::to_string(header.height) + "\n" +
             std::to_string(header.max_value) + "\n";
    bytes.reserve(bytes.size() +
                  header.row_samples() * static_cast<std::size_t>(header.height) * (wide ? 2 : 1));
    std::vector<std::uint16_t> row(header.row_samples());
    for (std::int32_t y = 0; y < header.height; ++y) {
        source(y, row);
        for (const std::uint16_t value : row) {
            if (wide) bytes.push_back(static_cast<char>(value >> 8U));
            bytes.push_back(static_cast<char>(value & 0xFFU));
        }
    }
    return bytes;
}

}  // namespace quadcut::io
