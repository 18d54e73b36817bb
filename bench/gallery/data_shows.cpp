// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/data_map.hpp"
#include "bench/gallery/entry_picture.hpp"
#include "bench/gallery/shows.hpp"
#include "io/carmen.hpp"
#include "io/map_server.hpp"
#include "quadcut/map/integrate.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut::gallery {
namespace {

namespace fs = std::filesystem;

constexpr double kLogResolution = 0.05;

/// The files of a folder with one of the endings, in order of their names.
std::vector<fs::path> files_in(const fs::path& folder,
                               const std::vector<std::string_view>& endings) {
    std::vector<fs::path> files;
    if (!fs::is_directory(folder)) return files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (std::find(endings.begin(), endings.end(), extension) != endings.end()) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

Section show_true_maps(const fs::path& data, const fs::path& output) {
    Section section{"Maps with hand-made rooms", {}};
    for (const fs::path& path : files_in(data / "rooms", {".yaml"})) {
        const std::string name = path.stem().string();
        const GridMap map = io::read_map(path).map;
        const fs::path truth_path =
            path.parent_path() / (name.substr(0, name.find('.')) + ".rooms.png");
        const Exhibit exhibit =
            make_exhibit(name, map, io::read_label_image(truth_path), map, segment(map));
        section.entries.push_back(write_pair(exhibit, "", output, "rooms/" + name + ".png"));
    }
    return section;
}

Section show_real_maps(const std::string& kind, const std::string& title, const fs::path& output) {
    Section section{title, {}};
    for (const DataMap& data : read_real_maps()) {
        if (data.kind != kind) continue;
        const Exhibit exhibit = make_exhibit(data.name, data.map, data.truth, data.map,
                                             segment(data.map), data.surely_free);
        section.entries.push_back(write_with_faults(exhibit, output, "real/" + data.name + ".png"));
    }
    return section;
}

Section show_logs(const fs::path& data, const fs::path& output) {
    Section section{"Laser logs", {}};
    for (const fs::path& path : files_in(data / "logs", {".log", ".gz"})) {
        const std::string name = path.filename().string();
        const io::LogFile log = io::read_carmen_log(path);
        const GridMap map = map_from_scans(log.scans, kLogResolution).to_grid();
        std::vector<Point> trajectory;
        for (const Scan& scan : log.scans) {
            trajectory.push_back({scan.world_from_sensor.x, scan.world_from_sensor.y});
        }
        const Segmentation rooms = segment(map, {}, {}, trajectory);
        const std::string note = std::to_string(log.scans.size()) + " scans";
        const std::string image = "logs/" + name + ".png";
        // intel_robotlaser is in another frame than the truth.
        if (name == "intel.log" || name == "intel_dense.log.gz") {
            const GridMap frame = io::read_map(path.parent_path() / "intel.gt.yaml").map;
            const Side result = resampled(frame, map, rooms);
            const Exhibit exhibit = make_exhibit(
                name, frame, io::read_label_image(path.parent_path() / "intel.gt_rooms.png"),
                result.map, result.rooms);
            section.entries.push_back(write_pair(exhibit, note, output, image));
        } else {
            section.entries.push_back(write_alone(name, note, map, rooms, output, image));
        }
    }
    return section;
}

Section show_other_maps(const fs::path& data, const fs::path& output) {
    // It is there for scale: 10,976 cells square, most of them not of any building.
    constexpr std::string_view kLeftOut = "rangelibc_gigantic_map.png";
    Section section{"Maps without a truth", {}};
    std::vector<fs::path> paths = files_in(data / "maps", {".yaml", ".png"});
    for (const fs::path& path : files_in(data / "maps", {".pgm"})) {
        // Others are the images of a YAML.
        if (!fs::exists(fs::path(path).replace_extension(".yaml"))) paths.push_back(path);
    }
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
        const std::string name = path.filename().string();
        if (name == kLeftOut) continue;
        const GridMap map = io::read_map(path).map;
        const std::string image = "maps/" + path.stem().string() + ".png";
        section.entries.push_back(write_alone(name, "", map, segment(map), output, image));
    }
    return section;
}

}  // namespace quadcut::gallery
