// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/laplacian.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/spectral/fake_accelerator.hpp"
#include "tests/unit/spectral/test_graphs.hpp"

namespace quadcut {
namespace {

constexpr LaplacianKind kAllKinds[] = {LaplacianKind::degree, LaplacianKind::unweighted,
                                       LaplacianKind::area};

/// Column j of the matrix.
std::vector<double> column(const Laplacian& laplacian, std::size_t j) {
    std::vector<double> unit(laplacian.size(), 0.0);
    std::vector<double> result(laplacian.size());
    unit[j] = 1.0;
    laplacian.apply(unit, result);
    return result;
}

/// 0 -2- 1 -3- 2, a loop of 5 on node 1; areas 1, 4, 9.
Graph small_graph() {
    return build_graph(std::vector<WeightedEdge>{{0, 1, 2.0}, {1, 2, 3.0}, {1, 1, 5.0}},
                       {1.0, 4.0, 9.0});
}

TEST(Laplacian, DegreeKindTakesTheLoopIntoWAndD) {
    // d = 2, 10, 3.
    const Laplacian laplacian(small_graph(), LaplacianKind::degree);
    const auto c0 = column(laplacian, 0);
    const auto c1 = column(laplacian, 1);
    const auto c2 = column(laplacian, 2);
    EXPECT_NEAR(c0[0], 1.0, 1e-15);
    EXPECT_NEAR(c1[1], 1.0 - 5.0 / 10.0, 1e-15);
    EXPECT_NEAR(c2[2], 1.0, 1e-15);
    EXPECT_NEAR(c0[1], -2.0 / std::sqrt(2.0 * 10.0), 1e-15);
    EXPECT_NEAR(c1[0], c0[1], 1e-15);
    EXPECT_NEAR(c2[1], -3.0 / std::sqrt(3.0 * 10.0), 1e-15);
    EXPECT_EQ(c0[2], 0.0);
}

TEST(Laplacian, UnweightedKindIsAsPrinted) {
    // deg = 1, 2, 1; the loop is none.
    const Laplacian laplacian(small_graph(), LaplacianKind::unweighted);
    const auto c1 = column(laplacian, 1);
    EXPECT_NEAR(c1[0], -1.0 / std::sqrt(2.0), 1e-15);
    EXPECT_NEAR(c1[1], 1.0, 1e-15);
    EXPECT_NEAR(c1[2], -1.0 / std::sqrt(2.0), 1e-15);
}

TEST(Laplacian, AreaKindIsDividedByAreas) {
    const Laplacian laplacian(small_graph(), LaplacianKind::area);
    const auto c1 = column(laplacian, 1);
    EXPECT_NEAR(c1[0], -2.0 / std::sqrt(1.0 * 4.0), 1e-15);
    EXPECT_NEAR(c1[1], 5.0 / 4.0, 1e-15);
    EXPECT_NEAR(c1[2], -3.0 / std::sqrt(4.0 * 9.0), 1e-15);
    EXPECT_NEAR(laplacian.norm_bound(), 2.0 + 1.0, 1e-15);
}

TEST(Laplacian, NodeWithoutNeighboursIsARowOfZeros) {
    const Graph graph = build_graph(std::vector<WeightedEdge>{{0, 0, 3.0}}, {1.0, 1.0});
    for (const LaplacianKind kind : kAllKinds) {
        const Laplacian laplacian(graph, kind);
        EXPECT_EQ(column(laplacian, 0), (std::vector<double>{0.0, 0.0}));
        EXPECT_EQ(column(laplacian, 1), (std::vector<double>{0.0, 0.0}));
        EXPECT_GT(laplacian.norm_bound(), 0.0);
        EXPECT_NE(laplacian.null_vector()[1], 0.0);
    }
}

TEST(Laplacian, NullVectorOfARandomGraph) {
    Random random(5);
    const Graph graph = test::random_graph(random, 300, 2.0);
    for (const LaplacianKind kind : kAllKinds) {
        const Laplacian laplacian(graph, kind);
        std::vector<double> product(laplacian.size());
        laplacian.apply(laplacian.null_vector(), product);
        for (const double value : product) EXPECT_NEAR(value, 0.0, 1e-11 * laplacian.norm_bound());
    }
}

TEST(Laplacian, WeightZeroIsNoEdge) {
    const Graph graph =
        build_graph(std::vector<WeightedEdge>{{0, 1, 0.0}, {1, 2, 1.0}}, {1.0, 1.0, 1.0});
    for (const LaplacianKind kind : kAllKinds) {
        const Laplacian laplacian(graph, kind);
        EXPECT_TRUE(laplacian.row_columns(0).empty());
        EXPECT_EQ(laplacian.row_columns(1).size(), 1U);
    }
}

TEST(Laplacian, SameBytesOnOneAndManyThreads) {
    Random random(6);
    const Graph graph = test::random_graph(random, 30000, 2.0);
    const Laplacian laplacian(graph, LaplacianKind::area);
    std::vector<double> x(laplacian.size());
    for (double& value : x) value = random.normal();
    std::vector<double> reference(x.size());
    laplacian.apply(x, reference, {1});
    for (const int num_threads : {2, 3, 8}) {
        std::vector<double> result(x.size());
        laplacian.apply(x, result, {num_threads});
        EXPECT_EQ(result, reference);
    }
}

TEST(Laplacian, ABlockIsItsVectorsOneByOne) {
    Random random(7);
    const Laplacian laplacian(test::random_graph(random, 200, 2.0), LaplacianKind::degree);
    const std::size_t size = laplacian.size();
    std::vector<double> block(3 * size);
    for (double& value : block) value = random.normal();
    std::vector<double> expected(block.size());
    for (std::size_t j = 0; j < 3; ++j) {
        laplacian.apply(std::span(block).subspan(j * size, size),
                        std::span(expected).subspan(j * size, size));
    }
    test::FakeAccelerator declining(true);
    for (const Executor& executor : {Executor{1}, Executor{2}, Executor{1, &declining}}) {
        std::vector<double> result(block.size());
        laplacian.apply_block(block, result, executor);
        EXPECT_EQ(result, expected);
    }
    EXPECT_EQ(declining.num_calls, 1);
    test::FakeAccelerator willing(false);
    std::vector<double> result(block.size());
    laplacian.apply_block(block, result, {1, &willing});
    EXPECT_EQ(result, std::vector<double>(block.size(), 9.0));
    block.pop_back();
    EXPECT_THROW(laplacian.apply_block(block, result), std::logic_error);
}

TEST(Laplacian, RefusesWhatIsNoGraph) {
    const auto graph = [](double weight, double area) {
        return build_graph(std::vector<WeightedEdge>{{0, 1, weight}}, {area, 1.0});
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Laplacian(graph(-1.0, 1.0), LaplacianKind::degree), std::logic_error);
    EXPECT_THROW(Laplacian(graph(nan, 1.0), LaplacianKind::unweighted), std::logic_error);
    EXPECT_THROW(Laplacian(graph(1.0, 0.0), LaplacianKind::area), std::logic_error);
    EXPECT_THROW(Laplacian(graph(1.0, nan), LaplacianKind::area), std::logic_error);
    EXPECT_NO_THROW(Laplacian(graph(1.0, 0.0), LaplacianKind::degree));
    std::vector<double> x(3);
    std::vector<double> y(2);
    const Laplacian laplacian(graph(1.0, 1.0), LaplacianKind::degree);
    EXPECT_THROW(laplacian.apply(x, y), std::logic_error);
}

}  // namespace
}  // namespace quadcut
