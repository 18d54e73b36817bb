// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/fault_pane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "bench/gallery/pair_picture.hpp"
#include "draw/render.hpp"

namespace quadcut::gallery {
namespace {

constexpr io::Rgb kOverCutInk{0xD0, 0x10, 0x30};
constexpr io::Rgb kMissedInk{0x10, 0x58, 0xD8};
constexpr io::Rgb kAgreedInk{0x55, 0x60, 0x6C};

struct VerdictLook {
    Verdict verdict;
    io::Rgb ink;
    const char* text;
};

constexpr std::array<VerdictLook, 4> kLooks{{
    {Verdict::right, {0xDF, 0xEC, 0xDC}, "right"},
    {Verdict::wrong, {0xFF, 0xDC, 0xA8}, "in a wrong room"},
    {Verdict::unlabelled, {0xF2, 0xB8, 0xC6}, "in no room"},
    {Verdict::left_out, {0xDD, 0xD6, 0xEA}, "a room where the truth has none: counts nowhere"},
}};

/// Verdicts as rooms of a plan: number i + 1 for kLooks[i].
draw::FloorPlan plan_of(const Exhibit& exhibit, const Raster<Verdict>& verdicts) {
    Segmentation rooms;
    rooms.labels = Raster<std::uint16_t>(verdicts.box());
    std::vector<io::Rgb> colors;
    for (std::size_t look = 0; look < kLooks.size(); ++look) {
        const auto number = static_cast<std::uint16_t>(look + 1);
        for (std::size_t i = 0; i < verdicts.values.size(); ++i) {
            if (verdicts.values[i] == kLooks.at(look).verdict) rooms.labels.values[i] = number;
        }
        Room room;
        room.id = RoomId{number};
        room.kind = RoomKind::room;
        rooms.rooms.push_back(room);
        colors.push_back(kLooks.at(look).ink);
    }
    draw::FloorPlan plan = draw::lay_out_floor_plan(exhibit.result.map, rooms, colors);
    plan.remove_text();
    return plan;
}

void draw_sides(draw::Canvas& canvas, const std::vector<CellSide>& sides, const Box& frame,
                const Point& origin, double pixels_per_cell, double width, io::Rgb ink) {
    draw::Shape shape;
    for (const CellSide& side : sides) {
        const double x = origin.x + (side.cell.x - frame.low.x) * pixels_per_cell;
        const double y = origin.y + (frame.high.y - side.cell.y) * pixels_per_cell;
        const double end = pixels_per_cell;
        // The cell's upper left corner is at (x, y).
        const std::array<Point, 2> line =
            side.is_upper ? std::array<Point, 2>{Point{x, y}, Point{x + end, y}}
                          : std::array<Point, 2>{Point{x + end, y}, Point{x + end, y + end}};
        shape.add_line(line, width);
    }
    canvas.fill(std::move(shape), ink);
}

}  // namespace

FaultPane::FaultPane(const Exhibit& exhibit)
    : faults_(find_faults(exhibit)),
      resolution_m_(exhibit.result.map.resolution_m),
      plan_(plan_of(exhibit, faults_.verdicts)) {}

void FaultPane::draw(draw::Canvas& canvas, const Box& frame, const Point& origin,
                     double pixels_per_cell, const draw::Typeface& typeface) const {
    draw::FloorPlan plan = plan_in_frame(plan_, frame, origin, pixels_per_cell);
    plan.border_width = 0.0;
    draw::draw_plan(canvas, plan, typeface);
    draw_sides(canvas, faults_.agreed, frame, origin, pixels_per_cell, 1.6, kAgreedInk);
    draw_sides(canvas, faults_.missed, frame, origin, pixels_per_cell, 4.5, kMissedInk);
    draw_sides(canvas, faults_.over_cut, frame, origin, pixels_per_cell, 4.5, kOverCutInk);
}

std::string FaultPane::cuts_text() const {
    std::string text;
    for (const FaultKey& key : cut_keys()) text += (text.empty() ? "" : ", ") + key.text;
    return text;
}

std::vector<FaultKey> FaultPane::cut_keys() const {
    // A border at 45 degrees has more sides of cells than its length; near enough.
    const auto sum = [this](const char* what, std::size_t num_cuts,
                            const std::vector<CellSide>& sides) {
        const double length_m = resolution_m_ * static_cast<double>(sides.size());
        return what + std::to_string(num_cuts) + " (" + std::to_string(std::lround(length_m)) +
               " m)";
    };
    std::vector<FaultKey> keys;
    if (faults_.num_over_cuts > 0) {
        keys.push_back(
            {kOverCutInk, sum("cuts too many: ", faults_.num_over_cuts, faults_.over_cut)});
    }
    if (faults_.num_missed_cuts > 0) {
        keys.push_back({kMissedInk, sum("missed: ", faults_.num_missed_cuts, faults_.missed)});
    }
    return keys;
}

std::vector<FaultKey> FaultPane::keys() const {
    std::vector<FaultKey> keys = cut_keys();
    for (const VerdictLook& look : kLooks) {
        const auto& verdicts = faults_.verdicts.values;
        if (std::find(verdicts.begin(), verdicts.end(), look.verdict) != verdicts.end()) {
            keys.push_back({look.ink, look.text});
        }
    }
    return keys;
}

}  // namespace quadcut::gallery
