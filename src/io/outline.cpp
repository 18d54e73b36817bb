// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/outline.hpp"

#include <array>
#include <utility>

#include "io/connected_cells.hpp"

namespace quadcut::io {
namespace {

/// The top bit of a cell marks that its lower edge has been walked along.
constexpr std::uint32_t kWalked = std::uint32_t{1} << 31U;

// Directions in counter-clockwise order.
constexpr int kEast = 0;
constexpr int kNumDirections = 4;
constexpr std::array<Cell, kNumDirections> kStep = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
/// Walks along the borders of numbered regions.
class Tracer {
public:
    Tracer(CellRegions& regions, std::uint32_t diagonal_value)
        : regions_(regions), cells_(regions.numbers), diagonal_value_(diagonal_value) {}

    /// Whether a ring starts at the lower edge of this cell.
    [[nodiscard]] bool starts_ring(std::int32_t x, std::int32_t y) const {
        const std::uint32_t cell = cells_.values[place(x, y)];
        return cell != 0 && (cell & kWalked) == 0 && region_at(x, y - 1) != cell;
    }

    OutlineRing walk(std::int32_t x, std::int32_t y) {
        const std::uint32_t region = cells_.values[place(x, y)];
        const Cell start{x, y};
        OutlineRing ring;
        Cell corner = start;
        int direction = kEast;
        do {
            if (direction == kEast) cells_.values[place(corner.x, corner.y)] |= kWalked;
            corner.x += kStep[static_cast<std::size_t>(direction)].x;
            corner.y += kStep[static_cast<std::size_t>(direction)].y;
            const int turned = turn(corner, direction, region);
            const bool junction = is_junction(corner);
            if (turned != direction || junction) ring.push_back({corner.x, corner.y, junction});
            direction = turned;
        } while (corner != start || direction != kEast);
        return ring;
    }

private:
    [[nodiscard]] std::size_t place(std::int32_t x, std::int32_t y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(cells_.width) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] std::uint32_t region_at(std::int32_t x, std::int32_t y) const {
        if (x < 0 || y < 0 || x >= cells_.width || y >= cells_.height) return 0;
        return cells_.values[place(x, y)] & ~kWalked;
    }

    [[nodiscard]] bool joins_diagonally(std::uint32_t region) const {
        return diagonal_value_ != 0 && region != 0 &&
               regions_.values[region - 1] == diagonal_value_;
    }

    /// The regions of the four cells around a corner, counter-clockwise from the upper right one.
    [[nodiscard]] std::array<std::uint32_t, kNumDirections> around(Cell corner) const {
        return {region_at(corner.x, corner.y), region_at(corner.x - 1, corner.y),
                region_at(corner.x - 1, corner.y - 1), region_at(corner.x, corner.y - 1)};
    }

    /// Where to go on from a corner with the region on the left. Where only the corner joins two
    /// cells of the region, right: then a hole that touches the outside there stays a hole, and
    /// no ring passes a point twice. But left, if the corner joins cells of the diagonal value.
    [[nodiscard]] int turn(Cell corner, int direction, std::uint32_t region) const {
        const std::array<std::uint32_t, kNumDirections> cells = around(corner);
        const auto cell = [&](int side) {
            return cells[static_cast<std::size_t>((side + kNumDirections) % kNumDirections)];
        };
        // Travelling in direction d, cell d is ahead on the left, d - 1 ahead on the right, d - 2
        // behind on the right.
        const bool left_ahead = cell(direction) == region;
        const bool right_ahead = cell(direction - 1) == region;
        const bool parted = !left_ahead && cell(direction) == cell(direction - 2) &&
                            joins_diagonally(cell(direction));
        if (right_ahead && !parted) return (direction + kNumDirections - 1) % kNumDirections;
        return left_ahead ? direction : (direction + 1) % kNumDirections;
    }

    [[nodiscard]] bool is_junction(Cell corner) const {
        const std::array<std::uint32_t, kNumDirections> cells = around(corner);
        int num_edges = 0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (cells[i] != cells[(i + 1) % cells.size()]) ++num_edges;
        }
        // Borders pass on either side of cells that are joined at the corner.
        const bool joined = (cells[0] == cells[2] && joins_diagonally(cells[0])) ||
                            (cells[1] == cells[3] && joins_diagonally(cells[1]));
        return num_edges > 2 && !joined;
    }

    const CellRegions& regions_;
    Raster<std::uint32_t>& cells_;
    std::uint32_t diagonal_value_;
};

}  // namespace

std::vector<RegionOutline> trace_outlines(Raster<std::uint32_t> values,
                                          std::uint32_t diagonal_value) {
    CellRegions regions = number_connected(std::move(values), diagonal_value);
    std::vector<RegionOutline> outlines(regions.values.size());
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        outlines[i].value = regions.values[i];
        outlines[i].num_cells = regions.num_cells[i];
    }
    Tracer tracer(regions, diagonal_value);
    const Raster<std::uint32_t>& cells = regions.numbers;
    std::size_t place = 0;
    for (std::int32_t y = 0; y < cells.height; ++y) {
        for (std::int32_t x = 0; x < cells.width; ++x, ++place) {
            if (!tracer.starts_ring(x, y)) continue;
            const std::uint32_t region = cells.values[place];
            OutlineRing ring = tracer.walk(x, y);
            for (OutlinePoint& point : ring) {
                point.x += cells.origin.x;
                point.y += cells.origin.y;
            }
            outlines[region - 1].rings.push_back(std::move(ring));
        }
    }
    return outlines;
}

std::vector<Cell> corners_of(const OutlineRing& ring) {
    std::vector<Cell> corners;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const OutlinePoint& before = ring[(i + ring.size() - 1) % ring.size()];
        const OutlinePoint& here = ring[i];
        const OutlinePoint& after = ring[(i + 1) % ring.size()];
        const bool straight =
            (before.x == here.x && here.x == after.x) || (before.y == here.y && here.y == after.y);
        if (!straight) corners.push_back({here.x, here.y});
    }
    return corners;
}

}  // namespace quadcut::io
