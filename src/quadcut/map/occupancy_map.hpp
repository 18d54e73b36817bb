// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/leaf.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/map/root.hpp"
#include "quadcut/map/state_pyramid.hpp"
#include "quadcut/map/tile.hpp"
#include "quadcut/map/tile_store.hpp"

namespace quadcut {

/// What a batch of writes did to the quadtree.
struct MapUpdate {
    /// Nodes of the tree in and above the 8 x 8-cell tiles whose log-odds changed.
    std::size_t nodes_touched = 0;
    /// Nodes that did not exist before, or had another state as leaves.
    std::size_t nodes_rebuilt = 0;
    /// The smallest block of the tree, a tile at least, that covers what was written or observed.
    /// Nothing if nothing was. Eq. (12): ps = num_nodes_in(covering) / num_nodes()
    std::optional<Root> covering;
    /// The 8 x 8-cell tiles whose log-odds may have changed, in Z order.
    std::vector<Cell> written;
    /// The tiles that a scan speaks of, changed or not, row by row.
    std::vector<Cell> observed;
};

/// The quadtree map: log-odds of being occupied in square cells, and the tree of maximal aligned
/// square blocks of one state (unknown, free, occupied) over them.
///
/// Stored are 8 x 8-cell tiles under a rectangular directory cropped to what was written, and one
/// byte for each tree node of tile size and up; no node is allocated on its own. Uniform tiles
/// collapse to their directory entry. Blocks are aligned relative to the root's lower left; the
/// root doubles towards the side where it is left, so that no block ever moves.
///
/// Writes are batched: look-ups see a write at once; the tree (leaves, counts) is that of the last
/// commit(), and asking for it while writes are pending throws std::logic_error.
///
/// Limits: -2^28 <= cell < 2^28 a side, and 2^25 tiles of bounding box (2.3 km x 2.3 km at 5 cm). A
/// write beyond them throws InputError and changes nothing.
class OccupancyMap {
public:
    /// An empty map. Its root is placed by the first write.
    /// Throws InputError unless 0 < resolution_m < infinity and the pose is finite.
    explicit OccupancyMap(double resolution_m, const Pose& world_from_map = {});
    /// An empty map whose root has its place: of tile size (level 3) or more, its lower left a
    /// multiple of 8. Throws InputError as above and when the root does not fit the limits.
    OccupancyMap(double resolution_m, const Pose& world_from_map, const Root& root);

    /// Free and occupied cells get the log-odds bounds. Cells keep their addresses; the root's
    /// lower left is a multiple of 1024, so that a part of a map has the blocks of the whole.
    /// O(cells).
    [[nodiscard]] static OccupancyMap from_grid(const GridMap& grid);
    /// The bounding box of what is known, from cell (0, 0) on; its pose is moved accordingly.
    [[nodiscard]] GridMap to_grid() const;
    /// The bounding box of what is known, with the map's own cell addresses.
    [[nodiscard]] Raster<CellState> to_raster() const;

    [[nodiscard]] double resolution_m() const { return resolution_m_; }
    /// The pose of the lower left corner of cell (0, 0).
    [[nodiscard]] const Pose& world_from_map() const { return world_from_map_; }
    /// The cell that holds a point of the world, metres. Throws InputError beyond the limits.
    [[nodiscard]] Cell cell_at(const Point& world) const;

    /// O(1) for any cell; unknown outside.
    [[nodiscard]] CellState state(Cell cell) const { return state_of(store_.log_odds(cell)); }
    /// kMinLogOdds .. kMaxLogOdds, 0 where nothing was observed. O(1) for any cell.
    [[nodiscard]] int log_odds(Cell cell) const { return store_.log_odds(cell); }

    /// The 8 x 8 cells (8 tile.x .., 8 tile.y ..). The reference dies with the next write.
    [[nodiscard]] const Tile& tile(Cell tile) const { return store_.tile(tile); }
    /// Whether these all share one value, and which; kMaxLogOdds + 1 if they do not.
    [[nodiscard]] bool is_uniform_tile(Cell tile) const { return store_.is_uniform(tile); }
    [[nodiscard]] int shared_log_odds(Cell tile) const { return store_.shared_log_odds(tile); }

    [[nodiscard]] const Root& root() const { return root_; }
    /// Whether the root has its place; false until the first write.
    [[nodiscard]] bool is_placed() const { return is_placed_; }
    /// A rectangle of tiles that holds all that is known.
    [[nodiscard]] Box written_tiles() const { return store_.directory().box(); }
    /// Leaves of the root, unknown ones included.
    [[nodiscard]] std::size_t num_leaves() const;
    /// Leaves and inner nodes: every inner node has four children.
    [[nodiscard]] std::size_t num_nodes() const { return (4 * num_leaves() - 1) / 3; }
    /// Nodes in a block of the tree, its own included; 1 if it lies inside a leaf.
    /// O(nodes of tile size and up in the block).
    /// @pre the block is the root or an aligned block of tile size and up inside of it.
    [[nodiscard]] std::size_t num_nodes_in(const Root& block) const;
    /// The smallest block of tile size and up that covers low .. high (inclusive).
    /// @pre both lie in the root.
    [[nodiscard]] Root block_around(Cell low, Cell high) const;
    /// All leaves of the root in depth-first (Z) order. O(leaves).
    [[nodiscard]] std::vector<Leaf> leaves() const;
    /// Bytes held.
    [[nodiscard]] std::size_t bytes() const;

    /// Makes room for cells low .. high (inclusive) at once, growing the root if need be.
    void reserve(Cell low, Cell high);
    /// Sets a cell to certainly free or occupied (a log-odds bound), or to never observed.
    void set_state(Cell cell, CellState state);
    /// Replaces the 8 x 8 cells (8 tile.x .., 8 tile.y ..).
    void set_tile(Cell tile, const Tile& values);
    /// Gives back the bytes that are kept for tiles to come.
    void shrink_to_fit() { store_.compact(); }
    /// Ends a batch: collapses, brings the tree up to date and reports.
    /// O(t log t + layers t) for t tiles whose cells changed.
    MapUpdate commit();

private:
    struct Pending {
        Cell tile;
        TileStates before;
    };

    /// Position in the pyramid's layer 0.
    [[nodiscard]] Cell tile_position(Cell tile) const {
        return root_.position(kTileBits, first_cell_of(tile));
    }
    void require_committed() const;
    void grow(const Box& tiles);

    double resolution_m_;
    Pose world_from_map_;
    Pose map_from_world_;
    Root root_{{0, 0}, kTileBits};
    bool is_placed_ = false;
    TileStore store_;
    StatePyramid pyramid_;
    std::vector<Pending> pending_;
    /// The root of the tree that num_leaves_ counts.
    Root committed_root_ = root_;
    std::size_t num_leaves_ = 1;
};

}  // namespace quadcut
