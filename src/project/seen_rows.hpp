// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "project/database.hpp"
#include "quadcut/follow/followed_map.hpp"

namespace quadcut::project {

/// Writes which rooms scans saw together, in place of what was. @pre a transaction is open.
void write_covisibility(const Database& database, const FollowedMap& state);
/// Reads it again; nothing in files of earlier versions. Throws InputError for rows that cannot be.
void read_covisibility(const Database& database, FollowedMap& state);

/// Reads the robot's way off the poses of the scans; nothing in files of earlier versions. Throws
/// InputError for poses that no map can hold.
void read_way(const Database& database, FollowedMap& state);

}  // namespace quadcut::project
