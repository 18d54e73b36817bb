// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/base/option_field.hpp"
#include "quadcut/base/parallel.hpp"
#include "quadcut/paper/options.hpp"
#include "quadcut/rooms/options.hpp"

namespace quadcut {

/// `rooms`: rooms as people see them. `paper`: the method as published.
enum class Preset : std::uint8_t { rooms, paper };

struct SegmentOptions {
    Preset preset = Preset::rooms;
    RoomsOptions rooms;
    PaperOptions paper;
    std::size_t num_threads = 2;
    std::size_t seed = 1;
    /// Whether the result carries the hierarchy of granularities; preset `rooms`.
    bool with_hierarchy = false;
    /// Does parts of the work, with the same result; not owned.
    Accelerator* accelerator = nullptr;
};

/// Every option by name, bound to the members of `options`, which must outlive the list.
[[nodiscard]] std::vector<OptionField> option_fields(SegmentOptions& options);

}  // namespace quadcut
