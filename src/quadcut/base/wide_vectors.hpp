// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

/// Before a function whose loops gain from it: compiled a second time for vectors of 256 bits,
/// which is called where the processor has them. Without fused multiply-add, so the results are the
/// same. Only where the loader can choose; under the thread sanitizer it chooses before that has
/// started.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_THREAD__)
#define QUADCUT_WIDE_VECTORS [[gnu::target_clones("avx2", "default")]]
#else
#define QUADCUT_WIDE_VECTORS
#endif
