// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "quadcut/base/option_field.hpp"

namespace quadcut {

/// One flag of a command, as its help shows it.
struct Flag {
    /// With its dashes: "--resolution".
    std::string name;
    /// Another way to write it, "-o"; mostly empty.
    std::string short_name;
    /// What stands for its value in the help; empty for a switch.
    std::string value;
    std::string text;
    bool is_required = false;
};

/// What a command takes.
struct CommandForm {
    std::string name;
    /// What it does, one line.
    std::string text;
    std::vector<std::string> operands;
    /// How many of the last operands may be left out.
    std::size_t num_optional = 0;
    /// The words of which the second operand is one, where it is a verb.
    std::vector<std::string> actions;
    std::vector<Flag> flags;
    /// The options that --set takes, by name.
    std::vector<std::string> settings;
    /// Command lines for the end of its help, at least two: they can be run as they are, in this
    /// order, where `quadcut demo -o build/demo` was run before.
    std::vector<std::string> examples;
    /// Flags that the command is to have in a later version.
    std::vector<std::string> planned_flags;
};

/// What was given on the command line.
struct Arguments {
    std::vector<std::string> operands;
    /// Flags by their name in the form, in the order given; a switch has an empty value.
    std::vector<std::pair<std::string, std::string>> flags;

    [[nodiscard]] bool has(std::string_view flag) const;
    [[nodiscard]] std::optional<std::string> value(std::string_view flag) const;
};

/// NAME=VALUE: a word, split at its first '='.
struct Setting {
    std::string name;
    std::optional<std::string> value;
};

[[nodiscard]] Setting split_setting(const std::string& word);

/// The flag of that name, long or short; null if there is none.
[[nodiscard]] const Flag* find_flag(const CommandForm& form, std::string_view name);

/// The switch that every command has.
inline constexpr std::string_view kHelpFlag = "--help";
/// The flag that may be repeated: `--set name=value`, for options without a flag of their own.
inline constexpr std::string_view kSetFlag = "--set";

/// Sorts the words after the command's name. `--name value` and `--name=value` are the same; a
/// value may begin with a dash, but not be a flag; negative numbers and all after `--` are
/// operands. With --help (-h) nothing else is checked. Throws InputError for an unknown flag, a
/// planned one, a repeated one, a missing or superfluous value, an unknown name after --set, a
/// required flag that is not there, and the wrong number of operands; it says what was probably
/// meant.
[[nodiscard]] Arguments parse_arguments(const CommandForm& form,
                                        std::span<const std::string> words);

/// The flag that sets a field: "--door-width" for door_width; its text says unit, range, default.
[[nodiscard]] Flag flag_of(const OptionField& field, std::string_view value);
/// The same for the field of the given name. @pre there is one.
[[nodiscard]] Flag flag_of(const std::vector<OptionField>& fields, std::string_view name,
                           std::string_view value);

/// The names of all of them.
[[nodiscard]] std::vector<std::string> names_of(const std::vector<OptionField>& fields);

/// Sets the fields whose flags, or whose names after --set, are among the arguments. Throws
/// InputError as io::set_option does, and for a field that is set twice.
void set_fields(const Arguments& arguments, const std::vector<OptionField>& fields);

}  // namespace quadcut
