// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "draw/lettering.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "draw/callouts.hpp"
#include "draw/label_spots.hpp"
#include "draw/typeface.hpp"
#include "quadcut/map/clearance.hpp"
#include "quadcut/rooms/label_tally.hpp"

namespace quadcut::draw {
namespace {

/// Numbers may be smaller than names, but not too small to be read.
constexpr double kNumberScale = 0.75;
constexpr double kLeastNumberUnit = 0.7;
constexpr double kCalloutSize = 16.0;
/// Names smaller than this may be larger elsewhere in the room.
constexpr double kSmallName = 16.0;
constexpr double kMuchLarger = 1.3;

/// Few rooms leave space for larger letters.
double letter_scale(std::size_t num_rooms) {
    constexpr double kManyRooms = 24.0;
    constexpr double kLargest = 1.5;
    const double rooms = std::max<double>(static_cast<double>(num_rooms), 1.0);
    return std::clamp(std::sqrt(std::sqrt(kManyRooms / rooms)), 1.0, kLargest);
}

/// The rooms without what furniture stands on, and of each room the point farthest from all
/// obstacles, in cells.
struct BareFloor {
    Raster<std::uint16_t> ground;
    std::vector<Point> inner_points;
};

/// The cell farthest from all obstacles; of several, the first.
struct Innermost {
    float clearance = 0.0F;
    std::size_t place = 0;
};

BareFloor clear_floor(const FloorCells& cells, std::size_t num_rooms, const Executor& executor) {
    BareFloor floor{cells.ground, std::vector<Point>(num_rooms)};
    Raster<std::uint8_t> open(cells.ground.origin, cells.ground.width, cells.ground.height);
    constexpr std::size_t kCells = std::size_t{1} << 16U;
    parallel_for(executor, open.values.size(), kCells, [&](std::size_t first, std::size_t last) {
        std::uint16_t* const ground = floor.ground.values.data();
        std::uint8_t* const is_open = open.values.data();
        const std::uint8_t* const furniture = cells.furniture.values.data();
        for (std::size_t i = first; i < last; ++i) {
            const bool is_bare = ground[i] < kFirstNonRoom && furniture[i] == 0;
            ground[i] = is_bare ? ground[i] : std::uint16_t{0};
            is_open[i] = std::uint8_t{ground[i] != 0};
        }
    });
    const Raster<float> clearance = clearance_m(open, 1.0, executor);
    const std::vector<Innermost> most = tally_by_label<Innermost>(
        floor.ground, executor,
        [&](Innermost& innermost, const LabelRun& run) {
            const float* const begin = clearance.values.data() + run.offset;
            const float here = largest(begin, run.num_cells, innermost.clearance);
            if (here <= innermost.clearance) return;
            const auto place = std::find(begin, begin + run.num_cells, here) - begin;
            innermost = {here, run.offset + static_cast<std::size_t>(place)};
        },
        [](Innermost& into, const Innermost& other) {
            if (other.clearance > into.clearance) into = other;
        });
    for (std::size_t room = 1; room < most.size() && room <= num_rooms; ++room) {
        if (most[room].clearance == 0.0F) continue;
        const Cell cell = open.cell(most[room].place);
        floor.inner_points[room - 1] = {cell.x + 0.5, cell.y + 0.5};
    }
    return floor;
}

/// Where the words of rooms stand.
class Lettering {
public:
    Lettering(const FloorCells& cells, const std::vector<RoomWords>& words,
              const LetteredPage& page, const Executor& executor)
        : ground_(cells.ground),
          words_(words),
          scale_(page.scale),
          unit_(page.unit * letter_scale(words.size())),
          number_unit_(std::max(kNumberScale * unit_, kLeastNumberUnit)) {
        // Of larger maps, a page shows no furniture that letters could stand on.
        constexpr std::size_t kMostCells = std::size_t{1} << 25U;
        if (ground_.values.size() <= kMostCells) bare_ = clear_floor(cells, words.size(), executor);
    }

    /// Beside the furniture where that does not make letters much smaller, on it where it does.
    [[nodiscard]] std::optional<RoomLabel> name_in_middle(std::size_t i) const {
        constexpr double kWorthIt = 0.75;
        const RoomWords& words = words_[i];
        LabelText text{static_cast<std::uint32_t>(i + 1), words.name, words.area, words.label_point,
                       words.centroid};
        auto label = place_label(text, ground_, scale_, unit_, typeface_);
        if (!label || !bare_) return label;
        text.label_point = bare_->inner_points[i];
        auto beside = place_label(text, bare_->ground, scale_, unit_, typeface_);
        const bool worth_it = beside && beside->name.size >= kWorthIt * label->name.size &&
                              (beside->area || !label->area);
        return worth_it ? beside : label;
    }
    [[nodiscard]] bool is_cramped(const std::optional<RoomLabel>& label) const {
        return !label || label->name.size < kSmallName * unit_;
    }
    /// The name at one of the spots, if that makes it much larger; the number, if there is no name.
    [[nodiscard]] std::optional<RoomLabel> name_or_number(std::size_t i,
                                                          std::optional<RoomLabel> in_middle,
                                                          const std::vector<Point>& spots) const {
        auto name = largest_at(i, words_[i].name, unit_, spots);
        if (!in_middle && !name) return largest_at(i, words_[i].number, number_unit_, spots);
        if (!in_middle) return name;
        return name && name->name.size > kMuchLarger * in_middle->name.size ? name : in_middle;
    }
    /// The numbers of the rooms without a label, beside them.
    [[nodiscard]] std::vector<RoomLabel> callouts(const std::vector<CrampedRoom>& rooms,
                                                  const std::vector<RoomLabel>& labels,
                                                  const LetteredPage& page) const {
        return place_callouts(rooms, labels, ground_, scale_,
                              {page.width, page.height, kCalloutSize * number_unit_}, typeface_);
    }

private:
    [[nodiscard]] std::optional<RoomLabel> largest_at(std::size_t i, const std::string& words,
                                                      double unit,
                                                      const std::vector<Point>& spots) const {
        std::optional<RoomLabel> largest;
        for (const Point& spot : spots) {
            const LabelText text{static_cast<std::uint32_t>(i + 1), words, "", spot, spot};
            auto label = place_label(text, ground_, scale_, unit, typeface_);
            if (label && (!largest || label->name.size > largest->name.size)) {
                largest = std::move(label);
            }
        }
        return largest;
    }

    const Raster<std::uint16_t>& ground_;
    const std::vector<RoomWords>& words_;
    PageScale scale_;
    double unit_;
    double number_unit_;
    std::optional<BareFloor> bare_;
    Typeface typeface_;
};

}  // namespace

std::vector<RoomLabel> place_labels(const FloorCells& cells, const std::vector<RoomWords>& words,
                                    const LetteredPage& page, const Executor& executor) {
    const Lettering lettering(cells, words, page, executor);
    // Rooms beyond the last value of the ground are drawn as that one.
    std::vector<std::optional<RoomLabel>> found(
        std::min<std::size_t>(words.size(), kFirstNonRoom - 1U));
    const auto for_each = [&](std::size_t count, const auto& body) {
        parallel_for(executor, count, 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) body(i);
        });
    };
    for_each(found.size(), [&](std::size_t i) { found[i] = lettering.name_in_middle(i); });
    std::vector<std::uint16_t> cramped;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (lettering.is_cramped(found[i])) cramped.push_back(static_cast<std::uint16_t>(i + 1));
    }
    const auto spots = find_label_spots(cells.ground, cramped, executor);
    for_each(cramped.size(), [&](std::size_t k) {
        const std::size_t i = cramped[k] - std::size_t{1};
        found[i] = lettering.name_or_number(i, std::move(found[i]), spots[k]);
    });
    std::vector<RoomLabel> labels;
    std::vector<CrampedRoom> beside;
    for (std::size_t k = 0; k < cramped.size(); ++k) {
        const std::size_t i = cramped[k] - std::size_t{1};
        if (found[i]) continue;
        const Point at = spots[k].empty() ? words[i].label_point : spots[k].front();
        beside.push_back({cramped[k], words[i].number, at});
    }
    for (std::optional<RoomLabel>& label : found) {
        if (label) labels.push_back(std::move(*label));
    }
    std::vector<RoomLabel> callouts = lettering.callouts(beside, labels, page);
    std::move(callouts.begin(), callouts.end(), std::back_inserter(labels));
    return labels;
}

}  // namespace quadcut::draw
