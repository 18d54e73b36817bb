// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/change_log.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace quadcut {
namespace {

/// The log is gone through when it has become twice as long, and as this.
constexpr std::size_t kMinLength = 4096;

bool is_before(Cell p, Cell q) { return std::pair(p.y, p.x) < std::pair(q.y, q.x); }

struct IsBefore {
    bool operator()(Cell p, Cell q) const { return is_before(p, q); }
};

template <typename Value, typename Compare>
void tidy(std::vector<Value>& values, const Compare& compare) {
    std::sort(values.begin(), values.end(), compare);
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

template <typename Value>
void append(const std::vector<Value>& more, std::vector<Value>& values) {
    values.insert(values.end(), more.begin(), more.end());
}

/// Leaves what is not in `later`, and adds it there.
template <typename Value, typename Compare>
void keep_new(std::vector<Value>& values, std::set<Value, Compare>& later) {
    std::erase_if(values, [&](const Value& value) { return !later.insert(value).second; });
    values.shrink_to_fit();
}

}  // namespace

Changes tidied(Changes changes) {
    tidy(changes.tiles, is_before);
    tidy(changes.rooms, std::less<>());
    tidy(changes.doors, std::less<>());
    return changes;
}

void ChangeLog::add(Changes changes) {
    num_added_ += changes.size();
    changes_.push_back(std::move(changes));
    if (num_added_ > num_kept_ + kMinLength) forget_what_changed_again();
}

Changes ChangeLog::since(std::uint64_t revision) const {
    Changes all;
    for (auto at = changes_.rbegin(); at != changes_.rend() && at->revision > revision; ++at) {
        append(at->tiles, all.tiles);
        append(at->rooms, all.rooms);
        append(at->doors, all.doors);
    }
    return tidied(std::move(all));
}

void ChangeLog::forget_what_changed_again() {
    std::set<Cell, IsBefore> tiles;
    std::set<RoomId> rooms;
    std::set<DoorId> doors;
    num_kept_ = 0;
    // From the last to the first.
    for (std::size_t k = changes_.size(); k > 0; --k) {
        Changes& changes = changes_[k - 1];
        keep_new(changes.tiles, tiles);
        keep_new(changes.rooms, rooms);
        keep_new(changes.doors, doors);
        num_kept_ += changes.size();
    }
    std::erase_if(changes_, [](const Changes& changes) { return changes.size() == 0; });
    num_added_ = 0;
}

}  // namespace quadcut
