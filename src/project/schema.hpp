// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace quadcut::project {

/// "QCUT".
inline constexpr std::int64_t kApplicationId = 0x51435554;
inline constexpr std::int64_t kFormatVersion = 4;

struct Table {
    std::string_view name;
    std::string_view sql;
    /// The first format version that has it.
    std::int64_t since = 1;
};

/// All tables, by name. A file with any other is no project file.
[[nodiscard]] std::span<const Table> tables();

}  // namespace quadcut::project
