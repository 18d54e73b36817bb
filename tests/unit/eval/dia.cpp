// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

#include "eval/dia.hpp"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/random.hpp"

namespace quadcut {
namespace {

Graph path_of_four() {
    const std::vector<WeightedEdge> edges{{0, 1, 1.0}, {1, 2, 2.0}, {2, 3, 3.0}, {3, 3, 4.0}};
    return build_graph(edges, std::vector<double>(4, 1.0));
}

TEST(Dia, APathLiesOnThreeDiagonals) {
    const Graph graph = path_of_four();
    const DiaMatrix matrix = build_dia(graph, 1000);
    EXPECT_EQ(matrix.offsets, (std::vector<std::int64_t>{-1, 0, 1}));
    EXPECT_EQ(matrix.values, (std::vector<double>{0, 1, 2, 3,  //
                                                  0, 0, 0, 4,  //
                                                  1, 2, 3, 0}));
    EXPECT_EQ(multiply(matrix, std::vector<double>{1, 10, 100, 1000}),
              (std::vector<double>{10, 201, 3020, 4300}));
}

TEST(Dia, BytesOfEachStorage) {
    const Graph graph = path_of_four();
    EXPECT_EQ(dense_bytes(graph), 4U * 4U * 8U);
    EXPECT_EQ(csr_bytes(graph), 5U * 8U + 7U * 12U);
    EXPECT_EQ(dia_bytes(graph), 3U * (8U + 4U * 8U));
}

TEST(Dia, ABoundOnTheBytesIsKept) {
    const Graph graph = path_of_four();
    EXPECT_NO_THROW((void)build_dia(graph, 120));
    EXPECT_THROW((void)build_dia(graph, 119), std::length_error);
}

TEST(Dia, EmptyGraph) {
    EXPECT_EQ(dia_bytes(Graph{}), 0U);
    EXPECT_TRUE(multiply(build_dia(Graph{}, 0), {}).empty());
}

TEST(Dia, TheProductIsThatOfTheRows) {
    Random random(3);
    std::vector<WeightedEdge> edges;
    constexpr std::uint32_t kNodes = 60;
    for (int i = 0; i < 300; ++i) {
        edges.push_back({static_cast<std::uint32_t>(random.below(kNodes)),
                         static_cast<std::uint32_t>(random.below(kNodes)), random.uniform()});
    }
    const Graph graph = build_graph(edges, std::vector<double>(kNodes, 1.0));
    std::vector<double> x(kNodes);
    for (double& value : x) value = random.uniform(-1.0, 1.0);
    const DiaMatrix matrix = build_dia(graph, dia_bytes(graph));
    // Both sum a row by ascending column, so not even the rounding differs.
    EXPECT_EQ(multiply(matrix, x), multiply(graph, x));
    EXPECT_THROW((void)multiply(matrix, std::vector<double>(3)), std::logic_error);
    EXPECT_THROW((void)multiply(graph, std::vector<double>(3)), std::logic_error);
}

}  // namespace
}  // namespace quadcut
