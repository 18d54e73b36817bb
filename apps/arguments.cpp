// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/arguments.hpp"

#include <algorithm>
#include <stdexcept>

#include "apps/misunderstanding.hpp"
#include "apps/option_help.hpp"
#include "io/nearest_word.hpp"
#include "io/option_text.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

/// Words that cannot be the value of a flag: other flags. A negative number can.
bool is_value(const CommandForm& form, const std::string& word) {
    return word.rfind("--", 0) != 0 && find_flag(form, word) == nullptr;
}

/// A dash before something that is no number; also one that a word processor made longer.
bool is_flag(const CommandForm& form, const std::string& word) {
    if (io::has_long_dash(word)) return true;
    if (word.size() < 2 || word[0] != '-') return false;
    const bool is_number = (word[1] >= '0' && word[1] <= '9') || word[1] == '.';
    return !is_number || find_flag(form, word) != nullptr;
}

}  // namespace

const Flag* find_flag(const CommandForm& form, std::string_view name) {
    for (const Flag& flag : form.flags) {
        if (flag.name == name || (!flag.short_name.empty() && flag.short_name == name)) {
            return &flag;
        }
    }
    return nullptr;
}

Setting split_setting(const std::string& word) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) return {word, std::nullopt};
    return {word.substr(0, equals), word.substr(equals + 1)};
}

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
        const Setting given = split_setting(word);
        const std::string next = i + 1 < words.size() ? words[i + 1] : "";
        const Flag* flag = find_flag(form, given.name);
        if (flag == nullptr) throw unknown_flag(form, given, next);
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
        } else if (i + 1 < words.size() && is_value(form, next)) {
            value = next;
            ++i;
        }
        if (value.empty()) throw InputError("option " + given.name + ": expected " + flag->value);
        if (flag->name == kSetFlag)
            check_setting(form, value, i + 1 < words.size() ? words[i + 1] : "");
        arguments.flags.emplace_back(flag->name, value);
    }
    check_operands(form, arguments, words);
    check_required(form, arguments, words);
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

std::vector<std::string> names_of(const std::vector<OptionField>& fields) {
    std::vector<std::string> names;
    for (const OptionField& field : fields) names.emplace_back(field.name);
    return names;
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
            const Setting setting = split_setting(value);
            set_once(setting.name, setting.value.value_or(""));
            continue;
        }
        std::string name = flag.substr(2);
        std::replace(name.begin(), name.end(), '-', '_');
        const auto named = [&name](const OptionField& field) { return field.name == name; };
        if (std::any_of(fields.begin(), fields.end(), named)) set_once(name, value);
    }
}

}  // namespace quadcut
