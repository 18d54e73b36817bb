// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/furnisher.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/passage.hpp"

namespace quadcut::sim {
namespace {

constexpr double kLeafThickness = 0.05;

// A part's wall as a frame: x along it, y into the room, and how long it is.
struct Wall {
    Frame frame;
    double length = 0.0;
};

Wall wall_of(const FloorPart& part, int side) {
    const Rect& r = part.rect;
    const Frame& f = part.frame;
    const Point minus_u{-f.u.x, -f.u.y};
    const Point minus_v{-f.v.x, -f.v.y};
    switch (side) {
        case 0:
            return {{f.map({r.x0, r.y0}), f.u, f.v}, r.width()};
        case 1:
            return {{f.map({r.x0, r.y1}), f.u, minus_v}, r.width()};
        case 2:
            return {{f.map({r.x0, r.y0}), f.v, f.u}, r.height()};
        default:
            return {{f.map({r.x1, r.y0}), f.v, minus_u}, r.height()};
    }
}

// Which y of the door's frame leads into the room.
double inwards(const PlanDoor& door, std::size_t room) { return door.b == room ? 1.0 : -1.0; }

double face_of(const PlanDoor& door, std::size_t room) {
    return door.b == room ? door.opening.y1 : door.opening.y0;
}

Polygon strip_before(const PlanDoor& door, std::size_t room, double margin, double depth) {
    const double face = face_of(door, room);
    const double end = face + inwards(door, room) * depth;
    return to_polygon(door.frame, {door.opening.x0 - margin, std::min(face, end),
                                   door.opening.x1 + margin, std::max(face, end)});
}

}  // namespace

Furnisher::Furnisher(const Plan& plan, std::size_t room, const Raster<std::uint16_t>& labels,
                     const CellGrid& grid, Random& random)
    : plan_(plan), room_(room), labels_(labels), grid_(grid), random_(random) {
    for (const PlanDoor& door : plan.doors) {
        if (door.a == room || door.b == room) doors_.push_back(door);
    }
    for (const Polygon& pillar : plan.pillars) kept_clear_.push_back(pillar);
}

const FloorPart& Furnisher::main_part() const {
    return *std::max_element(
        room().parts.begin(), room().parts.end(),
        [](const FloorPart& a, const FloorPart& b) { return a.rect.area() < b.rect.area(); });
}

bool Furnisher::is_floor(const Point& p) const {
    const Cell cell = grid_.cell(p);
    return labels_.contains(cell) && labels_.at(cell) == room_ + 1;
}

// Whether all of a footprint lies on the room's floor, the outermost cells aside.
bool Furnisher::has_floor(const Polygon& footprint) const {
    const Polygon inner = grow(footprint, -0.03);
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const Point& p = inner[i];
        const Point& q = inner[(i + 1) % inner.size()];
        const int steps = 1 + static_cast<int>(distance(p, q) / 0.2);
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            if (!is_floor({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)})) return false;
        }
    }
    return true;
}

// Whether there is wall behind all of it.
bool Furnisher::has_back(const Frame& frame, const Rect& footprint) const {
    const double behind = -0.6 * grid_.resolution_m - 0.02;
    for (int k = 0; k <= 8; ++k) {
        const double x = footprint.x0 + footprint.width() * k / 8.0;
        const Cell cell = grid_.cell(frame.map({x, behind}));
        if (labels_.contains(cell) && labels_.at(cell) != 0) return false;
    }
    return true;
}

void Furnisher::keep_doors_clear(double depth) {
    for (const PlanDoor& door : doors_) {
        kept_clear_.push_back(strip_before(door, room_, 0.1, depth));
    }
}

bool Furnisher::add_leaf(const PlanDoor& door, bool hinge_left, double width, double angle) {
    const double x = hinge_left ? door.opening.x0 : door.opening.x1;
    const double along = hinge_left ? 1.0 : -1.0;
    const double into = inwards(door, room_);
    const double y = face_of(door, room_);
    const Point d{along * std::cos(angle), into * std::sin(angle)};
    // The leaf swings clear of the opening: its thickness lies on the far side.
    const Point n{-along * std::sin(angle) * kLeafThickness,
                  into * std::cos(angle) * kLeafThickness};
    const Polygon leaf{door.frame.map({x, y}), door.frame.map({x + width * d.x, y + width * d.y}),
                       door.frame.map({x + width * d.x + n.x, y + width * d.y + n.y}),
                       door.frame.map({x + n.x, y + n.y})};
    for (const double t : {0.3, 0.6, 1.0}) {
        const Point p{x + t * width * d.x + 0.5 * n.x, y + t * width * d.y + 0.5 * n.y};
        if (!is_floor(door.frame.map(p))) return false;
    }
    for (const Polygon& clear : kept_clear_) {
        if (overlap(leaf, clear)) return false;
    }
    for (const Obstacle& other : leaves_) {
        if (overlap(leaf, other.box)) return false;
    }
    for (const PlanDoor& other : doors_) {
        if (&other == &door) continue;
        if (overlap(leaf, strip_before(other, room_, 0.0, 0.7)) ||
            overlap(leaf, to_polygon(other.frame, other.opening))) {
            return false;
        }
    }
    leaves_.push_back({leaf, {}, 0.0});
    return true;
}

void Furnisher::add_leaves(double share) {
    for (const PlanDoor& door : doors_) {
        if (door.is_open_passage) continue;
        const bool other_is_corridor =
            plan_.rooms[door.a == room_ ? door.b : door.a].use == RoomUse::corridor;
        // Doors open away from the corridor, and otherwise into the second room.
        if (room().use == RoomUse::corridor || (!other_is_corridor && door.b != room_)) continue;
        const bool hinge_left = random_.uniform() < 0.5;
        const double angle = random_.uniform(80.0, 115.0) * M_PI / 180.0;
        const double draw = random_.uniform();
        if (draw >= share) continue;
        const double width = door.opening.width();
        if (width > 1.25) {
            (void)add_leaf(door, true, 0.5 * width, angle);
            (void)add_leaf(door, false, 0.5 * width, angle);
            continue;
        }
        // One of the two sides may be taken by a wall.
        if (!add_leaf(door, hinge_left, width, angle) &&
            !add_leaf(door, hinge_left, width, 0.5 * M_PI)) {
            (void)add_leaf(door, !hinge_left, width, 0.5 * M_PI);
        }
    }
    for (const Obstacle& leaf : leaves_) kept_clear_.push_back(leaf.box);
}

bool Furnisher::place(const Piece& piece, const Frame& frame, double gap) {
    const Polygon footprint = to_polygon(frame, piece.footprint);
    Rect with_gap = piece.footprint;
    with_gap.y1 += gap;
    const Polygon needed = gap > 0.0 ? to_polygon(frame, with_gap) : footprint;
    if (!has_floor(needed)) return false;
    for (const Polygon& clear : kept_clear_) {
        if (overlap(footprint, clear)) return false;
    }
    for (const Placed& other : placed_) {
        if (overlap(needed, other.footprint)) return false;
    }
    Placed placed{{}, needed, random_.uniform()};
    for (const Rect& box : piece.boxes) placed.obstacles.push_back({to_polygon(frame, box), {}, 0});
    for (const Piece::Post& post : piece.posts) {
        placed.obstacles.push_back({{}, frame.map(post.center), post.radius_m});
    }
    placed_.push_back(std::move(placed));
    return true;
}

bool Furnisher::try_wall(const Piece& piece, const FloorPart& part, int side, double gap) {
    const Wall wall = wall_of(part, side);
    const double half = 0.5 * piece.footprint.width();
    const double free = wall.length - 2.0 * half - 0.04;
    if (free < 0.0) return false;
    const double choice = random_.uniform();
    const double place_in = random_.uniform();
    const double shift = choice < 0.3 ? 0.0 : choice < 0.6 ? free : place_in * free;
    const double off_wall = random_.uniform() < 0.6 ? 0.0 : random_.uniform(0.0, 0.08);
    const Frame frame = wall.frame.at({0.02 + shift + half, off_wall});
    Rect back = piece.footprint;
    back.y0 -= off_wall;
    return has_back(wall.frame.at({0.02 + shift + half, 0.0}), back) && place(piece, frame, gap);
}

bool Furnisher::add_at_wall(const Piece& piece, double gap) {
    constexpr int kTries = 14;
    for (int i = 0; i < kTries; ++i) {
        const FloorPart& part = room().parts[random_.below(room().parts.size())];
        const auto side = static_cast<int>(random_.below(4));
        if (try_wall(piece, part, side, gap)) return true;
    }
    return false;
}

bool Furnisher::add_opposite_door(const Piece& piece) {
    if (doors_.empty()) return false;
    const FloorPart& part = main_part();
    const PlanDoor& door = doors_.front();
    const Point from = door.frame.map(door.opening.center());
    int farthest = 0;
    double reach = -1.0;
    for (int side = 0; side < 4; ++side) {
        const Wall wall = wall_of(part, side);
        const double d = wall.frame.local(from).y;
        if (d > reach) {
            reach = d;
            farthest = side;
        }
    }
    for (int i = 0; i < 6; ++i) {
        if (try_wall(piece, part, farthest, 0.0)) return true;
    }
    return false;
}

bool Furnisher::add_beside_door(const Piece& piece) {
    if (doors_.empty()) return false;
    const PlanDoor& door = doors_[random_.below(doors_.size())];
    const double half = 0.5 * piece.footprint.width() + 0.11;
    const bool is_left = random_.uniform() < 0.5;
    const double x = is_left ? door.opening.x0 - half : door.opening.x1 + half;
    const double into = inwards(door, room_);
    const Point v{into * door.frame.v.x, into * door.frame.v.y};
    const Frame frame{door.frame.map({x, face_of(door, room_)}), door.frame.u, v};
    return has_back(frame, piece.footprint) && place(piece, frame, 0.0);
}

bool Furnisher::add_free(const Piece& piece, const FloorPart& part, const Point& middle,
                         int quarters, double jitter_rad) {
    const double angle = 0.5 * M_PI * quarters + random_.uniform(-jitter_rad, jitter_rad);
    const Point u{std::cos(angle), std::sin(angle)};
    const Point v{-u.y, u.x};
    const Point c = piece.footprint.center();
    const Frame in_part{{middle.x - c.x * u.x - c.y * v.x, middle.y - c.x * u.y - c.y * v.y}, u, v};
    return place(piece, compose(part.frame, in_part), 0.0);
}

void Furnisher::clear_ways() {
    Rect window = kNoRect;
    for (const FloorPart& part : room().parts) window.include(to_polygon(part.frame, part.rect));
    std::vector<Point> starts;
    for (const PlanDoor& door : doors_) {
        const double x = door.opening.center().x;
        starts.push_back(door.frame.map({x, face_of(door, room_) + inwards(door, room_) * 0.03}));
    }
    const Passage passage(labels_, grid_, static_cast<std::uint16_t>(room_ + 1), grow(window, 0.5),
                          starts);
    const auto is_open = [&](const std::vector<Placed>& placed) {
        std::vector<Obstacle> obstacles = leaves_;
        std::vector<Polygon> footprints;
        for (const Placed& one : placed) {
            obstacles.insert(obstacles.end(), one.obstacles.begin(), one.obstacles.end());
            footprints.push_back(one.footprint);
        }
        return passage.is_open(obstacles, footprints);
    };
    if (is_open(placed_)) return;
    std::vector<Placed> kept;
    if (!is_open(kept)) leaves_.clear();
    for (Placed& placed : placed_) {
        kept.push_back(std::move(placed));
        if (!is_open(kept)) kept.pop_back();
    }
    placed_ = std::move(kept);
}

std::vector<Obstacle> Furnisher::thinned(double density) const {
    std::vector<Obstacle> obstacles = leaves_;
    for (const Placed& placed : placed_) {
        if (placed.rank >= density) continue;
        obstacles.insert(obstacles.end(), placed.obstacles.begin(), placed.obstacles.end());
    }
    return obstacles;
}

}  // namespace quadcut::sim
