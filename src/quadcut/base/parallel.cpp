// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/base/parallel.hpp"

#include <algorithm>
#include <stdexcept>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace quadcut {

void parallel_for(const Executor& executor, std::size_t count, std::size_t chunk,
                  const std::function<void(std::size_t first, std::size_t last)>& body) {
    if (chunk == 0) throw std::logic_error("parallel_for: chunk must be positive");
    const std::size_t num_chunks = (count + chunk - 1) / chunk;
    const auto run = [&](std::size_t i) { body(i * chunk, std::min(count, (i + 1) * chunk)); };
    if (executor.num_threads <= 1 || num_chunks <= 1) {
        for (std::size_t i = 0; i < num_chunks; ++i) run(i);
        return;
    }
    // More threads than cores are allowed; without this TBB says on stderr that they are not.
    const tbb::global_control allow(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(executor.num_threads));
    tbb::task_arena arena(executor.num_threads);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, num_chunks, run); });
}

}  // namespace quadcut
