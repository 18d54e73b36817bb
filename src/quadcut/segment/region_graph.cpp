// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/segment/region_graph.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace quadcut {

RegionGraph::RegionGraph(const Raster<std::uint32_t>& pieces, std::uint32_t num_pieces,
                         const Raster<float>& clearance_m, double resolution_m)
    : pieces_(pieces),
      clearance_(clearance_m),
      gauge_(clearance_m, resolution_m),
      region_(num_pieces + 1),
      members_(num_pieces + 1),
      area_m2_(num_pieces + 1, 0.0),
      version_(num_pieces + 1, 0),
      saddles_(num_pieces + 1) {
    std::iota(region_.begin(), region_.end(), 0U);
    for (std::uint32_t piece = 1; piece <= num_pieces; ++piece) members_[piece] = {piece};
    for (const std::uint32_t piece : pieces.values) {
        area_m2_[piece] += resolution_m * resolution_m;
    }
    for (std::size_t i = 0; i < pieces.values.size(); ++i) {
        const Cell cell = pieces.cell(i);
        if (cell.x + 1 < pieces.origin.x + pieces.width) meet(cell, {cell.x + 1, cell.y});
        if (cell.y + 1 < pieces.origin.y + pieces.height) meet(cell, {cell.x, cell.y + 1});
    }
}

void RegionGraph::join(std::uint32_t a, std::uint32_t b) {
    for (const std::uint32_t piece : members_[b]) region_[piece] = a;
    members_[a].insert(members_[a].end(), members_[b].begin(), members_[b].end());
    members_[b].clear();
    area_m2_[a] += area_m2_[b];
    ++version_[a];
    saddles_[a].erase(b);
    for (const auto& [other, saddle] : saddles_[b]) {
        saddles_[other].erase(b);
        if (other == a) continue;
        widen(saddles_[a], other, saddle);
        widen(saddles_[other], a, {saddle.b, saddle.a, saddle.clearance_m, saddle.num_contacts});
    }
    saddles_[b].clear();
}

void RegionGraph::widen(std::map<std::uint32_t, Saddle>& saddles, std::uint32_t other,
                        const Saddle& saddle) {
    const auto [at, is_new] = saddles.emplace(other, saddle);
    if (is_new) return;
    const std::size_t num_contacts = at->second.num_contacts + saddle.num_contacts;
    if (saddle.clearance_m > at->second.clearance_m) at->second = saddle;
    at->second.num_contacts = num_contacts;
}

void RegionGraph::meet(Cell cell_a, Cell cell_b) {
    const std::uint32_t a = pieces_.at(cell_a);
    const std::uint32_t b = pieces_.at(cell_b);
    if (a == 0 || b == 0 || a == b) return;
    const float height = std::min(clearance_.at(cell_a), clearance_.at(cell_b));
    widen(saddles_[a], b, {cell_a, cell_b, height, 1});
    widen(saddles_[b], a, {cell_b, cell_a, height, 1});
}

}  // namespace quadcut
