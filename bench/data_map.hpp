// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <utility>
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
    std::string kind;      ///< plain, furnished or kth; real, growing or campus
    GridMap map;
    io::LabelImage truth;
    /// What is surely free (io::kSurelyFreeGrey), for scores that leave out the void; of real maps.
    io::FreeMask surely_free = {};
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

/// Maps of one building by the beginnings of their names: whoever leaves a building out of training
/// leaves out all of them. A building that read_data_maps() knows has its name from there.
inline constexpr std::array<std::pair<const char*, const char*>, 4> kBuildingOfNames{
    {{"intel_", "lab_intel"},
     {"fr101", "Freiburg101_scan"},
     {"cartesium_", "ubremen_cartesium"},
     {"ubremen_cartesium", "ubremen_cartesium"}}};

/// The building of a real map; its own name where no other map is of that building.
inline std::string building_of_real_map(const std::string& name) {
    for (const auto& [begin, building] : kBuildingOfNames) {
        if (name.rfind(begin, 0) == 0) return building;
    }
    return name;
}

namespace data_map {

inline DataMap read_real_map(const std::filesystem::path& path) {
    DataMap map;
    map.name = path.stem().string();
    map.building = building_of_real_map(map.name);
    map.kind = path.parent_path().filename() == "growing" ? "growing"
               : map.name.rfind("campus_", 0) == 0        ? "campus"
                                                          : "real";
    map.map = io::read_map(path).map;
    map.truth = io::read_label_image(path.parent_path() / (map.name + ".rooms.png"));
    map.surely_free =
        io::read_free_mask(path.parent_path() / (map.name + ".png"), io::kSurelyFreeGrey);
    return map;
}

}  // namespace data_map

/// The maps as robots scanned them, by kind (campus, growing, real) and name: those of one
/// building, or all. None when the data is not there.
inline std::vector<DataMap> read_real_maps(const std::string& building = "") {
    namespace fs = std::filesystem;
    std::vector<DataMap> maps;
    for (const fs::path& folder : {shared_path("data/real"), shared_path("data/real/growing")}) {
        if (!fs::exists(folder)) continue;
        for (const auto& entry : fs::directory_iterator(folder)) {
            if (entry.path().extension() != ".yaml") continue;
            const std::string name = entry.path().stem().string();
            if (!building.empty() && building_of_real_map(name) != building) continue;
            maps.push_back(data_map::read_real_map(entry.path()));
        }
    }
    std::sort(maps.begin(), maps.end(), [](const DataMap& p, const DataMap& q) {
        return std::pair(p.kind, p.name) < std::pair(q.kind, q.name);
    });
    return maps;
}

}  // namespace quadcut
