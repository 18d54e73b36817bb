// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/random.hpp"
#include "sim/shape.hpp"

namespace quadcut::sim {

/// A piece of furniture, or a group that belongs together, as a laser near the floor sees it:
/// boxes and round posts. In its own frame it stands with its back on y = 0, its middle at x = 0,
/// and grows towards +y.
struct Piece {
    struct Post {
        Point center;
        double radius_m = 0.04;
    };
    std::vector<Rect> boxes;
    std::vector<Post> posts;
    /// All that no other piece may stand on.
    Rect footprint;
};

/// How one room is furnished: its chairs and tables are of one make.
struct Make {
    enum class Chair { four_legs, star, post };
    enum class Desk { legs, panels, panels_and_drawers };
    Chair chair = Chair::four_legs;
    Desk desk = Desk::legs;
    double leg_radius_m = 0.03;
};

/// Whether desks in rows have thin walls between them.
enum class Partitions { none, some };

[[nodiscard]] Make draw_make(Random& random);

/// A box against the wall: cupboard, shelf, counter, sofa, bed, copier.
[[nodiscard]] Piece box_piece(double width, double depth);
/// A bin, a plant, a basin: a post that stands `gap` from the wall.
[[nodiscard]] Piece post_piece(double radius, double gap);
/// A desk and a chair before it; the chair is drawn out by a random amount.
[[nodiscard]] Piece desk_piece(const Make& make, double width, double depth, Random& random);
/// A table with chairs along both long sides, and at its ends where `ends` is set.
[[nodiscard]] Piece table_piece(const Make& make, double width, double depth, int chairs_a_side,
                                bool ends, Random& random);
/// Desks back to back in two rows of `columns`, with chairs.
[[nodiscard]] Piece island_piece(const Make& make, int columns, Random& random);
/// Shelves and cupboards side by side, `length` in all, each of another depth.
[[nodiscard]] Piece shelf_row_piece(double length, double least_depth, double most_depth,
                                    Random& random);
/// Desks of `width` back to back in two rows of `columns`. With partitions: a thin wall between the
/// rows, in places, and stubs of it between neighbours.
[[nodiscard]] Piece desk_row_piece(const Make& make, int columns, double width,
                                   Partitions partitions, Random& random);
/// Bags, boxes and cables in a heap.
[[nodiscard]] Piece heap_piece(double radius, Random& random);
/// A chair on its own.
[[nodiscard]] Piece chair_piece(const Make& make, Random& random);
/// A bed on four legs.
[[nodiscard]] Piece ward_bed_piece(double width, double length);

}  // namespace quadcut::sim
