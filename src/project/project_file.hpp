// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "project/database.hpp"
#include "project/edit_history.hpp"
#include "project/scan_position.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/follow/follower.hpp"

namespace quadcut::project {

/// How far a project is.
struct Progress {
    /// Nothing: its scans come from no log.
    std::optional<ScanPosition> position;
    /// All that was seen is cut.
    bool is_finished = false;
};

/// What has come since the last save.
struct Unsaved {
    /// Of the map.
    std::vector<Cell> tiles;
    /// Lines of updates.jsonl.
    std::string lines;
    std::vector<std::pair<std::size_t, RoomEvent>> events;
    /// Of the scans that were added.
    std::vector<Pose> poses = {};
};

/// The project file: one SQLite database (WAL) with the map's tiles, rooms, names, doors, lineage,
/// edits, options and the position in the log; docs/formats.md describes its tables. What is saved
/// is saved as a whole: a program killed at any moment leaves the last save. One program writes at
/// a time, others may read. All errors are InputError, name the file, and leave it valid.
class ProjectFile {
public:
    /// A new project, at a name that is free, as make_database_file() makes it.
    [[nodiscard]] static ProjectFile create(const std::filesystem::path& path,
                                            const FollowOptions& options,
                                            const std::optional<ScanPosition>& position);
    /// One without a file, whose bytes may become one; `name` stands in messages.
    [[nodiscard]] static ProjectFile in_memory(const std::filesystem::path& name,
                                               const FollowOptions& options,
                                               const std::optional<ScanPosition>& position);
    /// Opens one; refused: no project file, one of a newer version, one that another program
    /// writes to. The first save makes one of an older version one of this.
    ProjectFile(const std::filesystem::path& path, Access access);

    [[nodiscard]] const std::filesystem::path& path() const { return database_.path(); }
    [[nodiscard]] const FollowOptions& options() const { return options_; }
    [[nodiscard]] const Progress& progress() const { return progress_; }
    /// The follower as it was when last saved; `run` says how it runs. O(project).
    [[nodiscard]] Follower follower(const RunOptions& run) const;
    /// The lines of updates.jsonl so far.
    [[nodiscard]] std::string update_lines() const;
    /// Where its scans were taken, as far as this version or a later one has added them.
    [[nodiscard]] std::vector<Pose> poses() const;
    /// All edits of people, the first first.
    [[nodiscard]] std::vector<EditRecord> edits() const {
        return read_edits(database_, options_.resolution_m);
    }

    /// Throws InputError when a write has failed: it holds what was saved before, and stays so.
    void require_whole() const;
    /// Adds an edit to what the next save writes, and returns its number.
    [[nodiscard]] std::int64_t add(const EditRecord& record, const Reversal& inverse);
    /// What takes an edit back, or makes it again when it is undone.
    [[nodiscard]] Reversal inverse_of(const EditRecord& record) const {
        return read_inverse(database_, record);
    }
    /// The edit has its state from the next save on.
    void set_state(const EditRecord& record, const Reversal& inverse);
    /// Writes all that has changed since the last save; after a write that has failed, none can be
    /// made. O(changes).
    void save(const FollowedMap& state, const Unsaved& unsaved, const Progress& progress);

    /// What a file of this project holds, as it was last saved.
    [[nodiscard]] std::string file_bytes() const;
    /// "ok", or what is wrong with the file.
    [[nodiscard]] std::string integrity() const { return database_.integrity(); }
    /// No file of more pages than this; for tests of a full disk.
    void limit_pages(std::int64_t pages) { database_.limit_pages(pages); }

private:
    explicit ProjectFile(Database database) : database_(std::move(database)) {}
    void check_form() const;
    void bring_up_to_date();
    template <typename Write>
    void write(const Write& write);
    void write_unsaved(const Unsaved& unsaved);
    void read_options();
    void read_progress();

    Database database_;
    FollowOptions options_;
    Progress progress_;
    bool is_broken_ = false;
};

}  // namespace quadcut::project
