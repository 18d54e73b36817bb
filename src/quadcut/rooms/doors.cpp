// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/rooms/doors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "quadcut/map/connected_parts.hpp"
#include "quadcut/map/morton.hpp"
#include "quadcut/rooms/contacts.hpp"
#include "quadcut/rooms/door_model.hpp"
#include "quadcut/rooms/region_graph.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kOpeningsPerChunk = 4;

using Pair = std::pair<std::uint32_t, std::uint32_t>;

using Contacts = std::map<Pair, std::vector<Contact>>;

Contacts find_contacts(const Raster<std::uint32_t>& labels, const Executor& executor) {
    Contacts all;
    for (Contacts& part : for_each_contact<Contacts>(
             labels, executor, [](std::vector<Contact>&contacts, const Contact&contact) {
                 contacts.push_back(contact);
             })) {
        for (auto& [pair, contacts] : part) {
            std::vector<Contact>& joined = all[pair];
            joined.insert(joined.end(), contacts.begin(), contacts.end());
        }
    }
    return all;
}

/// Splits the contacts of two regions into openings: contacts that follow each other without a gap.
std::vector<std::vector<Contact>> split_into_openings(const std::vector<Contact>& contacts) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::uint32_t> label_at;
    LabelSets sets;
    for (const Contact& contact : contacts) {
        const std::uint32_t label = sets.add();
        for_each_cell(Box{contact.a, contact.a}.grown(2), [&](Cell cell) {
            const auto found = label_at.find({cell.y, cell.x});
            if (found != label_at.end()) sets.join(label, found->second);
        });
        label_at.emplace(std::pair{contact.a.y, contact.a.x}, label);
    }
    const std::vector<std::uint32_t> opening_of = sets.take_numbers();
    std::vector<std::vector<Contact>> openings(
        *std::max_element(opening_of.begin(), opening_of.end()));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        openings[opening_of[i + 1] - 1].push_back(contacts[i]);
    }
    return openings;
}

Saddle saddle_of(const std::vector<Contact>& opening, const Raster<float>& clearance_m,
                 const WallLines& lines) {
    Saddle saddle;
    for (const Contact& contact : opening) add_contact(contact, clearance_m, lines, saddle);
    return saddle;
}

/// The middle of a jamb's obstacle cell in the map frame: the surface that a cell stands for lies
/// on average there, not on the face that is turned to the opening.
Point jamb_point(Cell jamb, const LaidOutFrame& frame) {
    return frame.in_map({jamb.x + 0.5, jamb.y + 0.5});
}

/// Without jambs on both sides the ends of the contact stand for them.
std::array<Cell, 2> ends_of(const std::vector<Contact>& opening) {
    const Cell first = opening.front().a;
    Cell end = first;
    const auto squared = [](Cell p, Cell q) {
        const double dx = p.x - q.x;
        const double dy = p.y - q.y;
        return dx * dx + dy * dy;
    };
    for (const Contact& contact : opening) {
        if (squared(contact.a, first) > squared(end, first)) end = contact.a;
    }
    return {first, end};
}

/// One opening, and the door that it is.
struct Found {
    Pair pair;
    std::vector<Contact> contacts;
    Saddle saddle;
    Saddle free_saddle;
    Door door;
};

Door measure_door(const Found& opening, const RegionGraph& regions, NarrowingGauge& gauge,
                  const LaidOutFrame& frame) {
    const auto [a, b] = opening.pair;
    const BorderMeasure border =
        regions.measure_at(opening.saddle, opening.free_saddle, opening.pair, gauge);
    const Narrowing& narrowing = border.narrowing;
    const std::array<Cell, 2> jambs =
        narrowing.opening.has_jambs ? narrowing.opening.jambs : ends_of(opening.contacts);
    Door door;
    door.a = RoomId{a};
    door.b = RoomId{b};
    door.jamb_1 = jamb_point(jambs[0], frame);
    door.jamb_2 = jamb_point(jambs[1], frame);
    door.width_m = distance(door.jamb_1, door.jamb_2);
    // The saddle's cell a is in the region with the smaller label.
    const double narrower_m = 2.0 * narrowing.narrower.peak_m.back();
    const double wider_m = 2.0 * narrowing.wider.peak_m.back();
    door.room_a_width_m = narrowing.is_a_narrower ? narrower_m : wider_m;
    door.room_b_width_m = narrowing.is_a_narrower ? wider_m : narrower_m;
    door.confidence = 1.0 / (1.0 + std::exp(-door_log_odds(border)));
    return door;
}

}  // namespace

std::vector<Door> find_doors(const Raster<std::uint32_t>& labels, std::uint32_t num_regions,
                             const Ground& ground, const LaidOutFrame& frame, double min_width_m,
                             const Executor& executor) {
    std::vector<Door> doors;
    for (const PlacedDoor& found : find_doors_in(labels.box(), {}, labels, num_regions, ground,
                                                 frame, min_width_m, executor)) {
        doors.push_back(found.door);
    }
    return doors;
}

std::vector<PlacedDoor> find_doors_in(const Box& box, std::span<const Beyond> beyond,
                                      const Raster<std::uint32_t>& labels,
                                      std::uint32_t num_regions, const Ground& ground,
                                      const LaidOutFrame& frame, double min_width_m,
                                      const Executor& executor) {
    std::vector<Found> openings;
    for (const auto& [pair, contacts] : find_contacts(labels, executor)) {
        for (auto& opening : split_into_openings(contacts)) {
            const Saddle saddle = saddle_of(opening, ground.clearance_m, ground.lines);
            const Saddle free_saddle = saddle_of(opening, ground.free_clearance_m, ground.lines);
            // Where nobody passes is no door.
            const double width_m = 2.0 * static_cast<double>(saddle.clearance_m);
            if (width_m < kPassesNobodyM || !box.contains(saddle.a)) continue;
            openings.push_back({pair, std::move(opening), saddle, free_saddle, {}});
        }
    }
    RegionGraph regions(labels, num_regions, ground, executor);
    for (std::uint32_t i = 0; i < beyond.size(); ++i) regions.add_beyond(i + 1, beyond[i]);
    regions.describe_all(executor);
    std::vector<Found*> order;
    for (Found& opening : openings) order.push_back(&opening);
    const auto block = [around = labels.box()](const Found* opening) {
        return block_code(opening->contacts.front().a, around);
    };
    std::sort(order.begin(), order.end(),
              [&](const Found* p, const Found* q) { return block(p) < block(q); });
    parallel_for(executor, order.size(), kOpeningsPerChunk,
                 [&](std::size_t first, std::size_t last) {
                     NarrowingGauge gauge = regions.gauge();
                     for (std::size_t i = first; i < last; ++i) {
                         order[i]->door = measure_door(*order[i], regions, gauge, frame);
                     }
                 });
    std::vector<PlacedDoor> doors;
    for (const Found& found : openings) {
        if (found.door.width_m < min_width_m) continue;
        doors.push_back({found.door, found.saddle.a, found.saddle.b});
    }
    return doors;
}

}  // namespace quadcut
