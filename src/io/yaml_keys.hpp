// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/yaml.hpp"

namespace quadcut::io {

/// Reads the values of a mapping by their keys. All that it throws is InputError that names the
/// file, the line, the key and what was expected.
class YamlKeys {
public:
    /// `file` and `where` ("a map_server YAML") stand in messages. All three are referred to.
    /// @pre mapping.kind is mapping.
    YamlKeys(const YamlNode& mapping, const std::string& file, std::string_view where)
        : mapping_(mapping), file_(file), where_(where) {}

    /// Null when the key is not there. Throws when it is there twice.
    [[nodiscard]] const YamlNode* find(std::string_view key) const;
    /// Throws when the key is not there.
    [[nodiscard]] const YamlNode& require(std::string_view key) const;
    [[nodiscard]] double number(std::string_view key) const;
    /// A whole number in min .. max.
    [[nodiscard]] std::int64_t integer(std::string_view key, std::int64_t min,
                                       std::int64_t max) const;
    /// A scalar, as it is.
    [[nodiscard]] const std::string& text(std::string_view key) const;

    /// "map.yaml: line 3: origin: ".
    [[nodiscard]] std::string place(const YamlNode& node, std::string_view key) const;
    /// What was expected instead of the node.
    [[noreturn]] void fail(const YamlNode& node, std::string_view key,
                           const std::string& expected) const;

private:
    const YamlNode& mapping_;
    const std::string& file_;
    std::string_view where_;
};

}  // namespace quadcut::io
