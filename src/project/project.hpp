// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "project/access.hpp"
#include "project/edit_record.hpp"
#include "project/scan_position.hpp"
#include "project/snapshot.hpp"
#include "quadcut/base/run_options.hpp"
#include "quadcut/follow/edit.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/scan.hpp"

namespace quadcut {

/// How far a project is.
struct ProjectState {
    /// Grows with each change of the map, its rooms or their names; saved with them.
    std::uint64_t revision = 0;
    std::size_t num_scans = 0;
    std::size_t num_rooms = 0;
};

/// A living building: the map of a robot's scans with its rooms, and what people change in them,
/// kept in a file, or in memory only. Any thread may call: changes are made one after the other, in
/// the order of the calls, and who only reads waits for none of them (see snapshot()).
///
/// The file is one SQLite database (docs/formats.md). What is saved is saved as a whole: a program
/// killed at any moment leaves the last save. Unless it is said otherwise all errors are
/// InputError, which name the file, if it is about that, and leave it valid and the building as it
/// was.
class Project {
public:
    /// A new one at a name that is free.
    [[nodiscard]] static Project create(const std::filesystem::path& path,
                                        const FollowOptions& options,
                                        const std::optional<ScanPosition>& position = {},
                                        const RunOptions& run = {});
    /// Goes on where it was saved last. Refused: no project file, one of a newer version, one that
    /// another program writes to. The first save makes one of an older version one of this.
    /// O(project).
    [[nodiscard]] static Project open(const std::filesystem::path& path, Access access,
                                      const RunOptions& run = {});
    /// The project of a source of scans, which is made, in a folder that is made, if it is not
    /// there. Refused as above, and when it was begun with another source or with options that give
    /// another result.
    [[nodiscard]] static Project open_or_create(const std::filesystem::path& path,
                                                const FollowOptions& options,
                                                const ScanPosition& source,
                                                const RunOptions& run = {});
    /// One without a file.
    [[nodiscard]] static Project in_memory(const FollowOptions& options,
                                           const std::optional<ScanPosition>& position = {},
                                           const RunOptions& run = {});
    Project(Project&&) noexcept;
    Project& operator=(Project&&) = delete;
    Project(const Project&) = delete;
    Project& operator=(const Project&) = delete;
    /// What was not saved is lost.
    ~Project();

    // Changes. A project that was opened to be read has none: std::logic_error.

    /// Adds a scan, as Follower::add_scan(). Saves when the last save is half a second old: with
    /// the longest update and the time of a save, less than a second is ever lost. When that fails,
    /// the scan is added nevertheless.
    FollowUpdate add(const Scan& scan);
    /// Sets cells, as Follower::update_cells(); saves as above.
    FollowUpdate add(const Raster<CellState>& patch);
    /// Adds the next scan of its source, and moves the position on. One that cannot be used is left
    /// out and counted, with its place if that is known ("line 12"): a robot's log goes on. Saves
    /// as above. @pre there is a position
    std::optional<FollowUpdate> add_next(const Scan& scan, std::string_view place = {});
    /// Where the source is; saved by the next save.
    void set_position(const std::optional<ScanPosition>& position);
    /// Decides a part of a room again: what idle time is for. False when there is nothing to do.
    /// The update that comes next tells what became of it.
    bool refine();
    /// Cuts what is left, and saves; nothing when that was done, and nothing was added since.
    void finish();
    /// Changes rooms as Follower::edit() does; a name is kept without the spaces at its ends.
    /// Returns what was done. Not saved before the next save.
    EditRecord edit(const Edit& edit);
    /// Takes the last edit back that holds, or makes the first again of those that were undone
    /// last, and returns which. Throws InputError when there is none, or when it says why that is
    /// not possible any more.
    EditRecord undo();
    EditRecord redo();
    /// Writes all that has changed since the last save; after one that has failed none can be made.
    /// Nothing in memory. O(changes).
    void save();

    // Questions.

    /// The building after the last change, or after an earlier one while another is being made,
    /// but not before revision `at_least`. It is made at most once a revision, and handed out to
    /// all who ask. A reader waits only while there is none at all, or none so late.
    [[nodiscard]] std::shared_ptr<const Snapshot> snapshot(std::uint64_t at_least = 0) const;
    /// What changed after a revision, for any number of listeners; everything for those who know of
    /// none (0) or of one of another time that it was open. O(what changed). Waits for no change.
    [[nodiscard]] Changes changes_since(std::uint64_t revision) const;
    /// After the last change.
    [[nodiscard]] ProjectState state() const;
    /// All edits of people, the first first.
    [[nodiscard]] std::vector<EditRecord> history() const;
    [[nodiscard]] std::optional<ScanPosition> position() const;
    [[nodiscard]] const FollowOptions& options() const;

    /// A file that holds all, saved or not. @pre it was not opened to be read. Waits for changes.
    [[nodiscard]] std::string file_bytes();

private:
    struct Impl;
    explicit Project(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace quadcut
