// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/edit_text.hpp"

#include <cstdint>

#include "io/number_text.hpp"

namespace quadcut {
namespace {

std::string name_of(RoomId room) { return "room " + std::to_string(index(room)); }

std::string text_of(const Point& point) {
    std::string text = "(";
    text += io::with_decimals(point.x, 2) + ", ";
    return text + io::with_decimals(point.y, 2) + ")";
}

std::string between(const Edit& edit) {
    return "between " + text_of(edit.from) + " and " + text_of(edit.to);
}

/// Empty for what holds.
std::string_view text_of(EditState state) {
    switch (state) {
        case EditState::undone:
            return "undone";
        case EditState::dropped:
            return "undone for good";
        case EditState::done:
        case EditState::fixed:
            break;
    }
    return "";
}

}  // namespace

std::string_view name_of(EditKind kind) {
    switch (kind) {
        case EditKind::rename:
            return "rename";
        case EditKind::merge:
            return "merge";
        case EditKind::split:
            return "split";
        case EditKind::lock:
            return "lock";
        case EditKind::unlock:
            return "unlock";
    }
    return "";
}

std::string summary_of(const Edit& edit) {
    const std::string room = name_of(edit.room);
    if (edit.kind == EditKind::rename) return "rename " + room + " to " + edit.name;
    if (edit.kind == EditKind::merge) return "merge " + name_of(edit.other) + " into " + room;
    if (edit.kind != EditKind::split) return std::string(name_of(edit.kind)) + " " + room;
    return "split " + name_of(edit.other) + " from " + room + " " + between(edit);
}

std::string story_of(const Edit& edit) {
    const std::string room = name_of(edit.room);
    if (edit.kind == EditKind::rename) return room + " is now called " + edit.name;
    if (edit.kind == EditKind::merge) return name_of(edit.other) + " is now part of " + room;
    if (edit.kind == EditKind::lock) return room + " keeps its border";
    if (edit.kind == EditKind::unlock) return room + " changes with what is seen";
    return name_of(edit.other) + " is now apart from " + room + ", " + between(edit);
}

std::string history_text(std::span<const EditRecord> history) {
    if (history.empty()) return "no edits\n";
    std::string text;
    for (const EditRecord& record : history) {
        text += std::to_string(record.number) + "  scan " + std::to_string(record.scan) + "  " +
                summary_of(record.edit);
        const std::string_view state = text_of(record.state);
        if (!state.empty()) text.append("  (").append(state).append(")");
        text += "\n";
    }
    return text;
}

std::string history_json(std::span<const EditRecord> history) {
    io::JsonWriter json;
    json.begin_array(io::JsonLayout::lines);
    for (const EditRecord& record : history) {
        json.begin_object();
        write_edit(json, record);
        json.end_object();
    }
    json.end_array();
    return json.finish();
}

void write_edit(io::JsonWriter& json, const EditRecord& record) {
    const Edit& edit = record.edit;
    json.key("number").integer(static_cast<std::uint64_t>(record.number));
    json.key("scan").integer(record.scan);
    json.key("kind").text(std::string(name_of(edit.kind)));
    json.key("room").integer(index(edit.room));
    if (edit.kind == EditKind::rename) json.key("name").text(edit.name);
    if (edit.kind == EditKind::merge || edit.kind == EditKind::split) {
        json.key("other").integer(index(edit.other));
    }
    if (edit.kind == EditKind::split) {
        json.key("line").begin_array();
        for (const Point& end : {edit.from, edit.to}) {
            json.begin_array().number(end.x).number(end.y).end_array();
        }
        json.end_array();
    }
    json.key("is_undone").boolean(!text_of(record.state).empty());
    json.key("can_be_redone").boolean(record.state == EditState::undone);
}

}  // namespace quadcut
