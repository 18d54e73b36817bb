// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <chrono>
#include <cstdint>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "quadcut/map/grid_map.hpp"

// The yardstick of speed: the exact distance transform that OpenCV makes of a map.
namespace quadcut {

template <typename Work>
double timed_ms(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Free cells 255, all others 0.
inline cv::Mat free_image(const GridMap& map) {
    cv::Mat image(map.states.height, map.states.width, CV_8UC1);
    std::size_t i = 0;
    for (int y = 0; y < map.states.height; ++y) {
        auto* row = image.ptr<std::uint8_t>(y);
        for (int x = 0; x < map.states.width; ++x, ++i) {
            row[x] = map.states.values[i] == CellState::free ? 255 : 0;
        }
    }
    return image;
}

inline double distance_transform_ms(const cv::Mat& image, cv::Mat& distances) {
    return timed_ms(
        [&] { cv::distanceTransform(image, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE); });
}

}  // namespace quadcut
