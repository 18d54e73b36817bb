// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/base/parallel.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace quadcut {
namespace {

/// More threads than cores are allowed; without this TBB says on stderr that they are not.
void allow_threads(int num_threads) {
    constexpr auto kAllowed = tbb::global_control::max_allowed_parallelism;
    static std::mutex mutex;
    static std::optional<tbb::global_control> control;
    const std::lock_guard lock(mutex);
    const auto wanted = static_cast<std::size_t>(num_threads);
    // Never fewer than there would be: other users of TBB in the process have their threads, too.
    if (wanted <= tbb::global_control::active_value(kAllowed)) return;
    // The least of several controls would hold.
    control.reset();
    control.emplace(kAllowed, wanted);
}

/// An arena for so many threads, kept by the calling thread: a new one costs 10 us at first, and
/// ever more because TBB 2021 keeps the old ones in its lists.
tbb::task_arena& arena_of(int num_threads) {
    struct Arena {
        int num_threads = 0;
        std::unique_ptr<tbb::task_arena> arena;
    };
    thread_local std::vector<Arena> arenas;
    for (const Arena& known : arenas) {
        if (known.num_threads == num_threads) return *known.arena;
    }
    allow_threads(num_threads);
    arenas.push_back({num_threads, std::make_unique<tbb::task_arena>(num_threads)});
    return *arenas.back().arena;
}

}  // namespace

void parallel_for(const Executor& executor, std::size_t count, std::size_t chunk,
                  const std::function<void(std::size_t first, std::size_t last)>& body) {
    if (chunk == 0) throw std::logic_error("parallel_for: chunk must be positive");
    const std::size_t num_chunks = (count + chunk - 1) / chunk;
    const auto run = [&](std::size_t i) { body(i * chunk, std::min(count, (i + 1) * chunk)); };
    if (executor.num_threads <= 1 || num_chunks <= 1) {
        for (std::size_t i = 0; i < num_chunks; ++i) run(i);
        return;
    }
    arena_of(executor.num_threads).execute([&] {
        tbb::parallel_for(std::size_t{0}, num_chunks, run);
    });
}

}  // namespace quadcut
