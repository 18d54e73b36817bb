// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/why_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "io/json_writer.hpp"
#include "io/number_text.hpp"
#include "quadcut/rooms/fuse.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kNumToldCues = 3;
/// Less is no wall.
constexpr double kWallM = 0.3;

std::string metres(double value) { return with_decimals(value, 2) + " m"; }

std::string percent(double log_odds) {
    return with_decimals(100.0 / (1.0 + std::exp(-log_odds)), 0) + " %";
}

std::string_view ground_word(PlaceKind ground) {
    switch (ground) {
        case PlaceKind::beyond_map:
            return "beyond_map";
        case PlaceKind::occupied:
            return "occupied";
        case PlaceKind::unknown:
            return "unknown";
        case PlaceKind::left_out:
            return "left_out";
        case PlaceKind::room:
            return "room";
    }
    return "";
}

std::string_view verdict_word(Verdict verdict) {
    switch (verdict) {
        case Verdict::cut:
            return "cut";
        case Verdict::no_door:
            return "no_door";
        case Verdict::too_wide:
            return "too_wide";
        case Verdict::too_small:
            return "too_small";
        case Verdict::one_piece:
            return "one_piece";
    }
    return "";
}

std::string no_room_text(PlaceKind ground) {
    switch (ground) {
        case PlaceKind::beyond_map:
            return "no room: the map does not reach there\n";
        case PlaceKind::occupied:
            return "no room: an obstacle is there\n";
        case PlaceKind::unknown:
            return "no room: what is there is unknown\n";
        default:
            return "no room: the free space there is the ground outside, or smaller or narrower "
                   "than any room\n";
    }
}

std::string walls_text(const std::array<double, 2>& walls_m) {
    const auto num_sides =
        std::count_if(walls_m.begin(), walls_m.end(), [](double m) { return m >= kWallM; });
    if (num_sides == 0) return "no wall in line";
    return std::string("wall in line on ") + (num_sides == 1 ? "one side only" : "both sides") +
           " (" + metres(walls_m[0]) + " and " + metres(walls_m[1]) + ")";
}

/// On the saddle's side a (0) or b.
const SideOfSaddle& side_of(const Narrowing& narrowing, std::size_t side) {
    return narrowing.is_a_narrower == (side == 0) ? narrowing.narrower : narrowing.wider;
}

std::string measured_text(const Narrowing& narrowing) {
    const SideOfSaddle& p = side_of(narrowing, 0);
    const SideOfSaddle& q = side_of(narrowing, 1);
    return "opening " + metres(2.0 * narrowing.half_width_m) + " wide between " +
           metres(2.0 * p.region_peak_m) + " and " + metres(2.0 * q.region_peak_m) + " wide (" +
           with_decimals(p.region_area_m2, 1) + " and " + with_decimals(q.region_area_m2, 1) +
           " m^2), " + walls_text(narrowing.opening.line_of_walls_m);
}

std::string decided_text(const NearBorder& border, const RoomsOptions& options) {
    const double width_m = 2.0 * border.decision.border.narrowing.half_width_m;
    switch (border.decision.verdict) {
        case Verdict::cut:
            if (width_m < kPassesNobodyM) return "passes nobody: a wall that was seen in pieces";
            break;
        case Verdict::too_wide:
            return "wider than any door (door_width is " + metres(options.door_width_m) + ")";
        case Verdict::too_small:
            return "one side is smaller than a room, or nowhere as wide as a robot";
        case Verdict::one_piece:
            return "the spectral cut made one piece of both sides before doors were looked at";
        default:
            break;
    }
    const double from = border.granularity;
    std::string text = "like a door by " + percent(border.decision.log_odds) + "; granularity " +
                       rounded(options.granularity) + " asks for " +
                       percent(fuse_threshold(options.granularity)) + ", and ";
    if (from > 1.0) return text + "none cuts it";
    if (from <= 0.0) return text + "each one cuts it";
    return text + "from " + with_decimals(from, 2) + " on it is cut";
}

/// The cues by how much they moved the decision, the most first.
std::vector<std::size_t> strongest_cues(const NearBorder& border) {
    std::vector<std::size_t> order(kNumDoorCues);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
        return std::abs(border.contributions[p]) > std::abs(border.contributions[q]);
    });
    return order;
}

/// A cue as it is thought of: no logarithm.
double plain_value(std::size_t cue, float value) {
    const CueUnit unit = kDoorCues[cue].unit;
    const bool is_log = unit == CueUnit::ratio || unit == CueUnit::log_square_metres;
    return is_log ? std::exp(static_cast<double>(value)) : static_cast<double>(value);
}

std::string cue_text(std::size_t cue, float value, double contribution) {
    const CueUnit unit = kDoorCues[cue].unit;
    std::string text = contribution < 0.0 ? "  " : "  +";
    text += with_decimals(contribution, 2) + "  " + std::string(kDoorCues[cue].text) + ": " +
            with_decimals(plain_value(cue, value), 2);
    if (unit == CueUnit::metres) text += " m";
    if (unit == CueUnit::log_square_metres) text += " m^2";
    return text + "\n";
}

void write_border(JsonWriter& json, const NearBorder& border, const WrittenWhy& written) {
    const Narrowing& narrowing = border.decision.border.narrowing;
    json.begin_object(JsonLayout::lines);
    json.key("verdict").text(verdict_word(border.decision.verdict));
    json.key("distance_m").number(border.distance_m);
    json.key("sides").begin_array(JsonLayout::lines);
    for (std::size_t i = 0; i < border.sides.size(); ++i) {
        const SideOfSaddle& side = side_of(narrowing, i);
        json.begin_object().key("room").text(written.rooms[i]);
        json.key("x").number(border.sides[i].x).key("y").number(border.sides[i].y);
        json.key("width_m").number(2.0 * side.region_peak_m);
        json.key("area_m2").number(side.region_area_m2).end_object();
    }
    json.end_array();
    json.key("width_m").number(2.0 * narrowing.half_width_m);
    json.key("line_of_walls_m").begin_array();
    for (const double m : narrowing.opening.line_of_walls_m) json.number(m);
    json.end_array();
    json.key("log_odds").number(border.decision.log_odds);
    json.key("log_odds_needed").number(fuse_threshold(written.options.granularity));
    json.key("granularity").number(border.granularity);
    const std::array<float, kNumDoorCues> cues = door_cues(border.decision.border);
    json.key("cues").begin_array(JsonLayout::lines);
    for (const std::size_t cue : strongest_cues(border)) {
        json.begin_object().key("name").text(kDoorCues[cue].name);
        json.key("value").number(plain_value(cue, cues[cue]));
        json.key("log_odds").number(border.contributions[cue]).end_object();
    }
    json.end_array().end_object();
}

}  // namespace

std::string why_as_text(const WrittenWhy& written) {
    const Why& why = written.why;
    if (why.ground != PlaceKind::room) return no_room_text(why.ground);
    if (!why.border) {
        return "no cut: no place near here is narrower than its surroundings or in line with a "
               "wall, so that nothing "
               "proposes one; " +
               metres(why.clearance_m) + " to the nearest obstacle\n";
    }
    const NearBorder& border = *why.border;
    std::string text = "no cut: ";
    if (border.decision.verdict == Verdict::cut) {
        text = "cut between " + written.rooms[0] + " and " + written.rooms[1] + ": ";
    }
    text += measured_text(border.decision.border.narrowing) + "; " + metres(border.distance_m) +
            " away\n" + decided_text(border, written.options) + "\n";
    const std::array<float, kNumDoorCues> cues = door_cues(border.decision.border);
    const std::vector<std::size_t> order = strongest_cues(border);
    for (std::size_t i = 0; i < kNumToldCues; ++i) {
        text += cue_text(order[i], cues[order[i]], border.contributions[order[i]]);
    }
    return text;
}

std::string why_as_json(const WrittenWhy& written) {
    JsonWriter json;
    json.begin_object(JsonLayout::lines);
    json.key("ground").text(ground_word(written.why.ground));
    json.key("clearance_m").number(written.why.clearance_m);
    json.key("border");
    if (written.why.border) {
        write_border(json, *written.why.border, written);
    } else {
        json.null();
    }
    return json.end_object().finish();
}

}  // namespace quadcut::io
