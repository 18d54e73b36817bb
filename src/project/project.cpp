// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "io/file.hpp"
#include "io/option_text.hpp"
#include "io/updates.hpp"
#include "project/new_file.hpp"
#include "project/project_rows.hpp"
#include "project/schema.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::store {
namespace {

constexpr std::int64_t kMaxCount = std::int64_t{1} << 53;

void write_options(const Database& database, FollowOptions options) {
    Statement insert(database, "INSERT INTO options VALUES(?, ?)");
    for (const OptionField& field : option_fields(options.segment)) {
        // The result is the same on any number of threads.
        if (field.name == "threads") continue;
        const std::string value = io::option_text(field);
        insert.bind(1, field.name).bind(2, std::string_view(value)).run();
    }
}

void write_meta(const Database& database, std::string_view key, std::int64_t value) {
    Statement(database, "INSERT OR REPLACE INTO meta VALUES(?, ?)")
        .bind(1, key)
        .bind(2, value)
        .run();
}

void write_meta(const Database& database, std::string_view key, double value) {
    Statement(database, "INSERT OR REPLACE INTO meta VALUES(?, ?)")
        .bind(1, key)
        .bind(2, value)
        .run();
}

void write_meta(const Database& database, std::string_view key, std::string_view value) {
    Statement(database, "INSERT OR REPLACE INTO meta VALUES(?, ?)")
        .bind(1, key)
        .bind(2, value)
        .run();
}

void write_position(const Database& database, const LogPosition& position) {
    write_meta(database, "log", std::string_view(position.log));
    write_meta(database, "log_hash", static_cast<std::int64_t>(position.log_hash));
    write_meta(database, "num_done", static_cast<std::int64_t>(position.num_done));
    write_meta(database, "num_left_out", static_cast<std::int64_t>(position.num_left_out));
    write_meta(database, "first_left_out", std::string_view(position.first_left_out));
    write_meta(database, "is_finished", std::int64_t{position.is_finished});
}

/// One value of `meta`, ready to be read at column 0.
Statement meta(const Database& database, std::string_view key) {
    Statement statement(database, "SELECT value FROM meta WHERE key = ?");
    statement.bind(1, key);
    if (!statement.step()) {
        throw InputError(io::display_name(database.path()) + ": is incomplete: expected a row '" +
                         std::string(key) + "' in its table meta");
    }
    return statement;
}

/// Whether an option of earlier projects, which is none any more, has the value that all have now.
/// Throws InputError when it has another one.
bool is_without_choice(std::string_view name, std::string_view value) {
    // It meant something for rooms.fuse=ratio only.
    if (name == "rooms.min_ratio") return true;
    const std::string_view left = name == "rooms.fuse"        ? "model"
                                  : name == "rooms.furniture" ? "off_wall"
                                                              : "";
    if (left.empty()) return false;
    if (value == left) return true;
    throw InputError("was begun with " + std::string(name) + " = " + std::string(value) +
                     ", which is no choice any more: expected " + std::string(left) +
                     "; 'quadcut follow LOG -o DIR --project FILE' begins a new project");
}

std::size_t count_in_meta(const Database& database, std::string_view key) {
    return static_cast<std::size_t>(meta(database, key).integer(0, 0, kMaxCount));
}

}  // namespace

Project Project::in_memory(const std::filesystem::path& path, const FollowOptions& options,
                           const LogPosition& position) {
    Database database = Database::in_memory(path);
    database.run("BEGIN");
    for (const Table& table : tables()) database.run(std::string(table.sql));
    write_options(database, options);
    write_meta(database, "resolution_m", options.resolution_m);
    write_meta(database, "min_change_m2", options.min_change_m2);
    write_meta(database, "max_wait_m2_scans", options.max_wait_m2_scans);
    write_meta(database, "first_cut_m2", options.first_cut_m2);
    write_meta(database, "min_patch_m2", options.min_patch_m2);
    write_position(database, position);
    write_state(database, FollowedMap(options.resolution_m), {});
    database.run("PRAGMA application_id=" + std::to_string(kApplicationId));
    database.run("PRAGMA user_version=" + std::to_string(kFormatVersion));
    database.run("COMMIT");
    Project project(std::move(database));
    project.options_ = options;
    project.position_ = position;
    project.database_.run("BEGIN IMMEDIATE");
    return project;
}

Project Project::create(const std::filesystem::path& path, const FollowOptions& options,
                        const LogPosition& position) {
    make_database_file(path, in_memory(path, options, position).file_bytes());
    return Project(path, Access::write);
}

Project::Project(const std::filesystem::path& path, Access access) : database_(path, access) {
    // One state of the file for all that is read.
    if (access == Access::read) database_.run("BEGIN");
    check_form();
    if (access == Access::write) {
        database_.run("PRAGMA journal_mode=WAL");
        database_.run("PRAGMA synchronous=NORMAL");
        // Held until the project is closed, so that no other program writes.
        database_.run("BEGIN IMMEDIATE");
        bring_up_to_date();
    }
    read_options();
    read_position();
}

void Project::check_form() const {
    const std::string name = io::display_name(database_.path());
    if (database_.pragma("application_id") != kApplicationId) {
        throw InputError(name + ": is no project file: expected one that quadcut has written");
    }
    const std::int64_t version = database_.pragma("user_version");
    if (version < 1 || version > kFormatVersion) {
        throw InputError(name + ": is a project of format version " + std::to_string(version) +
                         ": expected 1 to " + std::to_string(kFormatVersion) +
                         (version > kFormatVersion ? "; a newer quadcut has written it" : ""));
    }
    Statement statement(database_, "SELECT sql FROM sqlite_master ORDER BY name");
    bool is_ours = true;
    for (const Table& table : tables()) {
        if (table.since > version) continue;
        is_ours = is_ours && statement.step() && statement.text(0) == table.sql;
    }
    if (!is_ours || statement.step()) {
        throw InputError(name + ": is no project file: its tables are not those of version " +
                         std::to_string(version));
    }
}

void Project::bring_up_to_date() {
    const std::int64_t version = database_.pragma("user_version");
    if (version == kFormatVersion) return;
    for (const Table& table : tables()) {
        if (table.since > version) database_.run(std::string(table.sql));
    }
    database_.run("PRAGMA user_version=" + std::to_string(kFormatVersion));
}

void Project::read_options() {
    const std::vector<OptionField> fields = option_fields(options_.segment);
    Statement statement(database_, "SELECT name, value FROM options ORDER BY name");
    try {
        while (statement.step()) {
            const std::string name = statement.text(0);
            const std::string value = statement.text(1);
            if (!is_without_choice(name, value)) io::set_option(fields, name, value);
        }
    } catch (const InputError& error) {
        throw InputError(io::display_name(database_.path()) + ": " + error.what());
    }
    options_.resolution_m = meta(database_, "resolution_m").number(0);
    options_.min_change_m2 = meta(database_, "min_change_m2").number(0);
    options_.max_wait_m2_scans = meta(database_, "max_wait_m2_scans").number(0);
    options_.first_cut_m2 = meta(database_, "first_cut_m2").number(0);
    options_.min_patch_m2 = meta(database_, "min_patch_m2").number(0);
    if (!(options_.resolution_m >= 0.001 && options_.resolution_m <= 10.0)) {
        throw InputError(io::display_name(database_.path()) + ": a resolution of " +
                         std::to_string(options_.resolution_m) + " m: expected 0.001 to 10");
    }
}

void Project::read_position() {
    position_.log = meta(database_, "log").text(0);
    position_.log_hash =
        static_cast<std::uint64_t>(meta(database_, "log_hash")
                                       .integer(0, std::numeric_limits<std::int64_t>::min(),
                                                std::numeric_limits<std::int64_t>::max()));
    position_.num_done = count_in_meta(database_, "num_done");
    position_.num_left_out = count_in_meta(database_, "num_left_out");
    position_.first_left_out = meta(database_, "first_left_out").text(0);
    position_.is_finished = meta(database_, "is_finished").integer(0, 0, 1) != 0;
}

Follower Project::follower(std::size_t num_threads) const {
    try {
        FollowOptions options = options_;
        options.segment.num_threads = num_threads;
        return Follower(options, read_state(database_, options.resolution_m));
    } catch (const InputError& error) {
        const std::string name = io::display_name(database_.path());
        const std::string what = error.what();
        if (what.rfind(name, 0) == 0) throw;
        throw InputError(name + ": contradicts itself: " + what);
    }
}

std::string Project::update_lines() const {
    std::string lines;
    Statement statement(database_, "SELECT line FROM updates ORDER BY seq");
    while (statement.step()) lines += statement.text(0);
    return lines;
}

void Project::add(const FollowUpdate& update, std::string_view line) {
    if (!line.empty()) waiting_.lines.emplace_back(line);
    for (const LifeEvent& event : update.events) waiting_.events.emplace_back(update.scan, event);
}

void Project::add(const EditRecord& record, const Edited& edited) {
    add(edited.update, "");
    write_edit(database_, record, edited.inverse);
}

EditRecord Project::undo(Follower& follower) {
    const std::vector<EditRecord> all = edits();
    const auto last = std::find_if(all.rbegin(), all.rend(), [](const EditRecord& record) {
        return record.state == EditState::done || record.state == EditState::fixed;
    });
    if (last == all.rend()) throw InputError("there is nothing to undo");
    if (last->state == EditState::fixed) {
        throw InputError("edit " + std::to_string(last->number) +
                         " was made by a version of quadcut that did not keep how to undo it");
    }
    return turn(follower, *last, EditState::undone);
}

EditRecord Project::redo(Follower& follower) {
    for (const EditRecord& record : edits()) {
        if (record.state == EditState::undone) return turn(follower, record, EditState::done);
    }
    throw InputError("there is nothing to redo: no edit was undone since the last was made");
}

EditRecord Project::turn(Follower& follower, EditRecord record, EditState state) {
    try {
        const Edited edited = follower.apply(read_inverse(database_, record));
        add(edited.update, "");
        write_inverse(database_, record.number, state, edited.inverse);
    } catch (const InputError& error) {
        throw InputError("edit " + std::to_string(record.number) + " cannot be " +
                         (state == EditState::undone ? "undone" : "made again") +
                         " after what was seen since: " + error.what());
    }
    record.state = state;
    return record;
}

void Project::save(Follower& follower, const LogPosition& position) {
    if (is_broken_) {
        throw InputError(io::display_name(database_.path()) +
                         ": a save has failed; it holds what was saved before");
    }
    // Until all is written: what a save that fails has taken from the follower is not lost unseen.
    is_broken_ = true;
    write_waiting();
    const Changes changes = follower.changes_since(saved_revision_);
    write_state(database_, follower.state(), changes.tiles);
    write_position(database_, position);
    database_.run("COMMIT");
    waiting_ = {};
    saved_revision_ = changes.revision;
    position_ = position;
    database_.run("BEGIN IMMEDIATE");
    is_broken_ = false;
}

void Project::write_waiting() {
    Statement line(database_, "INSERT INTO updates(line) VALUES(?)");
    for (const std::string& text : waiting_.lines) line.bind(1, std::string_view(text)).run();
    Statement event(database_,
                    "INSERT INTO lineage(scan, event, room, other, reason) VALUES(?, ?, ?, ?, ?)");
    for (const auto& [scan, life] : waiting_.events) {
        event.bind(1, static_cast<std::int64_t>(scan))
            .bind(2, std::string_view(io::name_of(life.life)))
            .bind(3, static_cast<std::int64_t>(index(life.room)))
            .bind(4, static_cast<std::int64_t>(index(life.other)))
            .bind(5, std::string_view(life.reason))
            .run();
    }
}

}  // namespace quadcut::store
