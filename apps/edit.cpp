// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "apps/command.hpp"
#include "apps/command_line.hpp"
#include "apps/numbers.hpp"
#include "apps/run_flags.hpp"
#include "apps/uninterrupted.hpp"
#include "io/file.hpp"
#include "io/json_writer.hpp"
#include "io/nearest_word.hpp"
#include "io/room_list.hpp"
#include "project/edit_text.hpp"
#include "project/project.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

/// What an action takes after its name.
struct Action {
    std::string_view name;
    std::size_t num_words;
    std::string_view words;
};
constexpr std::array<Action, 8> kActions{{{"rename", 2, "ROOM NAME"},
                                          {"merge", 2, "ROOM OTHER"},
                                          {"split", 4, "X1 Y1 X2 Y2"},
                                          {"lock", 1, "ROOM"},
                                          {"unlock", 1, "ROOM"},
                                          {"undo", 0, "nothing more"},
                                          {"redo", 0, "nothing more"},
                                          {"history", 0, "nothing more"}}};

std::vector<std::string_view> action_names() {
    std::vector<std::string_view> names;
    for (const Action& action : kActions) names.push_back(action.name);
    return names;
}

void check_words(const std::vector<std::string>& operands) {
    if (operands.size() < 2) {
        throw InputError("edit " + operands[0] +
                         ": expected an action: " + io::either_of(action_names()));
    }
    for (const Action& action : kActions) {
        if (action.name != operands[1]) continue;
        if (operands.size() == action.num_words + 2) return;
        throw InputError("edit PROJECT " + operands[1] + ": expected " + std::string(action.words));
    }
    throw std::logic_error("an action that no form has");
}

/// The edit that words ask for.
Edit edit_of(const std::vector<std::string>& operands, const Project& project) {
    const std::vector<std::string> words(operands.begin() + 2, operands.end());
    Edit edit;
    if (operands[1] == "split") {
        edit.kind = EditKind::split;
        edit.from = point_of(words[0], words[1]);
        edit.to = point_of(words[2], words[3]);
        return edit;
    }
    const std::shared_ptr<const Snapshot> building = project.snapshot();
    edit.room = building->find_room(words[0]);
    if (operands[1] == "rename") edit.name = words[1];
    if (operands[1] == "merge") {
        edit.kind = EditKind::merge;
        edit.other = building->find_room(words[1]);
    }
    if (operands[1] == "lock") edit.kind = EditKind::lock;
    if (operands[1] == "unlock") edit.kind = EditKind::unlock;
    return edit;
}

/// What was done, and the words that say so.
struct Done {
    EditRecord record;
    std::string story;
};

Done make(const std::vector<std::string>& operands, Project& project) {
    if (operands[1] == "undo") {
        const EditRecord undone = project.undo();
        return {undone, "undone: " + summary_of(undone.edit)};
    }
    if (operands[1] == "redo") {
        const EditRecord redone = project.redo();
        return {redone, "made again: " + summary_of(redone.edit)};
    }
    const EditRecord made = project.edit(edit_of(operands, project));
    return {made, story_of(made.edit)};
}

/// The edit, and the rooms and doors that there are after it.
void print_json(const EditRecord& record, const Segmentation& rooms) {
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    write_edit(json, record);
    io::write_rooms_and_doors(json, rooms);
    json.end_object();
    std::cout << json.finish();
}

/// Refuses what holds no edits, with the way to what does.
void require_project(const std::filesystem::path& path) {
    if (!std::filesystem::is_directory(path)) return;
    const bool is_result = std::filesystem::exists(path / "rooms.yaml");
    throw InputError(
        io::display_name(path) + ": is a folder" + (is_result ? " of results" : "") +
        ": expected a project file, which keeps what people change; 'quadcut follow LOG "
        "-o DIR --project FILE' makes one of a robot's log");
}

void run(const Arguments& arguments) {
    const std::vector<std::string>& operands = arguments.operands;
    require_project(operands[0]);
    check_words(operands);
    const SummaryStyle style = summary_style_of(arguments);
    if (operands[1] == "history") {
        const std::vector<EditRecord> history = Project::open(operands[0], Access::read).history();
        std::cout << (style == SummaryStyle::json ? history_json(history) : history_text(history));
        return;
    }
    Project project = Project::open(operands[0], Access::write);
    const Done done = make(operands, project);
    const Uninterrupted uninterrupted;
    project.save();
    if (style == SummaryStyle::json) {
        print_json(done.record, project.snapshot()->rooms());
        return;
    }
    const std::vector<std::string> anew{"export", operands[0], "-o", "DIR"};
    std::cout << done.story << "\nfiles that were written before do not show it: '"
              << command_line(anew) << "' writes them anew\n";
}

}  // namespace

Command edit_command() {
    CommandForm form;
    form.name = "edit";
    form.text =
        "Changes rooms of a project for good: rename ROOM NAME, merge ROOM OTHER, lock ROOM, "
        "unlock ROOM, split X1 Y1 X2 Y2; undo, redo; history lists what was changed.";
    form.operands = {"PROJECT", "ACTION", "ROOM|X1", "NAME|OTHER|Y1", "X2", "Y2"};
    form.num_optional = 5;
    form.flags = {json_flag()};
    form.flags[0].text =
        "the edit with the rooms and doors after it, or all of the history, as JSON";
    for (const std::string_view name : action_names()) form.actions.emplace_back(name);
    form.examples = {"quadcut edit build/demo/building.quadcut rename 4 Hall",
                     "quadcut edit build/demo/building.quadcut undo"};
    return {form, run};
}

}  // namespace quadcut
