// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/clutter.hpp"

#include <algorithm>
#include <cmath>

namespace quadcut::sim {
namespace {

double area_of(const Furnisher& furnisher) {
    double area = 0.0;
    for (const FloorPart& part : furnisher.room().parts) area += part.rect.area();
    return area;
}

int count_of(double wanted, Random& random) {
    return static_cast<int>(std::floor(wanted + random.uniform()));
}

Point somewhere(const Rect& rect, Random& random) {
    const double x = random.uniform(rect.x0, rect.x1);
    return {x, random.uniform(rect.y0, rect.y1)};
}

// Shelves side by side, no two alike in depth: a wall that is none.
void add_shelves(Furnisher& furnisher, double length, double most_depth, double way,
                 Random& random) {
    const Piece row = shelf_row_piece(length, 0.25, most_depth, random);
    furnisher.add_at_wall(row, way);
}

void line_corridor(Furnisher& furnisher, double amount, Random& random) {
    for (const FloorPart& part : furnisher.room().parts) {
        const double width = std::min(part.rect.width(), part.rect.height());
        const double length = std::max(part.rect.width(), part.rect.height());
        const double depth = std::min(0.6, width - 1.15);
        if (depth < 0.28) continue;
        const int wishes = count_of(amount * length / 6.0, random);
        for (int i = 0; i < wishes; ++i) {
            add_shelves(furnisher, random.uniform(0.8, 5.0), depth, 0.0, random);
        }
    }
}

// Rows of desks, back to back, with a partition between the two and stubs between neighbours.
void add_desk_rows(Furnisher& furnisher, double amount, Random& random) {
    const Make make = seen_from_above(draw_make(random));
    const FloorPart& part = furnisher.main_part();
    const Rect& r = part.rect;
    const bool along_x = random.uniform() < 0.5;
    const double length = along_x ? r.width() : r.height();
    const double across = along_x ? r.height() : r.width();
    const double pitch = random.uniform(3.6, 5.0);
    const double margin = random.uniform(0.0, 0.8);
    const double desk = random.uniform(1.4, 1.9);
    const Partitions partitions = random.uniform() < 0.6 ? Partitions::some : Partitions::none;
    const auto lines = static_cast<int>(std::lround((across - 2.0) / pitch));
    const int most = std::max(1, static_cast<int>((length - margin - 0.6) / desk));
    for (int i = 0; i < lines; ++i) {
        int left = most;
        double begin = margin;
        while (left > 0) {
            const int columns = std::min<int>(left, 1 + static_cast<int>(random.below(4)));
            const double wide = columns * desk;
            const double x = begin + 0.5 * wide + random.uniform(-0.1, 0.1);
            const double y = across * (i + 0.5) / std::max(1, lines) + random.uniform(-0.2, 0.2);
            const Point middle = along_x ? Point{r.x0 + x, r.y0 + y} : Point{r.x0 + y, r.y0 + x};
            if (random.uniform() < 0.35 + 0.6 * amount) {
                furnisher.add_free(desk_row_piece(make, columns, desk, partitions, random), part,
                                   middle, along_x ? 0 : 1, 0.03);
            }
            // Often a gap to walk through before the next ones.
            begin += wide + (random.uniform() < 0.6 ? random.uniform(0.7, 1.4) : 0.05);
            left = static_cast<int>((length - 0.6 - begin) / desk);
        }
    }
}

void add_islands(Furnisher& furnisher, int count, Random& random) {
    const FloorPart& part = furnisher.main_part();
    for (int i = 0; i < count; ++i) {
        const Piece box = box_piece(random.uniform(0.6, 2.6), random.uniform(0.4, 1.1));
        furnisher.add_free(box, part, somewhere(grow(part.rect, -0.6), random),
                           static_cast<int>(random.below(2)), 0.12);
    }
}

// What divides a room without making two of it: shelves and partitions that stand out of the wall.
void add_dividers(Furnisher& furnisher, int count, Random& random) {
    const Rect& r = furnisher.main_part().rect;
    const double across = std::min(r.width(), r.height());
    for (int i = 0; i < count; ++i) {
        const double thickness = random.uniform() < 0.4 ? 0.08 : random.uniform(0.3, 0.5);
        const double reach = random.uniform(0.25, 0.65) * across;
        furnisher.add_at_wall(box_piece(thickness, reach), 0.4);
    }
}

}  // namespace

Make seen_from_above(Make make) {
    if (make.chair == Make::Chair::star) make.chair = Make::Chair::post;
    return make;
}

void add_fixtures(Furnisher& furnisher, double amount, Random& random) {
    const RoomUse use = furnisher.room().use;
    if (use == RoomUse::corridor) return line_corridor(furnisher, amount, random);
    const double area = area_of(furnisher);
    if (area < 5.0) return;
    for (int i = count_of(0.8 * amount, random); i > 0; --i) {
        const double width = random.uniform(0.35, 0.65);
        const double depth = random.uniform(0.4, 1.8);
        furnisher.add_beside_door(box_piece(width, depth));
    }
    const bool has_rows = use != RoomUse::classroom && area > 22.0 &&
                          random.uniform() < (use == RoomUse::hall ? 0.4 : 0.65);
    if (has_rows) add_desk_rows(furnisher, amount, random);
    for (int i = count_of(amount * std::sqrt(area) * 0.7, random); i > 0; --i) {
        add_shelves(furnisher, random.uniform(0.8, 3.2), 0.65, 0.0, random);
    }
    if (area > 18.0) add_dividers(furnisher, count_of(amount * area / 28.0, random), random);
    if (area > 14.0) add_islands(furnisher, count_of(amount * area / 45.0, random), random);
}

void add_litter(Furnisher& furnisher, double amount, Random& random) {
    const bool is_corridor = furnisher.room().use == RoomUse::corridor;
    const Make make = seen_from_above(draw_make(random));
    if (!is_corridor) {
        const double wanted = amount * area_of(furnisher) * 0.6 * std::pow(random.uniform(), 2.0);
        for (int i = count_of(wanted, random); i > 0; --i) {
            furnisher.add_at_wall(heap_piece(random.uniform(0.2, 0.5), random));
        }
    }
    const double per_m2 = is_corridor ? 0.012 : random.uniform(0.05, 0.45);
    for (const FloorPart& part : furnisher.room().parts) {
        for (int i = count_of(amount * per_m2 * part.rect.area(), random); i > 0; --i) {
            const double choice = random.uniform();
            const Piece piece =
                choice < 0.55  ? chair_piece(make, random)
                : choice < 0.8 ? post_piece(random.uniform(0.03, 0.18), 0.0)
                               : box_piece(random.uniform(0.15, 0.7), random.uniform(0.15, 0.5));
            furnisher.add_free(piece, part, somewhere(part.rect, random),
                               static_cast<int>(random.below(4)), 0.8);
        }
    }
}

}  // namespace quadcut::sim
