// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>

#include "quadcut/follow/edit.hpp"

namespace quadcut {

/// Whether an edit holds. What is dropped was undone, and others were made since: it cannot be made
/// again. A fixed edit was made by a version that did not keep how to undo it.
enum class EditState : std::uint8_t { done, undone, dropped, fixed };

/// An edit of people, as it was made.
struct EditRecord {
    /// 1, 2, ... in the order in which they were made.
    std::int64_t number = 0;
    /// The scans that had been followed.
    std::size_t scan = 0;
    /// split: `room` is what was cut, `other` what began, between the ends of the cut.
    Edit edit;
    EditState state = EditState::done;
};

}  // namespace quadcut
