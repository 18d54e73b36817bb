// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/narrowing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace quadcut {
namespace {

constexpr double kStepM = 0.1;
/// What lies within these path lengths is noted: peaks at all, areas at the last two.
constexpr std::array<double, 3> kWithinM{1.5, 3.0, kNarrowingReachM};
constexpr std::uint16_t kUnseen = 0xFFFF;
constexpr std::uint16_t kUnreached = 0xFFFE;
/// Lengths are in fifths of a step and begin at 1: 0 is a place that no path leads to.
constexpr std::uint16_t kBlocked = 0;
constexpr unsigned kStart = 1;
constexpr unsigned kStraight = 5;
constexpr unsigned kDiagonal = 7;

std::int32_t stride_of(double resolution_m) {
    return std::max(1, static_cast<std::int32_t>(std::lround(kStepM / resolution_m)));
}

bool is_reached(std::uint16_t length) { return length != kBlocked && length < kUnreached; }

double path_m(unsigned length, double step_m) {
    return static_cast<double>(length - kStart) * step_m / kStraight;
}

}  // namespace

/// One walk: the window around its seed.
class NarrowingGauge::Walk {
public:
    Walk(NarrowingGauge& gauge, Cell seed, const RegionsView& regions, WalkedSide& walked)
        : gauge_(gauge),
          clearance_(gauge.clearance_),
          free_clearance_(gauge.free_clearance_),
          seed_(seed),
          seed_offset_(clearance_.offset(seed)),
          regions_(regions),
          pieces_(regions.pieces.values.data()),
          own_piece_(pieces_[seed_offset_]),
          region_(regions.region_at(seed_offset_)),
          walked_(walked) {
        const auto up = static_cast<std::int32_t>(1U << gauge.row_bits_);
        // East, north, west, south; then what lies between each and the next.
        steps_ = {1, up, -1, -up, up + 1, up - 1, -up - 1, -up + 1};
        const std::int32_t reach = gauge.radius_ * gauge.stride_cells_;
        is_all_inside_ = clearance_.contains({seed.x - reach, seed.y - reach}) &&
                         clearance_.contains({seed.x + reach, seed.y + reach});
    }

    /// Most of a region is reached by ways that no place is in the way of, which are as long as
    /// they can be short: a look along the rows. What is left is walked to.
    void go() {
        look_around();
        walk_behind();
        for (std::size_t i = 1; i < walked_.within.size(); ++i) {
            add(walked_.within[i - 1], walked_.within[i]);
        }
        walked_.reach_m = path_m(most_, gauge_.step_m_);
        std::fill(gauge_.length_.begin() + lowest_, gauge_.length_.begin() + highest_ + 1, kUnseen);
    }

private:
    [[nodiscard]] unsigned centre() const {
        const auto radius = static_cast<unsigned>(gauge_.radius_);
        return (radius << gauge_.row_bits_) + radius;
    }
    [[nodiscard]] unsigned ahead(unsigned place, unsigned way) const {
        return place + static_cast<unsigned>(steps_[way]);
    }
    [[nodiscard]] std::int32_t x_of(unsigned place) const {
        return static_cast<std::int32_t>(place & ((1U << gauge_.row_bits_) - 1)) - gauge_.radius_;
    }
    [[nodiscard]] std::int32_t y_of(unsigned place) const {
        return static_cast<std::int32_t>(place >> gauge_.row_bits_) - gauge_.radius_;
    }
    [[nodiscard]] bool is_inside(unsigned place) const {
        return is_all_inside_ ||
               clearance_.contains({seed_.x + x_of(place) * gauge_.stride_cells_,
                                    seed_.y + y_of(place) * gauge_.stride_cells_});
    }
    /// In the raster. @pre is_inside(place).
    [[nodiscard]] std::size_t offset_at(unsigned place) const {
        const std::int64_t cells = x_of(place) + std::int64_t{y_of(place)} * clearance_.width;
        return seed_offset_ + static_cast<std::size_t>(cells * gauge_.stride_cells_);
    }

    /// The first look at a place: whether it lies in the region.
    std::uint16_t look_at(unsigned place) {
        lowest_ = std::min(lowest_, place);
        highest_ = std::max(highest_, place);
        if (!is_inside(place)) return kBlocked;
        // Most places are of the piece that the one before was of.
        const std::uint32_t piece = pieces_[offset_at(place)];
        if (piece == own_piece_) return kUnreached;
        const std::uint32_t own = regions_.region_of_piece[piece];
        if (own == region_) {
            own_piece_ = piece;
            return kUnreached;
        }
        if (own != 0 && (walked_.met.empty() || walked_.met.back() != own)) {
            walked_.met.push_back(own);
        }
        return kBlocked;
    }
    [[nodiscard]] bool is_blocked(unsigned place) {
        std::uint16_t& shortest = gauge_.length_[place];
        if (shortest == kUnseen) shortest = look_at(place);
        return shortest == kBlocked;
    }
    void reach(unsigned place, unsigned way, unsigned length) {
        std::uint16_t& shortest = gauge_.length_[place];
        if (shortest == kUnseen) shortest = look_at(place);
        if (length >= shortest) return;
        shortest = static_cast<std::uint16_t>(length);
        gauge_.fronts_[length % gauge_.fronts_.size()].push_back(
            {static_cast<std::uint16_t>(place), static_cast<std::uint16_t>(way)});
    }
    void visit(unsigned place, unsigned length) {
        const std::size_t offset = offset_at(place);
        const std::int64_t x = x_of(place);
        const std::int64_t y = y_of(place);
        std::size_t i = 0;
        while (length > gauge_.noted_at_[i]) ++i;
        const WalkedSide::Within one{
            {clearance_.values[offset], free_clearance_.values[offset]}, 1, x * x, x * y, y * y};
        add(one, walked_.within[i]);
        most_ = std::max(most_, length);
    }
    static void add(const WalkedSide::Within& more, WalkedSide::Within& within) {
        for (std::size_t k = 0; k < within.peak_m.size(); ++k) {
            within.peak_m[k] = std::max(within.peak_m[k], more.peak_m[k]);
        }
        within.count += more.count;
        within.sum_xx += more.sum_xx;
        within.sum_xy += more.sum_xy;
        within.sum_yy += more.sum_yy;
    }

    /// The places with a shortest way from the seed all of whose places lie in the region.
    void look_around() {
        (void)is_blocked(centre());
        gauge_.length_[centre()] = kStart;
        visit(centre(), kStart);
        // How far the row before goes, to the right and to the left.
        std::array<std::int32_t, 2> first{};
        look_along(0, 1, 1, first[0]);
        look_along(0, 1, -1, first[1]);
        for (const int up : {1, -1}) {
            std::array<std::int32_t, 2> ends = first;
            for (std::int32_t y = 1; y <= gauge_.radius_; ++y) {
                const bool is_any_right = look_along(y, up, 1, ends[0]);
                const bool is_any_left = look_along(y, up, -1, ends[1]);
                if (!is_any_right && !is_any_left) break;
            }
        }
    }
    static std::uint16_t shortest(unsigned x, unsigned y) {
        return static_cast<std::uint16_t>(kStart + kStraight * std::max(x, y) +
                                          (kDiagonal - kStraight) * std::min(x, y));
    }
    /// In row y, the last place from the seed's column on to which the way may be so short; -1:
    /// none.
    static std::int32_t last_within(unsigned length, std::int32_t y) {
        constexpr auto kAlong = static_cast<std::int32_t>(kStraight);
        constexpr auto kAside = static_cast<std::int32_t>(kDiagonal - kStraight);
        const auto left = static_cast<std::int32_t>(length - kStart);
        if (left < kAlong * y) return -1;
        return left >= (kAlong + kAside) * y ? (left - kAside * y) / kAlong
                                             : (left - kAlong * y) / kAside;
    }
    /// One half of a row, from the seed's column outward; `end` is as far as the row before went,
    /// and then as far as this one. Whether anything is reached.
    bool look_along(std::int32_t y, std::int32_t up, std::int32_t side, std::int32_t& end) {
        const std::int32_t begin = static_cast<std::int32_t>(centre()) + y * up * steps_[1];
        std::uint16_t* const row = gauge_.length_.data() + begin;
        const std::uint16_t* const before = row - up * steps_[1];
        std::int32_t last = -1;
        // The seed is settled, and its column is looked at with the right half.
        std::int32_t x = side > 0 && y > 0 ? 0 : 1;
        bool is_from_side = y == 0;
        bool is_from_corner = y > 0 && x > 0 && is_reached(before[0]);
        for (std::size_t i = 0; i < walked_.within.size(); ++i) {
            // Of the places within this length: sums over them, in steps.
            std::array<float, 2> peak_m{};
            std::int32_t count = 0;
            std::int32_t sum_x = 0;
            std::int32_t sum_xx = 0;
            const std::int32_t stop = last_within(gauge_.noted_at_[i], y);
            for (; x <= stop && (x <= end + 1 || is_from_side); ++x) {
                const bool is_from_below = y > 0 && is_reached(before[side * x]);
                const bool is_near =
                    is_from_corner || (x < y ? is_from_below : x > y && is_from_side);
                is_from_corner = is_from_below;
                is_from_side = false;
                if (!is_near) continue;
                const auto place = static_cast<unsigned>(begin + side * x);
                std::uint16_t& length = row[side * x];
                length = look_at(place);
                if (length == kBlocked) continue;
                const std::size_t offset = offset_at(place);
                length = shortest(static_cast<unsigned>(x), static_cast<unsigned>(y));
                is_from_side = true;
                last = x;
                peak_m[0] = std::max(peak_m[0], clearance_.values[offset]);
                peak_m[1] = std::max(peak_m[1], free_clearance_.values[offset]);
                ++count;
                sum_x += x;
                sum_xx += x * x;
            }
            add({peak_m, count, sum_xx, std::int64_t{side * up * y} * sum_x,
                 std::int64_t{y} * y * count},
                walked_.within[i]);
        }
        end = std::max(last, 0);
        farthest_ = std::max(farthest_, end);
        if (last >= 0) most_ = std::max<unsigned>(most_, row[side * last]);
        return last >= 0;
    }

    /// Ways out of what was looked at, the shortest first.
    void find_starts(std::vector<Start>& starts) {
        const auto up = static_cast<std::size_t>(steps_[1]);
        const std::uint16_t* const length = gauge_.length_.data();
        std::vector<std::uint16_t>& most = gauge_.most_around_;
        most.resize(up);
        const unsigned low_row = lowest_ >> gauge_.row_bits_;
        const unsigned high_row = highest_ >> gauge_.row_bits_;
        const auto first = static_cast<std::size_t>(gauge_.radius_ - farthest_);
        const auto last = static_cast<std::size_t>(gauge_.radius_ + farthest_) + 1;
        for (unsigned y = std::max(1U, low_row); y <= high_row; ++y) {
            // The largest beside each place: where nothing is unseen nothing goes on.
            const std::uint16_t* const row = length + y * up;
            const std::uint16_t* const below = row - up;
            const std::uint16_t* const above = row + up;
            for (std::size_t x = first; x < last; ++x) {
                const auto larger = [](std::uint16_t p, std::uint16_t q) { return std::max(p, q); };
                const auto column = [&](std::size_t i) { return larger(below[i], above[i]); };
                most[x] = larger(larger(column(x - 1), column(x)),
                                 larger(column(x + 1), larger(row[x - 1], row[x + 1])));
            }
            for (std::size_t x = first; x < last; ++x) {
                if (most[x] >= kUnreached && is_reached(row[x])) {
                    add_starts(static_cast<unsigned>(y * up + x), starts);
                }
            }
        }
        std::sort(starts.begin(), starts.end(), [](const Start& p, const Start& q) {
            return std::tie(p.length, p.place, p.way) < std::tie(q.length, q.place, q.way);
        });
    }
    void add_starts(unsigned place, std::vector<Start>& starts) {
        for (unsigned way = 0; way < 8; ++way) {
            const unsigned next = ahead(place, way);
            const unsigned length = gauge_.length_[place] + (way < 4 ? kStraight : kDiagonal);
            if (gauge_.length_[next] < kUnreached || length > gauge_.longest_) continue;
            if (!is_blocked(next)) starts.push_back({length, next, way});
        }
    }
    /// Ways around corners, nearest places first (Dial's buckets).
    void walk_behind() {
        std::vector<Start>& starts = gauge_.starts_;
        find_starts(starts);
        auto start = starts.begin();
        std::size_t num_idle = gauge_.fronts_.size();
        for (unsigned length = kStart; length <= gauge_.longest_; ++length) {
            if (num_idle >= gauge_.fronts_.size()) {
                if (start == starts.end()) break;
                length = start->length;
            }
            for (; start != starts.end() && start->length == length; ++start) {
                reach(start->place, start->way, length);
            }
            std::vector<Reached>& front = gauge_.fronts_[length % gauge_.fronts_.size()];
            for (const Reached at : front) {
                if (gauge_.length_[at.place] != length) continue;
                visit(at.place, length);
                go_on(at.place, at.way, length);
            }
            num_idle = front.empty() ? num_idle + 1 : 0;
            front.clear();
        }
        starts.clear();
        for (std::vector<Reached>& front : gauge_.fronts_) front.clear();
    }
    /// On to the neighbours that cannot be reached as soon from the place before, unless it is
    /// around something blocked (Harabor and Grastien, "Online graph pruning for pathfinding on
    /// grid maps", 2011).
    void go_on(unsigned place, unsigned way, unsigned length) {
        const unsigned right = (way + 3) % 4;
        const unsigned left = (way + 1) % 4;
        if (way < 4) {
            reach(ahead(place, way), way, length + kStraight);
            if (is_blocked(ahead(place, left))) {
                reach(ahead(place, 4 + way), 4 + way, length + kDiagonal);
            }
            if (is_blocked(ahead(place, right))) {
                reach(ahead(place, 4 + right), 4 + right, length + kDiagonal);
            }
            return;
        }
        // A diagonal way is one between a straight one and the next.
        const unsigned first = way - 4;
        reach(ahead(place, first), first, length + kStraight);
        reach(ahead(place, left), left, length + kStraight);
        reach(ahead(place, way), way, length + kDiagonal);
        if (is_blocked(ahead(place, (first + 2) % 4))) {
            reach(ahead(place, 4 + left), 4 + left, length + kDiagonal);
        }
        if (is_blocked(ahead(place, right))) {
            reach(ahead(place, 4 + right), 4 + right, length + kDiagonal);
        }
    }

    NarrowingGauge& gauge_;
    const Raster<float>& clearance_;
    const Raster<float>& free_clearance_;
    Cell seed_;
    std::size_t seed_offset_;
    bool is_all_inside_ = false;
    const RegionsView& regions_;
    const std::uint32_t* pieces_;
    std::uint32_t own_piece_;
    std::uint32_t region_;
    WalkedSide& walked_;
    unsigned most_ = kStart;
    /// From the seed's column, of what was looked at.
    std::int32_t farthest_ = 0;
    std::array<std::int32_t, 8> steps_{};
    unsigned lowest_ = static_cast<unsigned>(-1);
    unsigned highest_ = 0;
};

NarrowingGauge::NarrowingGauge(const Raster<float>& clearance_m,
                               const Raster<float>& free_clearance_m, double resolution_m)
    : clearance_(clearance_m),
      free_clearance_(free_clearance_m),
      stride_cells_(stride_of(resolution_m)),
      step_m_(stride_cells_ * resolution_m),
      radius_(static_cast<std::int32_t>(std::ceil(kNarrowingReachM / step_m_)) + 2),
      row_bits_(static_cast<unsigned>(std::bit_width(2U * static_cast<unsigned>(radius_)))),
      longest_(static_cast<unsigned>(kStraight * kNarrowingReachM / step_m_) + kStart),
      length_((2U * static_cast<std::size_t>(radius_) + 1) << row_bits_, kUnseen) {
    for (std::size_t i = 0; i < kWithinM.size(); ++i) {
        noted_at_[i] = longest_;
        while (noted_at_[i] > kStart && path_m(noted_at_[i], step_m_) > kWithinM[i]) --noted_at_[i];
    }
}

/// No path is long enough to leave the window.
WalkedSide NarrowingGauge::walk_outward(Cell seed, const RegionsView& regions) {
    WalkedSide walked;
    walked.step_m = step_m_;
    // A cell that no longer belongs to a region has nothing behind it.
    if (regions.region_at(clearance_.offset(seed)) == 0) return walked;
    Walk(*this, seed, regions, walked).go();
    std::sort(walked.met.begin(), walked.met.end());
    walked.met.erase(std::unique(walked.met.begin(), walked.met.end()), walked.met.end());
    return walked;
}

Narrowing put_together(const Saddle& saddle, const Opening& opening, const SideOfSaddle& side_a,
                       const SideOfSaddle& side_b, double resolution_m) {
    Narrowing out;
    out.half_width_m = static_cast<double>(saddle.clearance_m);
    out.opening = opening;
    out.is_a_narrower = side_a.peak_m.back() <= side_b.peak_m.back();
    out.narrower = out.is_a_narrower ? side_a : side_b;
    out.wider = out.is_a_narrower ? side_b : side_a;
    out.border_ratio =
        static_cast<double>(saddle.num_contacts) * resolution_m / (2.0 * out.half_width_m);
    const auto num_contacts = static_cast<double>(std::max<std::size_t>(1, saddle.num_contacts));
    out.share_in_line = static_cast<double>(saddle.num_in_line) / num_contacts;
    out.less_wall_m = 0.1 * static_cast<double>(saddle.less_wall_dm) / num_contacts;
    out.more_wall_m = 0.1 * static_cast<double>(saddle.more_wall_dm) / num_contacts;
    return out;
}

}  // namespace quadcut
