// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace quadcut {

// Strong indices: they do not mix by accident.

/// Index of a leaf in the list that a map returned.
enum class LeafId : std::uint32_t {};
/// Who a room is, 1, 2, ..., from one result of a map to the next; 0 = no room.
enum class RoomId : std::uint32_t {};
/// Who a door of a followed map is, 1, 2, ...; 0 = no door.
enum class DoorId : std::uint32_t {};

template <typename Id>
    requires std::is_enum_v<Id>
[[nodiscard]] constexpr std::size_t index(Id id) { return static_cast<std::size_t>(id); }

}  // namespace quadcut
