// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/follow/match_rooms.hpp"

#include <algorithm>

namespace quadcut {

Kinship match_rooms(std::span<const double> earlier_sizes, std::span<const double> sizes,
                    std::vector<Meeting> meetings) {
    std::stable_sort(meetings.begin(), meetings.end(),
                     [](const Meeting& p, const Meeting& q) { return p.shared > q.shared; });
    Kinship kinship{std::vector<Kin>(earlier_sizes.size()), std::vector<Kin>(sizes.size())};
    for (const Meeting& meeting : meetings) {
        Kin& was = kinship.earlier[meeting.earlier];
        Kin& is = kinship.now[meeting.now];
        const bool has_earlier = meeting.shared >= 0.5 * earlier_sizes[meeting.earlier];
        const bool has_now = meeting.shared >= 0.5 * sizes[meeting.now];
        if (has_earlier && was.holder == kNoKin) was.holder = meeting.now;
        if (has_now && is.holder == kNoKin) is.holder = meeting.earlier;
        if ((has_earlier || has_now) && was.same == kNoKin && is.same == kNoKin) {
            was.same = meeting.now;
            is.same = meeting.earlier;
        }
    }
    return kinship;
}

}  // namespace quadcut
