// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/eigensolver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"
#include "tests/unit/spectral/test_graphs.hpp"

namespace quadcut {
namespace {

/// Eigenvalues, residuals against the whole graph's Laplacian, orthonormality and signs.
void expect_sound(const Graph& graph, LaplacianKind kind, const Eigenpairs& pairs) {
    const Laplacian laplacian(graph, kind);
    EXPECT_EQ(pairs.num_nodes, graph.num_nodes());
    EXPECT_EQ(pairs.vectors.size(), pairs.size() * pairs.num_nodes);
    EXPECT_EQ(pairs.components.size(), pairs.size());
    EXPECT_EQ(pairs.residuals.size(), pairs.size());
    EXPECT_LE(test::largest_residual(pairs, laplacian), 2e-9 * laplacian.norm_bound());
    EXPECT_LE(test::orthonormality_error(pairs), 2e-8);
    const auto component = connected_components(graph);
    for (std::size_t j = 0; j < pairs.size(); ++j) {
        const auto vector = pairs.vector(j);
        double largest = 0.0;
        for (std::size_t i = 0; i < vector.size(); ++i) {
            if (std::abs(vector[i]) > std::abs(largest)) largest = vector[i];
            if (component[i] != pairs.components[j]) {
                EXPECT_EQ(vector[i], 0.0);
            }
        }
        EXPECT_GT(largest, 0.0) << "sign of vector " << j;
    }
}

TEST(Eigensolver, NoNodeOneNodeTwoNodes) {
    EXPECT_EQ(smallest_eigenpairs(Graph{}, LaplacianKind::degree, 3).size(), 0U);

    const Graph one = build_graph({}, {2.0});
    const Eigenpairs alone = smallest_eigenpairs(one, LaplacianKind::area, 3);
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_EQ(alone.values[0], 0.0);
    EXPECT_EQ(alone.vectors, std::vector<double>{1.0});

    const Eigenpairs two = smallest_eigenpairs(test::path_graph(2), LaplacianKind::degree, 5);
    ASSERT_EQ(two.size(), 2U);
    EXPECT_NEAR(two.values[0], 0.0, 1e-15);
    EXPECT_NEAR(two.values[1], 2.0, 1e-15);

    EXPECT_EQ(smallest_eigenpairs(test::path_graph(2), LaplacianKind::degree, 0).size(), 0U);
}

TEST(Eigensolver, PathHasTheSpectrumOfTheTextbook) {
    for (const std::size_t n : {3U, 64U, 65U, 500U, 4000U}) {
        const Graph graph = test::path_graph(n);
        const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::area, 10);
        ASSERT_EQ(pairs.size(), std::min<std::size_t>(n, 10));
        for (std::size_t j = 0; j < pairs.size(); ++j) {
            const double s = std::sin(std::numbers::pi * static_cast<double>(j) /
                                      (2.0 * static_cast<double>(n)));
            EXPECT_NEAR(pairs.values[j], 4.0 * s * s, 1e-12) << "n " << n << ", pair " << j;
        }
        expect_sound(graph, LaplacianKind::area, pairs);
    }
}

TEST(Eigensolver, GridHasTheSpectrumOfTheTextbookWithItsMultiples) {
    // On a square, (a, b) and (b, a) give the same eigenvalue.
    for (const std::size_t width : {30U, 45U}) {
        constexpr std::size_t kHeight = 30;
        constexpr double kArea = 0.25;
        const Graph graph = test::grid_graph(width, kHeight, kArea);
        std::vector<double> expected;
        for (std::size_t a = 0; a < width; ++a) {
            for (std::size_t b = 0; b < kHeight; ++b) {
                const double sa = std::sin(std::numbers::pi * static_cast<double>(a) /
                                           (2.0 * static_cast<double>(width)));
                const double sb = std::sin(std::numbers::pi * static_cast<double>(b) /
                                           (2.0 * static_cast<double>(kHeight)));
                expected.push_back(4.0 * (sa * sa + sb * sb) / kArea);
            }
        }
        std::sort(expected.begin(), expected.end());
        for (const std::size_t count : {1U, 2U, 3U, 40U, 150U}) {
            const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::area, count);
            ASSERT_EQ(pairs.size(), count);
            for (std::size_t j = 0; j < count; ++j) {
                EXPECT_NEAR(pairs.values[j], expected[j], 1e-10) << "pair " << j;
            }
            expect_sound(graph, LaplacianKind::area, pairs);
        }
    }
}

TEST(Eigensolver, WholeSpectrumOfAMiddlingGraph) {
    Random random(3);
    const Graph graph = test::random_graph(random, 200, 1.0);
    const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::degree, 1000);
    ASSERT_EQ(pairs.size(), 200U);
    expect_sound(graph, LaplacianKind::degree, pairs);
    const Laplacian laplacian(graph, LaplacianKind::degree);
    double trace = 0.0;
    for (const double entry : laplacian.diagonal()) trace += entry;
    double sum = 0.0;
    for (const double value : pairs.values) sum += value;
    EXPECT_NEAR(sum, trace, 1e-9);
}

TEST(Eigensolver, StarIsAllButDegenerate) {
    // 0, then 1 many times, then 2.
    const Graph graph = test::star_graph(3000);
    for (const std::size_t count : {2U, 50U, 200U}) {
        const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::degree, count);
        ASSERT_EQ(pairs.size(), count);
        EXPECT_NEAR(pairs.values[0], 0.0, 1e-14);
        for (std::size_t j = 1; j < count; ++j) EXPECT_NEAR(pairs.values[j], 1.0, 1e-9);
        expect_sound(graph, LaplacianKind::degree, pairs);
    }
}

TEST(Eigensolver, EightDisconnectedEqualRooms) {
    constexpr std::size_t kSide = 20;
    const Graph rooms = test::floor_graph(test::room_plan(4, 2, kSide, test::Doors::none));
    const Graph one = test::grid_graph(kSide, kSide);
    for (const LaplacianKind kind :
         {LaplacianKind::degree, LaplacianKind::unweighted, LaplacianKind::area}) {
        const Eigenpairs single = smallest_eigenpairs(one, kind, 12);
        const Eigenpairs pairs = smallest_eigenpairs(rooms, kind, 8 * 12);
        ASSERT_EQ(pairs.size(), 8U * 12U);
        EXPECT_EQ(std::count_if(pairs.values.begin(), pairs.values.end(),
                                [](double value) { return value < 1e-10; }),
                  8);
        // Each eigenvalue of one room eight times, each room once in each such group.
        for (std::size_t j = 0; j < pairs.size(); ++j) {
            EXPECT_NEAR(pairs.values[j], single.values[j / 8], 1e-10) << "pair " << j;
        }
        for (std::size_t j = 0; j < 8; ++j) EXPECT_EQ(pairs.components[j], j);
        expect_sound(rooms, kind, pairs);

        const Eigenpairs eight = smallest_eigenpairs(rooms, kind, 8);
        for (std::size_t j = 0; j < 8; ++j) EXPECT_NEAR(eight.values[j], 0.0, 1e-14);
    }
}

TEST(Eigensolver, EightEqualRoomsAroundACorridor) {
    // Near-multiple eigenvalues inside one component: doors of one cell.
    const Graph graph = test::floor_graph(test::room_plan(4, 2, 21, test::Doors::open));
    ASSERT_EQ(connected_components(graph).back(), 0U);
    for (const LaplacianKind kind : {LaplacianKind::degree, LaplacianKind::area}) {
        const Eigenpairs pairs = smallest_eigenpairs(graph, kind, 30);
        ASSERT_EQ(pairs.size(), 30U);
        expect_sound(graph, kind, pairs);
        // Eight small ones, then a gap.
        EXPECT_GT(pairs.values[8], 3.0 * pairs.values[7]);
    }
}

TEST(Eigensolver, ComponentsOfAllSizesAreMerged) {
    Random random(8);
    const Graph graph = test::disjoint_union(
        {test::path_graph(1), test::grid_graph(25, 18), test::path_graph(2), test::star_graph(90),
         test::random_graph(random, 130, 1.5), build_graph({}, {1.0, 1.0, 1.0})});
    const auto component = connected_components(graph);
    const std::size_t num_components = component.back() + std::size_t{1};
    ASSERT_EQ(num_components, 8U);
    for (const std::size_t count : {3U, 8U, 40U}) {
        const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::degree, count);
        ASSERT_EQ(pairs.size(), count);
        expect_sound(graph, LaplacianKind::degree, pairs);
        for (std::size_t j = 0; j < std::min(count, num_components); ++j) {
            EXPECT_NEAR(pairs.values[j], 0.0, 1e-13);
            EXPECT_EQ(pairs.components[j], j);
        }
        if (count > num_components) {
            EXPECT_GT(pairs.values[num_components], 1e-4);
        }
    }
}

TEST(Eigensolver, ManyLonelyNodes) {
    const Graph graph = build_graph({}, std::vector<double>(20000, 1.0));
    const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::degree, 5);
    ASSERT_EQ(pairs.size(), 5U);
    for (std::size_t j = 0; j < 5; ++j) {
        EXPECT_EQ(pairs.values[j], 0.0);
        EXPECT_EQ(pairs.components[j], j);
        EXPECT_EQ(pairs.vector(j)[j], 1.0);
    }
}

TEST(Eigensolver, AllBelowALimit) {
    const Graph graph = test::floor_graph(test::room_plan(3, 3, 15, test::Doors::open), 0.04);
    const Eigenpairs all = smallest_eigenpairs(graph, LaplacianKind::area, 120);
    for (const std::size_t count : {1U, 9U, 57U, 100U}) {
        // Between two eigenvalues that differ.
        std::size_t last = count;
        while (all.values[last] - all.values[last - 1] < 1e-6) ++last;
        const double limit = 0.5 * (all.values[last] + all.values[last - 1]);
        const Eigenpairs pairs = eigenpairs_below(graph, LaplacianKind::area, limit, 1000);
        ASSERT_EQ(pairs.size(), last);
        for (std::size_t j = 0; j < last; ++j) {
            EXPECT_NEAR(pairs.values[j], all.values[j], 1e-9);
        }
        expect_sound(graph, LaplacianKind::area, pairs);

        const Eigenpairs few = eigenpairs_below(graph, LaplacianKind::area, limit, 7);
        ASSERT_EQ(few.size(), std::min<std::size_t>(7, last));
        for (std::size_t j = 0; j < few.size(); ++j) {
            EXPECT_NEAR(few.values[j], all.values[j], 1e-9);
        }
    }
    EXPECT_EQ(eigenpairs_below(graph, LaplacianKind::area, 0.0, 10).size(), 0U);
    EXPECT_EQ(eigenpairs_below(graph, LaplacianKind::area, -1.0, 10).size(), 0U);
    EXPECT_EQ(eigenpairs_below(graph, LaplacianKind::area, 1e-300, 10).size(), 1U);
    EXPECT_EQ(eigenpairs_below(graph, LaplacianKind::area, 1.0, 0).size(), 0U);
    EXPECT_THROW((void)eigenpairs_below(graph, LaplacianKind::area,
                                        std::numeric_limits<double>::quiet_NaN(), 10),
                 std::logic_error);
}

TEST(Eigensolver, BelowALimitOverDisconnectedRooms) {
    const Graph rooms = test::floor_graph(test::room_plan(4, 2, 12, test::Doors::none));
    const Eigenpairs pairs = eigenpairs_below(rooms, LaplacianKind::area, 0.1, 1000);
    const Eigenpairs one =
        eigenpairs_below(test::grid_graph(12, 12), LaplacianKind::area, 0.1, 1000);
    ASSERT_GT(one.size(), 2U);
    EXPECT_EQ(pairs.size(), 8 * one.size());
    EXPECT_EQ(eigenpairs_below(rooms, LaplacianKind::area, 0.1, 5).size(), 5U);
}

TEST(Eigensolver, LimitAboveTheWholeSpectrum) {
    const Graph graph = test::grid_graph(10, 10);
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(eigenpairs_below(graph, LaplacianKind::degree, 5.0, 1000).size(), 100U);
    EXPECT_EQ(eigenpairs_below(graph, LaplacianKind::degree, infinity, 1000).size(), 100U);
}

TEST(Eigensolver, LimitOnAMultipleEigenvalue) {
    // An even path has the eigenvalue 2, and so has the grid, many times; the limit sits on it.
    const Graph graph = test::grid_graph(16, 16);
    const Eigenpairs pairs = eigenpairs_below(graph, LaplacianKind::area, 2.0, 1000);
    expect_sound(graph, LaplacianKind::area, pairs);
    const Eigenpairs below = eigenpairs_below(graph, LaplacianKind::area, 2.0 - 1e-6, 1000);
    const Eigenpairs above = eigenpairs_below(graph, LaplacianKind::area, 2.0 + 1e-6, 1000);
    EXPECT_GE(pairs.size(), below.size());
    EXPECT_LE(pairs.size(), above.size());
}

TEST(Eigensolver, WeakCouplingAndEdgesOfWeightZero) {
    // Two rooms: tied by hardly anything, or by an edge that is none.
    for (const double weight : {1e-6, 1e-12, 1e-18, 1e-200, 0.0}) {
        Graph rooms = test::disjoint_union({test::grid_graph(15, 10), test::grid_graph(14, 10)});
        std::vector<WeightedEdge> edges;
        for (std::uint32_t i = 0; i < rooms.num_nodes(); ++i) {
            const auto columns = rooms.neighbours(i);
            for (std::size_t k = 0; k < columns.size(); ++k) {
                if (columns[k] > i) edges.push_back({i, columns[k], 1.0});
            }
        }
        edges.push_back({0, 200, weight});
        const Graph graph = build_graph(edges, rooms.area_m2);
        const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::area, 20);
        ASSERT_EQ(pairs.size(), 20U) << weight;
        expect_sound(graph, LaplacianKind::area, pairs);
        EXPECT_NEAR(pairs.values[1], 0.0, 1e-6);
        EXPECT_GT(pairs.values[2], 1e-3);
    }
}

TEST(Eigensolver, WeightsOverManyDecades) {
    Random random(12);
    std::vector<WeightedEdge> edges;
    for (std::uint32_t i = 1; i < 600; ++i) {
        const auto earlier = static_cast<std::uint32_t>(random.below(i));
        edges.push_back({earlier, i, std::pow(10.0, random.uniform(-8.0, 8.0))});
    }
    const Graph graph = build_graph(edges, std::vector<double>(600, 1.0));
    for (const LaplacianKind kind : {LaplacianKind::degree, LaplacianKind::area}) {
        const Eigenpairs pairs = smallest_eigenpairs(graph, kind, 25);
        ASSERT_EQ(pairs.size(), 25U);
        expect_sound(graph, kind, pairs);
    }
}

TEST(Eigensolver, SameBytesOnOneAndManyThreads) {
    const Graph graph = test::floor_graph(test::room_plan(5, 4, 17, test::Doors::open));
    const Eigenpairs reference = smallest_eigenpairs(graph, LaplacianKind::degree, 90);
    for (const int num_threads : {2, 3, 8}) {
        const Eigenpairs pairs =
            smallest_eigenpairs(graph, LaplacianKind::degree, 90, {}, {num_threads});
        EXPECT_EQ(pairs.values, reference.values);
        EXPECT_EQ(pairs.vectors, reference.vectors);
        EXPECT_EQ(pairs.residuals, reference.residuals);
    }
}

TEST(Eigensolver, AnImpossibleToleranceIsAnError) {
    const Graph graph = test::grid_graph(20, 20);
    EigenOptions options;
    options.tolerance = 1e-30;
    EXPECT_THROW((void)smallest_eigenpairs(graph, LaplacianKind::degree, 10, options),
                 NumericalError);
}

TEST(Eigensolver, PartOfASpectrumIsThatOfTheWhole) {
    // 16 pairs of 216 nodes are found by Lanczos steps, all 216 as a dense matrix.
    const Graph graph = test::floor_graph(test::room_plan(3, 2, 5, test::Doors::open));
    const std::size_t num_nodes = graph.num_nodes();
    ASSERT_GT(num_nodes * num_nodes, 700U * 16U);
    ASSERT_LE(num_nodes, 300U);
    for (const LaplacianKind kind : {LaplacianKind::degree, LaplacianKind::area}) {
        const Eigenpairs some = smallest_eigenpairs(graph, kind, 16);
        const Eigenpairs all = smallest_eigenpairs(graph, kind, num_nodes);
        ASSERT_EQ(all.size(), num_nodes);
        for (std::size_t j = 0; j < some.size(); ++j) {
            EXPECT_NEAR(some.values[j], all.values[j], 1e-8);
        }
        const Eigenpairs below =
            eigenpairs_below(graph, kind, 0.5 * (all.values[9] + all.values[10]), num_nodes);
        EXPECT_EQ(below.size(), 10U);
    }
}

}  // namespace
}  // namespace quadcut
