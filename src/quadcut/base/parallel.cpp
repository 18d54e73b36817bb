// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <stop_token>
#include <thread>
#include <vector>

#include <sys/resource.h>

namespace quadcut {
namespace {

/// Loops follow each other closely: who is out of work looks for more so often before he sleeps,
/// which waking up from takes longer than many a loop.
template <typename Condition>
void look_until(const Condition& holds) {
    constexpr int kLooksBeforeSleep = 1000;
    for (int i = 0; i < kLooksBeforeSleep && !holds(); ++i) std::this_thread::yield();
}

/// How many threads a limit of the address space (ulimit -v) allows: a quarter of it may be theirs.
/// Stack and heap of one take so much of it, used or not.
int num_allowed() {
    constexpr rlim_t kBytesOfThread = rlim_t{72} << 20U;
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0) return 0;
    return static_cast<int>(std::min<rlim_t>(limit.rlim_cur / 4 / kBytesOfThread, 1'000'000));
}

/// A loop that threads may help with.
struct Loop {
    const std::function<void(std::size_t chunk)>& run;
    std::size_t num_chunks;
    int num_places;
    std::atomic<int> num_helpers = 0;
    std::atomic<std::size_t> next = 0;
    std::exception_ptr error = nullptr;
};

/// The threads of the process. A loop within a loop is helped with as any other; who began a loop
/// does all of it that nobody helps with, so that none waits for a thread.
class Crew {
public:
    void run(Loop& loop) {
        std::unique_lock lock(mutex_);
        start(loop.num_places);
        loops_.push_back(&loop);
        ++num_open_;
        lock.unlock();
        wake_.notify_all();
        work_on(loop);
        lock.lock();
        loops_.erase(std::find(loops_.begin(), loops_.end(), &loop));
        --num_open_;
        lock.unlock();
        look_until([&] { return loop.num_helpers == 0; });
        // Also when none is left: the last one may not have let go of the loop yet.
        lock.lock();
        done_.wait(lock, [&] { return loop.num_helpers == 0; });
        if (loop.error) std::rethrow_exception(loop.error);
    }

    [[nodiscard]] int num_missing() const { return num_missing_; }

private:
    void start(int num_wanted) {
        const auto num_missing = [&] { return num_wanted - static_cast<int>(threads_.size()); };
        try {
            while (num_missing() > 0 && static_cast<int>(threads_.size()) < num_most_) {
                threads_.emplace_back([this](const std::stop_token& end) { serve(end); });
            }
        } catch (const std::exception&) {
            // A limit of processes or memory, which the next loop would meet again.
            num_most_ = static_cast<int>(threads_.size());
        }
        num_missing_ = std::max<int>(num_missing_, num_missing());
    }

    void serve(const std::stop_token& end) {
        std::unique_lock lock(mutex_);
        Loop* loop = nullptr;
        while (wake_.wait(lock, end, [&] { return (loop = find_open()) != nullptr; })) {
            --loop->num_places;
            ++loop->num_helpers;
            lock.unlock();
            work_on(*loop);
            lock.lock();
            if (--loop->num_helpers == 0) done_.notify_all();
            lock.unlock();
            look_until([&] { return num_open_ > 0; });
            lock.lock();
        }
    }

    [[nodiscard]] Loop* find_open() const {
        const auto is_open = [](const Loop* loop) {
            return loop->num_places > 0 && loop->next < loop->num_chunks;
        };
        const auto found = std::find_if(loops_.begin(), loops_.end(), is_open);
        return found == loops_.end() ? nullptr : *found;
    }

    void work_on(Loop& loop) {
        try {
            for (std::size_t i = loop.next++; i < loop.num_chunks; i = loop.next++) loop.run(i);
        } catch (...) {
            loop.next = loop.num_chunks;
            const std::lock_guard lock(mutex_);
            if (!loop.error) loop.error = std::current_exception();
        }
    }

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::condition_variable done_;
    std::vector<Loop*> loops_;
    std::atomic<int> num_open_ = 0;
    std::atomic<int> num_missing_ = 0;
    int num_most_ = num_allowed();
    // Last, so that they end before what they use.
    std::vector<std::jthread> threads_;
};

Crew& crew() {
    static Crew crew;
    return crew;
}

}  // namespace

void parallel_for(const Executor& executor, std::size_t count, std::size_t chunk,
                  const std::function<void(std::size_t first, std::size_t last)>& body) {
    if (chunk == 0) throw std::logic_error("parallel_for: chunk must be positive");
    const std::size_t num_chunks = (count + chunk - 1) / chunk;
    const std::function<void(std::size_t)> run = [&](std::size_t i) {
        body(i * chunk, std::min(count, (i + 1) * chunk));
    };
    const auto num_threads = static_cast<int>(
        std::min(num_chunks, static_cast<std::size_t>(std::max(1, executor.num_threads))));
    if (num_threads <= 1) {
        for (std::size_t i = 0; i < num_chunks; ++i) run(i);
        return;
    }
    Loop loop{run, num_chunks, num_threads - 1};
    crew().run(loop);
}

int num_threads_missing() { return crew().num_missing(); }

}  // namespace quadcut
