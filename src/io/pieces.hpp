// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <functional>
#include <string_view>
#include <utility>

namespace quadcut::io {

/// Gives bytes piece by piece. A piece is good until the next is asked for; an empty one is the
/// end.
using Pieces = std::function<std::string_view()>;

/// Bytes that are read more than once: begins anew each time.
using OpenPieces = std::function<Pieces()>;

/// Bytes in memory, which outlive the pieces, as one.
[[nodiscard]] inline Pieces pieces_of(std::string_view bytes) {
    return [bytes]() mutable { return std::exchange(bytes, std::string_view()); };
}

}  // namespace quadcut::io
