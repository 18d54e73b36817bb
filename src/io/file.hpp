// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace quadcut::io {

/// The largest file that is read into memory.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{1} << 31U;

/// The bytes of a file (or of a pipe). Throws InputError that names the path when it does not
/// exist, is a folder or a device, cannot be read, or holds more than `max_bytes`.
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::uint64_t max_bytes = kMaxFileBytes);

/// What a user named as input, read once.
struct InputFile {
    std::filesystem::path path;
    std::string name;              ///< in messages
    std::filesystem::path folder;  ///< what it names is looked for there; empty: the working folder
    std::string bytes;
};
/// Looks at the first bytes of an input, and throws when the rest is not worth reading.
using BeginningCheck = std::function<void(const InputFile& beginning)>;

/// The path that stands for standard input.
inline constexpr std::string_view kStandardInput = "-";
/// A BeginningCheck sees so many bytes, or all.
inline constexpr std::size_t kBeginningBytes = std::size_t{1} << 16U;

/// Reads a file, a pipe, or standard input ("-"); errors as read_file. `check` is called once,
/// before more than kBeginningBytes are read from a pipe, and before a file's length is judged.
[[nodiscard]] InputFile read_input(const std::filesystem::path& path,
                                   const BeginningCheck& check = {});

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
