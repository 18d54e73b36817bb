// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "apps/command.hpp"
#include "apps/command_line.hpp"
#include "apps/numbers.hpp"
#include "apps/room_choice.hpp"
#include "apps/run_flags.hpp"
#include "apps/uninterrupted.hpp"
#include "io/file.hpp"
#include "io/json_writer.hpp"
#include "io/nearest_word.hpp"
#include "io/number_text.hpp"
#include "io/room_list.hpp"
#include "io/room_name.hpp"
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

std::string name_of(RoomId room) { return "room " + std::to_string(index(room)); }

std::string text_of(Cell cell, double resolution_m) {
    std::string text = "(";
    text += io::with_decimals((cell.x + 0.5) * resolution_m, 2) + ", ";
    return text + io::with_decimals((cell.y + 0.5) * resolution_m, 2) + ")";
}

/// What an edit does: "merge room 12 into room 7".
std::string summary(const store::EditRecord& edit, double resolution_m) {
    const std::string room = name_of(edit.room);
    if (edit.kind == "rename") return "rename " + room + " to " + edit.name;
    if (edit.kind == "merge") return "merge " + name_of(edit.other) + " into " + room;
    if (edit.kind != "split") return edit.kind + " " + room;
    return "split " + name_of(edit.other) + " from " + room + " between " +
           text_of(edit.line.from, resolution_m) + " and " + text_of(edit.line.to, resolution_m);
}

std::string_view text_of(store::EditState state) {
    switch (state) {
        case store::EditState::undone:
            return "undone";
        case store::EditState::dropped:
            return "undone for good";
        case store::EditState::done:
        case store::EditState::fixed:
            break;
    }
    return "";
}

/// The members of an object that is being written.
void write_edit(io::JsonWriter& json, const store::EditRecord& edit, double resolution_m) {
    json.key("number").integer(static_cast<std::uint64_t>(edit.number));
    json.key("scan").integer(edit.scan);
    json.key("kind").text(edit.kind);
    json.key("room").integer(index(edit.room));
    if (edit.kind == "rename") json.key("name").text(edit.name);
    if (edit.kind == "merge" || edit.kind == "split") {
        json.key("other").integer(index(edit.other));
    }
    if (edit.kind == "split") {
        json.key("line").begin_array();
        for (const Cell cell : {edit.line.from, edit.line.to}) {
            json.begin_array();
            json.number((cell.x + 0.5) * resolution_m).number((cell.y + 0.5) * resolution_m);
            json.end_array();
        }
        json.end_array();
    }
    json.key("is_undone").boolean(!text_of(edit.state).empty());
    json.key("can_be_redone").boolean(edit.state == store::EditState::undone);
}

/// The edit, and the rooms and doors that there are after it.
void print_json(const store::EditRecord& edit, const Segmentation& rooms, double resolution_m) {
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    write_edit(json, edit, resolution_m);
    io::write_rooms_and_doors(json, rooms);
    json.end_object();
    std::cout << json.finish();
}

void print_history(const store::Project& project, SummaryStyle style) {
    const double resolution_m = project.options().resolution_m;
    const std::vector<store::EditRecord> edits = project.edits();
    if (style == SummaryStyle::json) {
        io::JsonWriter json;
        json.begin_array(io::JsonLayout::lines);
        for (const store::EditRecord& edit : edits) {
            json.begin_object();
            write_edit(json, edit, resolution_m);
            json.end_object();
        }
        json.end_array();
        std::cout << json.finish();
        return;
    }
    if (edits.empty()) std::cout << "no edits\n";
    for (const store::EditRecord& edit : edits) {
        std::cout << edit.number << "  scan " << edit.scan << "  " << summary(edit, resolution_m);
        if (!text_of(edit.state).empty()) std::cout << "  (" << text_of(edit.state) << ")";
        std::cout << "\n";
    }
}

/// The edit that words ask for.
Edit edit_of(const std::string& action, const std::vector<std::string>& words,
             const Follower& follower) {
    Edit edit;
    if (action == "split") {
        edit.kind = EditKind::split;
        edit.from = point_of(words[0], words[1]);
        edit.to = point_of(words[2], words[3]);
        return edit;
    }
    edit.room = room_of(words[0], follower);
    if (action == "rename") edit.name = io::trimmed_room_name(words[1]);
    if (action == "merge") {
        edit.kind = EditKind::merge;
        edit.other = room_of(words[1], follower);
    }
    if (action == "lock") edit.kind = EditKind::lock;
    if (action == "unlock") edit.kind = EditKind::unlock;
    return edit;
}

/// Makes an edit and says what it was.
store::EditRecord make(const std::vector<std::string>& operands, Follower& follower,
                       store::Project& project) {
    const Edit edit = edit_of(operands[1], {operands.begin() + 2, operands.end()}, follower);
    const Edited edited = follower.edit(edit);
    const Reversal& inverse = edited.inverse;
    store::EditRecord record{operands[1], inverse.room,         inverse.other,          edit.name,
                             {},          follower.num_scans(), store::EditState::done, 0};
    if (edit.kind == EditKind::split) record.line = inverse.lines.front();
    project.add(record, edited);
    record.number = project.edits().back().number;
    return record;
}

std::string story_of(const store::EditRecord& edit, double resolution_m) {
    const std::string room = name_of(edit.room);
    if (edit.kind == "rename") return room + " is now called " + edit.name;
    if (edit.kind == "merge") return name_of(edit.other) + " is now part of " + room;
    if (edit.kind == "lock") return room + " keeps its border";
    if (edit.kind == "unlock") return room + " changes with what is seen";
    return name_of(edit.other) + " is now apart from " + room + ", between " +
           text_of(edit.line.from, resolution_m) + " and " + text_of(edit.line.to, resolution_m);
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
        print_history(store::Project(operands[0], store::Access::read), style);
        return;
    }
    store::Project project(operands[0], store::Access::write);
    const double resolution_m = project.options().resolution_m;
    Follower follower = project.follower();
    store::EditRecord edit;
    std::string story;
    if (operands[1] == "undo") {
        edit = project.undo(follower);
        story = "undone: " + summary(edit, resolution_m);
    } else if (operands[1] == "redo") {
        edit = project.redo(follower);
        story = "made again: " + summary(edit, resolution_m);
    } else {
        edit = make(operands, follower, project);
        story = story_of(edit, resolution_m);
    }
    const Uninterrupted uninterrupted;
    project.save(follower, project.position());
    if (style == SummaryStyle::json) {
        print_json(edit, follower.rooms(), resolution_m);
        return;
    }
    const std::vector<std::string> anew{"export", operands[0], "-o", "DIR"};
    std::cout << story << "\nfiles that were written before do not show it: '" << command_line(anew)
              << "' writes them anew\n";
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
    form.examples = {"quadcut edit build/demo/building.quadcut rename 1 Hall",
                     "quadcut edit build/demo/building.quadcut undo"};
    return {form, run};
}

}  // namespace quadcut
