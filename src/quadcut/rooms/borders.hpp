// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "quadcut/base/parallel.hpp"
#include "quadcut/map/raster.hpp"
#include "quadcut/rooms/contacts.hpp"
#include "quadcut/rooms/narrowing.hpp"
#include "quadcut/rooms/wall_lines.hpp"

namespace quadcut {

/// The saddle of each two pieces a < b that touch, at the cell of a.
using BorderSaddles = std::map<std::pair<std::uint32_t, std::uint32_t>, Saddle>;

/// Counts a contact as one more of a border, and moves its saddle there if it is wider.
void add_contact(const Contact& contact, const Raster<float>& clearance_m, const WallLines& lines,
                 Saddle& saddle);

/// The widest saddle of each two labels that touch where there is clearance, in each of two
/// clearances. O(cells).
[[nodiscard]] std::array<BorderSaddles, 2> border_saddles(const Raster<std::uint32_t>& pieces,
                                                          const Raster<float>& clearance_m,
                                                          const Raster<float>& free_clearance_m,
                                                          const WallLines& lines,
                                                          const Executor& executor);

/// The borders between regions that only ever join, as one clearance shows them: the widest saddle
/// of each, and the opening there once it is measured.
class Borders {
public:
    Borders(const BorderSaddles& saddles, std::uint32_t num_pieces);

    [[nodiscard]] const std::map<std::uint32_t, Saddle>& of(std::uint32_t region) const {
        return saddles_[region];
    }
    /// The saddle between regions a < b, at the cell of a; nothing where they do not touch.
    [[nodiscard]] const Saddle* find(std::uint32_t a, std::uint32_t b) const;
    /// A place for the opening at that saddle, and whether it is a new one, to be filled. It stays
    /// where it is until the next join.
    [[nodiscard]] std::pair<Opening*, bool> place_for_opening(std::uint32_t a, std::uint32_t b);
    /// @pre It was measured.
    [[nodiscard]] const Opening& opening(std::uint32_t a, std::uint32_t b) const {
        return openings_.at({a, b});
    }
    /// Region b becomes a part of a; the saddles of both to a third region become the wider one.
    void join(std::uint32_t a, std::uint32_t b);

private:
    std::vector<std::map<std::uint32_t, Saddle>> saddles_;
    /// Of regions a < b, at the saddle of a.
    std::map<std::pair<std::uint32_t, std::uint32_t>, Opening> openings_;
};

/// What was walked in regions that only ever join, as far as it still holds, by the walk's seed.
class Walks {
public:
    explicit Walks(std::uint32_t num_pieces) : walks_(num_pieces + std::size_t{1}) {}

    /// A place for the walk from a cell of a region, and whether it is a new one, to be filled. It
    /// stays where it is until the next join.
    [[nodiscard]] std::pair<WalkedSide*, bool> place_for(std::uint32_t region, std::size_t seed);
    /// @pre It was walked.
    [[nodiscard]] const WalkedSide& from(std::uint32_t region, std::size_t seed) const {
        return walks_[region].at(seed);
    }
    /// Region b becomes a part of a; walks that came up against the other one no longer hold.
    /// `region_of_piece` is as before.
    void join(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> region_of_piece);

private:
    std::vector<std::map<std::size_t, WalkedSide>> walks_;
};

}  // namespace quadcut
