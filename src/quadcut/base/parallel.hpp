// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <functional>

#include "quadcut/base/run_options.hpp"

namespace quadcut {

/// Calls `body(first, last)` for consecutive chunks of 0 .. count, at most `chunk` long each. The
/// chunks are the same whatever the number of threads, so a body that writes only to slots of its
/// own range, or to a slot of its own chunk (first / chunk), gives the same bytes on 1 or N
/// threads. The first exception that a body throws is thrown again here. Threads are started when
/// they are first needed, and kept; where they cannot be started, those that there are do the work.
void parallel_for(const Executor& executor, std::size_t count, std::size_t chunk,
                  const std::function<void(std::size_t first, std::size_t last)>& body);

/// How many threads parallel_for() has had to do without so far, because they could not be started.
[[nodiscard]] int num_threads_missing();

}  // namespace quadcut
