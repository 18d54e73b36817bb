// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include "apps/command.hpp"
#include "apps/numbers.hpp"
#include "apps/uninterrupted.hpp"
#include "quadcut/base/error.hpp"
#include "store/project.hpp"

namespace quadcut {
namespace {

/// A room by its id, or by the name that people gave it.
RoomId room_of(const std::string& word, const Follower& follower) {
    std::uint32_t id = 0;
    const char* const end = word.data() + word.size();
    const auto [read, error] = std::from_chars(word.data(), end, id);
    if (error == std::errc() && read == end) return RoomId{id};
    for (const auto& [number, room] : follower.followed()) {
        if (room.name == word) return RoomId{number};
    }
    throw InputError("'" + word + "': expected the id of a room, or a name that was given to one");
}

/// What follows the action's name.
class Words {
public:
    Words(const std::vector<std::string>& operands, std::size_t count, const std::string& expected)
        : operands_(operands) {
        if (operands.size() == count + 2) return;
        throw InputError("edit PROJECT " + operands[1] + ": expected " + expected);
    }
    [[nodiscard]] const std::string& operator[](std::size_t i) const { return operands_[i + 2]; }

private:
    const std::vector<std::string>& operands_;
};

/// Makes the edit, and says what it was.
std::string apply(const std::vector<std::string>& operands, Follower& follower,
                  store::Project& project) {
    store::EditRecord record;
    record.kind = operands[1];
    if (record.kind == "rename") {
        const Words words(operands, 2, "ROOM NAME");
        record.room = room_of(words[0], follower);
        record.name = words[1];
        follower.rename(record.room, record.name);
    } else if (record.kind == "merge") {
        const Words words(operands, 2, "ROOM OTHER");
        record.room = room_of(words[0], follower);
        record.other = room_of(words[1], follower);
        project.add(follower.merge(record.room, record.other), "");
    } else if (record.kind == "split") {
        const Words words(operands, 4, "X1 Y1 X2 Y2");
        const FollowUpdate update =
            follower.split(point_of(words[0], words[1]), point_of(words[2], words[3]));
        record.room = update.events.front().other;
        record.other = update.events.front().room;
        record.line = follower.split_lines().back();
        project.add(update, "");
    } else if (record.kind == "lock") {
        const Words words(operands, 1, "ROOM");
        record.room = room_of(words[0], follower);
        follower.lock(record.room);
    } else {
        throw InputError("edit: '" + record.kind + "': expected rename, merge, split or lock");
    }
    project.add(record);
    const std::string room = "room " + std::to_string(index(record.room));
    const std::string other = "room " + std::to_string(index(record.other));
    if (record.kind == "rename") return room + " is now called " + record.name;
    if (record.kind == "merge") return other + " is now part of " + room;
    if (record.kind == "split") return other + " is now apart from " + room;
    return room + " keeps its border";
}

void run(const Arguments& arguments) {
    store::Project project(arguments.operands[0], store::Access::write);
    Follower follower = project.follower();
    const std::string story = apply(arguments.operands, follower, project);
    const Uninterrupted uninterrupted;
    project.save(follower, project.position());
    std::cout << story << "\n";
}

}  // namespace

Command edit_command() {
    CommandForm form;
    form.name = "edit";
    form.text =
        "Changes rooms of a project for good: rename ROOM NAME, merge ROOM OTHER, lock ROOM, "
        "split X1 Y1 X2 Y2.";
    form.operands = {"PROJECT", "ACTION", "ROOM|X1", "NAME|OTHER|Y1", "X2", "Y2"};
    form.num_optional = 3;
    form.actions = {"rename", "merge", "split", "lock", "unlock", "undo", "redo", "history"};
    form.examples = {
        "quadcut follow build/demo/simulation/robot.log -o followed --project home.quadcut",
        "quadcut edit home.quadcut rename 1 Hall", "quadcut edit home.quadcut lock 1"};
    return {form, run};
}

}  // namespace quadcut
