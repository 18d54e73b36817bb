// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "quadcut/base/parallel.hpp"
#include "quadcut/follow/follow_update.hpp"
#include "quadcut/follow/followed_map.hpp"
#include "quadcut/follow/options.hpp"

namespace quadcut {

/// Whether enough has changed.
[[nodiscard]] bool is_cut_due(const FollowedMap& followed, const FollowOptions& options);

/// Cuts around all that has changed, patches of this size and larger.
/// O(cells within 30 m of what has changed + rooms).
void cut_again(FollowedMap& followed, const FollowOptions& options, double min_patch_m2,
               const Executor& executor, FollowUpdate& update);

/// What a decision goes by may lie farther from a change than a window reaches: the area of a room,
/// and its other doors. So rooms that have become others are decided again, a block at a time: the
/// one of which the largest share has come or gone since, at least `min_stale`. False: none has.
bool refine_stalest(FollowedMap& followed, const FollowOptions& options, double min_stale,
                    const Executor& executor, FollowUpdate& update);

/// The robot's way goes on. Where it enters what was dropped for lying off it, the tile is noted
/// as changed, and rooms are to be cut again at once: true.
[[nodiscard]] bool note_way(FollowedMap& followed, const Point& at, const FollowOptions& options,
                            Changes& changes);

/// What was seen in and around a room that was locked counts from now on.
void catch_up(FollowedMap& followed, const FollowOptions& options, std::uint32_t room,
              const Executor& executor, FollowUpdate& update);

}  // namespace quadcut
