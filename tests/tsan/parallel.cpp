// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// Stands in for src/quadcut/base/parallel.cpp under the thread sanitizer. Debian's TBB is not
// instrumented, so the sanitizer sees races in its scheduler that are none, and every way to
// silence those silences the loop bodies too. Plain threads show it the bodies as they are.
#include "quadcut/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace quadcut {

void parallel_for(const Executor& executor, std::size_t count, std::size_t chunk,
                  const std::function<void(std::size_t first, std::size_t last)>& body) {
    if (chunk == 0) throw std::logic_error("parallel_for: chunk must be positive");
    const std::size_t num_chunks = (count + chunk - 1) / chunk;
    std::atomic<std::size_t> next = 0;
    std::exception_ptr error;
    std::mutex error_mutex;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < num_chunks; i = next++) {
                body(i * chunk, std::min(count, (i + 1) * chunk));
            }
        } catch (...) {
            next = num_chunks;
            const std::lock_guard lock(error_mutex);
            if (!error) error = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    for (int i = 1; i < executor.num_threads; ++i) threads.emplace_back(work);
    work();
    for (std::thread& thread : threads) thread.join();
    if (error) std::rethrow_exception(error);
}

}  // namespace quadcut
