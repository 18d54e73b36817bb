// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string_view>

namespace quadcut::opencl {

/// sight.cl and product.cl, which are part of the program.
[[nodiscard]] std::string_view sight_kernels();
[[nodiscard]] std::string_view product_kernels();

}  // namespace quadcut::opencl
