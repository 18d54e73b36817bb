// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <string>

#include "quadcut/explain/why.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut::io {

/// An explanation, and what it is told with.
struct WrittenWhy {
    const Why& why;
    const RoomsOptions& options;
    /// The rooms on both sides of the border, by id and name; empty where there is none.
    std::array<std::string, 2> rooms;
};

/// For people: what was measured in one line, what decided in the next, then the three cues that
/// moved the decision most.
[[nodiscard]] std::string why_as_text(const WrittenWhy& written);

/// An object: ground, clearance_m, border (null, or place, sides, widths, verdict, log_odds,
/// granularities, and all cues with what they added); metres, map frame.
[[nodiscard]] std::string why_as_json(const WrittenWhy& written);

}  // namespace quadcut::io
