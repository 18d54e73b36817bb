// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "project/project_file.hpp"
#include "project/scan_position.hpp"
#include "quadcut/follow/follower.hpp"

namespace quadcut::project {

/// A project goes on with the source of scans and the options that it has. Throws InputError when
/// these are others.
void require_begun_with(const ProjectFile& file, const FollowOptions& options,
                        const ScanPosition& source);

}  // namespace quadcut::project
