// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace quadcut::io {

/// A YAML that describes one thing is not longer.
inline constexpr std::size_t kMaxYamlBytes = std::size_t{1} << 20U;

enum class YamlKind { none, scalar, list, mapping, alias };

/// A node of a YAML text.
struct YamlNode {
    YamlKind kind = YamlKind::none;
    std::string text;             ///< of a scalar
    std::vector<YamlNode> items;  ///< of a list; of a mapping key, value, key, value, ...
    std::uint64_t line = 0;       ///< 1, 2, ...
};

/// The first document of a YAML text; kind none when there is none. Aliases are not resolved, so
/// there are no more nodes than bytes. Throws InputError with the line when the text is no YAML,
/// is longer than `max_bytes`, or nests deeper than 32 levels.
[[nodiscard]] YamlNode parse_yaml(std::string_view bytes, const std::string& name,
                                  std::size_t max_bytes = kMaxYamlBytes);

}  // namespace quadcut::io
