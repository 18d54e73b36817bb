// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/column.hpp"
#include "sim/openness.hpp"
#include "sim/skeleton.hpp"
#include "sim/unit.hpp"

namespace quadcut::sim {
namespace {

// The open end of a corridor that has been built.
struct OpenEnd {
    Frame frame;  // v outwards, origin in the middle of the end line
    std::size_t room = 0;
    double corridor_m = 2.0;
};

// How far the rooms beside a corridor reach from it, at most.
constexpr double kReach = 7.8;
constexpr double kWalkwayM = 5.0;
constexpr double kJointWallM = 0.12;

// A way from an open end to the wing that is to be joined to it.
struct Joint {
    Frame from;
    double straight_m = 0.0;
    double turn_rad = 0.0;  // positive: towards u
    Frame bend;             // at the bend, after it
    double after_m = 0.0;
    double corridor_m = 2.0;

    [[nodiscard]] Frame end() const { return bend.at({0.0, after_m}); }
};

struct Candidate {
    std::size_t open_end = 0;
    Joint joint;
    bool has_fire_door = false;
    Frame plan_from_wing;
    std::size_t entry = 0;
    std::vector<Polygon> footprint;
    double extent = std::numeric_limits<double>::infinity();
};

Joint draw_joint(const OpenEnd& open, double turn_rad, double first_m, double second_m) {
    Joint joint{open.frame, first_m, turn_rad, {}, second_m, open.corridor_m};
    const double side = turn_rad < 0.0 ? -1.0 : 1.0;
    const double c = std::cos(turn_rad);
    const double s = std::sin(turn_rad);
    const Point& u = open.frame.u;
    const Point& v = open.frame.v;
    joint.bend.u = {c * u.x - s * v.x, c * u.y - s * v.y};
    joint.bend.v = {s * u.x + c * v.x, s * u.y + c * v.y};
    // The inner corner stays where it is; the corridor swings about it.
    const double half = 0.5 * open.corridor_m * side;
    const Point inner = open.frame.map({half, first_m});
    joint.bend.origin = {inner.x - half * joint.bend.u.x, inner.y - half * joint.bend.u.y};
    return joint;
}

// What the bend adds between the two straight parts.
std::optional<Polygon> wedge_of(const Joint& joint) {
    if (joint.turn_rad == 0.0) return std::nullopt;
    const double side = joint.turn_rad < 0.0 ? -1.0 : 1.0;
    const double half = 0.5 * joint.corridor_m * side;
    const double tip = joint.corridor_m * std::tan(0.5 * std::abs(joint.turn_rad));
    return Polygon{joint.from.map({half, joint.straight_m}),
                   joint.from.map({-half, joint.straight_m}),
                   joint.from.map({-half, joint.straight_m + tip}), joint.bend.map({-half, 0.0})};
}

class LayoutBuilder {
public:
    LayoutBuilder(const LayoutOptions& options, Random random)
        : options_(options), random_(random) {}

    Layout build();

private:
    [[nodiscard]] WingStyle draw_style(double corridor_m);
    [[nodiscard]] bool is_free(const std::vector<Polygon>& footprint) const;
    [[nodiscard]] double extent_with(const std::vector<Polygon>& footprint) const;
    std::optional<Candidate> draw_candidate(const Skeleton& skeleton, bool is_turned, int attempt);
    void add_first_wing(double frontage);
    bool add_wing(double frontage);
    Rect draw_fire_door(double corridor_m, double y);
    std::size_t begin_walkway(const Joint& joint, std::size_t corridor, double wall_m);
    void build_joint(const Candidate& candidate, std::size_t corridor, bool is_walkway);
    void build_wing(const Skeleton& skeleton, const WingStyle& style, const Frame& frame,
                    std::optional<std::size_t> entry, std::size_t entry_room);
    void close_end(const OpenEnd& open);
    bool add_lobby_at(const OpenEnd& open);
    [[nodiscard]] double frontage_for(int rooms) const;

    LayoutOptions options_;
    Random random_;
    Layout layout_;
    std::vector<OpenEnd> open_ends_;
    std::vector<Polygon> footprint_;
};

WingStyle LayoutBuilder::draw_style(double corridor_m) {
    WingStyle style;
    style.corridor_m = corridor_m;
    const bool deep = layout_.trade == Trade::school;
    const bool shallow = layout_.trade == Trade::home;
    const double low = shallow ? 3.2 : deep ? 5.5 : 4.0;
    const double high = shallow ? 4.8 : deep ? 7.5 : 7.0;
    style.outer_depth_m = random_.uniform(low, high);
    style.inner_depth_m = random_.uniform(low, high);
    style.corridor_wall_m = random_.uniform(0.11, 0.22);
    style.partition_m = random_.uniform(0.1, 0.16);
    style.outer_wall_m = random_.uniform(0.18, 0.25);
    return style;
}

double LayoutBuilder::frontage_for(int rooms) const {
    constexpr double kPerRoom[] = {2.75, 2.9, 2.7, 3.6};
    return std::max(6.0, (rooms - 1) * kPerRoom[static_cast<std::size_t>(layout_.trade)]);
}

bool LayoutBuilder::is_free(const std::vector<Polygon>& footprint) const {
    for (const Polygon& built : footprint_) {
        for (const Polygon& polygon : footprint) {
            if (overlap(built, polygon)) return false;
        }
    }
    return true;
}

double LayoutBuilder::extent_with(const std::vector<Polygon>& footprint) const {
    Rect box = kNoRect;
    for (const Polygon& polygon : footprint_) box.include(polygon);
    for (const Polygon& polygon : footprint) box.include(polygon);
    return box.width() * box.width() + box.height() * box.height();
}

std::optional<Candidate> LayoutBuilder::draw_candidate(const Skeleton& skeleton, bool is_turned,
                                                       int attempt) {
    Candidate candidate;
    candidate.open_end = random_.below(open_ends_.size());
    const OpenEnd& open = open_ends_[candidate.open_end];
    const double angle = random_.uniform(15.0, 40.0) * M_PI / 180.0;
    const double turn = !is_turned ? 0.0 : random_.uniform() < 0.5 ? angle : -angle;
    // Far enough that the rows on the inner side of the bend do not meet; farther when crowded.
    const double least = 0.4 + (is_turned ? kReach * std::tan(0.5 * std::abs(turn)) : 0.0);
    const double slack =
        random_.uniform(0.0, 1.5 + 0.15 * attempt) + (options_.num_wings > 0 ? kWalkwayM : 0.0);
    candidate.joint = draw_joint(open, turn, least + 0.5 * slack, least + 0.5 * slack);
    candidate.has_fire_door = random_.uniform() < 0.55 || options_.num_wings > 0;

    candidate.entry = random_.below(skeleton.ports.size());
    const Frame& port = skeleton.ports[candidate.entry].frame;
    const Frame end = candidate.joint.end();
    const double mirror = random_.uniform() < 0.5 ? 1.0 : -1.0;
    const auto to_plan = [&](const Point& p) {
        const Point local = port.local(p);
        return end.map({mirror * local.x, -local.y});
    };
    Frame& frame = candidate.plan_from_wing;
    frame.origin = to_plan({0, 0});
    const Point ux = to_plan({1, 0});
    const Point vy = to_plan({0, 1});
    frame.u = {ux.x - frame.origin.x, ux.y - frame.origin.y};
    frame.v = {vy.x - frame.origin.x, vy.y - frame.origin.y};
    for (const Rect& rect : skeleton.footprint) {
        candidate.footprint.push_back(to_polygon(frame, grow(rect, 0.15)));
    }
    if (!is_free(candidate.footprint)) return {};
    const double half = 0.5 * open.corridor_m + 0.3;
    const std::vector<Polygon> way{
        to_polygon(candidate.joint.from, {-half, 0.45, half, candidate.joint.straight_m}),
        to_polygon(candidate.joint.bend, {-half, 0, half, candidate.joint.after_m})};
    if (!is_free(way)) return {};
    candidate.extent = extent_with(candidate.footprint);
    return candidate;
}

void LayoutBuilder::build_wing(const Skeleton& skeleton, const WingStyle& style, const Frame& frame,
                               std::optional<std::size_t> entry, std::size_t entry_room) {
    Plan& plan = layout_.plan;
    std::vector<std::optional<std::size_t>> room_of(skeleton.num_corridors);
    if (entry) room_of[skeleton.ports[*entry].corridor] = entry_room;
    for (const auto& part : skeleton.corridors) {
        std::optional<std::size_t>& room = room_of[part.corridor];
        if (room) {
            plan.rooms[*room].parts.push_back({frame, part.rect});
        } else {
            room = plan.add_room(RoomUse::corridor, frame, part.rect, style.outer_wall_m);
        }
    }
    for (const auto& door : skeleton.fire_doors) {
        plan.doors.push_back(
            {*room_of[door.a], *room_of[door.b], compose(frame, door.frame), door.opening, false});
    }
    for (Strip strip : skeleton.strips) {
        strip.frame = compose(frame, strip.frame);
        fill_strip(plan, strip, *room_of[strip.corridor], style, layout_.trade, random_);
    }
    for (const Rect& yard : skeleton.voids) {
        plan.shafts.push_back({to_polygon(frame, yard), random_.uniform() < 0.3});
    }
    for (std::size_t i = 0; i < skeleton.ports.size(); ++i) {
        if (entry == i) continue;
        const Port& port = skeleton.ports[i];
        open_ends_.push_back(
            {compose(frame, port.frame), *room_of[port.corridor], style.corridor_m});
    }
    for (const Rect& rect : skeleton.footprint) {
        footprint_.push_back(to_polygon(frame, rect));
    }
    layout_.wing_of_room.resize(plan.rooms.size(), layout_.num_wings);
    ++layout_.num_wings;
}

void LayoutBuilder::add_first_wing(double frontage) {
    const WingStyle style = draw_style(layout_.trade == Trade::home ? random_.uniform(1.2, 1.8)
                                                                    : random_.uniform(1.6, 2.6));
    const Skeleton skeleton = draw_skeleton(style, frontage, random_);
    const double c = std::cos(options_.yaw_rad);
    const double s = std::sin(options_.yaw_rad);
    build_wing(skeleton, style, {{0, 0}, {c, s}, {-s, c}}, std::nullopt, 0);
}

Rect LayoutBuilder::draw_fire_door(double corridor_m, double y) {
    const double widest = options_.num_wings > 0 ? 1.2 : 1.6;
    const double width = std::min(corridor_m - 0.3, random_.uniform(0.9, widest));
    return {-0.5 * width, y, 0.5 * width, y + kJointWallM};
}

// A corridor of its own behind a fire door.
std::size_t LayoutBuilder::begin_walkway(const Joint& joint, std::size_t corridor, double wall_m) {
    Plan& plan = layout_.plan;
    const std::size_t walkway = plan.rooms.size();
    plan.doors.push_back(
        {corridor, walkway, joint.from, draw_fire_door(joint.corridor_m, 0.0), false});
    plan.rooms.push_back({RoomUse::corridor, {}, {}, wall_m});
    layout_.wing_of_room.push_back(layout_.wing_of_room[corridor]);
    return walkway;
}

// The straight ways and the bend become floor: of the corridor left behind up to the fire door.
void LayoutBuilder::build_joint(const Candidate& candidate, std::size_t corridor, bool is_walkway) {
    const Joint& joint = candidate.joint;
    PlanRoom& room = layout_.plan.rooms[corridor];
    const double half = 0.5 * joint.corridor_m;
    const double begin = is_walkway ? kJointWallM : 0.0;
    const double wall = candidate.has_fire_door ? kJointWallM : 0.0;
    room.parts.push_back({joint.from, {-half, begin, half, joint.straight_m}});
    if (const std::optional<Polygon> wedge = wedge_of(joint)) room.wedges.push_back(*wedge);
    room.parts.push_back({joint.bend, {-half, 0, half, joint.after_m - wall}});
    if (!candidate.has_fire_door) return;
    layout_.plan.doors.push_back({corridor, layout_.plan.rooms.size(), joint.bend,
                                  draw_fire_door(joint.corridor_m, joint.after_m - wall), false});
}

bool LayoutBuilder::add_wing(double frontage) {
    if (open_ends_.empty()) return false;
    std::optional<Candidate> best;
    // All candidates of a wing have one corridor width, that of the building.
    const WingStyle style = draw_style(open_ends_.front().corridor_m);
    const Skeleton skeleton = draw_skeleton(style, frontage, random_);
    const bool is_turned = random_.uniform() < options_.turned_wings;
    int found = 0;
    for (int attempt = 0; attempt < 150 && found < 6; ++attempt) {
        const std::optional<Candidate> candidate = draw_candidate(skeleton, is_turned, attempt);
        if (!candidate) continue;
        ++found;
        if (!best || candidate->extent < best->extent) best = candidate;
    }
    if (!best) return false;
    std::size_t corridor = open_ends_[best->open_end].room;
    open_ends_.erase(open_ends_.begin() + static_cast<std::ptrdiff_t>(best->open_end));
    const bool is_walkway = options_.num_wings > 0;
    if (is_walkway) corridor = begin_walkway(best->joint, corridor, style.outer_wall_m);
    build_joint(*best, corridor, is_walkway);
    const double half = 0.5 * best->joint.corridor_m + 0.3;
    footprint_.push_back(to_polygon(best->joint.from, {-half, 0, half, best->joint.straight_m}));
    footprint_.push_back(to_polygon(best->joint.bend, {-half, 0, half, best->joint.after_m}));
    std::size_t entry_room = corridor;
    if (best->has_fire_door) {
        // The door names the room that is added next: the wing's own corridor.
        entry_room = layout_.plan.rooms.size();
        layout_.plan.rooms.push_back({RoomUse::corridor, {}, {}, style.outer_wall_m});
    }
    build_wing(skeleton, style, best->plan_from_wing, best->entry, entry_room);
    if (best->joint.turn_rad != 0.0) ++layout_.num_turned_wings;
    return true;
}

bool LayoutBuilder::add_lobby_at(const OpenEnd& open) {
    if (options_.openness <= 0.0 || random_.uniform() >= options_.openness) return false;
    const Lobby lobby = draw_lobby(open.corridor_m, random_);
    const std::vector<Polygon> space{to_polygon(open.frame, lobby.space())};
    if (!is_free(space)) return false;
    add_lobby(layout_.plan, lobby, open.frame, open.room);
    layout_.wing_of_room.resize(layout_.plan.rooms.size(), layout_.wing_of_room[open.room]);
    footprint_.push_back(space.front());
    return true;
}

// A hall or a room across the end of a corridor, where there is space for one.
void LayoutBuilder::close_end(const OpenEnd& open) {
    if (add_lobby_at(open)) return;
    const double wall = random_.uniform(0.12, 0.2);
    const double depth = random_.uniform(4.0, 9.0);
    const double left = 0.5 * open.corridor_m + random_.uniform(0.3, 5.0);
    const double right = 0.5 * open.corridor_m + random_.uniform(0.3, 5.0);
    if (random_.uniform() < 0.35) return;
    const std::vector<Polygon> space{
        to_polygon(open.frame, {-left - 0.25, 0.3, right + 0.25, wall + depth + 0.25})};
    if (!is_free(space)) return;
    WingStyle style;
    style.corridor_wall_m = wall;
    Lot lot;
    lot.frame = open.frame.at({-left, wall});
    lot.end = left + right;
    lot.depth = depth;
    lot.front_begin = left - 0.5 * open.corridor_m;
    lot.front_end = left + 0.5 * open.corridor_m;
    lot.corridor = open.room;
    UnitBuilder units(layout_.plan, style, layout_.trade, random_);
    if (open.corridor_m > 1.9 && random_.uniform() < 0.3) {
        units.add_open_room(lot);
    } else {
        units.add_room(lot);
    }
    layout_.wing_of_room.resize(layout_.plan.rooms.size(), layout_.wing_of_room[open.room]);
    footprint_.push_back(space.front());
}

Layout LayoutBuilder::build() {
    const double choice = random_.uniform();
    const bool small = options_.num_rooms <= 14;
    layout_.trade = small && choice < 0.4 ? Trade::home
                    : choice < 0.64       ? Trade::office
                    : choice < 0.82       ? Trade::clinic
                                          : Trade::school;
    const int wing_size = static_cast<int>(
        random_.uniform(11.0 + 0.06 * options_.num_rooms, 16.0 + 0.15 * options_.num_rooms));
    const auto remaining = [&] {
        return options_.num_rooms - static_cast<int>(layout_.plan.rooms.size());
    };
    const auto is_more_wanted = [&] {
        return options_.num_wings > 0 ? layout_.num_wings < options_.num_wings : remaining() > 3;
    };
    const auto next_size = [&] {
        if (options_.num_wings > 0) return options_.num_rooms / options_.num_wings;
        const int left = remaining();
        return left <= wing_size * 3 / 2 ? left : wing_size;
    };
    add_first_wing(frontage_for(next_size()));
    int failures = 0;
    while (is_more_wanted() && failures < 12) {
        if (!add_wing(frontage_for(next_size()))) ++failures;
    }
    for (const OpenEnd& open : open_ends_) {
        if (remaining() > 0) close_end(open);
    }
    return layout_;
}

}  // namespace

Layout draw_layout(const LayoutOptions& options) {
    // A draw may come out too large, or run into itself: the first one near the wish is taken.
    constexpr std::uint64_t kTries = 12;
    const Random random = Random(options.seed).fork(1);
    Layout best;
    int best_error = std::numeric_limits<int>::max();
    for (std::uint64_t i = 0; i < kTries && best_error > options.num_rooms / 10; ++i) {
        Layout layout = LayoutBuilder(options, random.fork(i)).build();
        const int error = std::abs(static_cast<int>(layout.plan.rooms.size()) - options.num_rooms) +
                          std::max(0, options.num_wings - layout.num_wings) * options.num_rooms;
        if (error >= best_error) continue;
        best_error = error;
        best = std::move(layout);
    }
    if (options.openness > 0.0) {
        widen_doors(best.plan, 0.6 * options.openness, random.fork(kTries + 1));
    }
    add_columns(best.plan, random.fork(kTries));
    return best;
}

}  // namespace quadcut::sim
