// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "quadcut/spectral/eigensolver.hpp"
#include "tests/unit/spectral/test_graphs.hpp"

namespace quadcut {
namespace {

constexpr LaplacianKind kAllKinds[] = {LaplacianKind::degree, LaplacianKind::unweighted,
                                       LaplacianKind::area};

/// The Laplacian of the whole graph from its definition, without Laplacian.
Eigen::MatrixXd dense_laplacian(const Graph& graph, LaplacianKind kind) {
    const auto size = static_cast<Eigen::Index>(graph.num_nodes());
    Eigen::MatrixXd W = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
        const auto columns = graph.neighbours(i);
        const auto weights = graph.neighbour_weights(i);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const bool loop = columns[k] == i;
            if (kind == LaplacianKind::unweighted && loop) continue;
            W(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(columns[k])) =
                kind == LaplacianKind::unweighted ? 1.0 : weights[k];
        }
    }
    const Eigen::VectorXd d = W.rowwise().sum();
    Eigen::VectorXd scale = d;
    if (kind == LaplacianKind::area) {
        scale = Eigen::Map<const Eigen::VectorXd>(graph.area_m2.data(), size);
    }
    const Eigen::VectorXd s = (scale.array() > 0.0).select(scale.cwiseSqrt().cwiseInverse(), 0.0);
    return s.asDiagonal() * (Eigen::MatrixXd(d.asDiagonal()) - W) * s.asDiagonal();
}

/// Eigenvalues agree, and so do the spaces that clusters of eigenvalues span.
void compare(const Graph& graph, LaplacianKind kind, const Eigenpairs& pairs) {
    const Eigen::MatrixXd L = dense_laplacian(graph, kind);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> dense(L);
    const double norm = std::max(1e-12, dense.eigenvalues().cwiseAbs().maxCoeff());
    const auto size = static_cast<Eigen::Index>(graph.num_nodes());
    for (std::size_t j = 0; j < pairs.size(); ++j) {
        const auto column = static_cast<Eigen::Index>(j);
        ASSERT_NEAR(pairs.values[j], dense.eigenvalues()[column], 1e-9 * norm) << "pair " << j;
        const Eigen::Map<const Eigen::VectorXd> vector(pairs.vector(j).data(), size);
        // What of the vector lies outside the eigenvectors of eigenvalues near its own.
        Eigen::VectorXd outside = vector;
        for (Eigen::Index i = 0; i < size; ++i) {
            if (std::abs(dense.eigenvalues()[i] - pairs.values[j]) > 1e-4 * norm) continue;
            outside -= dense.eigenvectors().col(i) * dense.eigenvectors().col(i).dot(vector);
        }
        ASSERT_LE(outside.norm(), 1e-4) << "pair " << j;
    }
}

TEST(EigenDenseOracle, RandomGraphsOfOneAndOfSeveralComponents) {
    Random random(21);
    for (int round = 0; round < 40; ++round) {
        const std::size_t num_nodes = 2 + random.below(220);
        const std::size_t num_groups = 1 + random.below(std::min<std::size_t>(num_nodes, 4));
        const Graph graph =
            test::random_graph(random, num_nodes, random.uniform(0.0, 3.0), num_groups);
        const std::size_t count = 1 + random.below(num_nodes + 5);
        for (const LaplacianKind kind : kAllKinds) {
            SCOPED_TRACE(testing::Message() << "round " << round << ", " << num_nodes << " nodes, "
                                            << count << " pairs, kind " << static_cast<int>(kind));
            const Eigenpairs pairs = smallest_eigenpairs(graph, kind, count);
            ASSERT_EQ(pairs.size(), std::min(count, num_nodes));
            compare(graph, kind, pairs);
        }
    }
}

TEST(EigenDenseOracle, FloorPlans) {
    Random random(22);
    for (int round = 0; round < 6; ++round) {
        auto plan = test::room_plan(3, 2, 7 + static_cast<std::size_t>(round) % 3,
                                    round % 2 == 0 ? test::Doors::open : test::Doors::none);
        // Some furniture.
        for (int i = 0; i < 8; ++i) {
            std::string& row = plan[random.below(plan.size())];
            row[random.below(row.size())] = '#';
        }
        const Graph graph = test::floor_graph(plan, 0.0025);
        for (const LaplacianKind kind : kAllKinds) {
            const Eigenpairs pairs = smallest_eigenpairs(graph, kind, 45);
            ASSERT_EQ(pairs.size(), 45U);
            compare(graph, kind, pairs);
        }
    }
}

TEST(EigenDenseOracle, CountsBelowLimits) {
    Random random(23);
    for (int round = 0; round < 20; ++round) {
        const std::size_t num_nodes = 80 + random.below(150);
        const Graph graph = test::random_graph(random, num_nodes, 1.0, 1 + random.below(3));
        for (const LaplacianKind kind : kAllKinds) {
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> dense(dense_laplacian(graph, kind),
                                                                       Eigen::EigenvaluesOnly);
            const double largest = dense.eigenvalues().maxCoeff();
            const double limit = largest * std::pow(10.0, random.uniform(-3.0, 0.1));
            const double slack = 1e-7 * largest;
            const auto below = [&](double at) {
                return static_cast<std::size_t>((dense.eigenvalues().array() < at).count());
            };
            const Eigenpairs pairs = eigenpairs_below(graph, kind, limit, num_nodes);
            EXPECT_GE(pairs.size(), below(limit - slack));
            EXPECT_LE(pairs.size(), below(limit + slack));
            compare(graph, kind, pairs);
        }
    }
}

}  // namespace
}  // namespace quadcut
