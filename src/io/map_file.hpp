// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "quadcut/map/occupancy_map.hpp"

namespace quadcut::io {

/// A map as bytes, the same on every machine. Equal maps (log-odds, root, resolution, pose) give
/// equal bytes, whatever their history. Throws std::logic_error while writes are pending.
///
/// Little endian: "QUADMAP" 0x1A; u32 version = 1; f64 resolution_m; f64 x, y, yaw_rad of
/// world_from_map; u32 1 if the root has its place, else 0; i32 x, y of its lower left cell; u32
/// its level; i32 x, y of the lowest tile that is not unknown; u32 width, height of the rectangle
/// of such tiles; a byte for each tile, row by row: its log-odds less kMinLogOdds if they are all
/// the same, else 255; for each of the latter 64 such bytes, row by row; u64 FNV-1a of all that
/// came before.
[[nodiscard]] std::vector<std::byte> encode_map(const OccupancyMap& map);

/// The map of such bytes; encoding it again gives the same bytes. `name` stands in messages.
/// Bytes are untrusted: memory stays within a small multiple of their number. Throws InputError
/// that names the byte and what was expected there.
[[nodiscard]] OccupancyMap decode_map(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadcut::io
