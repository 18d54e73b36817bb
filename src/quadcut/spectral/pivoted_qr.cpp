// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/pivoted_qr.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace quadcut {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t kSamplesPerChunk = 2048;
constexpr double kRankTolerance = 1e-9;

/// Samples chosen one by one: the longest after what lies along those before has been taken away
/// (the pivots of a column-pivoted QR of the transposed embedding), the first of equals.
std::vector<std::size_t> choose_pivots(const Embedding& samples) {
    const auto rows = static_cast<Eigen::Index>(samples.num_samples);
    const auto dims = static_cast<Eigen::Index>(samples.num_dims);
    const Eigen::Map<const RowMatrix> values(samples.values.data(), rows, dims);
    Eigen::VectorXd left = values.rowwise().squaredNorm();
    const double largest = left.maxCoeff();
    RowMatrix basis(dims, dims);
    std::vector<std::size_t> pivots;
    for (Eigen::Index k = 0; k < dims; ++k) {
        Eigen::Index pivot = 0;
        if (left.maxCoeff(&pivot) <= kRankTolerance * largest) break;
        Eigen::RowVectorXd direction = values.row(pivot);
        // Twice is enough for orthogonality to machine precision.
        for (int pass = 0; pass < 2; ++pass) {
            direction -= (direction * basis.topRows(k).transpose()) * basis.topRows(k);
        }
        const double length = direction.norm();
        if (length * length <= kRankTolerance * largest) break;
        basis.row(k) = direction / length;
        left -= (values * basis.row(k).transpose()).cwiseAbs2();
        left[pivot] = 0.0;
        pivots.push_back(static_cast<std::size_t>(pivot));
    }
    return pivots;
}

/// Labels numbered by first sample; axes without a sample disappear.
Clustering renumbered(const std::vector<std::uint32_t>& axes, std::size_t num_axes) {
    constexpr auto kUnseen = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> number(num_axes, kUnseen);
    Clustering out;
    out.labels.resize(axes.size());
    for (std::size_t i = 0; i < axes.size(); ++i) {
        std::uint32_t& own = number[axes[i]];
        if (own == kUnseen) own = static_cast<std::uint32_t>(out.num_clusters++);
        out.labels[i] = own;
    }
    return out;
}

}  // namespace

Clustering cluster_pivoted_qr(const Embedding& samples, const Executor& executor) {
    if (samples.num_samples == 0) return {};
    const std::vector<std::size_t> pivots =
        samples.num_dims == 0 ? std::vector<std::size_t>{} : choose_pivots(samples);
    std::vector<std::uint32_t> axes(samples.num_samples, 0);
    if (pivots.empty()) return renumbered(axes, 1);

    const auto dims = static_cast<Eigen::Index>(samples.num_dims);
    RowMatrix typical(static_cast<Eigen::Index>(pivots.size()), dims);
    for (std::size_t k = 0; k < pivots.size(); ++k) {
        const auto row = samples.row(pivots[k]);
        typical.row(static_cast<Eigen::Index>(k)) =
            Eigen::Map<const Eigen::RowVectorXd>(row.data(), dims);
    }
    // The orthogonal polar factor of the typical samples, as columns: the rotation whose axes come
    // nearest to them.
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(typical.transpose(),
                                                Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::MatrixXd rotation = svd.matrixU() * svd.matrixV().transpose();
    parallel_for(
        executor, samples.num_samples, kSamplesPerChunk, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const Eigen::Map<const Eigen::RowVectorXd> row(samples.row(i).data(), dims);
                Eigen::Index axis = 0;
                (row * rotation).cwiseAbs().maxCoeff(&axis);
                axes[i] = static_cast<std::uint32_t>(axis);
            }
        });
    return renumbered(axes, pivots.size());
}

}  // namespace quadcut
