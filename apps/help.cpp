// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/help.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "io/option_text.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kTextColumn = 12;
constexpr std::array<std::string_view, 4> kPlannedCommands{"export", "serve", "ros2", "batch"};

}  // namespace

std::vector<Command> commands() {
    return {segment_command(),   map_command(),     follow_command(),   locate_command(),
            edit_command(),      score_command(),   simulate_command(), demo_command(),
            reproduce_command(), options_command(), version_command()};
}

std::string help_text() {
    std::string help = "quadcut cuts the map of a robot into rooms and finds the doors.\n\n";
    for (const Command& command : commands()) {
        std::string name = "  " + command.form.name;
        name.resize(kTextColumn, ' ');
        help += name + command.form.text + "\n";
    }
    return help +
           "\nquadcut COMMAND --help says what a command takes.\n"
           "Exit codes: 0 done, 1 locate: the point is in no room, 2 bad input, 3 internal "
           "error.\n";
}

Command find_command(std::string_view name) {
    std::vector<std::string_view> known{"help"};
    const std::vector<Command> all = commands();
    for (const Command& command : all) {
        if (command.form.name == name) return command;
        known.emplace_back(command.form.name);
    }
    if (std::find(kPlannedCommands.begin(), kPlannedCommands.end(), name) !=
        kPlannedCommands.end()) {
        throw InputError("'" + std::string(name) + "': not in this version of quadcut");
    }
    const std::string_view nearest = io::nearest_word(name, known);
    throw InputError("unknown command '" + std::string(name) + "'" +
                     (nearest.empty() ? "; 'quadcut help' lists the commands"
                                      : ": did you mean '" + std::string(nearest) + "'?"));
}

}  // namespace quadcut
