// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "quadcut/route/sight.hpp"

namespace quadcut {

/// A way over cells, each a neighbour of the one before; empty when there is none.
struct CellWay {
    std::vector<Cell> cells;
    /// In cells: 1 a straight step, the root of 2 a diagonal one.
    double length = 0.0;
    /// Cells that were looked at, each counted once however often that was.
    std::size_t num_cells_read = 0;
};

/// A* over the cells where the robot fits, 8 neighbours, with the octile distance: what ways are
/// measured by. A diagonal step needs both cells beside it. Keeps its memory, so that a search
/// costs what it reads and not what the map has.
class CellSearch {
public:
    explicit CellSearch(const RobotFloor& floor)
        : floor_(floor), nodes_(floor.clearance_m.values.size()) {}

    CellWay find(Cell from, Cell to) {
        ++search_;
        num_read_ = 0;
        queue_ = {};
        const Raster<float>& cells = floor_.clearance_m;
        const std::size_t goal = cells.offset(to);
        reach(cells.offset(from), 0.0F, kNoStep, to);
        while (!queue_.empty()) {
            const auto [bound, offset] = queue_.top();
            queue_.pop();
            if (offset == goal) return way_to(to);
            Node& node = nodes_[offset];
            if (node.is_done) continue;
            node.is_done = true;
            expand(cells.cell(offset), node.length, to);
        }
        return {{}, 0.0, num_read_};
    }

private:
    static constexpr std::uint8_t kNoStep = 8;
    static constexpr std::array<Cell, 8> kSteps{
        {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    static constexpr float kDiagonal = 1.41421356F;

    struct Node {
        std::uint32_t search = 0;
        float length = 0.0F;
        std::uint8_t step = kNoStep;
        bool is_done = false;
        bool fits = false;
    };
    using Entry = std::pair<float, std::size_t>;

    static float octile(Cell a, Cell b) {
        const auto x = static_cast<float>(std::abs(a.x - b.x));
        const auto y = static_cast<float>(std::abs(a.y - b.y));
        return std::max(x, y) + (kDiagonal - 1.0F) * std::min(x, y);
    }
    /// Notes that the cell was read.
    Node& node_at(std::size_t offset) {
        Node& node = nodes_[offset];
        if (node.search == search_) return node;
        node = {search_, std::numeric_limits<float>::infinity(), kNoStep, false,
                floor_.clearance_m.values[offset] >= floor_.radius_m};
        ++num_read_;
        return node;
    }
    bool fits(Cell cell) {
        return floor_.clearance_m.contains(cell) && node_at(floor_.clearance_m.offset(cell)).fits;
    }
    void reach(std::size_t offset, float length, std::uint8_t step, Cell to) {
        Node& node = node_at(offset);
        if (length >= node.length) return;
        node.length = length;
        node.step = step;
        queue_.push({length + octile(floor_.clearance_m.cell(offset), to), offset});
    }
    void expand(Cell cell, float length, Cell to) {
        for (std::size_t i = 0; i < kSteps.size(); ++i) {
            const Cell step = kSteps[i];
            const Cell next{cell.x + step.x, cell.y + step.y};
            if (!fits(next)) continue;
            const bool is_diagonal = i >= 4;
            if (is_diagonal && !(fits({next.x, cell.y}) && fits({cell.x, next.y}))) continue;
            reach(floor_.clearance_m.offset(next), length + (is_diagonal ? kDiagonal : 1.0F),
                  static_cast<std::uint8_t>(i), to);
        }
    }
    CellWay way_to(Cell to) {
        CellWay way{{to}, 0.0, num_read_};
        for (Cell cell = to;;) {
            const std::uint8_t step = nodes_[floor_.clearance_m.offset(cell)].step;
            if (step == kNoStep) break;
            way.length += step >= 4 ? std::sqrt(2.0) : 1.0;
            cell = {cell.x - kSteps[step].x, cell.y - kSteps[step].y};
            way.cells.push_back(cell);
        }
        std::reverse(way.cells.begin(), way.cells.end());
        return way;
    }

    const RobotFloor& floor_;
    std::vector<Node> nodes_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
    std::uint32_t search_ = 0;
    std::size_t num_read_ = 0;
};

/// How long the way is when it is pulled straight, in cells: from each bend on to the farthest of
/// its cells up to which the robot can go straight.
inline double pulled_length(const CellWay& way, const RobotFloor& floor) {
    Sight sight(floor);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < way.cells.size();) {
        std::size_t next = i + 1;
        for (std::size_t j = i + 2; j < way.cells.size(); ++j) {
            if (sight.sees(way.cells[i], way.cells[j])) next = j;
        }
        length += static_cast<double>(cells_between(way.cells[i], way.cells[next]));
        i = next;
    }
    return length;
}

}  // namespace quadcut
