// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/peers/bandwidth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

#include "bench/peers/stop_watch.hpp"

namespace quadcut::peers {
namespace {

/// 256 MB an array: eight times the largest cache that we have met.
constexpr std::size_t kLength = std::size_t{1} << 25U;
constexpr std::size_t kChunk = std::size_t{1} << 18U;
constexpr int kRounds = 60;
/// A product moves a third of what a sum does, a ninth of a triad.
constexpr int kProductsInTurn = 5;

/// Eight sums at a time, so that no addition waits for the one before.
double sum(std::span<const double> values) {
    std::array<double, 8> sums{};
    for (std::size_t i = 0; i + sums.size() <= values.size(); i += sums.size()) {
        for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += values[i + j];
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

ProductBesideBandwidth measure_product(const Laplacian& laplacian, std::size_t num_entries,
                                       const Executor& executor) {
    std::vector<double> a(kLength, 1.0);
    const std::vector<double> b(kLength, 2.0);
    const std::vector<double> c(kLength, 3.0);
    std::vector<double> sums(kLength / kChunk, 0.0);
    std::vector<double> x(laplacian.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(static_cast<double>(i));
    std::vector<double> result(x.size());
    double read_s = std::numeric_limits<double>::infinity();
    double triad_s = read_s;
    double product_s = read_s;
    const auto keep_least = [](double& least, int rounds, const auto& work) {
        least = std::min(least, shortest(rounds, work).wall_s);
    };
    for (int round = 0; round < kRounds; ++round) {
        keep_least(read_s, 1, [&] {
            parallel_for(executor, kLength, kChunk, [&](std::size_t first, std::size_t last) {
                sums[first / kChunk] = sum(std::span(b).subspan(first, last - first));
            });
        });
        keep_least(triad_s, 1, [&] {
            parallel_for(executor, kLength, kChunk, [&](std::size_t first, std::size_t last) {
                for (std::size_t i = first; i < last; ++i) a[i] = b[i] + 0.5 * c[i];
            });
        });
        keep_least(product_s, kProductsInTurn, [&] { laplacian.apply(x, result, executor); });
    }
    if (std::accumulate(sums.begin(), sums.end(), 0.0) != 2.0 * kLength || a[kLength / 2] != 3.5) {
        throw std::logic_error("measure_product: the loops did not do their work");
    }
    ProductBesideBandwidth found;
    found.bandwidth = {8.0 * kLength / read_s, 24.0 * kLength / triad_s};
    found.product = {
        1e3 * product_s,
        static_cast<double>(num_entries * (sizeof(double) + sizeof(std::uint32_t)) +
                            x.size() * (3 * sizeof(double) + 2 * sizeof(std::uint32_t)))};
    return found;
}

}  // namespace quadcut::peers
