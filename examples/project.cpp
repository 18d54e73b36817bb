// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/project.hpp>

#include "two_rooms.hpp"

int main() {
    // Project::create("building.quadcut", {}) keeps it in a file.
    quadcut::Project project = quadcut::Project::in_memory({});
    project.add(two_rooms().states);
    project.finish();

    quadcut::Edit edit;
    edit.kind = quadcut::EditKind::rename;
    edit.room = project.snapshot()->room_at({1.0, 2.0});  // metres
    edit.name = "Kitchen";
    project.edit(edit);
    // What a snapshot shows stays as it is while the project goes on; any number of threads may
    // read it.
    const auto snapshot = project.snapshot();
    project.undo();
    std::cout << snapshot->rooms().rooms.front().name << ", and "
              << project.snapshot()->rooms().rooms.front().name << " again\n";
}
// Prints: Kitchen, and room 1 again
