// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "quadcut/base/ids.hpp"
#include "quadcut/follow/follower.hpp"

namespace quadcut {

/// The room that a word on the command line means: by its id, or by the name that is displayed.
/// Throws InputError when there is none, or when it is the id of one and the name of another.
/// O(map) when it is no id and no name that people gave.
[[nodiscard]] RoomId room_of(const std::string& word, const Follower& follower);

}  // namespace quadcut
