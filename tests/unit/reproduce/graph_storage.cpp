// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/graph_storage.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace quadcut::reproduce {
namespace {

TEST(GraphStorage, BytesOfEachStorage) {
    const std::vector<WeightedEdge> edges{{0, 1, 1.0}, {1, 2, 2.0}, {2, 3, 3.0}, {3, 3, 4.0}};
    const Graph path = build_graph(edges, std::vector<double>(4, 1.0));
    EXPECT_EQ(dense_bytes(path), 4U * 4U * 8U);
    EXPECT_EQ(csr_bytes(path), 5U * 8U + 7U * 12U);
    EXPECT_EQ(dia_bytes(path), 3U * (8U + 4U * 8U)) << "a path lies on three diagonals";
    EXPECT_EQ(dia_bytes(Graph{}), 0U);
}

}  // namespace
}  // namespace quadcut::reproduce
