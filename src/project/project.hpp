// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "project/database.hpp"
#include "project/edit_history.hpp"
#include "quadcut/follow/follower.hpp"

namespace quadcut::store {

/// The log that a project follows, and how far.
struct LogPosition {
    std::string log;
    std::uint64_t log_hash = 0;
    /// Scans of the log that are done, those left out included.
    std::size_t num_done = 0;
    std::size_t num_left_out = 0;
    /// Why the first of these was left out.
    std::string first_left_out;
    bool is_finished = false;
};

/// The project file: one SQLite database (WAL) with the map's tiles, rooms, names, doors, lineage,
/// edits, options and the position in the log; docs/formats.md describes its tables. What is saved
/// is saved as a whole: a program killed at any moment leaves the last save. One program writes at
/// a time, others may read. All errors are InputError, name the file, and leave it valid.
class Project {
public:
    /// A new project, at a name that is free, as make_database_file() makes it.
    [[nodiscard]] static Project create(const std::filesystem::path& path,
                                        const FollowOptions& options, const LogPosition& position);
    /// One without a file, whose bytes become one at the end; `path` stands in messages.
    [[nodiscard]] static Project in_memory(const std::filesystem::path& path,
                                           const FollowOptions& options,
                                           const LogPosition& position);
    /// Opens one; refused: no project file, one of a newer version, one that another program
    /// writes to. The first save makes one of an older version one of this.
    Project(const std::filesystem::path& path, Access access);

    [[nodiscard]] const FollowOptions& options() const { return options_; }
    [[nodiscard]] const LogPosition& position() const { return position_; }
    /// The follower as it was when last saved. O(project).
    [[nodiscard]] Follower follower(std::size_t num_threads = 2) const;
    /// The lines of updates.jsonl so far.
    [[nodiscard]] std::string update_lines() const;
    /// All edits of people, the first first.
    [[nodiscard]] std::vector<EditRecord> edits() const { return read_edits(database_); }

    /// Adds to what the next save writes. An empty line is none.
    void add(const FollowUpdate& update, std::string_view line);
    void add(const EditRecord& record, const Edited& edited);
    /// Takes the last edit back that holds, or makes the first again of those that were undone
    /// last; the next save writes it. Returns which. Throws InputError, with nothing changed, when
    /// there is none, or when it says why that is not possible any more.
    EditRecord undo(Follower& follower);
    EditRecord redo(Follower& follower);
    /// Writes all that has changed since the last save; after one that has failed, none can be
    /// made. O(changes).
    void save(Follower& follower, const LogPosition& position);

    /// What a file of this project holds, as it was last saved.
    [[nodiscard]] std::string file_bytes() const { return database_.file_bytes(); }
    /// "ok", or what is wrong with the file.
    [[nodiscard]] std::string integrity() const { return database_.integrity(); }
    /// No file of more pages than this; for tests of a full disk.
    void limit_pages(std::int64_t pages) { database_.limit_pages(pages); }

private:
    explicit Project(Database database) : database_(std::move(database)) {}
    void check_form() const;
    void bring_up_to_date();
    EditRecord turn(Follower& follower, EditRecord record, EditState state);
    void write_waiting();
    void read_options();
    void read_position();

    Database database_;
    FollowOptions options_;
    LogPosition position_;
    struct Waiting {
        std::vector<std::string> lines;
        std::vector<std::pair<std::size_t, LifeEvent>> events;
    };
    Waiting waiting_;
    /// Of the follower.
    std::uint64_t saved_revision_ = 0;
    bool is_broken_ = false;
};

}  // namespace quadcut::store
