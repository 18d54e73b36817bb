// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "io/descriptor.hpp"
#include "io/file.hpp"
#include "io/pieces.hpp"

namespace quadcut::io {

/// The path that stands for standard input.
inline constexpr std::string_view kStandardInput = "-";
/// An input's kind is told by so many bytes, or all.
inline constexpr std::size_t kBeginningBytes = std::size_t{1} << 16U;

/// What a user named as input, read once.
struct InputFile {
    std::filesystem::path path;
    std::string name;              ///< in messages
    std::filesystem::path folder;  ///< what it names is looked for there; empty: the working folder
    std::string bytes;
};

/// What a user named as input, of which no more than the beginning is read yet: a file, a pipe, or
/// standard input ("-"). Errors as read_file().
class Input {
public:
    explicit Input(const std::filesystem::path& path);
    /// What is in memory.
    explicit Input(InputFile whole) : beginning_(std::move(whole)), rest_(-1) {}

    /// With its first kBeginningBytes, or all.
    [[nodiscard]] const InputFile& beginning() const { return beginning_; }

    [[nodiscard]] InputFile read_all() &&;

    /// To be read as often as one likes, in bounded memory: what comes from a pipe, and is not
    /// small, is kept in a temporary file without a name. Pieces throw InputError when they cannot
    /// be read or the file has changed.
    [[nodiscard]] OpenPieces open_pieces() &&;

private:
    InputFile beginning_;
    Descriptor rest_;
};

/// Looks at the first bytes of an input, and throws when the rest is not worth reading.
using BeginningCheck = std::function<void(const InputFile& beginning)>;

/// Reads a file, a pipe, or standard input ("-"); errors as read_file. `check` is called once,
/// before more than kBeginningBytes are read, and before a file's length is judged.
[[nodiscard]] InputFile read_input(const std::filesystem::path& path,
                                   const BeginningCheck& check = {});

}  // namespace quadcut::io
