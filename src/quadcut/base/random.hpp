// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstdint>

namespace quadcut {

/// Seeded generator (xoshiro256**, seeded through SplitMix64: Blackman and Vigna 2018). The same
/// seed gives the same numbers on every machine, which std's distributions do not promise.
class Random {
public:
    explicit Random(std::uint64_t seed);

    /// 64 uniform bits.
    std::uint64_t bits();
    /// Uniform in [0, 1), 53 bits.
    double uniform();
    /// Uniform in [low, high).
    double uniform(double low, double high);
    /// Uniform in 0 .. count - 1, without bias. @pre count > 0.
    std::uint64_t below(std::uint64_t count);
    /// Normal with mean 0 and standard deviation 1 (polar method).
    double normal();
    /// A generator whose stream is independent of this one's; `stream` tells them apart.
    [[nodiscard]] Random fork(std::uint64_t stream) const;

private:
    std::array<std::uint64_t, 4> state_{};
    double spare_normal_ = 0.0;
    bool has_spare_normal_ = false;
};

}  // namespace quadcut
