// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/command_help.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace quadcut {
namespace {

constexpr std::size_t kHelpColumn = 24;
constexpr std::size_t kHelpWidth = 100;
constexpr const char* kExamplesTitle = "\nExamples ('./run demo' makes build/demo):\n";

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

std::string short_form(const Flag& flag) {
    return (flag.short_name.empty() ? flag.name : flag.short_name) +
           (flag.value.empty() ? "" : " " + flag.value);
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
    if (!form.examples.empty()) help += kExamplesTitle;
    for (const std::string& example : form.examples) help += "  " + example + "\n";
    return help;
}

}  // namespace quadcut
