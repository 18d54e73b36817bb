// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace quadcut::io {

/// The largest file that is read into memory.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 31U;

/// The bytes of a file (or of a pipe). Throws InputError that names the path when it does not
/// exist, is a folder or a device, cannot be read, or holds more than `max_bytes`.
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::uint64_t max_bytes = kMaxFileBytes);

/// Writes `bytes` to a new file beside `path` and renames it to `path`: whatever happens, `path`
/// holds its old content or all of the new one. Throws InputError that names the path when it
/// cannot be written; nothing is left behind then.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// FNV-1a over the bytes, 64 bits: tells inputs apart in a report, not a safeguard against
/// forgery. `seed` continues an earlier hash.
[[nodiscard]] std::uint64_t hash_bytes(std::string_view bytes,
                                       std::uint64_t seed = 0xCBF29CE484222325ULL);

/// A path as it is shown in messages.
[[nodiscard]] std::string display_name(const std::filesystem::path& path);

}  // namespace quadcut::io
