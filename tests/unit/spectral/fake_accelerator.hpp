// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "quadcut/spectral/accelerator.hpp"

namespace quadcut::test {

/// Declines, or answers with something that no CPU would: one edge, and a block of nines.
class FakeAccelerator final : public Accelerator {
public:
    explicit FakeAccelerator(bool declines) : declines_(declines) {}

    std::optional<std::vector<WeightedEdge>> sight_edges(const LeafTable& /*table*/,
                                                         std::span<const LeafId> /*nodes*/,
                                                         double /*resolution_m*/,
                                                         SelfLoops /*self_loops*/) override {
        ++num_calls;
        if (declines_) return std::nullopt;
        return std::vector<WeightedEdge>{{7, 8, 9.0}};
    }
    bool multiply(const MatrixRows& /*matrix*/, std::span<const double> /*block*/,
                  std::span<double> result) override {
        ++num_calls;
        std::fill(result.begin(), result.end(), 9.0);
        return !declines_;
    }

    int num_calls = 0;

private:
    bool declines_;
};

}  // namespace quadcut::test
