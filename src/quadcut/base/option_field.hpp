// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace quadcut {

/// A choice among words; `value` is the index of the one that is set.
struct Choice {
    std::uint8_t* value = nullptr;
    std::vector<std::string_view> words;
};

/// The enumerators' order is the words' order.
template <typename Enum>
Choice choice(Enum& value, std::vector<std::string_view> words) {
    static_assert(std::is_same_v<std::underlying_type_t<Enum>, std::uint8_t>);
    return {reinterpret_cast<std::uint8_t*>(&value), std::move(words)};
}

/// A count, or one of the words that stand for certain values, within the range or not.
struct CountOrWord {
    std::size_t* value = nullptr;
    std::vector<std::pair<std::string_view, std::size_t>> words;
};

/// What an option decides: the result, or only how the work is done.
enum class Decides : std::uint8_t { result, run };

/// One option of a stage: where its value lives, and all that is said about it anywhere: on the
/// command line, in files, in docs/options.md. The default is the value in the options struct.
struct OptionField {
    std::string_view name;
    /// "m", "m^2", "1/m^2", "rad", or empty for a pure number.
    std::string_view unit;
    /// Smallest and largest value allowed (numbers only).
    double low = 0.0;
    double high = 0.0;
    /// One line.
    std::string_view text;
    /// The equation or item of the paper that it belongs to; may be empty.
    std::string_view source;
    std::variant<double*, std::size_t*, int*, Choice, CountOrWord> value;
    Decides decides = Decides::result;
};

/// The fields of options of one or more stages, in this order, by their add_fields(). Bound to
/// their members, which must outlive the list.
template <typename... Options>
[[nodiscard]] std::vector<OptionField> option_fields(Options&... options) {
    std::vector<OptionField> fields;
    (add_fields(options, fields), ...);
    return fields;
}

}  // namespace quadcut
