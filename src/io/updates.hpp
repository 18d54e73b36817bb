// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "quadcut/follow/follow_update.hpp"

namespace quadcut::io {

/// One line of updates.jsonl, with its line end.
[[nodiscard]] std::string to_json_line(const FollowUpdate& update);

}  // namespace quadcut::io
