// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/cases.hpp"
#include "bench/shared_folder.hpp"
#include "io/label_image.hpp"
#include "io/map_server.hpp"
#include "quadcut/map/grid_map.hpp"

namespace quadcut {

/// A hand-labelled map of the data.
struct DataMap {
    std::string name;      ///< as lab_a.furnished
    std::string building;  ///< as lab_a
    std::string kind;      ///< plain, furnished or kth
    GridMap map;
    io::LabelImage truth;
};

/// Those of one building, or all; by name. None when the data is not there.
inline std::vector<DataMap> read_data_maps(const std::string& building = "") {
    namespace fs = std::filesystem;
    const fs::path folder = shared_path("data/rooms");
    std::vector<DataMap> maps;
    if (!fs::exists(folder)) return maps;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".yaml") continue;
        DataMap map;
        map.name = entry.path().stem().string();
        map.building = map.name.substr(0, map.name.find('.'));
        if (!building.empty() && map.building != building) continue;
        map.kind =
            map.building.rfind("kth_", 0) == 0 ? "kth" : map.name.substr(map.name.find('.') + 1);
        map.map = io::read_map(entry.path()).map;
        map.truth = io::read_label_image(folder / (map.building + ".rooms.png"));
        maps.push_back(std::move(map));
    }
    std::sort(maps.begin(), maps.end(),
              [](const DataMap& p, const DataMap& q) { return p.name < q.name; });
    return maps;
}

}  // namespace quadcut
