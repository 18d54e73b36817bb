// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "quadcut/follow/follow_update.hpp"

namespace quadcut {

/// Each once, in order.
[[nodiscard]] Changes tidied(Changes changes);

/// What changed, update by update. Of each tile, room and door mostly the last change is kept, so
/// that memory does not grow with time.
class ChangeLog {
public:
    /// Nothing is known of what changed up to here.
    explicit ChangeLog(std::uint64_t begin = 0) : begin_(begin) {}

    [[nodiscard]] std::uint64_t begin() const { return begin_; }
    /// @pre the revision is higher than all before.
    void add(Changes changes);
    /// All that changed after a revision, which is begin() or later. O(changes since then).
    [[nodiscard]] Changes since(std::uint64_t revision) const;
    /// What is kept.
    [[nodiscard]] std::size_t size() const { return num_kept_ + num_added_; }

private:
    void forget_what_changed_again();

    std::uint64_t begin_;
    std::vector<Changes> changes_;
    std::size_t num_kept_ = 0;
    std::size_t num_added_ = 0;
};

}  // namespace quadcut
