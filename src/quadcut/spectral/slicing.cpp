// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/slicing.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <string>

#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

/// Pairs of one slice at most, unless they are (nearly) one multiple eigenvalue.
constexpr std::size_t kSlicePairs = 32;
/// Share of the norm: a narrower part of the spectrum is not divided further.
constexpr double kNarrow = 1e-10;
/// Share of the norm: eigenvalues this close may stand for each other where a factorisation between
/// them is impossible.
constexpr double kMultiple = 3e-6;
/// Where an eigenvalue count is tried: shares of the norm above the place asked for.
constexpr double kNudges[] = {0.0, 1e-9, 1e-8, 1e-7, 1e-6};
/// Growth of a factorisation up to which it is good for counting, and for solving.
constexpr double kCountGrowth = 1e7;
constexpr double kSolveGrowth = 1e4;
constexpr int kMaxProbes = 90;
constexpr int kMaxZooms = 12;
constexpr int kMaxShifts = 7;

class Planner {
public:
    Planner(const Laplacian& laplacian, ShiftedFactor& factor, Random& random)
        : laplacian_(laplacian), factor_(factor), random_(random) {}

    std::vector<SpectrumSlice> plan(const SpectrumRequest& request) {
        const SpectrumMark zero{0.0, 0};
        SpectrumMark high{1.001 * laplacian_.norm_bound(), laplacian_.size()};
        if (request.limit < high.at) {
            high = mark(request.limit);
            // However low the limit, the eigenvalue zero is below it.
            high.num_below = std::max<std::size_t>(1, high.num_below);
        }
        if (high.num_below <= request.max_count) {
            divide({zero, high, high.num_below});
        } else {
            divide_smallest(request.max_count, high);
        }
        return std::move(slices_);
    }

private:
    /// Counts the eigenvalues below `at`, or a little above it where rounding forbids.
    [[nodiscard]] SpectrumMark mark(double at) {
        for (const double nudge : kNudges) {
            const double place = at + nudge * laplacian_.norm_bound();
            const auto [num_below, growth] = factor_.factorize(place);
            if (growth <= kCountGrowth) return {place, num_below};
        }
        throw NumericalError("eigensolver: no stable factorisation of L - sigma I near sigma = " +
                             std::to_string(at));
    }

    /// Looks for a mark with `wanted` eigenvalues below it or a few more. There is none inside a
    /// multiple eigenvalue: then as many copies as are missing become a slice of their own.
    void divide_smallest(std::size_t wanted, SpectrumMark high) {
        const double norm = laplacian_.norm_bound();
        const std::size_t slack = 2 + wanted / 8;
        const double target = static_cast<double>(wanted) + 0.5 * static_cast<double>(slack);
        double guess = weyl_estimate() * target;
        SpectrumMark low{0.0, 0};
        for (int probe = 0; probe < kMaxProbes && high.at - low.at > kNarrow * norm; ++probe) {
            const SpectrumMark middle = mark(between(low, high, guess, probe));
            if (middle.at <= low.at || middle.at >= high.at) {
                if (high.at - low.at <= kMultiple * norm) break;
                continue;
            }
            (middle.num_below < wanted ? low : high) = middle;
            if (high.num_below >= wanted && high.num_below <= wanted + slack) {
                return divide({{0.0, 0}, high, high.num_below});
            }
            const double below = static_cast<double>(low.num_below);
            const double inside = static_cast<double>(high.num_below - low.num_below);
            guess = high.num_below == laplacian_.size()
                        ? middle.at * target / std::max(1.0, static_cast<double>(middle.num_below))
                        : low.at + (high.at - low.at) * (target - below) / inside;
        }
        if (high.at - low.at > kMultiple * norm) {
            throw NumericalError("eigensolver: no end found for the wanted part of the spectrum");
        }
        divide({{0.0, 0}, low, low.num_below});
        slices_.push_back({low, high, wanted - low.num_below});
    }

    /// By Weyl's law, lambda_k = 4 pi k / area for the Laplace operator in the plane. What stands
    /// for the area here is the sum of d_i, deg_i or area_i, over the mean weight of an edge.
    [[nodiscard]] double weyl_estimate() const {
        const auto scale = laplacian_.null_vector();
        double measure = 0.0;
        double weight = 0.0;
        std::size_t num_entries = 0;
        for (std::size_t i = 0; i < laplacian_.size(); ++i) {
            measure += scale[i] * scale[i];
            const auto columns = laplacian_.row_columns(i);
            const auto values = laplacian_.row_values(i);
            for (std::size_t k = 0; k < columns.size(); ++k) {
                weight -= values[k] * scale[i] * scale[columns[k]];
            }
            num_entries += columns.size();
        }
        const double mean = weight / static_cast<double>(std::max<std::size_t>(1, num_entries));
        return 4.0 * std::numbers::pi * mean / measure;
    }

    /// `guess`, kept well inside the bracket; every third probe halves it.
    [[nodiscard]] double between(const SpectrumMark& low, const SpectrumMark& high, double guess,
                                 int probe) {
        const double width = high.at - low.at;
        const double margin = (probe % 3 == 2 ? 0.49 : 0.02) * width;
        return std::clamp(guess, low.at + margin, high.at - margin) +
               random_.uniform(0.0, 0.001) * width;
    }

    void divide(const SpectrumSlice& whole) {
        const std::size_t count = whole.high.num_below - whole.low.num_below;
        if (count == 0) return;
        const double width = whole.high.at - whole.low.at;
        if (count > kSlicePairs && width > kNarrow * laplacian_.norm_bound()) {
            // The eigenvalues of floor plans are spread evenly but for the first.
            const std::size_t parts = (count + kSlicePairs - 1) / kSlicePairs;
            const std::size_t lower_parts = parts / 2;
            const double share = static_cast<double>(lower_parts) / static_cast<double>(parts);
            const SpectrumMark middle =
                mark(whole.low.at + (share + random_.uniform(-0.01, 0.01)) * width);
            if (whole.low.at < middle.at && middle.at < whole.high.at) {
                divide({whole.low, middle, middle.num_below - whole.low.num_below});
                divide({middle, whole.high, whole.high.num_below - middle.num_below});
                return;
            }
        }
        slices_.push_back(whole);
    }

    const Laplacian& laplacian_;
    ShiftedFactor& factor_;
    Random& random_;
    std::vector<SpectrumSlice> slices_;
};

}  // namespace

std::vector<SpectrumSlice> plan_slices(const Laplacian& laplacian, ShiftedFactor& factor,
                                       const SpectrumRequest& request, Random& random) {
    return Planner(laplacian, factor, random).plan(request);
}

SpectrumSlice place_shift(const SpectrumSlice& slice, ShiftedFactor& factor, Random& random) {
    SpectrumSlice narrowed = slice;
    for (int zoom = 0; zoom < kMaxZooms; ++zoom) {
        const double width = narrowed.high.at - narrowed.low.at;
        ShiftedFactor::Inertia inertia;
        double best_shift = 0.0;
        double least_growth = std::numeric_limits<double>::infinity();
        for (int attempt = 0; attempt < kMaxShifts; ++attempt) {
            const double share = 0.5 + random.uniform(-0.04, 0.04) * (attempt + 1);
            inertia = factor.factorize(narrowed.low.at + share * width);
            if (inertia.growth < least_growth) {
                least_growth = inertia.growth;
                best_shift = factor.shift();
            }
            if (inertia.growth <= kSolveGrowth) break;
        }
        if (inertia.growth > kSolveGrowth) {
            factor.factorize(best_shift);
            break;
        }
        if (inertia.num_below == narrowed.high.num_below) {
            narrowed.high.at = factor.shift();
        } else if (inertia.num_below == std::max<std::size_t>(1, narrowed.low.num_below)) {
            // Nothing but the null vector counts as nothing: it is not searched for.
            narrowed.low.at = factor.shift();
        } else {
            break;
        }
    }
    return narrowed;
}

}  // namespace quadcut
