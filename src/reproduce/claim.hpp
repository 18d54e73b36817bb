// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace quadcut::reproduce {

/// A number, and what it was measured on; nothing where a figure has but one.
struct Measured {
    std::string where;
    double value = 0.0;
};
/// By world.
using ByWorld = std::vector<Measured>;

/// On which side of the limit a number has to be.
enum class Bound : std::uint8_t { below, at_most, equal, at_least, above };

/// A statement of the paper as a test: it holds when every number keeps the limit.
struct Claim {
    /// What is measured: "inner submaps, two states".
    std::string quantity;
    ByWorld numbers;
    /// As after a number: "%".
    std::string unit;
    Bound bound = Bound::at_least;
    double limit = 0.0;
    /// Why the limit is where it is.
    std::string reason;
};

/// False for a claim without numbers, and for numbers that are not finite.
[[nodiscard]] bool holds(const Claim& claim);
/// "4", "22.4 % on MIT-CSAIL, 10.8 % on Intel".
[[nodiscard]] std::string measured_text(const Claim& claim);
/// "at most 25 %".
[[nodiscard]] std::string limit_text(const Claim& claim);

/// All on one line: "Agrees: ...", "Differs: ...", or "Agrees in 2 of 3: ... Differs: ...".
[[nodiscard]] std::string verdict(const std::vector<Claim>& claims);
[[nodiscard]] std::size_t count_held(const std::vector<Claim>& claims);
[[nodiscard]] bool agrees(const std::vector<Claim>& claims);

}  // namespace quadcut::reproduce
