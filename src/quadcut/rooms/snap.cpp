// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/snap.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace quadcut {
namespace {

constexpr auto kNoPiece = static_cast<std::uint32_t>(-1);

/// How many cells of one basin each piece holds; a basin meets few pieces.
using Shares = std::vector<std::pair<std::uint32_t, std::size_t>>;

void add_cells(Shares& shares, std::uint32_t piece) {
    for (auto& [other, num_cells] : shares) {
        if (other != piece) continue;
        ++num_cells;
        return;
    }
    shares.emplace_back(piece, 1);
}

/// The piece that holds most of each basin; the smaller piece wins a tie.
std::vector<std::uint32_t> majority_pieces(const Basins& basins, const LeafTable& leaves,
                                           std::span<const LeafId> nodes,
                                           std::span<const std::uint32_t> piece_of_node) {
    std::vector<Shares> shares(basins.count + 1);
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        const Leaf& leaf = leaves.leaf(nodes[node]);
        for (std::int32_t y = 0; y < leaf.side_cells(); ++y) {
            for (std::int32_t x = 0; x < leaf.side_cells(); ++x) {
                const Cell cell{leaf.lower_left.x + x, leaf.lower_left.y + y};
                add_cells(shares[basins.labels.at(cell)], piece_of_node[node]);
            }
        }
    }
    std::vector<std::uint32_t> pieces(basins.count + 1, kNoPiece);
    for (std::uint32_t basin = 1; basin <= basins.count; ++basin) {
        std::size_t most = 0;
        for (const auto& [piece, num_cells] : shares[basin]) {
            if (num_cells > most || (num_cells == most && piece < pieces[basin])) {
                most = num_cells;
                pieces[basin] = piece;
            }
        }
    }
    return pieces;
}

}  // namespace

Basins snap_to_basins(const Basins& basins, const LeafTable& leaves, std::span<const LeafId> nodes,
                      std::span<const std::uint32_t> piece_of_node) {
    const std::vector<std::uint32_t> pieces = majority_pieces(basins, leaves, nodes, piece_of_node);
    std::vector<std::uint32_t> parent(basins.count + 1);
    std::iota(parent.begin(), parent.end(), 0U);
    const auto find = [&](std::uint32_t basin) {
        while (parent[basin] != basin) basin = parent[basin] = parent[parent[basin]];
        return basin;
    };
    const Raster<std::uint32_t>& labels = basins.labels;
    const auto meet = [&](std::uint32_t p, std::uint32_t q) {
        if (p == q || p == 0 || q == 0 || pieces[p] != pieces[q] || pieces[p] == kNoPiece) return;
        const std::uint32_t a = find(p);
        const std::uint32_t b = find(q);
        parent[std::max(a, b)] = std::min(a, b);
    };
    const auto width = static_cast<std::size_t>(labels.width);
    for (std::size_t i = 0; i < labels.values.size(); ++i) {
        if ((i + 1) % width != 0) meet(labels.values[i], labels.values[i + 1]);
        if (i + width < labels.values.size()) meet(labels.values[i], labels.values[i + width]);
    }
    Basins snapped{labels, 0};
    std::vector<std::uint32_t> number(basins.count + 1, 0);
    for (std::uint32_t& label : snapped.labels.values) {
        if (label == 0) continue;
        std::uint32_t& own = number[find(label)];
        if (own == 0) own = ++snapped.count;
        label = own;
    }
    return snapped;
}

}  // namespace quadcut
