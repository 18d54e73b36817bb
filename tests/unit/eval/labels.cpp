// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "eval/labels.hpp"

#include <gtest/gtest.h>

namespace quadcut {
namespace {

TEST(LabelsOfRasters, StandUprightAndBack) {
    Raster<std::uint32_t> raster({0, 0}, 2, 3);
    raster.at({0, 0}) = 1;
    raster.at({1, 2}) = 2;
    const io::LabelImage image = as_label_image(raster, 0);
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.height, 3);
    EXPECT_EQ(image.values, (std::vector<std::uint32_t>{0, 2, 0, 0, 1, 0}));
    EXPECT_EQ(as_raster(image).values, raster.values);
}

}  // namespace
}  // namespace quadcut
