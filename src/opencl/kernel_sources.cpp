// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/kernel_sources.hpp"

// Defined in kernels.S.in, which takes the files in at build time.
extern "C" {
extern const char kQuadcutSightKernels[];
extern const unsigned int kQuadcutSightKernelsSize;
extern const char kQuadcutProductKernels[];
extern const unsigned int kQuadcutProductKernelsSize;
}

namespace quadcut::opencl {

std::string_view sight_kernels() { return {kQuadcutSightKernels, kQuadcutSightKernelsSize}; }

std::string_view product_kernels() { return {kQuadcutProductKernels, kQuadcutProductKernelsSize}; }

}  // namespace quadcut::opencl
