// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/skeleton.hpp"

#include <algorithm>

namespace quadcut::sim {
namespace {

enum class Side { north, south, east, west };

// Builds in wing coordinates. w: corridor, t: corridor wall, both between faces.
class SkeletonBuilder {
public:
    SkeletonBuilder(const WingStyle& style, Random& random) : style_(style), random_(random) {}

    [[nodiscard]] Skeleton bar(double frontage);
    [[nodiscard]] Skeleton bend(double frontage);
    [[nodiscard]] Skeleton court(double frontage);
    [[nodiscard]] Skeleton ring(double frontage);
    [[nodiscard]] Skeleton comb(double frontage);

private:
    [[nodiscard]] double w() const { return style_.corridor_m; }
    [[nodiscard]] double t() const { return style_.corridor_wall_m; }
    [[nodiscard]] double outer() const { return style_.outer_depth_m; }
    [[nodiscard]] double inner() const { return style_.inner_depth_m; }

    void add_corridor(const Rect& rect, std::size_t corridor = 0);
    // A strip on `side` of its corridor, whose front is open between two wing coordinates.
    void add_strip(const Rect& area, Side side, double front_begin, double front_end,
                   std::size_t corridor = 0);
    void add_port(const Point& middle, Side side, std::size_t corridor = 0);
    void fill_core(const Rect& core);
    void add_branch(double x, double length);

    const WingStyle& style_;
    Random& random_;
    Skeleton skeleton_;
};

Frame facing(Side side, const Point& origin) {
    switch (side) {
        case Side::north:
            return {origin, {1, 0}, {0, 1}};
        case Side::south:
            return {origin, {1, 0}, {0, -1}};
        case Side::east:
            return {origin, {0, 1}, {1, 0}};
        case Side::west:
            return {origin, {0, 1}, {-1, 0}};
    }
    return {};
}

void SkeletonBuilder::add_corridor(const Rect& rect, std::size_t corridor) {
    skeleton_.corridors.push_back({rect, corridor});
    skeleton_.num_corridors = std::max(skeleton_.num_corridors, corridor + 1);
    skeleton_.footprint.push_back(grow(rect, t()));
}

void SkeletonBuilder::add_strip(const Rect& area, Side side, double front_begin, double front_end,
                                std::size_t corridor) {
    const bool level = side == Side::north || side == Side::south;
    const double start = level ? area.x0 : area.y0;
    const double length = level ? area.width() : area.height();
    if (length < 2.0) return;
    Point origin{area.x0, area.y0};
    if (side == Side::south) origin.y = area.y1;
    if (side == Side::west) origin.x = area.x1;
    skeleton_.strips.push_back({facing(side, origin), length, level ? area.height() : area.width(),
                                std::max(0.0, front_begin - start),
                                std::min(length, front_end - start), corridor});
    skeleton_.footprint.push_back(grow(area, style_.outer_wall_m));
}

void SkeletonBuilder::add_port(const Point& middle, Side side, std::size_t corridor) {
    skeleton_.ports.push_back({facing(side, middle), corridor});
}

// One straight corridor, rooms on one or both sides.
Skeleton SkeletonBuilder::bar(double frontage) {
    const bool both_sides = frontage < 16.0 || random_.uniform() < 0.85;
    const double length = std::max(3.2, both_sides ? frontage / 2.0 : frontage);
    add_corridor({0, 0, length, w()});
    add_strip({0, w() + t(), length, w() + t() + outer()}, Side::north, 0, length);
    if (both_sides) add_strip({0, -t() - inner(), length, -t()}, Side::south, 0, length);
    add_port({0, 0.5 * w()}, Side::west);
    add_port({length, 0.5 * w()}, Side::east);
    return skeleton_;
}

// An L: along x at the top, down along y at the left.
Skeleton SkeletonBuilder::bend(double frontage) {
    // Outer strips: a + outer and b; inner strips: a - w and b - inner.
    const double sum = std::max(2.0 * inner() + 8.0, (frontage - outer() + w() + inner()) / 2.0);
    const double share = random_.uniform(0.4, 0.65);
    const double a = std::max(sum * share, inner() + w() + 3.5);
    const double b = std::max(sum - a, inner() + 4.0);
    add_corridor({0, 0, a, w()});
    add_corridor({0, -b, w(), 0});
    add_strip({-t() - outer(), w() + t(), a, w() + t() + outer()}, Side::north, 0, a);
    add_strip({-t() - outer(), -b, -t(), w()}, Side::west, -b, w());
    add_strip({w() + t(), -t() - inner(), a, -t()}, Side::south, w(), a);
    add_strip({w() + t(), -b, w() + t() + inner(), -2 * t() - inner()}, Side::east, -b, 0);
    add_port({a, 0.5 * w()}, Side::east);
    add_port({0.5 * w(), -b}, Side::south);
    return skeleton_;
}

// A U around a yard that is open to the north.
Skeleton SkeletonBuilder::court(double frontage) {
    const double yard = random_.uniform(4.0, 9.0);
    const double a = 2.0 * (w() + t() + inner()) + yard + 2.0 * style_.outer_wall_m;
    // Outer: a + 2 outer and twice b; inner: a - 2 w and twice b - inner.
    const double rest = frontage - (2.0 * a + 2.0 * outer() - 2.0 * w());
    const double b = std::max(inner() + 5.0, (rest + 2.0 * inner()) / 4.0);
    add_corridor({0, 0, a, w()});
    add_corridor({0, w(), w(), b});
    add_corridor({a - w(), w(), a, b});
    add_strip({-t() - outer(), -t() - outer(), a + t() + outer(), -t()}, Side::south, 0, a);
    add_strip({-t() - outer(), 0, -t(), b}, Side::west, 0, b);
    add_strip({a + t(), 0, a + t() + outer(), b}, Side::east, 0, b);
    add_strip({w() + t(), w() + t(), a - w() - t(), w() + t() + inner()}, Side::north, w(),
              a - w());
    const double inner_begin = w() + 2 * t() + inner();
    add_strip({w() + t(), inner_begin, w() + t() + inner(), b}, Side::east, inner_begin, b);
    add_strip({a - w() - t() - inner(), inner_begin, a - w() - t(), b}, Side::west, inner_begin, b);
    add_port({0.5 * w(), b}, Side::north);
    add_port({a - 0.5 * w(), b}, Side::north);
    return skeleton_;
}

// The inside of a ring: rooms back to back, rooms around a yard, or one row of rooms.
void SkeletonBuilder::fill_core(const Rect& core) {
    const double d = inner();
    const double wall = style_.partition_m;
    if (core.height() < 2.0 * d) {
        add_strip(core, random_.uniform() < 0.5 ? Side::north : Side::south, core.x0, core.x1);
        return;
    }
    if (core.height() < 2.0 * d + 3.0) {
        const double middle = core.center().y;
        add_strip({core.x0, core.y0, core.x1, middle - 0.5 * wall}, Side::north, core.x0, core.x1);
        add_strip({core.x0, middle + 0.5 * wall, core.x1, core.y1}, Side::south, core.x0, core.x1);
        return;
    }
    add_strip({core.x0, core.y0, core.x1, core.y0 + d}, Side::north, core.x0, core.x1);
    add_strip({core.x0, core.y1 - d, core.x1, core.y1}, Side::south, core.x0, core.x1);
    const double low = core.y0 + d + wall;
    const double high = core.y1 - d - wall;
    add_strip({core.x0, low, core.x0 + d, high}, Side::east, low, high);
    add_strip({core.x1 - d, low, core.x1, high}, Side::west, low, high);
    const double o = style_.outer_wall_m;
    skeleton_.voids.push_back({core.x0 + d + o, low - wall + o, core.x1 - d - o, high + wall - o});
}

// A corridor around a core, rooms outside and inside; it is reached through the outer row.
Skeleton SkeletonBuilder::ring(double frontage) {
    const double rows = frontage > 130.0  ? 2.0 + random_.uniform(0.0, 1.0) * 1.2
                        : frontage > 80.0 ? 2.0
                                          : 1.0;
    double core_height = rows * inner() + (rows > 1.0 ? style_.partition_m : 0.0);
    if (rows > 2.0) core_height = 2.0 * inner() + random_.uniform(5.0, 10.0);
    const double b = core_height + 2.0 * (w() + t());
    double a = (frontage - 2.0 * b - 2.0 * outer()) / (rows > 1.0 ? 4.0 : 3.0);
    a = std::max(a, (rows > 2.0 ? 2.0 * inner() + 5.0 : 6.0) + 2.0 * (w() + t()));
    add_corridor({0, 0, a, w()});
    add_corridor({0, b - w(), a, b});
    add_corridor({0, w(), w(), b - w()});
    add_corridor({a - w(), w(), a, b - w()});
    fill_core({w() + t(), w() + t(), a - w() - t(), b - w() - t()});
    add_strip({-t() - outer(), b + t(), a + t() + outer(), b + t() + outer()}, Side::north, 0,
              a + t() + outer());
    add_strip({-t() - outer(), -t() - outer(), a + t() + outer(), -t()}, Side::south,
              -t() - outer(), a);
    // Two ways out: the lower corridor goes on to the west, the upper one to the east.
    const double end = t() + outer();
    add_strip({-end, w() + t(), -t(), b}, Side::west, w(), b);
    add_corridor({-end, 0, 0, w()});
    add_port({-end, 0.5 * w()}, Side::west);
    add_strip({a + t(), 0, a + end, b - w() - t()}, Side::east, 0, b - w() - t());
    add_corridor({a, b - w(), a + end, b});
    add_port({a + end, b - 0.5 * w()}, Side::east);
    return skeleton_;
}

// A branch to the north at x: corridor and a row on either side.
void SkeletonBuilder::add_branch(double x, double length) {
    const double start = w() + 2.0 * t() + outer();
    const double end = start + length;
    std::size_t corridor = 0;
    if (random_.uniform() < 0.4) {
        corridor = skeleton_.num_corridors;
        const double wall = style_.partition_m;
        const double door = std::min(w() - 0.3, random_.uniform(0.9, 1.4));
        const double y = w() + t();
        add_corridor({x, w(), x + w(), y}, 0);
        add_corridor({x, y + wall, x + w(), end}, corridor);
        const double middle = x + 0.5 * w();
        skeleton_.fire_doors.push_back(
            {{}, {middle - 0.5 * door, y, middle + 0.5 * door, y + wall}, 0, corridor});
    } else {
        add_corridor({x, w(), x + w(), end}, corridor);
    }
    add_strip({x - t() - inner(), start, x - t(), end}, Side::west, start, end, corridor);
    add_strip({x + w() + t(), start, x + w() + t() + inner(), end}, Side::east, start, end,
              corridor);
    add_port({x + 0.5 * w(), end}, Side::north, corridor);
}

// A spine along x with one to four branches to the north.
Skeleton SkeletonBuilder::comb(double frontage) {
    const double pitch_min = w() + 2.0 * (t() + inner() + style_.outer_wall_m);
    const double pitch = pitch_min + (random_.uniform() < 0.3 ? 0.0 : random_.uniform(3.0, 7.0));
    // One branch of length l adds 2 l of frontage, and its share of the spine 2 pitch - w.
    const double length_wanted = random_.uniform(12.0, 20.0);
    const auto num_branches = static_cast<int>(
        std::clamp(frontage / (2.0 * length_wanted + 2.0 * pitch - w()), 1.0, 4.0));
    const double spine = pitch * num_branches;
    const double length = std::max(6.0, (frontage / num_branches - 2.0 * pitch + w()) / 2.0);
    add_corridor({0, 0, spine, w()});
    add_strip({0, -t() - outer(), spine, -t()}, Side::south, 0, spine);
    double begin = 0.0;
    for (int i = 0; i < num_branches; ++i) {
        const double x = pitch * (i + 0.5) - 0.5 * w();
        add_strip({begin, w() + t(), x - t(), w() + t() + outer()}, Side::north, begin, x - t());
        add_branch(x, length * (num_branches > 1 ? random_.uniform(0.8, 1.2) : 1.0));
        begin = x + w() + t();
    }
    add_strip({begin, w() + t(), spine, w() + t() + outer()}, Side::north, begin, spine);
    add_port({0, 0.5 * w()}, Side::west);
    add_port({spine, 0.5 * w()}, Side::east);
    return skeleton_;
}

}  // namespace

Skeleton draw_skeleton(const WingStyle& style, double frontage_m, Random& random) {
    SkeletonBuilder builder(style, random);
    const double choice = random.uniform();
    if (frontage_m < 34.0) return builder.bar(frontage_m);
    if (frontage_m < 62.0) {
        return choice < 0.5 ? builder.bar(frontage_m) : builder.bend(frontage_m);
    }
    if (choice < 0.12) return builder.bar(std::min(frontage_m, 90.0));
    if (choice < 0.26) return builder.bend(frontage_m);
    if (choice < 0.42) return builder.court(frontage_m);
    if (choice < 0.74) return builder.ring(frontage_m);
    return builder.comb(frontage_m);
}

}  // namespace quadcut::sim
