// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>

namespace quadcut {

/// One program writes to a project file at a time, others may read.
enum class Access : std::uint8_t { read, write };

}  // namespace quadcut
