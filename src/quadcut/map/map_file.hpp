// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "quadcut/map/occupancy_map.hpp"

namespace quadcut {

/// A map as bytes, the same on every machine: little endian, docs/formats.md. Equal maps (log-odds,
/// root, resolution, pose) give equal bytes, whatever their history.
/// Throws std::logic_error while writes are pending.
[[nodiscard]] std::vector<std::byte> encode_map(const OccupancyMap& map);

/// The map of such bytes; encoding it again gives the same bytes. `name` stands in messages.
/// Bytes are untrusted: memory stays within a small multiple of their number. Throws InputError
/// that names the byte and what was expected there.
[[nodiscard]] OccupancyMap decode_map(std::span<const std::byte> bytes, const std::string& name);

}  // namespace quadcut
