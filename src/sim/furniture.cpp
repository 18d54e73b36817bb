// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "sim/furniture.hpp"

#include <algorithm>
#include <cmath>

#include "sim/clutter.hpp"
#include "sim/furnisher.hpp"
#include "sim/piece.hpp"

namespace quadcut::sim {
namespace {

// What a kind of box measures.
struct BoxSizes {
    double least_width;
    double most_width;
    double least_depth;
    double most_depth;
};

constexpr BoxSizes kCupboard{0.8, 2.2, 0.4, 0.62};
constexpr BoxSizes kShelf{0.7, 2.0, 0.28, 0.42};
constexpr BoxSizes kSofa{0.85, 2.3, 0.8, 0.95};
constexpr BoxSizes kMachine{1.8, 3.6, 0.6, 0.8};

// Chooses what stands in a room.
class Decorator {
public:
    Decorator(Furnisher& furnisher, const Make& make, Random& random)
        : furnisher_(furnisher), random_(random), make_(make), part_(furnisher.main_part()) {
        for (const FloorPart& part : furnisher.room().parts) area_ += part.rect.area();
    }

    void decorate();

private:
    void boxes(int count, const BoxSizes& sizes);
    void small_things(int count);
    void desks(int count);
    // Tables or islands in rows over the main part of the room.
    template <typename MakePiece>
    void rows(double pitch_x, double pitch_y, double margin, bool along_x, MakePiece make_piece);
    void table_in_the_middle();
    void side_table();
    void corridor();
    void office();
    void hall();
    void open_plan();
    void laboratory();
    void classroom();
    void cubicle();
    void kitchen();
    void lounge();
    void bedroom();
    void ward();
    void bathroom();

    [[nodiscard]] int count(double per_m2, int least, int most) const {
        return std::clamp(static_cast<int>(std::lround(area_ * per_m2)), least, most);
    }

    Furnisher& furnisher_;
    Random& random_;
    Make make_;
    FloorPart part_;
    double area_ = 0.0;
};

void Decorator::boxes(int count, const BoxSizes& sizes) {
    for (int i = 0; i < count; ++i) {
        const double width = random_.uniform(sizes.least_width, sizes.most_width);
        furnisher_.add_at_wall(
            box_piece(width, random_.uniform(sizes.least_depth, sizes.most_depth)), 0.3);
    }
}

void Decorator::small_things(int count) {
    for (int i = 0; i < count; ++i) {
        const double size = random_.uniform(0.12, 0.25);
        const double other = random_.uniform(0.3, 0.6);
        if (random_.uniform() < 0.5) {
            furnisher_.add_at_wall(post_piece(size, 0.05));
        } else {
            furnisher_.add_at_wall(box_piece(2.0 * size, other));
        }
    }
}

void Decorator::desks(int count) {
    const double depth = random_.uniform(0.68, 0.82);
    for (int i = 0; i < count; ++i) {
        const double width = random_.uniform(1.2, 1.8);
        furnisher_.add_at_wall(desk_piece(make_, width, depth, random_));
    }
}

template <typename MakePiece>
void Decorator::rows(double pitch_x, double pitch_y, double margin, bool along_x,
                     MakePiece make_piece) {
    const Rect& r = part_.rect;
    const double width = (along_x ? r.width() : r.height()) - 2.0 * margin;
    const double height = (along_x ? r.height() : r.width()) - 2.0 * margin;
    const auto columns = static_cast<int>(width / pitch_x);
    const auto lines = static_cast<int>(height / pitch_y);
    for (int i = 0; i < lines; ++i) {
        for (int j = 0; j < columns; ++j) {
            const double x = margin + width * (j + 0.5) / columns + random_.uniform(-0.08, 0.08);
            const double y = margin + height * (i + 0.5) / lines + random_.uniform(-0.08, 0.08);
            const Point middle = along_x ? Point{r.x0 + x, r.y0 + y} : Point{r.x0 + y, r.y0 + x};
            furnisher_.add_free(make_piece(), part_, middle, along_x ? 0 : 1, 0.04);
        }
    }
}

void Decorator::table_in_the_middle() {
    const Rect& r = part_.rect;
    const bool along_x = r.width() >= r.height();
    const double length = std::clamp(std::max(r.width(), r.height()) - 3.0, 1.4, 6.0);
    const double depth = std::clamp(std::min(r.width(), r.height()) - 3.4, 0.8, 1.6);
    const auto chairs = static_cast<int>(length / random_.uniform(0.65, 0.85));
    const Piece table = table_piece(make_, length, depth, chairs, random_.uniform() < 0.5, random_);
    const Point c = r.center();
    furnisher_.add_free(table, part_,
                        {c.x + random_.uniform(-0.3, 0.3), c.y + random_.uniform(-0.3, 0.3)},
                        along_x ? 0 : 1, 0.05);
}

// A small table with chairs, somewhere.
void Decorator::side_table() {
    const double width = random_.uniform(0.8, 1.4);
    const Piece table = table_piece(make_, width, random_.uniform(0.7, 0.9), width > 1.1 ? 2 : 1,
                                    random_.uniform() < 0.3, random_);
    const Rect& r = part_.rect;
    for (int i = 0; i < 8; ++i) {
        const Point middle{random_.uniform(r.x0 + 0.8, r.x1 - 0.8),
                           random_.uniform(r.y0 + 0.8, r.y1 - 0.8)};
        const auto quarters = static_cast<int>(random_.below(2));
        if (furnisher_.add_free(table, part_, middle, quarters, 0.25)) return;
    }
}

// Only against walls, with a way of at least 1.1 m left, and nothing across from it.
void Decorator::corridor() {
    for (const FloorPart& part : furnisher_.room().parts) {
        const double width = std::min(part.rect.width(), part.rect.height());
        const double length = std::max(part.rect.width(), part.rect.height());
        const auto wishes = static_cast<int>(length / 5.0);
        for (int i = 0; i < wishes; ++i) {
            const double choice = random_.uniform();
            const double long_side = random_.uniform(0.4, 1.8);
            const double depth = random_.uniform(0.25, 0.5);
            const Piece piece = choice < 0.3 ? post_piece(random_.uniform(0.12, 0.22), 0.05)
                                             : box_piece(long_side, depth);
            const double way = width - piece.footprint.y1;
            if (way > 1.1) furnisher_.add_at_wall(piece, way - 0.12);
        }
    }
}

void Decorator::office() {
    const double choice = random_.uniform();
    const bool has_table = area_ > 15.0 && choice < 0.5;
    if (area_ > 20.0 && choice > 0.7) {
        open_plan();
    } else {
        desks(count(0.14, 1, 5));
    }
    boxes(count(0.1, 1, 3), kCupboard);
    boxes(count(0.06, 0, 3), kShelf);
    if (has_table) side_table();
    small_things(count(0.12, 1, 4));
}

void Decorator::open_plan() {
    const Rect& r = part_.rect;
    const int columns = std::max(r.width(), r.height()) > 9.0 ? 2 : 1;
    rows(columns * 1.6 + 1.2, 4.0, 0.2, r.width() >= r.height(),
         [&] { return island_piece(make_, columns, random_); });
}

void Decorator::hall() {
    if (random_.uniform() < 0.6) {
        open_plan();
    } else {
        rows(3.4, 3.4, 0.9, true, [&] {
            return table_piece(make_, random_.uniform(1.2, 1.8), 0.8, 2, random_.uniform() < 0.4,
                               random_);
        });
    }
    boxes(5, kShelf);
    boxes(3, kSofa);
    small_things(6);
}

void Decorator::laboratory() {
    const bool along_x = part_.rect.width() >= part_.rect.height();
    rows(4.4, 2.9, 0.5, along_x, [&] {
        return table_piece(make_, random_.uniform(2.4, 3.2), random_.uniform(0.8, 1.4), 2, false,
                           random_);
    });
    boxes(2, kMachine);
    boxes(3, kCupboard);
    small_things(4);
}

void Decorator::classroom() {
    const bool along_x = part_.rect.width() < part_.rect.height();
    rows(1.95, 1.75, 0.55, along_x, [&] { return desk_piece(make_, 1.3, 0.55, random_); });
    boxes(2, kCupboard);
    boxes(2, kShelf);
    small_things(2);
}

void Decorator::kitchen() {
    const double width = std::min(random_.uniform(1.8, 3.6),
                                  std::max(part_.rect.width(), part_.rect.height()) - 0.3);
    furnisher_.add_at_wall(box_piece(width, 0.62), 0.5);
    furnisher_.add_at_wall(box_piece(0.62, 0.64), 0.4);
    if (area_ > 8.0) side_table();
    boxes(1, kCupboard);
    small_things(2);
}

void Decorator::lounge() {
    boxes(count(0.12, 2, 4), kSofa);
    side_table();
    if (area_ > 22.0) table_in_the_middle();
    boxes(2, kCupboard);
    boxes(1, kShelf);
    small_things(3);
}

void Decorator::bedroom() {
    const double width = random_.uniform() < 0.5 ? 0.95 : random_.uniform(1.4, 1.85);
    furnisher_.add_at_wall(box_piece(width, random_.uniform(2.0, 2.15)), 0.3);
    furnisher_.add_at_wall(box_piece(random_.uniform(1.2, 2.6), 0.62), 0.5);
    furnisher_.add_at_wall(box_piece(0.45, 0.4));
    if (area_ > 11.0) desks(1);
    small_things(2);
}

void Decorator::ward() {
    const bool on_legs = random_.uniform() < 0.6;
    const int beds = count(0.09, 1, 4);
    for (int i = 0; i < beds; ++i) {
        const double length = random_.uniform(2.0, 2.2);
        furnisher_.add_at_wall(on_legs ? ward_bed_piece(0.95, length) : box_piece(0.95, length),
                               0.4);
        furnisher_.add_at_wall(box_piece(0.5, 0.45));
    }
    boxes(2, kCupboard);
    side_table();
    small_things(2);
}

void Decorator::bathroom() {
    furnisher_.add_opposite_door(box_piece(0.38, random_.uniform(0.55, 0.68)));
    furnisher_.add_at_wall(post_piece(0.1, 0.15));
    if (area_ > 4.0) furnisher_.add_at_wall(box_piece(random_.uniform(1.5, 1.75), 0.75), 0.3);
    furnisher_.add_at_wall(box_piece(0.3, 0.3));
}

void Decorator::cubicle() {
    const double width = std::min(part_.rect.width(), part_.rect.height()) - 0.5;
    furnisher_.add_opposite_door(desk_piece(make_, width, 0.7, random_));
    small_things(2);
}

void Decorator::decorate() {
    switch (furnisher_.room().use) {
        case RoomUse::corridor:
        case RoomUse::aisle:
            return corridor();
        case RoomUse::hall:
            return hall();
        case RoomUse::office:
            return office();
        case RoomUse::open_office:
            open_plan();
            boxes(3, kCupboard);
            small_things(4);
            break;
        case RoomUse::meeting:
            table_in_the_middle();
            boxes(1, kCupboard);
            small_things(2);
            break;
        case RoomUse::laboratory:
            return laboratory();
        case RoomUse::classroom:
            return classroom();
        case RoomUse::cubicle:
            return cubicle();
        case RoomUse::washroom:
            for (int i = 0; i < 2; ++i) furnisher_.add_at_wall(box_piece(0.5, 0.4));
            small_things(1);
            break;
        case RoomUse::toilet:
            furnisher_.add_opposite_door(box_piece(0.36, random_.uniform(0.5, 0.65)));
            break;
        case RoomUse::storage:
            boxes(4, kShelf);
            small_things(4);
            break;
        case RoomUse::kitchen:
            return kitchen();
        case RoomUse::lounge:
            return lounge();
        case RoomUse::bedroom:
            return bedroom();
        case RoomUse::ward:
            return ward();
        case RoomUse::bathroom:
            return bathroom();
    }
}

}  // namespace

std::vector<Obstacle> furnish(const Plan& plan, std::size_t room, const FurnitureOptions& options,
                              const Raster<std::uint16_t>& labels, const CellGrid& grid,
                              Random random) {
    const RoomUse use = plan.rooms[room].use;
    Random litter = random.fork(1);
    Furnisher furnisher(plan, room, labels, grid, random);
    furnisher.add_leaves(options.open_leaves);
    const bool is_cluttered = options.clutter > 0.0;
    double depth = is_cluttered ? 0.35 : 0.9;
    double area = 0.0;
    for (const FloorPart& part : plan.rooms[room].parts) area += part.rect.area();
    if (!is_cluttered && (use == RoomUse::cubicle || area < 6.0)) depth = 0.6;
    furnisher.keep_doors_clear(depth);
    if (is_cluttered) add_fixtures(furnisher, options.clutter, litter);
    const Make make = draw_make(random);
    Decorator(furnisher, is_cluttered ? seen_from_above(make) : make, random).decorate();
    if (is_cluttered) {
        add_litter(furnisher, options.clutter, litter);
    } else if (use != RoomUse::corridor) {
        furnisher.clear_ways();
    }
    return furnisher.thinned(options.density);
}

}  // namespace quadcut::sim
