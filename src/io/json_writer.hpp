// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/number_text.hpp"

namespace quadcut::io {

/// How the members of an object or array are set: all on one line, or each on its own.
enum class JsonLayout : std::uint8_t { one_line, lines };

/// A JSON text in double quotes. Bytes that are no UTF-8 become U+FFFD. It is valid YAML, too.
[[nodiscard]] std::string json_text(std::string_view text);

/// Writes JSON from the first byte to the last: commas, quotes and indents are its own business,
/// what goes where is the caller's. Faster than building a tree, and its layout can be read.
class JsonWriter {
public:
    JsonWriter& begin_object(JsonLayout layout = JsonLayout::one_line);
    JsonWriter& end_object();
    JsonWriter& begin_array(JsonLayout layout = JsonLayout::one_line);
    JsonWriter& end_array();
    JsonWriter& key(std::string_view name);

    JsonWriter& text(std::string_view value);
    JsonWriter& integer(std::uint64_t value);
    JsonWriter& boolean(bool value);
    JsonWriter& null();
    /// A value that is JSON already, as it stands.
    JsonWriter& verbatim(std::string_view json);
    /// As append_rounded.
    JsonWriter& number(double value, int max_decimals = kMillimetreDecimals);
    /// As append_exact, but null if not finite.
    JsonWriter& exact_number(double value);

    /// The whole text with a line end. @pre all that was begun has ended.
    [[nodiscard]] std::string finish();

private:
    struct Level {
        JsonLayout layout = JsonLayout::one_line;
        bool empty = true;
    };

    void before_value();
    void next_member();
    void end(char bracket);

    std::string text_;
    std::vector<Level> levels_;
    bool after_key_ = false;
};

}  // namespace quadcut::io
