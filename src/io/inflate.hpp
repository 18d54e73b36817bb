// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "io/pieces.hpp"

namespace quadcut::io {

/// Whether the bytes begin like a gzip file.
[[nodiscard]] bool is_gzip(std::string_view bytes);

/// Unpacks gzip piece by piece. Joined files are one; what follows the last and is no gzip is
/// padding.
class Inflater {
public:
    /// `more` comes after `bytes`, which are good until it is called for the first time. `name`
    /// stands in messages. @pre is_gzip(bytes)
    Inflater(std::string_view bytes, std::string name, std::uint64_t max_total_bytes,
             Pieces more = pieces_of({}));
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater();

    /// The next piece, good until the one after it; empty at the end. Throws InputError when the
    /// bytes are damaged, end early, or unpack to more than the limit.
    [[nodiscard]] std::string_view next();

private:
    struct Stream;

    std::size_t unpack();
    bool goes_on();

    std::string_view bytes_;  ///< not yet unpacked
    Pieces more_;
    std::string carried_;  ///< what is left of a piece, and the next
    std::string name_;
    std::uint64_t max_total_bytes_;
    std::unique_ptr<Stream> stream_;
    std::uint64_t position_ = 0;
    std::uint64_t total_ = 0;
    bool finished_ = false;
};

/// All that gzip bytes unpack to. Errors as Inflater::next().
[[nodiscard]] std::string unpack_gzip(std::string_view bytes, const std::string& name,
                                      std::uint64_t max_total_bytes);

/// The first bytes that gzip bytes unpack to, at most one piece; empty when they are damaged.
[[nodiscard]] std::string unpack_beginning(std::string_view bytes);

}  // namespace quadcut::io
