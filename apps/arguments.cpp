// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/arguments.hpp"

#include <algorithm>
#include <stdexcept>

#include "apps/option_help.hpp"
#include "io/option_text.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kHelpColumn = 24;
constexpr std::size_t kHelpWidth = 100;

/// A word of the command line that is a flag, split at its first '='.
struct FlagWord {
    std::string name;
    std::optional<std::string> value;
};

FlagWord split_flag(const std::string& word) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) return {word, std::nullopt};
    return {word.substr(0, equals), word.substr(equals + 1)};
}

const Flag* find_flag(const CommandForm& form, const std::string& name) {
    for (const Flag& flag : form.flags) {
        if (flag.name == name || (!flag.short_name.empty() && flag.short_name == name)) {
            return &flag;
        }
    }
    return nullptr;
}

/// Words that cannot be the value of a flag: other flags. A negative number can.
bool is_value(const CommandForm& form, const std::string& word) {
    return word.rfind("--", 0) != 0 && find_flag(form, word) == nullptr;
}

/// A dash before something that is no number.
bool is_flag(const CommandForm& form, const std::string& word) {
    if (word.size() < 2 || word[0] != '-') return false;
    const bool is_number = (word[1] >= '0' && word[1] <= '9') || word[1] == '.';
    return !is_number || find_flag(form, word) != nullptr;
}

[[noreturn]] void reject_flag(const CommandForm& form, const std::string& name) {
    const auto& planned = form.planned_flags;
    if (std::find(planned.begin(), planned.end(), name) != planned.end()) {
        throw InputError("option " + name + ": not in this version of quadcut");
    }
    std::vector<std::string_view> known{kHelpFlag};
    for (const Flag& flag : form.flags) {
        known.push_back(flag.name);
        if (!flag.short_name.empty()) known.push_back(flag.short_name);
    }
    const std::string_view nearest = io::nearest_word(name, known);
    throw InputError("unknown option '" + name + "'" +
                     (nearest.empty() ? "; 'quadcut " + form.name + " --help' lists the options"
                                      : ": did you mean '" + std::string(nearest) + "'?"));
}

void check_operands(const CommandForm& form, const std::vector<std::string>& operands) {
    const std::size_t least = form.operands.size() - form.num_optional;
    if (operands.size() > form.operands.size()) {
        throw InputError("unexpected '" + operands[form.operands.size()] +
                         "'; usage: " + usage_of(form));
    }
    if (operands.size() < least) {
        throw InputError("missing " + form.operands[operands.size()] +
                         "; usage: " + usage_of(form));
    }
}

/// The shortest way to write a flag with its value: "-o DIR".
std::string short_form(const Flag& flag) {
    return (flag.short_name.empty() ? flag.name : flag.short_name) +
           (flag.value.empty() ? "" : " " + flag.value);
}

void check_required(const CommandForm& form, const Arguments& arguments) {
    for (const Flag& flag : form.flags) {
        if (flag.is_required && !arguments.has(flag.name)) {
            throw InputError("missing " + short_form(flag) + "; usage: " + usage_of(form));
        }
    }
}

/// Appends `text`, broken between words, in the right-hand column of the help.
void append_column(std::string& help, std::string_view text) {
    std::size_t column = kHelpColumn;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(' '), text.size());
        if (column > kHelpColumn && column + 1 + length > kHelpWidth) {
            help += '\n' + std::string(kHelpColumn, ' ');
            column = kHelpColumn;
        } else if (column > kHelpColumn) {
            help += ' ';
            ++column;
        }
        help += text.substr(0, length);
        column += length;
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    help += '\n';
}

void append_flag(std::string& help, const Flag& flag) {
    std::string left = "  " + (flag.short_name.empty() ? "" : flag.short_name + ", ") + flag.name +
                       (flag.value.empty() ? "" : " " + flag.value);
    if (left.size() + 1 > kHelpColumn) {
        left += '\n' + std::string(kHelpColumn, ' ');
    } else {
        left.resize(kHelpColumn, ' ');
    }
    help += left;
    append_column(help, flag.text);
}

}  // namespace

bool Arguments::has(std::string_view flag) const { return value(flag).has_value(); }

std::optional<std::string> Arguments::value(std::string_view flag) const {
    for (const auto& [name, text] : flags) {
        if (name == flag) return text;
    }
    return std::nullopt;
}

Arguments parse_arguments(const CommandForm& form, std::span<const std::string> words) {
    Arguments arguments;
    bool only_operands = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (only_operands || !is_flag(form, word)) {
            arguments.operands.push_back(word);
            continue;
        }
        if (word == "--") {
            only_operands = true;
            continue;
        }
        if (word == kHelpFlag || word == "-h") {
            arguments.flags = {{std::string(kHelpFlag), ""}};
            return arguments;
        }
        const FlagWord given = split_flag(word);
        const Flag* flag = find_flag(form, given.name);
        if (flag == nullptr) reject_flag(form, given.name);
        if (flag->name != kSetFlag && arguments.has(flag->name)) {
            throw InputError("option " + given.name + ": given twice");
        }
        if (flag->value.empty()) {
            if (given.value) throw InputError("option " + given.name + ": takes no value");
            arguments.flags.emplace_back(flag->name, "");
            continue;
        }
        std::string value;
        if (given.value) {
            value = *given.value;
        } else if (i + 1 < words.size() && is_value(form, words[i + 1])) {
            value = words[++i];
        }
        if (value.empty()) throw InputError("option " + given.name + ": expected " + flag->value);
        arguments.flags.emplace_back(flag->name, value);
    }
    check_operands(form, arguments.operands);
    check_required(form, arguments);
    return arguments;
}

Flag flag_of(const OptionField& field, std::string_view value) {
    std::string name = "--" + std::string(field.name);
    std::replace(name.begin(), name.end(), '_', '-');
    return {name, "", std::string(value), std::string(field.text) + " (" + facts_of(field) + ")"};
}

Flag flag_of(const std::vector<OptionField>& fields, std::string_view name,
             std::string_view value) {
    for (const OptionField& field : fields) {
        if (field.name == name) return flag_of(field, value);
    }
    throw std::logic_error("no option field '" + std::string(name) + "'");
}

void set_fields(const Arguments& arguments, const std::vector<OptionField>& fields) {
    std::vector<std::string> done;
    const auto set_once = [&](const std::string& name, const std::string& value) {
        if (std::find(done.begin(), done.end(), name) != done.end()) {
            throw InputError("option " + name + ": given twice");
        }
        io::set_option(fields, name, value);
        done.push_back(name);
    };
    for (const auto& [flag, value] : arguments.flags) {
        if (flag == kSetFlag) {
            const FlagWord setting = split_flag(value);
            if (!setting.value) {
                throw InputError("option --set: '" + value + "': expected NAME=VALUE");
            }
            set_once(setting.name, *setting.value);
            continue;
        }
        std::string name = flag.substr(2);
        std::replace(name.begin(), name.end(), '-', '_');
        const auto named = [&name](const OptionField& field) { return field.name == name; };
        if (std::any_of(fields.begin(), fields.end(), named)) set_once(name, value);
    }
}

std::string usage_of(const CommandForm& form) {
    std::string usage = "quadcut " + form.name;
    for (std::size_t i = 0; i < form.operands.size(); ++i) {
        const bool is_optional = i + form.num_optional >= form.operands.size();
        usage += is_optional ? " [" + form.operands[i] + "]" : " " + form.operands[i];
    }
    bool has_optional = false;
    for (const Flag& flag : form.flags) {
        if (flag.is_required) usage += " " + short_form(flag);
        has_optional = has_optional || !flag.is_required;
    }
    return has_optional ? usage + " [options]" : usage;
}

std::string help_of(const CommandForm& form) {
    std::string help = usage_of(form) + "\n" + form.text + "\n";
    if (!form.flags.empty()) help += "\n";
    for (const Flag& flag : form.flags) append_flag(help, flag);
    return help;
}

}  // namespace quadcut
