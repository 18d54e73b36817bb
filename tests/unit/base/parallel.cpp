// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/base/parallel.hpp"

#include <atomic>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <pthread.h>

namespace quadcut {
namespace {

/// How often each of so many indices is met.
std::vector<int> visits(int num_threads, std::size_t count, std::size_t chunk) {
    std::vector<int> met(count);
    parallel_for({num_threads}, count, chunk, [&](std::size_t first, std::size_t last) {
        EXPECT_EQ(first % chunk, 0U);
        EXPECT_LE(last - first, chunk);
        for (std::size_t i = first; i < last; ++i) ++met[i];
    });
    return met;
}

TEST(ParallelFor, MeetsEachIndexOnce) {
    for (const int num_threads : {1, 2, 3, 8}) {
        for (const std::size_t count : {0U, 1U, 2U, 7U, 1000U}) {
            for (const std::size_t chunk : {1U, 3U, 2000U}) {
                EXPECT_EQ(visits(num_threads, count, chunk), std::vector<int>(count, 1));
            }
        }
    }
    EXPECT_THROW(parallel_for({2}, 4, 0, [](std::size_t, std::size_t) {}), std::logic_error);
}

TEST(ParallelFor, AsManyLoopsAsOneLikes) {
    std::uint64_t sum = 0;
    for (int round = 0; round < 3000; ++round) {
        const std::vector<int> met = visits(2 + round % 3, 6, 1);
        sum += static_cast<std::uint64_t>(std::accumulate(met.begin(), met.end(), 0));
    }
    EXPECT_EQ(sum, 18'000U);
}

TEST(ParallelFor, LoopsWithinLoopsAndBesideEachOther) {
    std::atomic<int> count = 0;
    const auto nest = [&count] {
        parallel_for({3}, 8, 1, [&](std::size_t, std::size_t) {
            parallel_for({4}, 8, 1, [&](std::size_t, std::size_t) {
                parallel_for({2}, 8, 1, [&](std::size_t, std::size_t) { ++count; });
            });
        });
    };
    std::thread other(nest);
    nest();
    other.join();
    EXPECT_EQ(count, 2 * 8 * 8 * 8);
}

TEST(ParallelFor, ThrowsWhatABodyThrowsAndGoesOn) {
    for (const int num_threads : {1, 2, 4}) {
        for (int round = 0; round < 100; ++round) {
            EXPECT_THROW(parallel_for({num_threads}, 100, 1,
                                      [](std::size_t first, std::size_t) {
                                          if (first % 7 == 3) throw std::runtime_error("seven");
                                      }),
                         std::runtime_error);
        }
        EXPECT_EQ(visits(num_threads, 10, 1), std::vector<int>(10, 1));
    }
}

TEST(ParallelFor, UsesSeveralAtOnce) {
    // Each body waits until another one has begun.
    std::atomic<int> num_begun = 0;
    parallel_for({2}, 2, 1, [&](std::size_t, std::size_t) {
        ++num_begun;
        while (num_begun < 2) std::this_thread::yield();
    });
    EXPECT_EQ(num_begun, 2);
}

// The last of this file: a process that has met the limit does not ask again.
TEST(LimitOnTasks, FewerDoTheSameWork) {
    pthread_attr_t before;
    ASSERT_EQ(pthread_getattr_default_np(&before), 0);
    // No stack of so many bytes can be had.
    pthread_attr_t huge = before;
    ASSERT_EQ(pthread_attr_setstacksize(&huge, std::size_t{1} << 50U), 0);
    ASSERT_EQ(pthread_setattr_default_np(&huge), 0);
    EXPECT_EQ(num_threads_missing(), 0);
    EXPECT_EQ(visits(64, 1000, 3), std::vector<int>(1000, 1));
    EXPECT_EQ(visits(2, 1000, 3), std::vector<int>(1000, 1));
    EXPECT_GT(num_threads_missing(), 0);
    EXPECT_LE(num_threads_missing(), 63);
    ASSERT_EQ(pthread_setattr_default_np(&before), 0);
}

}  // namespace
}  // namespace quadcut
