// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// The edge stage, OpenCL C 1.2: the same integers as graph/visibility.cpp and line_of_sight.cpp, so
// the same edges. The CPU asks each leaf for its finer neighbours; here each leaf asks for its
// coarser ones, because those are at most eight a level, at places known beforehand: every
// work-item has the same little to do. Four kernels, in this order: block_bits, see_edges,
// place_edges, finish_edges.

// As in map/leaf_table.hpp.
#define MIXED 0x80000000u
#define NOTHING 0xFFFFFFFFu
#define NO_LEAF 0xFF

// Of eq. (3): 1.05 squared, times 20 squared. A test gives another.
#ifndef REACH2
#define REACH2 441
#endif

// As Leaf of map/leaf.hpp.
typedef struct {
    int x;
    int y;
    uchar level;
    uchar state;
    uchar unused[2];
} Leaf;

// As LeafTable::Tile.
typedef struct {
    uint first_leaf;
    uint num_leaves;
    uchar offsets[64];
} Tile;

// As WeightedEdge of graph/graph.hpp. The weight passes as its bits: a device without doubles can
// carry it, too.
typedef struct {
    uint a;
    uint b;
    ulong weight;
} Edge;

// As Scene of sight_stage.cpp.
typedef struct {
    int root_x;
    int root_y;
    int directory_x;
    int directory_y;
    int directory_width;
    int directory_height;
    // The box of the nodes, its corners included.
    int low_x;
    int low_y;
    int high_x;
    int high_y;
    // Words of 64 cells: of a row of the bits by rows, of all of those, and the same by columns.
    uint words_per_row;
    uint num_row_words;
    uint words_per_column;
    uint num_column_words;
    uint num_nodes;
    // The level of the largest node.
    int max_level;
    // The levels of a loop's weight: 0 no loops, 1 the node's own, 2 the largest.
    int loops;
    int free_state;
} Scene;

// The leaf of a cell, if it has at least this level.
static uint find_leaf(__constant Scene* scene, __global const uint* directory,
                      __global const Tile* tiles, int x, int y, int level) {
    const int column = (x >> 3) - scene->directory_x;
    const int row = (y >> 3) - scene->directory_y;
    if (column < 0 || row < 0 || column >= scene->directory_width ||
        row >= scene->directory_height) {
        return NOTHING;
    }
    const uint entry = directory[(size_t)row * (uint)scene->directory_width + (uint)column];
    if ((entry & MIXED) == 0u || entry == NOTHING) return entry;
    // A tile that leaves share has none as large as a tile.
    if (level >= 3) return NOTHING;
    __global const Tile* tile = tiles + (entry & ~MIXED);
    const uchar offset = tile->offsets[(y & 7) * 8 + (x & 7)];
    return offset == NO_LEAF ? NOTHING : tile->first_leaf + offset;
}

// The bits of BlockedCells: by rows, then by columns; a border of one blocked cell, and a word more
// in each row. A work-item makes one word.
__kernel void block_bits(__constant Scene* scene, __global const uint* directory,
                         __global const Tile* tiles, __global const Leaf* leaves,
                         __global ulong* bits) {
    const uint word = (uint)get_global_id(0);
    if (word >= scene->num_row_words + scene->num_column_words) return;
    const bool upright = word >= scene->num_row_words;
    const uint place = upright ? word - scene->num_row_words : word;
    const uint per_line = upright ? scene->words_per_column : scene->words_per_row;
    const int low_along = upright ? scene->low_y : scene->low_x;
    const int high_along = upright ? scene->high_y : scene->high_x;
    const int low_across = upright ? scene->low_x : scene->low_y;
    const int high_across = upright ? scene->high_x : scene->high_y;
    const int across = low_across - 1 + (int)(place / per_line);
    const int first = low_along - 1 + 64 * (int)(place % per_line);
    ulong blocked = ~0ul;
    if (across >= low_across && across <= high_across) {
        int along = max(first, low_along);
        const int last = min(first + 63, high_along);
        while (along <= last) {
            const int x = upright ? across : along;
            const int y = upright ? along : across;
            const uint id = find_leaf(scene, directory, tiles, x, y, 0);
            int next = along + 1;
            if (id != NOTHING) {
                __global const Leaf* leaf = leaves + id;
                next = min((upright ? leaf->y : leaf->x) + (1 << leaf->level), last + 1);
                if (leaf->state == scene->free_state) {
                    const int count = next - along;
                    const ulong run = count >= 64 ? ~0ul : (1ul << count) - 1ul;
                    blocked &= ~(run << (along - first));
                }
            }
            along = next;
        }
    }
    bits[word] = blocked;
}

// A view of the bits, by rows or by columns.
typedef struct {
    __global const ulong* words;
    long low_along;
    long low_across;
    long per_line;
} Bits;

static ulong bits_from(const Bits* bits, long row, long column) {
    const long bit = column - bits->low_along;
    const long word = (row - bits->low_across) * bits->per_line + (bit >> 6);
    const uint shift = (uint)(bit & 63);
    return (bits->words[word] >> shift) | ((bits->words[word + 1] << 1) << (63u - shift));
}

static ulong low_bits(long count) { return count >= 64 ? ~0ul : (1ul << count) - 1ul; }

static bool any_bit(const Bits* bits, long row, long first, long last) {
    for (; last - first >= 64; first += 64) {
        if (bits_from(bits, row, first) != 0ul) return true;
    }
    return (bits_from(bits, row, first) & low_bits(last - first + 1)) != 0ul;
}

static long map_row(bool falls, long row) { return falls ? -1 - row : row; }

static bool any_pinch(const Bits* bits, bool falls, long row, long first, long last) {
    for (long corner = first; corner <= last; corner += 63) {
        const ulong below = bits_from(bits, map_row(falls, row - 1), corner - 1);
        const ulong above = bits_from(bits, map_row(falls, row), corner - 1);
        const ulong pinches = ((below << 1) & above) | (below & (above << 1));
        if (((pinches >> 1) & low_bits(last - corner + 1)) != 0ul) return true;
    }
    return false;
}

static long floor_divide(long a, long b) {
    const long quotient = a / b;
    return quotient * b > a ? quotient - 1 : quotient;
}

static bool level_is_clear(const Bits* bits, bool falls, long v, long u_first, long u_last) {
    const long row = v >> 1;
    const long first = u_first >> 1;
    const long last = ((u_last + 1) >> 1) - 1;
    if ((v & 1) != 0) return first > last || !any_bit(bits, map_row(falls, row), first, last);
    for (long column = first; column <= last; column += 64) {
        const ulong both = bits_from(bits, map_row(falls, row - 1), column) &
                           bits_from(bits, map_row(falls, row), column);
        if ((both & low_bits(last - column + 1)) != 0ul) return false;
    }
    return !any_pinch(bits, falls, row, (u_first + 1) >> 1, u_last >> 1);
}

static bool slope_is_clear(const Bits* bits, bool falls, long u, long v, long du, long dv,
                           long u_first, long u_last) {
    const long rise = (u_first - u) * dv + v * du;
    long row = floor_divide(rise, 2 * du);
    long column = u_first >> 1;
    const bool starts_at_corner = rise == row * 2 * du && (u_first & 1) == 0;
    if (starts_at_corner && any_pinch(bits, falls, row, column, column)) return false;
    const long denominator = 2 * dv;
    const long numerator = u * dv + (2 * (row + 1) - v) * du;
    long crossing = floor_divide(numerator, denominator);
    long rest = numerator - crossing * denominator;
    const long step = du / dv;
    const long step_rest = 2 * (du - step * dv);
    const long end = u_last >> 1;
    const long end_rest = (u_last & 1) * dv;
    while (crossing < end || (crossing == end && rest < end_rest)) {
        const long until = rest == 0 ? crossing - 1 : crossing;
        if (any_bit(bits, map_row(falls, row), column, until)) return false;
        ++row;
        if (rest == 0 && any_pinch(bits, falls, row, crossing, crossing)) return false;
        column = crossing;
        crossing += step;
        rest += step_rest;
        if (rest >= denominator) {
            rest -= denominator;
            ++crossing;
        }
    }
    const long last = ((u_last + 1) >> 1) - 1;
    if (column <= last && any_bit(bits, map_row(falls, row), column, last)) return false;
    const bool ends_at_corner = end_rest == 0 && crossing == end && rest == 0;
    return !(ends_at_corner && any_pinch(bits, falls, row + 1, end, end));
}

// BlockedCells::sees() between the centres (in half cells) of two free leaves of these sides.
static bool sees(__constant Scene* scene, __global const ulong* bits, long ax, long ay, long a_side,
                 long bx, long by, long b_side) {
    const bool steep = abs(by - ay) > abs(bx - ax);
    // Along the longer axis u, from the end with the smaller u.
    const long au = steep ? ay : ax;
    const long av = steep ? ax : ay;
    const long bu = steep ? by : bx;
    const long bv = steep ? bx : by;
    const bool turned = bu < au;
    const long u = turned ? bu : au;
    const long v = turned ? bv : av;
    const long du = turned ? au - bu : bu - au;
    const long rise = turned ? av - bv : bv - av;
    const long u_first = u + (turned ? b_side : a_side);
    const long u_last = u + du - (turned ? a_side : b_side);
    const bool falls = rise < 0;
    Bits view;
    view.words = steep ? bits + scene->num_row_words : bits;
    view.low_along = (steep ? scene->low_y : scene->low_x) - 1L;
    view.low_across = (steep ? scene->low_x : scene->low_y) - 1L;
    view.per_line = steep ? scene->words_per_column : scene->words_per_row;
    const long w = falls ? -v : v;
    if (rise == 0) return level_is_clear(&view, falls, w, u_first, u_last);
    return slope_is_clear(&view, falls, u, w, du, falls ? -rise : rise, u_first, u_last);
}

// Where a leaf may have neighbours so many levels up: at 13 places of its own level (its own place
// among them), or at the 3 x 3 blocks around the one that holds it.
typedef struct {
    // The block of that level that holds the leaf.
    int x;
    int y;
    int side;
    int level;
    int num_places;
    // From the leaf's centre to the block's, half cells.
    long dx;
    long dy;
    // Eq. (3), 400 d^2 <= 441 (2 s_i + 2 s_j)^2, divided by four.
    long reach;
} Ring;

static Ring ring_around(__constant Scene* scene, Leaf leaf, int step) {
    Ring ring;
    ring.level = leaf.level + step;
    ring.side = 1 << ring.level;
    ring.num_places = step == 0 ? 13 : 9;
    // Blocks are aligned with the root.
    ring.x = leaf.x - ((leaf.x - scene->root_x) & (ring.side - 1));
    ring.y = leaf.y - ((leaf.y - scene->root_y) & (ring.side - 1));
    const int side = 1 << leaf.level;
    ring.dx = 2L * (ring.x - leaf.x) + ring.side - side;
    ring.dy = 2L * (ring.y - leaf.y) + ring.side - side;
    const long sides = (long)side + ring.side;
    ring.reach = REACH2 * sides * sides;
    return ring;
}

static int2 offset_of(int num_places, int place) {
    if (num_places == 9) return (int2)(place % 3 - 1, place / 3 - 1);
    // 1, 3, 5, 3, 1 places in the rows from two below to two above.
    if (place == 0) return (int2)(0, -2);
    if (place < 4) return (int2)(place - 2, -1);
    if (place < 9) return (int2)(place - 6, 0);
    if (place < 12) return (int2)(place - 10, 1);
    return (int2)(0, 2);
}

// The node that is the leaf at a place of a ring around leaf `id`, or NOTHING; that is also the
// answer where eq. (3) or rule 2 forbid the pair. Its lower left cell comes out in `low`.
static uint neighbour_at(__constant Scene* scene, __global const uint* directory,
                         __global const Tile* tiles, __global const Leaf* leaves,
                         __global const uint* node_of_leaf, uint id, const Ring* ring, int place,
                         int2* low) {
    const int2 offset = offset_of(ring->num_places, place);
    if (offset.x == 0 && offset.y == 0) return NOTHING;
    const long dx = ring->dx + 2L * ring->side * offset.x;
    const long dy = ring->dy + 2L * ring->side * offset.y;
    if (100 * (dx * dx + dy * dy) > ring->reach) return NOTHING;
    low->x = ring->x + ring->side * offset.x;
    low->y = ring->y + ring->side * offset.y;
    const uint other = find_leaf(scene, directory, tiles, low->x, low->y, ring->level);
    if (other == NOTHING || leaves[other].level != ring->level) return NOTHING;
    // Rule 2: the coarser leaf comes first; of two equal ones, the earlier.
    if (ring->num_places == 13 && other > id) return NOTHING;
    return node_of_leaf[other];
}

// Which places have a neighbour that is seen, for node get_global_id(0), get_global_id(1) levels
// up: a bit a place. Counts the entries of each row of edges.
__kernel void see_edges(__constant Scene* scene, __global const uint* directory,
                        __global const Tile* tiles, __global const Leaf* leaves,
                        __global const uint* node_of_leaf, __global const uint* nodes,
                        __global const ulong* bits, __global ushort* seen, __global uint* counts) {
    const uint node = (uint)get_global_id(0);
    const int step = (int)get_global_id(1);
    if (node >= scene->num_nodes) return;
    const uint id = nodes[node];
    const Leaf leaf = leaves[id];
    ushort mask = 0;
    if (leaf.level + step <= scene->max_level) {
        const Ring ring = ring_around(scene, leaf, step);
        const long side = 1L << leaf.level;
        for (int place = 0; place < ring.num_places; ++place) {
            int2 low;
            const uint other = neighbour_at(scene, directory, tiles, leaves, node_of_leaf, id,
                                            &ring, place, &low);
            if (other == NOTHING) continue;
            if (!sees(scene, bits, 2L * low.x + ring.side, 2L * low.y + ring.side, ring.side,
                      2L * leaf.x + side, 2L * leaf.y + side, side)) {
                continue;
            }
            mask |= (ushort)(1 << place);
            atomic_inc(counts + other);
        }
    }
    if (step == 0 && scene->loops != 0) atomic_inc(counts + node);
    seen[(size_t)step * scene->num_nodes + node] = mask;
}

// Puts each edge anywhere in its row, which begins at row_begin[a]; `counts` runs down to zero.
__kernel void place_edges(__constant Scene* scene, __global const uint* directory,
                          __global const Tile* tiles, __global const Leaf* leaves,
                          __global const uint* node_of_leaf, __global const uint* nodes,
                          __global const ushort* seen, __global const uint* row_begin,
                          __global uint* counts, __global uint2* pairs) {
    const uint node = (uint)get_global_id(0);
    const int step = (int)get_global_id(1);
    if (node >= scene->num_nodes) return;
    const uint id = nodes[node];
    const Leaf leaf = leaves[id];
    const uint mask = seen[(size_t)step * scene->num_nodes + node];
    const Ring ring = ring_around(scene, leaf, step);
    for (int place = 0; place < 13; ++place) {
        if ((mask >> place & 1u) == 0u) continue;
        int2 low;
        const uint other = neighbour_at(scene, directory, tiles, leaves, node_of_leaf, id, &ring,
                                        place, &low);
        pairs[row_begin[other] + atomic_dec(counts + other) - 1u] = (uint2)(other, node);
    }
    if (step == 0 && scene->loops != 0) {
        pairs[row_begin[node] + atomic_dec(counts + node) - 1u] = (uint2)(node, node);
    }
}

// Entries first .. end of the edges as they are returned: each at its rank among the second ends of
// its row, with its weight, which depends on the two levels only: weights[32 a + b].
__kernel void finish_edges(__constant Scene* scene, __global const Leaf* leaves,
                           __global const uint* nodes, __global const uint* row_begin,
                           __global const uint2* pairs, __global const ulong* weights, uint first,
                           uint end, __global Edge* edges) {
    const uint entry = first + (uint)get_global_id(0);
    if (entry >= end) return;
    const uint2 pair = pairs[entry];
    const uint begin = row_begin[pair.x];
    const uint row_end = row_begin[pair.x + 1];
    uint rank = 0;
    for (uint other = begin; other < row_end; ++other) rank += pairs[other].y < pair.y ? 1u : 0u;
    int level_a = leaves[nodes[pair.x]].level;
    int level_b = leaves[nodes[pair.y]].level;
    if (pair.x == pair.y && scene->loops == 2) {
        level_a = scene->max_level;
        level_b = scene->max_level;
    }
    Edge edge;
    edge.a = pair.x;
    edge.b = pair.y;
    edge.weight = weights[32 * level_a + level_b];
    edges[begin + rank - first] = edge;
}
