// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/pivoted_qr.hpp"

#include <vector>

#include <Eigen/Dense>

namespace quadcut {
namespace {

using Eigen::Index;
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowVector = Eigen::RowVectorXd;

constexpr std::size_t kSamplesPerChunk = 16384;
/// Share of the longest sample's squared length: what is left below it is rounding error.
constexpr double kRankTolerance = 1e-12;

using Rows = Eigen::Map<const RowMatrix>;

/// Rows first .. last of the samples.
Rows rows(const Embedding& samples, std::size_t first, std::size_t last) {
    return {samples.values.data() + first * samples.num_dims, static_cast<Index>(last - first),
            static_cast<Index>(samples.num_dims)};
}

/// Samples chosen one by one: the longest after what lies along those before has been taken away
/// (the pivots of a column-pivoted QR of the transposed embedding), the first of equals.
RowMatrix choose_pivots(const Embedding& samples, const Executor& executor) {
    const Index num_dims = static_cast<Index>(samples.num_dims);
    Eigen::VectorXd left = rows(samples, 0, samples.num_samples).rowwise().squaredNorm();
    const double smallest = kRankTolerance * left.maxCoeff();
    RowMatrix directions(num_dims, num_dims);
    RowMatrix pivots(num_dims, num_dims);
    Index count = 0;
    for (; count < num_dims; ++count) {
        Index pivot = 0;
        if (!(left.maxCoeff(&pivot) > smallest)) break;
        pivots.row(count) = rows(samples, 0, samples.num_samples).row(pivot);
        const auto before = directions.topRows(count);
        RowVector direction = pivots.row(count);
        for (int pass = 0; pass < 2; ++pass) {
            direction -= (direction * before.transpose()).eval() * before;
        }
        directions.row(count) = direction.normalized();
        parallel_for(
            executor, samples.num_samples, kSamplesPerChunk,
            [&](std::size_t first, std::size_t last) {
                left.segment(static_cast<Index>(first), static_cast<Index>(last - first)) -=
                    (rows(samples, first, last) * directions.row(count).transpose()).cwiseAbs2();
            });
        left[pivot] = 0.0;
    }
    return pivots.topRows(count);
}

}  // namespace

Clustering cluster_pivoted_qr(const Embedding& samples, const Executor& executor) {
    if (samples.num_samples == 0) return {};
    std::vector<std::uint32_t> axes(samples.num_samples, 0);
    if (samples.num_dims == 0) return numbered_by_first_sample(axes, 1);
    const RowMatrix pivots = choose_pivots(samples, executor);
    if (pivots.rows() == 0) return numbered_by_first_sample(axes, 1);

    // The orthogonal polar factor of the pivots: the rotation whose axes come nearest to them.
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(pivots.transpose(),
                                                Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::MatrixXd rotation = svd.matrixU() * svd.matrixV().transpose();
    parallel_for(executor, samples.num_samples, kSamplesPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     const RowMatrix turned = rows(samples, first, last) * rotation;
                     for (std::size_t i = first; i < last; ++i) {
                         Index axis = 0;
                         turned.row(static_cast<Index>(i - first)).cwiseAbs().maxCoeff(&axis);
                         axes[i] = static_cast<std::uint32_t>(axis);
                     }
                 });
    return numbered_by_first_sample(axes, static_cast<std::size_t>(pivots.rows()));
}

}  // namespace quadcut
