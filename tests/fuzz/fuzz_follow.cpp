// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/base/error.hpp"
#include "quadcut/follow/check_followed.hpp"
#include "quadcut/follow/follower.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/segment/result.hpp"

// The bytes are a sequence of scans, patches, edits, saves and loads. Beside the follower goes a
// plain model: the log-odds of each cell, the ids that were ever given, and what was saved.

namespace {

using quadcut::Cell;
using quadcut::RoomId;

/// All that the bytes can reach.
constexpr std::int32_t kLow = -128;
constexpr std::int32_t kSide = 320;
constexpr double kResolutionM = 0.1;

void require(bool is_so) {
    if (!is_so) __builtin_trap();
}

class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    [[nodiscard]] bool is_empty() const { return size_ == 0; }
    std::uint8_t byte() {
        if (size_ == 0) return 0;
        --size_;
        return *data_++;
    }
    /// -6.4 .. 6.35 m.
    double metres() { return (static_cast<int>(byte()) - 128) * 0.05; }
    Cell cell() { return {byte() % 128 - 64, byte() % 128 - 64}; }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

quadcut::FollowOptions options() {
    quadcut::FollowOptions options;
    options.resolution_m = kResolutionM;
    options.first_cut_m2 = 4.0;
    return options;
}

class Fuzz {
public:
    explicit Fuzz(Bytes bytes) : bytes_(bytes), follower_(options(), quadcut::RunOptions{1}) {}

    void run() {
        for (int i = 0; i < 40 && !bytes_.is_empty(); ++i) {
            switch (bytes_.byte() % 8) {
                case 0:
                case 1:
                    scan();
                    break;
                case 2:
                case 3:
                    patch();
                    break;
                case 4:
                    edit();
                    break;
                case 5:
                    note(follower_.finish());
                    break;
                case 6:
                    if (const auto update = follower_.refine()) note(*update);
                    break;
                default:
                    save_and_load();
            }
            check();
        }
    }

private:
    void scan() {
        quadcut::Scan scan;
        scan.world_from_sensor = {bytes_.metres() / 3.0, bytes_.metres() / 3.0, bytes_.metres()};
        scan.angle_step_rad = 0.1;
        scan.max_range_m = 8.0;
        scan.ranges_m.resize(bytes_.byte() % 64);
        for (float& range : scan.ranges_m) range = static_cast<float>(bytes_.byte()) * 0.02F;
        const auto evidence = quadcut::evidence_of(follower_.map(), scan);
        note(follower_.add_scan(scan));
        const quadcut::IntegrateOptions how;
        for (const quadcut::TileEvidence& one : evidence) {
            const Cell low = quadcut::first_cell_of(one.tile);
            for (std::size_t i = 0; i < quadcut::kTileCells; ++i) {
                const int delta = (one.hit >> i & 1) != 0    ? how.hit
                                  : (one.miss >> i & 1) != 0 ? how.miss
                                                             : 0;
                if (delta == 0) continue;
                std::int8_t& value = log_odds_.at({low.x + static_cast<std::int32_t>(i % 8),
                                                   low.y + static_cast<std::int32_t>(i / 8)});
                value = quadcut::bounded_sum(value, delta);
            }
        }
    }

    void patch() {
        const Cell low = bytes_.cell();
        const std::int32_t width = 1 + bytes_.byte() % 64;
        const std::int32_t height = 1 + bytes_.byte() % 64;
        const auto state = static_cast<quadcut::CellState>(bytes_.byte() % 3);
        note(follower_.update_cells({low, width, height, state}));
        for (std::int32_t y = 0; y < height; ++y) {
            for (std::int32_t x = 0; x < width; ++x) {
                log_odds_.at({low.x + x, low.y + y}) = quadcut::log_odds_of(state);
            }
        }
    }

    RoomId some_room() {
        const auto& rooms = follower_.state().rooms;
        if (rooms.empty()) return RoomId{bytes_.byte()};
        auto at = rooms.begin();
        std::advance(at, bytes_.byte() % rooms.size());
        return RoomId{at->first};
    }

    void edit() {
        before_ = rooms_of_cells();
        const std::uint8_t kind = bytes_.byte() % 6;
        quadcut::Edit edit{
            static_cast<quadcut::EditKind>(kind), some_room(), some_room(), {}, {}, {}};
        edit.name = std::string(1, static_cast<char>(bytes_.byte()));
        if (edit.kind == quadcut::EditKind::split) {
            edit.from = {bytes_.metres(), bytes_.metres()};
            edit.to = {bytes_.metres(), bytes_.metres()};
        }
        try {
            if (kind == 5) {
                turn();
            } else {
                keep(follower_.edit(edit));
            }
        } catch (const quadcut::InputError&) {
        }
    }

    /// What is done at once and taken back leaves the cells as they were.
    void keep(const quadcut::Edited& edited) {
        note(edited.update);
        // It may have unlocked a room for a moment.
        locked_cells_.clear();
        const auto once = rooms_of_cells();
        const quadcut::Edited back = follower_.apply(edited.inverse);
        const bool is_cut = edited.update.segment_ms + back.update.segment_ms > 0.0;
        require(is_cut || rooms_of_cells() == before_);
        const quadcut::Edited again = follower_.apply(back.inverse);
        require(is_cut || again.update.segment_ms > 0.0 || rooms_of_cells() == once);
        edits_.push_back(again.inverse);
    }

    /// Takes back what was done some time ago, in whatever order.
    void turn() {
        if (edits_.empty()) return;
        quadcut::Reversal& edit = edits_[bytes_.byte() % edits_.size()];
        const quadcut::Edited edited = follower_.apply(edit);
        locked_cells_.clear();
        edit = edited.inverse;
    }

    std::vector<std::uint32_t> rooms_of_cells() const {
        std::vector<std::uint32_t> rooms;
        for (std::size_t i = 0; i < log_odds_.values.size(); ++i) {
            rooms.push_back(follower_.state().cells.room(log_odds_.cell(i)));
        }
        return rooms;
    }

    void save_and_load() {
        const quadcut::FollowedMap& now = follower_.state();
        const quadcut::Changes changes = follower_.changes_since(saved_revision_);
        saved_revision_ = changes.revision;
        for (const Cell tile : changes.tiles) {
            saved_[{tile.y, tile.x}] = {now.map.tile(tile), now.cells.tile(tile)};
        }
        quadcut::FollowedMap state = now;
        state.map = now.map.is_placed() ? quadcut::OccupancyMap(kResolutionM, {}, now.map.root())
                                        : quadcut::OccupancyMap(kResolutionM);
        state.cells = {};
        for (const auto& [at, tile] : saved_) {
            quadcut::add_tile(state, {at.second, at.first}, tile.first, tile.second);
        }
        state.map.commit();
        follower_ = quadcut::Follower(options(), std::move(state), quadcut::RunOptions{1});
        static_cast<void>(follower_.rooms());
    }

    void note(const quadcut::FollowUpdate& update) {
        for (const quadcut::RoomEvent& event : update.events) {
            const bool is_new = event.change == quadcut::RoomChange::born ||
                                event.change == quadcut::RoomChange::split;
            const auto id = static_cast<std::uint32_t>(event.room);
            if (is_new) require(ids_.insert(id).second);
        }
    }

    void check() {
        std::map<std::uint32_t, std::size_t> cells;
        for (std::size_t i = 0; i < log_odds_.values.size(); ++i) {
            const Cell cell = log_odds_.cell(i);
            require(follower_.map().log_odds(cell) == log_odds_.values[i]);
            const std::uint32_t room = follower_.state().cells.room(cell);
            if (room != 0) ++cells[room];
        }
        require(cells.size() == follower_.num_rooms());
        for (const auto& [id, room] : follower_.state().rooms) {
            require(cells[id] == room.num_cells && room.num_cells > 0);
            // A locked room keeps its cells.
            if (room.is_locked) {
                require(locked_cells_.emplace(id, room.num_cells).first->second == room.num_cells);
            } else {
                locked_cells_.erase(id);
            }
        }
        require(follower_.map().leaves().size() == follower_.map().num_leaves());
    }

    Bytes bytes_;
    quadcut::Follower follower_;
    quadcut::Raster<std::int8_t> log_odds_{{kLow, kLow}, kSide, kSide};
    std::map<std::pair<std::int32_t, std::int32_t>, std::pair<quadcut::Tile, quadcut::RoomTile>>
        saved_;
    std::uint64_t saved_revision_ = 0;
    std::set<std::uint32_t> ids_;
    std::map<std::size_t, std::size_t> locked_cells_;
    std::vector<quadcut::Reversal> edits_;
    /// The rooms of all cells before an edit.
    std::vector<std::uint32_t> before_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Fuzz(Bytes(data, size)).run();
    return 0;
}
