// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/part_rooms.hpp"

#include <algorithm>
#include <map>

namespace quadcut {

std::vector<std::uint32_t> majority_rooms(const Raster<std::uint32_t>& parts, std::uint32_t count,
                                          const Raster<std::uint32_t>& rooms) {
    std::vector<std::map<std::uint32_t, std::size_t>> shares(count + std::size_t{1});
    for (std::size_t i = 0; i < parts.values.size(); ++i) {
        if (parts.values[i] != 0 && parts.values[i] <= count)
            ++shares[parts.values[i]][rooms.values[i]];
    }
    std::vector<std::uint32_t> result;
    for (const auto& share : shares) {
        const auto most =
            std::max_element(share.begin(), share.end(),
                             [](const auto& p, const auto& q) { return p.second < q.second; });
        result.push_back(most == share.end() ? 0 : most->first);
    }
    return result;
}

std::vector<std::uint32_t> groups_of(const std::vector<std::uint32_t>& rooms,
                                     const FollowedMap& followed) {
    std::vector<std::uint32_t> groups;
    for (const std::uint32_t id : rooms) {
        const auto room = followed.rooms.find(id);
        groups.push_back(room == followed.rooms.end() ? 0 : room->second.merge_group);
    }
    return groups;
}

}  // namespace quadcut
