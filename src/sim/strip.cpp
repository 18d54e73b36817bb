// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/strip.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "sim/unit.hpp"

namespace quadcut::sim {
namespace {

// What may stand in a row: how often by trade (office, home, clinic, school), how long, and the
// depth that it needs.
struct Offer {
    void (UnitBuilder::*build)(const Lot&);  ///< null: a plain room
    std::array<double, 4> weight;
    double min_length;
    double max_length;
    double min_depth;
    double max_depth;
};

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr std::array<Offer, 13> kOffers{{
    {nullptr, {4, 6, 4, 3}, 1.5, 2.2, 0.0, 5.2},
    {nullptr, {34, 26, 22, 10}, 2.4, 4.2, 0.0, kAny},
    {nullptr, {16, 16, 16, 10}, 4.2, 6.4, 0.0, kAny},
    {nullptr, {7, 0, 5, 34}, 7.0, 10.5, 4.5, kAny},
    {nullptr, {3, 0, 1, 5}, 13.0, 19.0, 5.0, kAny},
    {&UnitBuilder::add_room_around, {9, 10, 26, 6}, 3.7, 6.0, 4.2, kAny},
    {&UnitBuilder::add_deep_suite, {7, 4, 4, 4}, 2.8, 4.8, 5.6, kAny},
    {&UnitBuilder::add_side_suite, {7, 5, 5, 6}, 6.0, 9.0, 0.0, kAny},
    {&UnitBuilder::add_washroom, {7, 0, 6, 9}, 2.6, 4.6, 3.8, kAny},
    {&UnitBuilder::add_aisle, {7, 0, 0, 0}, 6.0, 7.6, 4.6, kAny},
    {&UnitBuilder::add_cubicle_row, {5, 0, 0, 0}, 8.5, 14.0, 5.6, kAny},
    {&UnitBuilder::add_open_room, {6, 14, 5, 4}, 3.2, 5.5, 0.0, kAny},
    {&UnitBuilder::add_core, {4, 2, 4, 4}, 2.4, 3.4, 0.0, kAny},
}};

// Of rooms with a door, the least width of their front.
constexpr double kLeastFront = 1.6;
constexpr double kLeastRoom = 2.3;

class StripFiller {
public:
    StripFiller(Plan& plan, const Strip& strip, std::size_t corridor, const WingStyle& style,
                Trade trade, Random& random)
        : strip_(strip),
          style_(style),
          trade_(trade),
          random_(random),
          units_(plan, style, trade, random) {
        lot_.frame = strip.frame;
        lot_.depth = strip.depth;
        lot_.front_begin = strip.front_begin;
        lot_.front_end = strip.front_end;
        lot_.corridor = corridor;
    }

    void fill();

private:
    [[nodiscard]] const Offer* choose(double room_left) const;
    [[nodiscard]] double end_of(double length) const;
    void build_room();

    const Strip& strip_;
    const WingStyle& style_;
    Trade trade_;
    Random& random_;
    UnitBuilder units_;
    Lot lot_;
    // The plain room built last, when it ends where the next one begins.
    std::optional<std::size_t> neighbour_;
};

const Offer* StripFiller::choose(double room_left) const {
    const auto fits = [&](const Offer& offer) {
        return offer.min_length <= room_left && strip_.depth >= offer.min_depth &&
               strip_.depth <= offer.max_depth;
    };
    double sum = 0.0;
    for (const Offer& offer : kOffers) {
        if (fits(offer)) sum += offer.weight[static_cast<std::size_t>(trade_)];
    }
    double draw = random_.uniform() * sum;
    for (const Offer& offer : kOffers) {
        if (!fits(offer)) continue;
        draw -= offer.weight[static_cast<std::size_t>(trade_)];
        if (draw < 0.0) return &offer;
    }
    return nullptr;
}

// Where a lot of the wanted length ends, so that it has a front and what remains is usable.
double StripFiller::end_of(double length) const {
    const double end = std::max(lot_.begin + length, strip_.front_begin + kLeastFront);
    const double least_tail = std::max(kLeastRoom, strip_.length - strip_.front_end + kLeastFront);
    return strip_.length - end - style_.partition_m < least_tail ? strip_.length : end;
}

void StripFiller::build_room() {
    const std::size_t room = units_.add_room(lot_);
    if (neighbour_ && random_.uniform() < 0.08) units_.join(*neighbour_, room, lot_);
    neighbour_ = room;
}

void StripFiller::fill() {
    if (strip_.front_end - strip_.front_begin < kLeastFront) return;
    while (lot_.begin < strip_.length) {
        const Offer* offer = choose(strip_.length - lot_.begin);
        const double length =
            offer != nullptr ? random_.uniform(offer->min_length, offer->max_length) : kLeastRoom;
        lot_.end = end_of(length);
        const bool as_offered = offer != nullptr && lot_.is_fronted() &&
                                lot_.length() >= offer->min_length &&
                                lot_.length() <= offer->max_length * 1.15;
        if (as_offered && offer->build != nullptr) {
            neighbour_.reset();
            (units_.*offer->build)(lot_);
        } else {
            build_room();
        }
        lot_.begin = lot_.end + style_.partition_m;
    }
}

}  // namespace

void fill_strip(Plan& plan, const Strip& strip, std::size_t corridor, const WingStyle& style,
                Trade trade, Random& random) {
    StripFiller(plan, strip, corridor, style, trade, random).fill();
}

}  // namespace quadcut::sim
