// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "io/file.hpp"
#include "io/image.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/map/grid_map.hpp"
#include "quadcut/map/raster.hpp"

namespace quadcut {

/// Parts of maps in two blocks side by side, all at one scale: which of the two is real?
class CropSheet {
public:
    static constexpr double kCropM = 14.0;
    static constexpr double kPixelM = 0.05;
    static constexpr std::int32_t kCropPixels = 280;
    /// Crops a side of a block.
    static constexpr std::int32_t kSide = 4;
    static constexpr std::size_t kNumCrops = kSide * kSide;

    /// The busiest of some places of the map that `seed` draws, in the next crop of a block (0:
    /// left, 1: right). Nothing when the block is full or the map has no free cell.
    void add(std::size_t block, const GridMap& map, std::uint64_t seed) {
        std::vector<Raster<CellState>>& crops = blocks_[block];
        if (crops.size() >= kNumCrops) return;
        std::optional<Raster<CellState>> best;
        std::size_t most = 0;
        Random random(seed);
        for (int i = 0; i < kPlaces; ++i) {
            const std::size_t offset = random.below(map.states.values.size());
            if (map.states.values[offset] != CellState::free) continue;
            Raster<CellState> crop = cut(map, map.states.cell(offset));
            const std::size_t found = num_edges(crop);
            if (best && found <= most) continue;
            most = found;
            best = std::move(crop);
        }
        if (best) crops.push_back(*std::move(best));
    }

    /// As map_server draws maps. Throws InputError when the file cannot be written.
    void write(const std::filesystem::path& path) const {
        constexpr std::int32_t kBlock = kSide * (kCropPixels + kGap);
        const io::ImageHeader header{2 * kBlock + kMiddle, kBlock + kGap, 1, 255};
        Raster<std::uint8_t> page({0, 0}, header.width, header.height, 255);
        for (std::size_t block = 0; block < 2; ++block) {
            for (std::size_t i = 0; i < blocks_[block].size(); ++i) {
                const auto column = static_cast<std::int32_t>(i) % kSide;
                const auto row = static_cast<std::int32_t>(i) / kSide;
                const std::int32_t left = block == 0 ? kGap : kBlock + kMiddle;
                paste(page, blocks_[block][i],
                      {left + column * (kCropPixels + kGap), kGap + row * (kCropPixels + kGap)});
            }
        }
        io::write_file_atomically(
            path, io::encode_png(header, [&](std::int32_t y, std::span<std::uint16_t> samples) {
                const auto first =
                    page.values.begin() + static_cast<std::ptrdiff_t>(y) * page.width;
                std::copy(first, first + page.width, samples.begin());
            }));
    }

    [[nodiscard]] std::size_t num_crops(std::size_t block) const { return blocks_[block].size(); }

private:
    static constexpr int kPlaces = 400;
    static constexpr std::int32_t kGap = 6;
    static constexpr std::int32_t kMiddle = 48;

    static Raster<CellState> cut(const GridMap& map, Cell middle) {
        Raster<CellState> crop({0, 0}, kCropPixels, kCropPixels);
        for (std::size_t i = 0; i < crop.values.size(); ++i) {
            const Cell pixel = crop.cell(i);
            const auto at = [&](std::int32_t from, std::int32_t along) {
                const double m = (along + 0.5 - 0.5 * kCropPixels) * kPixelM;
                return static_cast<std::int32_t>(std::floor(from + 0.5 + m / map.resolution_m));
            };
            const Cell cell{at(middle.x, pixel.x), at(middle.y, pixel.y)};
            if (map.states.contains(cell)) crop.values[i] = map.states.at(cell);
        }
        return crop;
    }
    // Places where free floor ends.
    static std::size_t num_edges(const Raster<CellState>& crop) {
        std::size_t count = 0;
        for (std::size_t i = 0; i + 1 < crop.values.size(); ++i) {
            const bool is_free = crop.values[i] == CellState::free;
            if (is_free != (crop.values[i + 1] == CellState::free)) ++count;
        }
        return count;
    }
    static void paste(Raster<std::uint8_t>& page, const Raster<CellState>& crop, Cell corner) {
        for (std::size_t i = 0; i < crop.values.size(); ++i) {
            const Cell pixel = crop.cell(i);
            const CellState state = crop.values[i];
            page.at({corner.x + pixel.x, corner.y + kCropPixels - 1 - pixel.y}) =
                state == CellState::free       ? 254
                : state == CellState::occupied ? 0
                                               : 205;
        }
    }

    std::vector<Raster<CellState>> blocks_[2];
};

}  // namespace quadcut
