// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// What people change in a project, and take back.
#include <algorithm>
#include <string>
#include <utility>

#include "io/room_name.hpp"
#include "project/project_impl.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

Point middle_of(Cell cell, double resolution_m) {
    return {(cell.x + 0.5) * resolution_m, (cell.y + 0.5) * resolution_m};
}

}  // namespace

EditRecord Project::edit(const Edit& edit) {
    return impl_->change([&] {
        impl_->file.require_whole();
        EditRecord record{0, impl_->follower.num_scans(), edit, EditState::done};
        Edit& made = record.edit;
        if (made.kind == EditKind::rename) made.name = io::trimmed_room_name(edit.name);
        const Edited edited = impl_->follower.edit(made);
        made.room = edited.inverse.room;
        made.other = edited.inverse.other;
        if (made.kind == EditKind::split) {
            const SplitLine& line = edited.inverse.lines.front();
            made.from = middle_of(line.from, options().resolution_m);
            made.to = middle_of(line.to, options().resolution_m);
        }
        record.number = impl_->file.add(record, edited.inverse);
        impl_->note(record);
        impl_->tell(edited.update.events, edited.update.scan);
        return record;
    });
}

EditRecord Project::undo() {
    return impl_->change([&] {
        const std::vector<EditRecord>& all = impl_->history;
        const auto last = std::find_if(all.rbegin(), all.rend(), [](const EditRecord& record) {
            return record.state == EditState::done || record.state == EditState::fixed;
        });
        if (last == all.rend()) throw InputError("there is nothing to undo");
        if (last->state == EditState::fixed) {
            throw InputError("edit " + std::to_string(last->number) +
                             " was made by a version of quadcut that did not keep how to undo it");
        }
        return impl_->reverse(*last, EditState::undone);
    });
}

EditRecord Project::redo() {
    return impl_->change([&] {
        for (const EditRecord& record : impl_->history) {
            if (record.state == EditState::undone) return impl_->reverse(record, EditState::done);
        }
        throw InputError("there is nothing to redo: no edit was undone since the last was made");
    });
}

EditRecord Project::Impl::reverse(EditRecord record, EditState becomes) {
    file.require_whole();
    try {
        const Edited edited = follower.apply(file.inverse_of(record));
        record.state = becomes;
        file.set_state(record, edited.inverse);
        note(record);
        tell(edited.update.events, edited.update.scan);
    } catch (const InputError& error) {
        throw InputError("edit " + std::to_string(record.number) + " cannot be " +
                         (becomes == EditState::undone ? "undone" : "made again") +
                         " after what was seen since: " + error.what());
    }
    return record;
}

/// What was undone before a new edit cannot be made again.
void Project::Impl::note(const EditRecord& record) {
    const std::lock_guard lock(mutex);
    const auto same = std::find_if(history.begin(), history.end(), [&](const EditRecord& earlier) {
        return earlier.number == record.number;
    });
    if (same != history.end()) {
        *same = record;
        return;
    }
    for (EditRecord& earlier : history) {
        if (earlier.state == EditState::undone) earlier.state = EditState::dropped;
    }
    history.push_back(record);
}

}  // namespace quadcut
