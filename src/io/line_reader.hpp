// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/inflate.hpp"
#include "io/pieces.hpp"

namespace quadcut::io {

/// One line without its end. `text` is good until the next line is read.
struct Line {
    std::string_view text;
    std::uint64_t number = 0;  ///< 1, 2, ...
    bool too_long = false;     ///< `text` is only its beginning
    bool ended = true;         ///< false for a last line without a line end
};

struct LineLimits {
    std::size_t max_line_bytes = std::size_t{1} << 20U;
    std::uint64_t max_total_bytes = std::uint64_t{1} << 32U;
};

/// Splits bytes into lines ("\n" or "\r\n"), plain or gzip by their content. A byte order mark
/// before the first is left out. Compressed bytes are unpacked piece by piece: memory is bounded by
/// the longest line allowed.
class LineReader {
public:
    /// `name` stands in messages. @pre the first piece has two bytes, if there are as many
    LineReader(Pieces pieces, std::string name, LineLimits limits = {});
    /// @pre `bytes` outlives the reader.
    LineReader(std::string_view bytes, std::string name, LineLimits limits = {})
        : LineReader(pieces_of(bytes), std::move(name), limits) {}

    /// The next line; nothing at the end. Throws InputError when compressed bytes are damaged, end
    /// early, or unpack to more than the limit.
    std::optional<Line> next();

private:
    bool refill();

    LineLimits limits_;
    Pieces pieces_;
    std::optional<Inflater> inflater_;  ///< none: plain bytes
    std::string_view pending_;          ///< unpacked, not yet returned
    std::string carried_;               ///< the beginning of a line that spans two pieces
    std::uint64_t line_number_ = 0;
};

}  // namespace quadcut::io
