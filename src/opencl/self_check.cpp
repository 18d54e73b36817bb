// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/self_check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/visibility.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut::opencl {
namespace {

/// Two rooms with pillars and an unknown corner: leaves of all sizes, sight along rows, columns and
/// slopes, past corners and through gaps.
GridMap small_map() {
    GridMap map;
    map.states = Raster<CellState>({0, 0}, 64, 64, CellState::free);
    for (std::int32_t i = 0; i < 64; ++i) {
        if (i < 40 || i > 48) map.states.at({33, i}) = CellState::occupied;
        map.states.at({i, i * i * 7 % 61}) = CellState::occupied;
        if (i < 9) map.states.at({i, 63}) = CellState::unknown;
    }
    return map;
}

bool are_same(const std::vector<WeightedEdge>& p, const std::vector<WeightedEdge>& q) {
    return std::equal(
        p.begin(), p.end(), q.begin(), q.end(), [](const WeightedEdge& a, const WeightedEdge& b) {
            return a.a == b.a && a.b == b.b &&
                   std::bit_cast<std::uint64_t>(a.weight) == std::bit_cast<std::uint64_t>(b.weight);
        });
}

/// Passes the products of a Laplacian on to a stage.
class Products final : public Accelerator {
public:
    explicit Products(ProductStage& stage) : stage_(stage) {}
    std::optional<std::vector<WeightedEdge>> sight_edges(const LeafTable& /*table*/,
                                                         std::span<const LeafId> /*nodes*/,
                                                         double /*resolution_m*/,
                                                         SelfLoops /*self_loops*/) override {
        return std::nullopt;
    }
    bool multiply(const MatrixRows& matrix, std::span<const double> block,
                  std::span<double> result) override {
        stage_.multiply(matrix, block, result);
        return true;
    }

private:
    ProductStage& stage_;
};

}  // namespace

void check_against_cpu(SightStage& stage) {
    const GridMap map = small_map();
    const FreeLeaves leaves = free_leaves(map);
    for (const SelfLoops loops : {SelfLoops::own_weight, SelfLoops::largest_weight}) {
        if (!are_same(stage.find(leaves.table, leaves.nodes, map.resolution_m, loops),
                      sight_edges(leaves.table, leaves.nodes, map.resolution_m, loops))) {
            throw DeviceError("its edges are not those of the CPU");
        }
    }
}

void check_against_cpu(ProductStage& stage) {
    const GridMap map = small_map();
    const FreeLeaves leaves = free_leaves(map);
    const Laplacian laplacian(
        build_graph(sight_edges(leaves.table, leaves.nodes, map.resolution_m),
                    leaf_areas_m2(leaves.table, leaves.nodes, map.resolution_m)),
        LaplacianKind::degree);
    // More vectors than are on their way at a time; no value is short, so that a fused operation
    // rounds to other bits.
    std::vector<double> block(17 * laplacian.size());
    for (std::size_t i = 0; i < block.size(); ++i) block[i] = std::sin(static_cast<double>(i));
    std::vector<double> expected(block.size());
    std::vector<double> found(block.size());
    laplacian.apply_block(block, expected);
    Products products(stage);
    laplacian.apply_block(block, found, {1, &products});
    if (found != expected) throw DeviceError("its products are not those of the CPU");
}

}  // namespace quadcut::opencl
