// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/piece.hpp"

#include <algorithm>
#include <cmath>

namespace quadcut::sim {
namespace {

void add_chair(Piece& piece, const Make& make, const Point& p, Random& random) {
    const double turn = random.uniform(-0.35, 0.35);
    const auto around = [&](int count, double radius, double first) {
        for (int i = 0; i < count; ++i) {
            const double angle = first + turn + 2.0 * M_PI * i / count;
            piece.posts.push_back(
                {{p.x + radius * std::cos(angle), p.y + radius * std::sin(angle)}, 0.02});
        }
    };
    switch (make.chair) {
        case Make::Chair::four_legs:
            around(4, 0.28, 0.25 * M_PI);
            break;
        case Make::Chair::star:
            piece.posts.push_back({p, 0.04});
            around(5, 0.27, 0.0);
            break;
        case Make::Chair::post:
            piece.posts.push_back({p, 0.06});
            break;
    }
}

// The part of a desk that reaches the floor.
void add_desk(Piece& piece, const Make& make, const Rect& top, bool drawers_left) {
    if (make.desk == Make::Desk::legs) {
        for (const double x : {top.x0 + 0.06, top.x1 - 0.06}) {
            for (const double y : {top.y0 + 0.06, top.y1 - 0.06}) {
                piece.posts.push_back({{x, y}, make.leg_radius_m});
            }
        }
        return;
    }
    piece.boxes.push_back({top.x0, top.y0 + 0.03, top.x0 + 0.05, top.y1 - 0.05});
    piece.boxes.push_back({top.x1 - 0.05, top.y0 + 0.03, top.x1, top.y1 - 0.05});
    if (make.desk == Make::Desk::panels_and_drawers) {
        const double depth = std::min(0.6, top.height() - 0.1);
        piece.boxes.push_back(
            drawers_left ? Rect{top.x0, top.y0 + 0.05, top.x0 + 0.42, top.y0 + 0.05 + depth}
                         : Rect{top.x1 - 0.42, top.y0 + 0.05, top.x1, top.y0 + 0.05 + depth});
    }
}

}  // namespace

Make draw_make(Random& random) {
    Make make;
    const double chair = random.uniform();
    make.chair = chair < 0.5   ? Make::Chair::four_legs
                 : chair < 0.8 ? Make::Chair::star
                               : Make::Chair::post;
    const double desk = random.uniform();
    make.desk = desk < 0.45   ? Make::Desk::legs
                : desk < 0.65 ? Make::Desk::panels
                              : Make::Desk::panels_and_drawers;
    make.leg_radius_m = random.uniform(0.02, 0.05);
    return make;
}

Piece box_piece(double width, double depth) {
    const Rect box{-0.5 * width, 0.0, 0.5 * width, depth};
    return {{box}, {}, box};
}

Piece post_piece(double radius, double gap) {
    const double reach = gap + 2.0 * radius;
    return {{}, {{{0.0, gap + radius}, radius}}, {-radius, 0.0, radius, reach}};
}

Piece desk_piece(const Make& make, double width, double depth, Random& random) {
    Piece piece;
    const Rect top{-0.5 * width, 0.0, 0.5 * width, depth};
    add_desk(piece, make, top, random.uniform() < 0.5);
    const double out = random.uniform(-0.05, 0.45);
    add_chair(piece, make, {random.uniform(-0.2, 0.2), depth + out}, random);
    piece.footprint = {top.x0, 0.0, top.x1, depth + out + 0.35};
    return piece;
}

Piece table_piece(const Make& make, double width, double depth, int chairs_a_side, bool ends,
                  Random& random) {
    Piece piece;
    constexpr double kSeat = 0.5;  // a chair's place on either side of the table
    const Rect top{-0.5 * width, kSeat, 0.5 * width, kSeat + depth};
    const int bays = std::max(1, static_cast<int>(std::lround(width / 2.0)));
    for (int i = 0; i <= bays; ++i) {
        const double x = top.x0 + 0.08 + (width - 0.16) * i / bays;
        piece.posts.push_back({{x, top.y0 + 0.08}, make.leg_radius_m});
        piece.posts.push_back({{x, top.y1 - 0.08}, make.leg_radius_m});
    }
    for (int i = 0; i < chairs_a_side; ++i) {
        const double x = top.x0 + width * (i + 0.5) / chairs_a_side;
        const auto jitter = [&] { return random.uniform(-0.06, 0.06); };
        const double low = top.y0 - random.uniform(0.0, 0.22);
        const double high = top.y1 + random.uniform(0.0, 0.22);
        const double x_low = x + jitter();
        const double x_high = x + jitter();
        add_chair(piece, make, {x_low, low}, random);
        add_chair(piece, make, {x_high, high}, random);
    }
    if (ends) {
        add_chair(piece, make, {top.x0 - 0.1, top.center().y}, random);
        add_chair(piece, make, {top.x1 + 0.1, top.center().y}, random);
    }
    const double side = ends ? 0.42 : 0.0;
    piece.footprint = {top.x0 - side, 0.0, top.x1 + side, depth + 2.0 * kSeat};
    return piece;
}

Piece island_piece(const Make& make, int columns, Random& random) {
    Piece piece;
    constexpr double kWidth = 1.6;
    constexpr double kDepth = 0.8;
    constexpr double kSeat = 0.75;
    const double left = -0.5 * columns * kWidth;
    for (int i = 0; i < columns; ++i) {
        const double x = left + i * kWidth;
        const bool drawers_left = random.uniform() < 0.5;
        add_desk(piece, make, {x, kSeat, x + kWidth, kSeat + kDepth}, drawers_left);
        add_desk(piece, make, {x, kSeat + kDepth, x + kWidth, kSeat + 2.0 * kDepth}, drawers_left);
        for (const double y : {kSeat, kSeat + 2.0 * kDepth}) {
            const double out = random.uniform(0.0, 0.35);
            const double dx = random.uniform(-0.25, 0.25);
            add_chair(piece, make, {x + 0.5 * kWidth + dx, y > 1.0 ? y + out : y - out}, random);
        }
    }
    piece.footprint = {left, 0.0, -left, 2.0 * (kSeat + kDepth)};
    return piece;
}

Piece shelf_row_piece(double length, double least_depth, double most_depth, Random& random) {
    Piece piece;
    double x = -0.5 * length;
    double deepest = 0.0;
    while (x < 0.5 * length - 0.2) {
        const double width = std::min(random.uniform(0.5, 1.3), 0.5 * length - x);
        const double depth = random.uniform(least_depth, most_depth);
        piece.boxes.push_back({x, 0.0, x + width, depth});
        deepest = std::max(deepest, depth);
        x += width + (random.uniform() < 0.2 ? random.uniform(0.05, 0.3) : 0.0);
    }
    piece.footprint = {-0.5 * length, 0.0, 0.5 * length, deepest};
    return piece;
}

Piece desk_row_piece(const Make& make, int columns, double width, Partitions partitions,
                     Random& random) {
    Piece piece;
    constexpr double kDepth = 0.8;
    constexpr double kSeat = 0.6;
    constexpr double kThin = 0.06;
    const double left = -0.5 * columns * width;
    const double middle = kSeat + kDepth;
    for (int i = 0; i <= columns; ++i) {
        const double x = left + i * width;
        if (partitions == Partitions::some && random.uniform() < 0.7) {
            const double reach = random.uniform(0.5, kDepth + 0.5);
            piece.boxes.push_back({x - 0.5 * kThin, middle - reach, x + 0.5 * kThin,
                                   middle + random.uniform(0.5, kDepth + 0.5)});
        }
        if (i == columns) break;
        if (partitions == Partitions::some && random.uniform() < 0.85) {
            piece.boxes.push_back({x, middle - 0.5 * kThin, x + width, middle + 0.5 * kThin});
        }
        for (const double y : {kSeat, middle}) {
            const double seat = y < middle ? y - random.uniform(-0.2, 0.35)
                                           : y + kDepth + random.uniform(-0.2, 0.35);
            add_desk(piece, make, {x, y, x + width, y + kDepth}, random.uniform() < 0.5);
            const double at = x + width * random.uniform(0.25, 0.75);
            if (random.uniform() < 0.8) add_chair(piece, make, {at, seat}, random);
            // A drawer unit or a computer under some.
            if (random.uniform() < 0.4) {
                const double box = x + random.uniform(0.05, width - 0.55);
                piece.boxes.push_back({box, y + 0.1, box + 0.42, y + 0.65});
            }
        }
    }
    piece.footprint = {left, 0.1, -left, 2.0 * middle - 0.1};
    return piece;
}

Piece heap_piece(double radius, Random& random) {
    Piece piece;
    const auto count = 3 + static_cast<int>(random.below(8));
    for (int i = 0; i < count; ++i) {
        const double angle = random.uniform(-M_PI, M_PI);
        const double away = radius * random.uniform();
        const Point at{away * std::cos(angle), radius + away * std::sin(angle)};
        const double size = random.uniform(0.02, 0.14);
        if (random.uniform() < 0.6) {
            piece.posts.push_back({at, size});
        } else {
            const double other = random.uniform(0.02, 0.2);
            piece.boxes.push_back({at.x - size, at.y - other, at.x + size, at.y + other});
        }
    }
    piece.footprint = {-radius, 0.0, radius, 2.0 * radius};
    return piece;
}

Piece chair_piece(const Make& make, Random& random) {
    Piece piece;
    add_chair(piece, make, {0.0, 0.3}, random);
    piece.footprint = {-0.25, 0.05, 0.25, 0.55};
    return piece;
}

Piece ward_bed_piece(double width, double length) {
    Piece piece;
    for (const double x : {-0.5 * width + 0.08, 0.5 * width - 0.08}) {
        for (const double y : {0.15, length - 0.1}) piece.posts.push_back({{x, y}, 0.04});
    }
    piece.footprint = {-0.5 * width, 0.0, 0.5 * width, length};
    return piece;
}

}  // namespace quadcut::sim
