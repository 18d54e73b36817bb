// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/project_file.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "io/file.hpp"
#include "io/option_text.hpp"
#include "io/room_events.hpp"
#include "project/new_file.hpp"
#include "project/project_rows.hpp"
#include "project/schema.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::project {
namespace {

constexpr std::int64_t kMaxCount = std::int64_t{1} << 53;
/// Before this version, these options were rows of `meta`.
constexpr std::int64_t kAllOptionsInOneTable = 3;
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kOptionsInMeta{
    {{"resolution", "resolution_m"},
     {"follow.min_change", "min_change_m2"},
     {"follow.max_wait", "max_wait_m2_scans"},
     {"follow.first_cut", "first_cut_m2"},
     {"follow.min_patch", "min_patch_m2"}}};

void write_options(const Database& database, FollowOptions options) {
    Statement insert(database, "INSERT INTO options VALUES(?, ?)");
    for (const OptionField& field : option_fields(options)) {
        if (field.decides != Decides::result) continue;
        const std::string value = io::option_text(field);
        insert.bind(1, field.name).bind(2, std::string_view(value)).run();
    }
}

template <typename Value>
void write_meta(const Database& database, std::string_view key, Value value) {
    Statement(database, "INSERT OR REPLACE INTO meta VALUES(?, ?)")
        .bind(1, key)
        .bind(2, value)
        .run();
}

/// No log has an empty name.
void write_progress(const Database& database, const Progress& progress) {
    const ScanPosition position = progress.position.value_or(ScanPosition{});
    write_meta(database, "log", std::string_view(position.source));
    write_meta(database, "log_hash", static_cast<std::int64_t>(position.source_hash));
    write_meta(database, "num_done", static_cast<std::int64_t>(position.num_done));
    write_meta(database, "num_left_out", static_cast<std::int64_t>(position.num_left_out));
    write_meta(database, "first_left_out", std::string_view(position.first_left_out));
    write_meta(database, "is_finished", std::int64_t{progress.is_finished});
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
    // Components are the same however they are found; the others meant something for
    // rooms.fuse=ratio or the spectral cut of leaves only.
    if (name == "paper.components" || name == "rooms.min_ratio" || name == "rooms.max_eigenvalue" ||
        name == "rooms.laplacian" || name == "rooms.full_clearance") {
        return true;
    }
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

ProjectFile ProjectFile::in_memory(const std::filesystem::path& name, const FollowOptions& options,
                                   const std::optional<ScanPosition>& position) {
    Database database = Database::in_memory(name);
    database.run("BEGIN");
    for (const Table& table : tables()) database.run(std::string(table.sql));
    write_options(database, options);
    write_progress(database, {position});
    write_state(database, FollowedMap(options.resolution_m), {});
    database.run("PRAGMA application_id=" + std::to_string(kApplicationId));
    database.run("PRAGMA user_version=" + std::to_string(kFormatVersion));
    database.run("COMMIT");
    ProjectFile file(std::move(database));
    file.options_ = options;
    file.progress_.position = position;
    file.database_.run("BEGIN IMMEDIATE");
    return file;
}

ProjectFile ProjectFile::create(const std::filesystem::path& path, const FollowOptions& options,
                                const std::optional<ScanPosition>& position) {
    make_database_file(path, in_memory(path, options, position).file_bytes());
    return ProjectFile(path, Access::write);
}

ProjectFile::ProjectFile(const std::filesystem::path& path, Access access)
    : database_(path, access) {
    // One state of the file for all that is read.
    if (access == Access::read) database_.run("BEGIN");
    check_form();
    if (access == Access::write) {
        database_.run("PRAGMA journal_mode=WAL");
        database_.run("PRAGMA synchronous=NORMAL");
        // Held until the project is closed, so that no other program writes.
        database_.run("BEGIN IMMEDIATE");
    }
    read_options();
    if (access == Access::write) bring_up_to_date();
    read_progress();
}

void ProjectFile::check_form() const {
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

void ProjectFile::bring_up_to_date() {
    const std::int64_t version = database_.pragma("user_version");
    if (version == kFormatVersion) return;
    for (const Table& table : tables()) {
        if (table.since > version) database_.run(std::string(table.sql));
    }
    database_.run("DELETE FROM options");
    write_options(database_, options_);
    for (const auto& [name, key] : kOptionsInMeta) {
        Statement(database_, "DELETE FROM meta WHERE key = ?").bind(1, key).run();
    }
    database_.run("PRAGMA user_version=" + std::to_string(kFormatVersion));
}

void ProjectFile::read_options() {
    const std::vector<OptionField> fields = option_fields(options_);
    const auto set = [&](const std::string& name, const std::string& value) {
        try {
            if (!is_without_choice(name, value)) io::set_option(fields, name, value);
        } catch (const InputError& error) {
            throw InputError(io::display_name(database_.path()) + ": " + error.what());
        }
    };
    Statement statement(database_, "SELECT name, value FROM options ORDER BY name");
    while (statement.step()) set(statement.text(0), statement.text(1));
    if (database_.pragma("user_version") >= kAllOptionsInOneTable) return;
    for (const auto& [name, key] : kOptionsInMeta) {
        double value = meta(database_, key).number(0);
        set(std::string(name), io::option_text({"", "", 0.0, 0.0, "", "", &value}));
    }
}

void ProjectFile::read_progress() {
    ScanPosition position;
    position.source = meta(database_, "log").text(0);
    position.source_hash =
        static_cast<std::uint64_t>(meta(database_, "log_hash")
                                       .integer(0, std::numeric_limits<std::int64_t>::min(),
                                                std::numeric_limits<std::int64_t>::max()));
    position.num_done = count_in_meta(database_, "num_done");
    position.num_left_out = count_in_meta(database_, "num_left_out");
    position.first_left_out = meta(database_, "first_left_out").text(0);
    if (!position.source.empty()) progress_.position = std::move(position);
    progress_.is_finished = meta(database_, "is_finished").integer(0, 0, 1) != 0;
}

Follower ProjectFile::follower(const RunOptions& run) const {
    try {
        return Follower(options_, read_state(database_, options_), run);
    } catch (const InputError& error) {
        const std::string name = io::display_name(database_.path());
        const std::string what = error.what();
        if (what.rfind(name, 0) == 0) throw;
        throw InputError(name + ": contradicts itself: " + what);
    }
}

std::string ProjectFile::update_lines() const {
    std::string lines;
    Statement statement(database_, "SELECT line FROM updates ORDER BY seq");
    while (statement.step()) lines += statement.text(0);
    return lines;
}

std::vector<Pose> ProjectFile::poses() const {
    std::vector<Pose> poses;
    if (!has_table(database_, "poses")) return poses;
    Statement row(database_, "SELECT x, y, yaw_rad FROM poses ORDER BY seq");
    while (row.step()) poses.push_back({row.number(0), row.number(1), row.number(2)});
    return poses;
}

void ProjectFile::require_whole() const {
    if (!is_broken_) return;
    throw InputError(io::display_name(database_.path()) +
                     ": a save has failed; it holds what was saved before");
}

/// Until all is written it is broken: what a save that fails has taken is not lost unseen.
template <typename Write>
void ProjectFile::write(const Write& write) {
    require_whole();
    is_broken_ = true;
    write();
    is_broken_ = false;
}

std::int64_t ProjectFile::add(const EditRecord& record, const Reversal& inverse) {
    std::int64_t number = 0;
    write([&] { number = write_edit(database_, record, inverse); });
    return number;
}

void ProjectFile::set_state(const EditRecord& record, const Reversal& inverse) {
    write([&] { write_inverse(database_, record.number, record.state, inverse); });
}

void ProjectFile::save(const FollowedMap& state, const Unsaved& unsaved, const Progress& progress) {
    write([&] {
        write_unsaved(unsaved);
        write_state(database_, state, unsaved.tiles);
        write_progress(database_, progress);
        database_.run("COMMIT");
        progress_ = progress;
        database_.run("BEGIN IMMEDIATE");
    });
}

void ProjectFile::write_unsaved(const Unsaved& unsaved) {
    Statement insert(database_, "INSERT INTO updates(line) VALUES(?)");
    for (std::string_view lines = unsaved.lines; !lines.empty();) {
        const std::size_t length = std::min(lines.find('\n'), lines.size() - 1) + 1;
        insert.bind(1, lines.substr(0, length)).run();
        lines.remove_prefix(length);
    }
    Statement pose(database_, "INSERT INTO poses(x, y, yaw_rad) VALUES(?, ?, ?)");
    for (const Pose& one : unsaved.poses) {
        pose.bind(1, one.x).bind(2, one.y).bind(3, one.yaw_rad).run();
    }
    Statement event(database_,
                    "INSERT INTO lineage(scan, event, room, other, reason) VALUES(?, ?, ?, ?, ?)");
    for (const auto& [scan, one] : unsaved.events) {
        event.bind(1, static_cast<std::int64_t>(scan))
            .bind(2, std::string_view(io::name_of(one.change)))
            .bind(3, static_cast<std::int64_t>(index(one.room)))
            .bind(4, static_cast<std::int64_t>(index(one.other)))
            .bind(5, std::string_view(one.reason))
            .run();
    }
}

std::string ProjectFile::file_bytes() const { return database_.file_bytes(); }

}  // namespace quadcut::project
