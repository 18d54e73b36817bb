// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/peers/bandwidth.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
constexpr int kRounds = 12;
constexpr int kProductRounds = 60;

/// Eight sums at a time, so that no addition waits for the one before.
double sum(std::span<const double> values) {
    std::array<double, 8> sums{};
    for (std::size_t i = 0; i + sums.size() <= values.size(); i += sums.size()) {
        for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += values[i + j];
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

Bandwidth measure_bandwidth(const Executor& executor) {
    std::vector<double> a(kLength, 1.0);
    const std::vector<double> b(kLength, 2.0);
    const std::vector<double> c(kLength, 3.0);
    std::vector<double> sums(kLength / kChunk, 0.0);
    Bandwidth bandwidth;
    const Duration read = shortest(kRounds, [&] {
        parallel_for(executor, kLength, kChunk, [&](std::size_t first, std::size_t last) {
            sums[first / kChunk] = sum(std::span(b).subspan(first, last - first));
        });
    });
    const Duration triad = shortest(kRounds, [&] {
        parallel_for(executor, kLength, kChunk, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) a[i] = b[i] + 0.5 * c[i];
        });
    });
    if (std::accumulate(sums.begin(), sums.end(), 0.0) != 2.0 * kLength || a[kLength / 2] != 3.5) {
        throw std::logic_error("measure_bandwidth: the loops did not do their work");
    }
    bandwidth.read = 8.0 * kLength / read.wall_s;
    bandwidth.triad = 24.0 * kLength / triad.wall_s;
    return bandwidth;
}

Product measure_product(const Laplacian& laplacian, std::size_t num_entries,
                        const Executor& executor) {
    std::vector<double> x(laplacian.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(static_cast<double>(i));
    std::vector<double> result(x.size());
    const Duration time = shortest(kProductRounds, [&] { laplacian.apply(x, result, executor); });
    Product product;
    product.ms = 1e3 * time.wall_s;
    product.bytes =
        static_cast<double>(num_entries * (sizeof(double) + sizeof(std::uint32_t)) +
                            x.size() * (3 * sizeof(double) + 2 * sizeof(std::uint32_t)));
    return product;
}

}  // namespace quadcut::peers
