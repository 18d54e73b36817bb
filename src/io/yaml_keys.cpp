// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/yaml_keys.hpp"

#include <cstddef>
#include <optional>

#include "io/fields.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {

const YamlNode* YamlKeys::find(std::string_view key) const {
    const YamlNode* found = nullptr;
    for (std::size_t i = 0; i + 1 < mapping_.items.size(); i += 2) {
        const YamlNode& candidate = mapping_.items[i];
        if (candidate.kind != YamlKind::scalar || candidate.text != key) continue;
        if (found != nullptr) {
            throw InputError(file_ + ": line " + std::to_string(candidate.line) + ": the key " +
                             quote(key) + " stands there a second time");
        }
        found = &mapping_.items[i + 1];
    }
    return found;
}

const YamlNode& YamlKeys::require(std::string_view key) const {
    const YamlNode* node = find(key);
    if (node == nullptr) {
        throw InputError(file_ + ": the key " + quote(key) + " is missing, expected it in " +
                         std::string(where_));
    }
    return *node;
}

double YamlKeys::number(std::string_view key) const {
    const YamlNode& node = require(key);
    const std::optional<double> value =
        node.kind == YamlKind::scalar ? parse_number(node.text) : std::nullopt;
    if (!value) fail(node, key, "a number");
    return *value;
}

std::int64_t YamlKeys::integer(std::string_view key, std::int64_t min, std::int64_t max) const {
    const YamlNode& node = require(key);
    const std::optional<std::int64_t> value =
        node.kind == YamlKind::scalar ? parse_integer(node.text) : std::nullopt;
    if (!value || *value < min || *value > max) {
        fail(node, key,
             "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    }
    return *value;
}

const std::string& YamlKeys::text(std::string_view key) const {
    const YamlNode& node = require(key);
    if (node.kind != YamlKind::scalar) fail(node, key, "a text");
    return node.text;
}

std::string YamlKeys::place(const YamlNode& node, std::string_view key) const {
    return file_ + ": line " + std::to_string(node.line) + ": " + std::string(key) + ": ";
}

void YamlKeys::fail(const YamlNode& node, std::string_view key, const std::string& expected) const {
    throw InputError(place(node, key) + "expected " + expected + ", found " +
                     (node.kind == YamlKind::scalar  ? quote(node.text)
                      : node.kind == YamlKind::alias ? "an alias"
                                                     : "a list or a mapping"));
}

}  // namespace quadcut::io
