// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace quadcut::io {

[[nodiscard]] bool is_bmp(std::string_view bytes);
[[nodiscard]] bool is_jpeg(std::string_view bytes);
[[nodiscard]] bool is_gif(std::string_view bytes);

/// Where the image ends in the bytes of such a file. The decoder fills in what is missing; here it
/// is found missing: throws InputError with `name` when the file ends before the image does.
[[nodiscard]] std::size_t end_of_bmp(std::string_view bytes, const std::string& name);
[[nodiscard]] std::size_t end_of_jpeg(std::string_view bytes, const std::string& name);
[[nodiscard]] std::size_t end_of_gif(std::string_view bytes, const std::string& name);

}  // namespace quadcut::io
