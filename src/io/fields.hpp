// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace quadcut::io {

/// The whole of `text` as a number, whatever the locale: decimal, with an optional sign, or nan
/// and inf in any case. Nothing when anything else stands in it or it fits in no double.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);
/// The whole of `text` as a decimal integer.
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view text);

/// Walks over the fields of a line, which white space parts.
class Fields {
public:
    explicit Fields(std::string_view line) : rest_(line) {}

    /// The next field; empty at the end of the line.
    std::string_view next();
    /// The next field as a number; nothing at the end and for any other text.
    std::optional<double> next_number() { return parse_number(next()); }
    std::optional<std::int64_t> next_integer() { return parse_integer(next()); }
    /// What has not been read yet.
    [[nodiscard]] std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
};

/// With the small letters of ASCII for its capitals.
[[nodiscard]] std::string lower_case(std::string_view text);

/// A piece of a file as it may stand in a message: in quotes, short, and printable.
[[nodiscard]] std::string quote(std::string_view text);

}  // namespace quadcut::io
