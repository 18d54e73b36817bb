// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/callouts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "draw/floor_cells.hpp"

namespace quadcut::draw {
namespace {

// Of the size of the numbers.
constexpr double kPadding = 0.25;
constexpr double kNearest = 1.2;
constexpr double kFarthest = 14.0;
constexpr double kStep = 0.7;
/// Text on rooms is as bad as so much of a longer line.
constexpr double kOnRooms = 8.0;
constexpr int kNumDirections = 24;

struct PageBox {
    Point low;
    Point high;
};

PageBox box_around(const Point& center, double width, double height) {
    return {{center.x - width / 2.0, center.y - height / 2.0},
            {center.x + width / 2.0, center.y + height / 2.0}};
}

/// Where there is text on the page, in blocks of a few pixels.
class TextOnPage {
public:
    explicit TextOnPage(const CalloutPage& page)
        : taken_({0, 0}, block(page.width) + 1, block(page.height) + 1) {}

    void take(const PageBox& box) {
        for_each_block(box, [&](Cell block) { taken_.at(block) = 1; });
    }
    void take(const Leader& leader) {
        const double dx = leader.to.x - leader.from.x;
        const double dy = leader.to.y - leader.from.y;
        const double steps = std::ceil(std::hypot(dx, dy) / kBlock) + 1.0;
        for (double t = 0.0; t <= 1.0; t += 1.0 / steps) {
            take(box_around({leader.from.x + t * dx, leader.from.y + t * dy}, 1.0, 1.0));
        }
    }
    [[nodiscard]] bool is_free(const PageBox& box) const {
        if (!taken_.contains(cell(box.low)) || !taken_.contains(cell(box.high))) return false;
        bool is_free = true;
        for_each_block(box, [&](Cell block) { is_free = is_free && taken_.at(block) == 0; });
        return is_free;
    }

private:
    static constexpr double kBlock = 4.0;
    static std::int32_t block(double pixels) {
        constexpr double kMost = 1e8;
        return static_cast<std::int32_t>(std::floor(std::clamp(pixels, -kMost, kMost) / kBlock));
    }
    static Cell cell(const Point& at) { return {block(at.x), block(at.y)}; }

    template <typename Visitor>
    void for_each_block(const PageBox& box, const Visitor& visit) const {
        const Cell low = cell(box.low);
        const Cell high = cell(box.high);
        for (std::int32_t y = std::max(low.y, 0); y <= std::min(high.y, taken_.height - 1); ++y) {
            for (std::int32_t x = std::max(low.x, 0); x <= std::min(high.x, taken_.width - 1);
                 ++x) {
                visit(Cell{x, y});
            }
        }
    }

    Raster<std::uint8_t> taken_;
};

/// What a label covers of the page; more, where it is turned.
PageBox box_of(const RoomLabel& label, const Typeface& typeface) {
    const TextAxes axes(label.direction);
    PageBox box{label.name.anchor, label.name.anchor};
    const auto add = [&](const TextLine& line) {
        const double half = typeface.width(line.text, line.size) / 2.0 + kPadding * line.size;
        const double up = typeface.cap_height(line.size) + kPadding * line.size;
        for (const double along : {-half, half}) {
            for (const double down : {-up, kPadding * line.size}) {
                const Point corner{line.anchor.x + along * axes.along.x + down * axes.down.x,
                                   line.anchor.y + along * axes.along.y + down * axes.down.y};
                box.low = {std::min(box.low.x, corner.x), std::min(box.low.y, corner.y)};
                box.high = {std::max(box.high.x, corner.x), std::max(box.high.y, corner.y)};
            }
        }
    };
    add(label.name);
    if (label.area) add(*label.area);
    return box;
}

/// The share of a box that lies on rooms.
double share_on_rooms(const Raster<std::uint16_t>& ground, const PageScale& scale,
                      const PageBox& box) {
    constexpr int kSamples = 5;
    int num_on_rooms = 0;
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const int column = i % kSamples;
        const int row = i / kSamples;
        const double u = (column + 0.5) / kSamples;
        const double v = (row + 0.5) / kSamples;
        const Point at{box.low.x + u * (box.high.x - box.low.x),
                       box.low.y + v * (box.high.y - box.low.y)};
        const Cell cell{
            static_cast<std::int32_t>(std::floor((at.x - scale.left) / scale.pixels_per_cell)),
            static_cast<std::int32_t>(std::floor((scale.bottom - at.y) / scale.pixels_per_cell))};
        if (ground.contains(cell) && is_room(ground.at(cell))) ++num_on_rooms;
    }
    return static_cast<double>(num_on_rooms) / (kSamples * kSamples);
}

/// From a place to the nearest point of the box.
Leader leader_to(const Point& from, const PageBox& box) {
    return {from,
            {std::clamp(from.x, box.low.x, box.high.x), std::clamp(from.y, box.low.y, box.high.y)}};
}

/// A number, and the place that it is to be near to.
struct Near {
    Point spot;
    double size = 0.0;
    /// The number on the place itself.
    PageBox box;
};

/// Around the place, farther and farther out; the place itself if all is taken.
PageBox find_box(const Near& near, const TextOnPage& text, const Raster<std::uint16_t>& ground,
                 const PageScale& scale) {
    const double width = near.box.high.x - near.box.low.x;
    const double height = near.box.high.y - near.box.low.y;
    PageBox best = near.box;
    double least = std::numeric_limits<double>::max();
    for (double distance = kNearest; distance < std::min(kFarthest, least); distance += kStep) {
        for (int k = 0; k < kNumDirections; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kNumDirections;
            const Point center{
                near.spot.x + (distance * near.size + width / 2.0) * std::cos(angle),
                near.spot.y + (distance * near.size + height / 2.0) * std::sin(angle)};
            const PageBox box = box_around(center, width, height);
            if (!text.is_free(box)) continue;
            const double cost = distance + kOnRooms * share_on_rooms(ground, scale, box);
            if (cost >= least) continue;
            least = cost;
            best = box;
        }
    }
    return best;
}

}  // namespace

std::vector<RoomLabel> place_callouts(const std::vector<CrampedRoom>& rooms,
                                      const std::vector<RoomLabel>& labels,
                                      const Raster<std::uint16_t>& ground, const PageScale& scale,
                                      const CalloutPage& page, const Typeface& typeface) {
    if (rooms.empty()) return {};
    TextOnPage text(page);
    for (const RoomLabel& label : labels) text.take(box_of(label, typeface));
    const double size = page.text_size;
    const double cap = typeface.cap_height(size);
    std::vector<RoomLabel> callouts;
    for (const CrampedRoom& room : rooms) {
        const Point spot = scale.to_page(room.spot);
        const double width = typeface.width(room.number, size) + 2.0 * kPadding * size;
        const Near near{spot, size, box_around(spot, width, cap + 2.0 * kPadding * size)};
        const PageBox box = find_box(near, text, ground, scale);
        RoomLabel label;
        label.room = room.room;
        label.name = {room.number,
                      size,
                      {(box.low.x + box.high.x) / 2.0, (box.low.y + box.high.y + cap) / 2.0}};
        label.leader = leader_to(spot, box);
        text.take(box);
        text.take(*label.leader);
        callouts.push_back(std::move(label));
    }
    return callouts;
}

}  // namespace quadcut::draw
