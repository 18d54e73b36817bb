// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/json_writer.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "io/utf8.hpp"

namespace quadcut::io {
namespace {

/// JSON would let most of these stand; YAML, which takes our texts too, does not.
bool needs_escape(char32_t code_point) {
    return code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0) || code_point == 0xFFFE ||
           code_point == 0xFFFF;
}

void append_escaped(std::string& out, char32_t code_point) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    if (code_point == U'"' || code_point == U'\\') {
        out += '\\';
        out += static_cast<char>(code_point);
    } else if (needs_escape(code_point)) {
        out += "\\u";
        for (const unsigned shift : {12U, 8U, 4U, 0U}) out += kDigits[(code_point >> shift) & 15U];
    } else {
        append_utf8(out, code_point);
    }
}

}  // namespace

std::string json_text(std::string_view text) {
    std::string result = "\"";
    for (const char32_t code_point : decode_utf8(text)) append_escaped(result, code_point);
    result += '"';
    return result;
}

void JsonWriter::next_member() {
    if (levels_.empty()) return;
    Level& level = levels_.back();
    if (!level.empty) text_ += level.layout == JsonLayout::lines ? "," : ", ";
    if (level.layout == JsonLayout::lines) {
        text_ += '\n';
        text_.append(levels_.size(), ' ');
    }
    level.empty = false;
}

void JsonWriter::before_value() {
    if (!after_key_) next_member();
    after_key_ = false;
}

void JsonWriter::end(char bracket) {
    if (levels_.empty() || after_key_) throw std::logic_error("JsonWriter: nothing to end here");
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.layout == JsonLayout::lines && !level.empty) {
        text_ += '\n';
        text_.append(levels_.size(), ' ');
    }
    text_ += bracket;
}

JsonWriter& JsonWriter::begin_object(JsonLayout layout) {
    before_value();
    text_ += '{';
    levels_.push_back({layout, true});
    return *this;
}

JsonWriter& JsonWriter::end_object() {
    end('}');
    return *this;
}

JsonWriter& JsonWriter::begin_array(JsonLayout layout) {
    before_value();
    text_ += '[';
    levels_.push_back({layout, true});
    return *this;
}

JsonWriter& JsonWriter::end_array() {
    end(']');
    return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
    next_member();
    text_ += json_text(name);
    text_ += ": ";
    after_key_ = true;
    return *this;
}

JsonWriter& JsonWriter::text(std::string_view value) {
    before_value();
    text_ += json_text(value);
    return *this;
}

JsonWriter& JsonWriter::integer(std::uint64_t value) {
    before_value();
    text_ += std::to_string(value);
    return *this;
}

JsonWriter& JsonWriter::boolean(bool value) {
    before_value();
    text_ += value ? "true" : "false";
    return *this;
}

JsonWriter& JsonWriter::null() {
    before_value();
    text_ += "null";
    return *this;
}

JsonWriter& JsonWriter::verbatim(std::string_view json) {
    before_value();
    text_ += json;
    return *this;
}

JsonWriter& JsonWriter::number(double value, int max_decimals) {
    before_value();
    append_rounded(text_, value, max_decimals);
    return *this;
}

JsonWriter& JsonWriter::exact_number(double value) {
    before_value();
    if (std::isfinite(value)) {
        append_exact(text_, value);
    } else {
        text_ += "null";
    }
    return *this;
}

std::string JsonWriter::finish() {
    if (!levels_.empty() || after_key_)
        throw std::logic_error("JsonWriter: something is still open");
    text_ += '\n';
    return std::exchange(text_, {});
}

}  // namespace quadcut::io
