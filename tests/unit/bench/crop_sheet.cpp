// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/crop_sheet.hpp"

#include <filesystem>

#include <gtest/gtest.h>

namespace quadcut {
namespace {

GridMap hall(CellState inside) {
    GridMap map;
    map.resolution_m = 0.1;
    map.states = Raster<CellState>({0, 0}, 60, 60, CellState::occupied);
    for_each_cell({{5, 5}, {54, 54}}, [&](Cell cell) { map.states.at(cell) = inside; });
    return map;
}

TEST(CropSheet, HoldsSixteenCropsABlock) {
    CropSheet sheet;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) sheet.add(0, hall(CellState::free), seed);
    EXPECT_EQ(sheet.num_crops(0), CropSheet::kNumCrops);
    EXPECT_EQ(sheet.num_crops(1), 0U);
    sheet.add(1, hall(CellState::unknown), 1);
    EXPECT_EQ(sheet.num_crops(1), 0U);
}

TEST(CropSheet, IsAPicture) {
    CropSheet sheet;
    sheet.add(0, hall(CellState::free), 1);
    const auto path = std::filesystem::path(testing::TempDir()) / "crop_sheet.png";
    sheet.write(path);
    std::size_t num_floor = 0;
    const io::ParsedImage image = io::parse_image(
        io::read_file(path), "crop_sheet.png",
        [&](const io::ImageHeader&, std::int32_t, std::span<const std::uint16_t> samples) {
            num_floor += static_cast<std::size_t>(std::count(samples.begin(), samples.end(), 254));
        });
    EXPECT_GT(image.header.width, 2 * CropSheet::kSide * CropSheet::kCropPixels);
    // 5 m by 5 m of floor at 5 cm a pixel.
    EXPECT_EQ(num_floor, 10000U);
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace quadcut
