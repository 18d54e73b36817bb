// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/help.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/command_line.hpp"
#include "io/found_instead.hpp"
#include "io/nearest_word.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kTextColumn = 12;
constexpr std::array<std::string_view, 3> kPlannedCommands{"serve", "ros2", "batch"};

/// Other words for commands.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kOtherWords{
    {{"cut", "segment"},
     {"explain", "why"},
     {"partition", "segment"},
     {"track", "follow"},
     {"watch", "follow"},
     {"where", "locate"},
     {"path", "route"},
     {"navigate", "route"},
     {"generate", "simulate"},
     {"evaluate", "score"},
     {"compare", "score"},
     {"settings", "options"}}};

bool is_command(std::string_view word) {
    const std::vector<Command> all = commands();
    return word == "help" || std::any_of(all.begin(), all.end(), [word](const Command& command) {
               return command.form.name == word;
           });
}

bool is_planned(std::string_view word) {
    return std::find(kPlannedCommands.begin(), kPlannedCommands.end(), word) !=
           kPlannedCommands.end();
}

bool is_action(std::string_view word) {
    const std::vector<std::string> actions = edit_command().form.actions;
    return std::find(actions.begin(), actions.end(), word) != actions.end();
}

bool is_file(const std::string& word) {
    std::error_code error;
    return std::filesystem::exists(word, error);
}

/// Also one that is not there.
bool is_like_file(const std::string& word) {
    return word.find_first_of("./") != std::string::npos || is_file(word);
}

/// Words whose first is no command's name misspelled, but a file or a flag that stands too early.
bool is_out_of_order(std::span<const std::string> words) {
    const std::string& first = words[0];
    if (first.rfind('-', 0) == 0) {
        return find_flag(segment_command().form, split_setting(first).name) != nullptr ||
               std::any_of(words.begin() + 1, words.end(), is_command);
    }
    return is_like_file(first);
}

/// The first command among the words that can be no flag's value, or else the first at all.
std::span<const std::string>::iterator find_command_in(std::span<const std::string> words) {
    const auto is_free = [&](const std::string& word) {
        const auto at = static_cast<std::size_t>(&word - words.data());
        return is_command(word) && (at == 0 || words[at - 1].rfind('-', 0) != 0);
    };
    const auto found = std::find_if(words.begin(), words.end(), is_free);
    return found != words.end() ? found : std::find_if(words.begin(), words.end(), is_command);
}

/// What has rooms already.
bool is_result(const std::string& word) {
    std::error_code error;
    return std::filesystem::is_directory(word, error) || io::is_project(word);
}

/// The command that is missing before the words: what most people want of a map or a log.
std::string with_command(std::span<const std::string> words) {
    std::vector<std::string> all{"segment"};
    all.insert(all.end(), words.begin(), words.end());
    if (is_command("rooms") && is_result(words[0])) {
        all[0] = "rooms";
        return command_line(all);
    }
    const auto is_output = [](const std::string& word) {
        return word.rfind("-o", 0) == 0 || word.rfind("--output", 0) == 0;
    };
    if (std::none_of(words.begin(), words.end(), is_output)) {
        all.insert(all.end(), {"-o", "rooms"});
    }
    return command_line(all);
}

/// The words with their command in front.
std::string in_order(std::span<const std::string> words) {
    const auto found = find_command_in(words);
    if (found == words.end()) return with_command(words);
    std::vector<std::string> ordered{*found};
    ordered.insert(ordered.end(), words.begin(), found);
    ordered.insert(ordered.end(), found + 1, words.end());
    return command_line(ordered);
}

/// `rename PROJECT ...` as edit takes it.
std::string as_edit(std::span<const std::string> words) {
    if (words.size() < 2 || !is_like_file(words[1])) {
        return "quadcut edit PROJECT " + words[0] + " ...";
    }
    std::vector<std::string> ordered{"edit", words[1], words[0]};
    ordered.insert(ordered.end(), words.begin() + 2, words.end());
    return command_line(ordered);
}

/// Two commands in one line, and edit's action before its project.
void check_order(std::span<const std::string> words) {
    const auto rest = words.subspan(1);
    if (rest.size() < 2 || rest[1].rfind('-', 0) == 0 || is_file(rest[0])) return;
    if (words[0] == "edit" && is_action(rest[0]) && !is_action(rest[1])) {
        throw InputError("edit: '" + rest[0] +
                         "': expected the project first: " + io::did_you_mean({as_edit(rest)}));
    }
    if (words[0] != "help" && is_command(rest[0])) {
        throw InputError("'" + rest[0] + "': a command after the command " + words[0] + ": " +
                         io::did_you_mean({command_line(rest)}));
    }
}

}  // namespace

std::vector<Command> commands() {
    return {segment_command(),   map_command(),     follow_command(),   rooms_command(),
            locate_command(),    why_command(),     route_command(),    edit_command(),
            export_command(),    score_command(),   simulate_command(), demo_command(),
            reproduce_command(), options_command(), version_command()};
}

std::string help_text() {
    std::string help =
        "quadcut cuts the map of a robot into rooms and finds the doors. Mostly:\n\n"
        "  quadcut segment map.yaml -o rooms\n\n";
    for (const Command& command : commands()) {
        std::string name = "  " + command.form.name;
        name.resize(kTextColumn, ' ');
        help += name + command.form.text + "\n";
    }
    return help +
           "\nquadcut COMMAND --help says what a command takes, with examples.\n"
           "Exit codes: 0 done, 1 locate: the point is in no room, route: there is no way, 2 bad "
           "input, 3 internal error.\n";
}

Command find_command(std::string_view name) {
    std::vector<std::string_view> known{"help"};
    const std::vector<Command> all = commands();
    for (const Command& command : all) {
        if (command.form.name == name) return command;
        known.emplace_back(command.form.name);
    }
    if (is_planned(name)) {
        throw InputError("'" + std::string(name) + "': not in this version of quadcut");
    }
    std::string_view meant = name;
    for (const auto& [other, command] : kOtherWords) {
        if (name == other) meant = command;
    }
    throw InputError("unknown command '" + std::string(name) + "'" +
                     io::suggestion(meant, known, "; 'quadcut help' lists the commands"));
}

Command command_of(std::span<const std::string> words) {
    if (is_command(words[0])) {
        check_order(words);
    } else if (is_planned(words[0])) {
        return find_command(words[0]);
    } else if (is_action(words[0]) && !is_file(words[0])) {
        throw InputError("unknown command '" + words[0] +
                         "': " + io::did_you_mean({as_edit(words)}));
    } else if (is_out_of_order(words)) {
        throw InputError("'" + words[0] +
                         "': expected a command first: " + io::did_you_mean({in_order(words)}));
    }
    return find_command(words[0]);
}

}  // namespace quadcut
