// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/misunderstanding.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/command.hpp"
#include "apps/command_help.hpp"
#include "apps/command_line.hpp"
#include "io/nearest_word.hpp"

namespace quadcut {
namespace {

/// What other programs call flags of ours.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kOtherWords{
    {{"--dir", "--output"},
     {"--directory", "--output"},
     {"--folder", "--output"},
     {"--out-dir", "--output"},
     {"--outdir", "--output"},
     {"--destination", "--output"},
     {"--cell-size", "--resolution"},
     {"--jobs", "--threads"},
     {"--gpu", "--device"},
     {"--cpu", "--device"},
     {"--no-progress", "--quiet"},
     {"--silent", "--quiet"}}};

/// What stands for a folder in a command line that is suggested.
constexpr const char* kSomeFolder = "rooms";

/// The value that was given, or the next word when it may be meant.
std::string value_of(const Setting& given, const std::string& next) {
    if (given.value && !given.value->empty()) return *given.value;
    constexpr std::string_view kNumber = "-.0123456789";
    constexpr std::string_view kWord = "abcdefghijklmnopqrstuvwxyz_";
    const bool is_number = next.find_first_not_of(kNumber) == std::string::npos;
    const bool is_word = next.find_first_not_of(kWord) == std::string::npos;
    return !next.empty() && (is_number || is_word) ? next : "X";
}

/// A flag by its name or another word for it, or an option, as it is written.
std::string written(const CommandForm& form, std::string_view name, const std::string& value) {
    for (const auto& [other, flag] : kOtherWords) {
        if (name == other) name = flag;
    }
    if (const Flag* flag = find_flag(form, name)) return short_form(*flag);
    if (name == kHelpFlag) return std::string(name);
    return std::string(kSetFlag) + " " + std::string(name) + "=" + value;
}

std::vector<std::string_view> known_names(const CommandForm& form) {
    std::vector<std::string_view> known;
    for (const Flag& flag : form.flags) {
        known.push_back(flag.name);
        if (!flag.short_name.empty()) known.push_back(flag.short_name);
    }
    for (const auto& [other, flag] : kOtherWords) {
        if (find_flag(form, flag) != nullptr) known.push_back(other);
    }
    known.push_back(kHelpFlag);
    known.insert(known.end(), form.settings.begin(), form.settings.end());
    return known;
}

/// The flags and options that are meant by a name that is none, as they are written.
std::vector<std::string> meant_by(const CommandForm& form, const std::string& name,
                                  const std::string& value) {
    std::vector<std::string> meant;
    for (const std::string_view near : io::nearest_words(name, known_names(form))) {
        // An option that has a flag of its own is known twice.
        std::string own = "--" + std::string(near);
        std::replace(own.begin(), own.end(), '_', '-');
        const bool has_flag = find_flag(form, own) != nullptr;
        const std::string text = written(form, has_flag ? own : near, value);
        if (std::find(meant.begin(), meant.end(), text) == meant.end()) meant.push_back(text);
    }
    // "-orooms"
    const Flag* flag = find_flag(form, name.substr(0, 2));
    if (meant.empty() && flag != nullptr && !flag->value.empty()) {
        meant.push_back(name.substr(0, 2) + " " + name.substr(2));
    }
    return meant;
}

/// Whether --set takes what here looks like a flag of its own.
bool is_setting(const CommandForm& form, const std::string& flag) {
    std::string name = flag.substr(std::min(flag.find_first_not_of('-'), flag.size()));
    std::replace(name.begin(), name.end(), '-', '_');
    return std::find(form.settings.begin(), form.settings.end(), name) != form.settings.end();
}

/// Whose flag, or whose option after --set, it is: the first such command. Nothing if it is none's.
std::optional<InputError> has_other_owner(const CommandForm& form, const std::string& name) {
    for (const Command& command : commands()) {
        const auto& settings = command.form.settings;
        const bool is_setting = std::find(settings.begin(), settings.end(), name) != settings.end();
        if (!is_setting && find_flag(command.form, name) == nullptr) continue;
        return InputError("unknown option '" + name + "': " + command.form.name + " has it, not " +
                          form.name);
    }
    return std::nullopt;
}

std::string suggestion(const std::vector<std::string>& meant, const std::string& otherwise) {
    return meant.empty() ? "; " + otherwise : ": " + io::did_you_mean(meant);
}

/// The words as a command line, with the output folder that is missing in them.
std::string with_output(const CommandForm& form, std::span<const std::string> words,
                        const std::string& folder) {
    std::vector<std::string> all{form.name};
    all.insert(all.end(), words.begin(), words.end());
    all.insert(all.end(), {"-o", folder});
    return command_line(all);
}

[[noreturn]] void reject_operand(const CommandForm& form, const Arguments& arguments,
                                 std::span<const std::string> words) {
    const std::size_t most = form.operands.size();
    const std::string& first = arguments.operands[most];
    const Setting setting = split_setting(first);
    const auto meant =
        setting.value ? meant_by(form, setting.name, *setting.value) : std::vector<std::string>();
    if (!meant.empty()) throw InputError("unexpected '" + first + "': " + io::did_you_mean(meant));
    std::error_code error;
    const bool is_file = std::filesystem::is_regular_file(first, error);
    const bool takes_folder =
        !is_file && find_flag(form, "-o") != nullptr && !arguments.has("--output");
    if (takes_folder && arguments.operands.size() == most + 1) {
        std::vector<std::string> others(words.begin(), words.end());
        others.erase(std::find(others.rbegin(), others.rend(), first).base() - 1);
        throw InputError("unexpected '" + first +
                         "': " + io::did_you_mean({with_output(form, others, first)}));
    }
    throw InputError(
        "unexpected '" + first + "'" +
        (most == 1 ? ": " + form.name + " takes one " + form.operands[0] + " at a time" : "") +
        "; usage: " + usage_of(form));
}

/// "X,Y" in two words, when the command then has all that it needs.
std::string without_commas(const CommandForm& form, const std::vector<std::string>& operands) {
    std::vector<std::string> words{form.name};
    for (const std::string& operand : operands) {
        const std::size_t comma = operand.find(',');
        words.push_back(operand.substr(0, comma));
        if (comma != std::string::npos) words.push_back(operand.substr(comma + 1));
    }
    return words.size() == form.operands.size() + 1 ? command_line(words) : "";
}

void check_action(const CommandForm& form, const std::string& word) {
    const std::vector<std::string_view> known(form.actions.begin(), form.actions.end());
    if (std::find(known.begin(), known.end(), word) != known.end()) return;
    throw InputError(form.name + ": '" + word + "': expected " + io::either_of(known) +
                     io::suggestion(word, known));
}

}  // namespace

InputError unknown_flag(const CommandForm& form, const Setting& given, const std::string& next) {
    const auto& planned = form.planned_flags;
    if (std::find(planned.begin(), planned.end(), given.name) != planned.end()) {
        return InputError("option " + given.name + ": not in this version of quadcut");
    }
    const auto owned = has_other_owner(form, given.name);
    if (owned && !is_setting(form, given.name)) return *owned;
    const auto meant = meant_by(form, given.name, value_of(given, next));
    return InputError("unknown option '" + given.name + "'" +
                      suggestion(meant, "'quadcut " + form.name + " --help' lists the options"));
}

void check_setting(const CommandForm& form, const std::string& value, const std::string& next) {
    const Setting setting = split_setting(value);
    const auto& known = form.settings;
    const bool is_known = std::find(known.begin(), known.end(), setting.name) != known.end();
    if (is_known && setting.value) return;
    const auto owned = has_other_owner(form, setting.name);
    if (owned && !is_known) throw InputError(*owned);
    const std::string shown = value_of(setting, next);
    const auto meant = is_known
                           ? std::vector{std::string(kSetFlag) + " " + setting.name + "=" + shown}
                           : meant_by(form, setting.name, shown);
    const std::string what = setting.value ? "unknown option '" + setting.name + "'"
                                           : "option --set: '" + value + "': expected NAME=VALUE";
    throw InputError(what + suggestion(meant, "'quadcut options' lists them"));
}

void check_operands(const CommandForm& form, const Arguments& arguments,
                    std::span<const std::string> words) {
    const std::size_t least = form.operands.size() - form.num_optional;
    const std::size_t count = arguments.operands.size();
    if (count > form.operands.size()) reject_operand(form, arguments, words);
    if (count < least) {
        const std::string meant = without_commas(form, arguments.operands);
        throw InputError(
            "missing " + form.operands[count] +
            (meant.empty() ? "; usage: " + usage_of(form) : ": " + io::did_you_mean({meant})));
    }
    if (!form.actions.empty() && count > 1) check_action(form, arguments.operands[1]);
}

void check_required(const CommandForm& form, const Arguments& arguments,
                    std::span<const std::string> words) {
    for (const Flag& flag : form.flags) {
        if (!flag.is_required || arguments.has(flag.name)) continue;
        const std::string what = "missing " + short_form(flag) + " (" + flag.text + ")";
        if (flag.short_name != "-o") throw InputError(what + "; usage: " + usage_of(form));
        throw InputError(what + ": for example '" + with_output(form, words, kSomeFolder) + "'");
    }
}

}  // namespace quadcut
