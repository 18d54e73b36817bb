// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace quadcut::io {

[[nodiscard]] bool is_bmp(std::string_view bytes);
[[nodiscard]] bool is_gif(std::string_view bytes);

/// Where the image ends in the bytes of such a file. The decoder trusts what it reads, and fills in
/// what is missing; here that is found out before: throws InputError with `name` when the size is
/// absurd, when the file ends before the image does, or when a table is damaged.
[[nodiscard]] std::size_t end_of_bmp(std::string_view bytes, const std::string& name);
[[nodiscard]] std::size_t end_of_gif(std::string_view bytes, const std::string& name);

}  // namespace quadcut::io
