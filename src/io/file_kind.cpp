// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/file_kind.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "io/fields.hpp"
#include "io/image.hpp"
#include "io/inflate.hpp"
#include "io/input.hpp"

namespace quadcut::io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

constexpr std::string_view kPlayRos1 =
    "play it to a mapper (rosbag play), then 'rosrun map_server map_saver -f map' writes map.yaml";
constexpr std::string_view kPlayRos2 =
    "play it to a mapper (ros2 bag play), then 'ros2 run nav2_map_server map_saver_cli -f map' "
    "writes map.yaml";
constexpr std::string_view kSaveCartographer =
    "'cartographer_pbstream_to_ros_map -pbstream_filename FILE -map_filestem map' (of "
    "cartographer_ros) writes map.yaml";
constexpr std::string_view kSaveSlamToolbox =
    "load it into slam_toolbox, then 'ros2 run nav2_map_server map_saver_cli -f map' writes "
    "map.yaml";
constexpr std::string_view kSaveOctoMap =
    "'octomap_server FILE' publishes its floor, which 'map_saver -f map map:=projected_map' "
    "writes as map.yaml";
constexpr std::string_view kSaveCloud =
    "make a grid of it first: octomap_server takes points and publishes /projected_map, which "
    "map_saver writes";
constexpr std::string_view kSaveRtabmap =
    "'rtabmap-databaseViewer FILE' exports the grid map, or map_saver writes what RTAB-Map "
    "publishes";
constexpr std::string_view kProject =
    "'quadcut rooms', 'export', 'locate' and 'edit' take it, and 'follow --project' goes on with "
    "it";
constexpr std::string_view kDatabase =
    "a ROS 2 bag is played to a mapper (ros2 bag play), whose map 'map_saver_cli -f map' writes";
constexpr std::string_view kDraw =
    "export it as a PNG, black where there are walls and white where the floor is free";
constexpr std::string_view kConvert = "save it as a PNG (any picture program does)";
constexpr std::string_view kUnpack = "unpack it first";
constexpr std::string_view kResult =
    "rooms.yaml of the same folder is a map that can be read, and --previous takes the folder";
constexpr std::string_view kSlice = "make a grid map of it first: a level slice, drawn as a PNG";

/// How a kind is told: by bytes at a place, by a suffix, or by both.
struct Sign {
    std::size_t offset = 0;
    std::string_view bytes;   ///< empty: whatever they are
    std::string_view suffix;  ///< empty: whatever it is
    FileNature nature;
};

constexpr FileNature kImage{FileKind::image, "an image",
                            "'quadcut segment' cuts the map that it shows"};
constexpr FileNature kMapYaml{FileKind::map_yaml, "a map (YAML)", "'quadcut segment' cuts it"};
constexpr FileNature kLog{FileKind::laser_log, "a laser log",
                          "'quadcut map LOG -o DIR' makes map.yaml and map.pgm of it"};
constexpr FileNature kPoses{FileKind::poses, "a trajectory",
                            "--poses takes it, beside the map or the log"};

constexpr FileNature foreign(std::string_view what, std::string_view way_out) {
    return {FileKind::unknown, what, way_out};
}

/// The first that fits is what a file is.
constexpr std::array kSignsOfContent{
    Sign{0, "#ROSBAG V", "", foreign("a ROS 1 bag", kPlayRos1)},
    Sign{0, "\x89MCAP0", "", foreign("an MCAP file (a ROS 2 bag)", kPlayRos2)},
    Sign{0, "rosbag2_bagfile_information", "", foreign("the list of a ROS 2 bag", kPlayRos2)},
    Sign{68, "QCUT", "", foreign("a project of quadcut", kProject)},
    Sign{0, "SQLite format 3", ".db3", foreign("a ROS 2 bag", kPlayRos2)},
    Sign{0, "SQLite format 3", ".db", foreign("a database, as RTAB-Map writes", kSaveRtabmap)},
    Sign{0, "SQLite format 3", "", foreign("an SQLite database", kDatabase)},
    Sign{0, "\xDB\x01\xF5\x5B\x7B\x1F\x1D\x7B", "",
         foreign("a state of Cartographer (pbstream)", kSaveCartographer)},
    Sign{8, "serialization::archive", "",
         foreign("a pose graph of slam_toolbox", kSaveSlamToolbox)},
    Sign{3, "serialization::archive", "",
         foreign("a pose graph of slam_toolbox", kSaveSlamToolbox)},
    Sign{0, "# Octomap OcTree", "", foreign("an OctoMap", kSaveOctoMap)},
    Sign{0, "# .PCD", "", foreign("a point cloud (PCD)", kSaveCloud)},
    Sign{0, "VERSION .", ".pcd", foreign("a point cloud (PCD)", kSaveCloud)},
    Sign{0, "ply\n", "", foreign("a point cloud (PLY)", kSaveCloud)},
    Sign{0, "ply\r\n", "", foreign("a point cloud (PLY)", kSaveCloud)},
    Sign{0, "LASF", "", foreign("a point cloud (LAS)", kSaveCloud)},
    Sign{0, "%PDF", "", foreign("a PDF", kDraw)},
    Sign{0, "<svg", "", foreign("an SVG drawing", kDraw)},
    Sign{0, "AC10", "", foreign("a DWG drawing", kDraw)},
    Sign{0, "P1", "", foreign("a PBM image", kConvert)},
    Sign{0, "P3", "", foreign("a PPM image", kConvert)},
    Sign{0, "P4", "", foreign("a PBM image", kConvert)},
    Sign{0, "P6", "", foreign("a PPM image", kConvert)},
    Sign{0, "P7\n", "", foreign("a PAM image", kConvert)},
    Sign{8, "WEBP", "", foreign("a WebP image", kConvert)},
    Sign{4, "ftypavif", "", foreign("an AVIF image", kConvert)},
    Sign{4, "ftyphei", "", foreign("a HEIF image", kConvert)},
    Sign{0, "8BPS", "", foreign("a Photoshop image", kConvert)},
    Sign{0, "gimp xcf", "", foreign("a GIMP image", kConvert)},
    Sign{0, "PK\x03\x04", "", foreign("a ZIP archive", kUnpack)},
    Sign{0, "7z\xBC\xAF\x27\x1C", "", foreign("a 7z archive", kUnpack)},
    Sign{0, "BZh", "", foreign("a file packed by bzip2", kUnpack)},
    Sign{0,
         "\xFD"
         "7zXZ",
         "", foreign("a file packed by xz", kUnpack)},
    Sign{0, "\x28\xB5\x2F\xFD", "", foreign("a file packed by zstd", kUnpack)},
    Sign{257, "ustar", "", foreign("a tar archive", kUnpack)},
    Sign{0,
         "\x7F"
         "ELF",
         "", foreign("a program", "give the map or the log itself")},
};

constexpr std::array kSignsOfName{
    Sign{0, "", ".yaml", kMapYaml},
    Sign{0, "", ".yml", kMapYaml},
    Sign{0, "", ".pgm", kImage},
    Sign{0, "", ".png", kImage},
    Sign{0, "", ".bmp", kImage},
    Sign{0, "", ".jpg", kImage},
    Sign{0, "", ".jpeg", kImage},
    Sign{0, "", ".gif", kImage},
    Sign{0, "", ".tif", kImage},
    Sign{0, "", ".tiff", kImage},
    Sign{0, "", ".log", kLog},
    Sign{0, "", ".clf", kLog},
    Sign{0, "", ".gz", kLog},
    Sign{0, "", ".tum", kPoses},
    Sign{0, "", ".g2o", kPoses},
    Sign{0, "", ".bag", foreign("a ROS 1 bag", kPlayRos1)},
    Sign{0, "", ".db3", foreign("a ROS 2 bag", kPlayRos2)},
    Sign{0, "", ".mcap", foreign("an MCAP file (a ROS 2 bag)", kPlayRos2)},
    Sign{0, "", ".pbstream", foreign("a state of Cartographer (pbstream)", kSaveCartographer)},
    Sign{0, "", ".posegraph", foreign("a pose graph of slam_toolbox", kSaveSlamToolbox)},
    Sign{0, "", ".data", foreign("the scans of slam_toolbox's pose graph", kSaveSlamToolbox)},
    Sign{0, "", ".bt", foreign("an OctoMap", kSaveOctoMap)},
    Sign{0, "", ".ot", foreign("an OctoMap", kSaveOctoMap)},
    Sign{0, "", ".pcd", foreign("a point cloud (PCD)", kSaveCloud)},
    Sign{0, "", ".ply", foreign("a point cloud (PLY)", kSaveCloud)},
    Sign{0, "", ".las", foreign("a point cloud (LAS)", kSaveCloud)},
    Sign{0, "", ".laz", foreign("a point cloud (LAZ)", kSaveCloud)},
    Sign{0, "", ".xyz", foreign("a point cloud", kSaveCloud)},
    Sign{0, "", ".db", foreign("a database, as RTAB-Map writes", kSaveRtabmap)},
    Sign{0, "", ".svg", foreign("an SVG drawing", kDraw)},
    Sign{0, "", ".pdf", foreign("a PDF", kDraw)},
    Sign{0, "", ".dxf", foreign("a DXF drawing", kDraw)},
    Sign{0, "", ".dwg", foreign("a DWG drawing", kDraw)},
    Sign{0, "", ".dae", foreign("a Collada model", kSlice)},
    Sign{0, "", ".stl", foreign("an STL model", kSlice)},
    Sign{0, "", ".obj", foreign("an OBJ model", kSlice)},
    Sign{0, "", ".world", foreign("a world of Gazebo", kSlice)},
    Sign{0, "", ".sdf", foreign("a world of Gazebo", kSlice)},
    Sign{0, "", ".geojson", foreign("a GeoJSON", kResult)},
    Sign{0, "", ".json", foreign("a JSON", kResult)},
    Sign{0, "", ".jsonl", foreign("a list of JSON", kResult)},
};

template <std::size_t Count>
const FileNature* find_sign(const std::array<Sign, Count>& signs, std::string_view bytes,
                            std::string_view lower_name) {
    const auto fits = [&](const Sign& sign) {
        return bytes.size() >= sign.offset && bytes.substr(sign.offset).starts_with(sign.bytes) &&
               lower_name.ends_with(sign.suffix);
    };
    const auto found = std::find_if(signs.begin(), signs.end(), fits);
    return found == signs.end() ? nullptr : &found->nature;
}

/// What a line of text begins with tells.
const FileNature* nature_of_line(std::string_view line) {
    constexpr std::array kLogWords{"FLASER "sv, "RLASER "sv, "ROBOTLASER"sv, "RAWLASER"sv,
                                   "ODOM "sv,   "PARAM "sv,  "SYNC "sv,      "TRUEPOS "sv};
    constexpr std::array kPoseWords{"VERTEX_SE2 "sv, "VERTEX_SE3:QUAT "sv, "EDGE_SE2 "sv};
    constexpr std::array kYamlWords{"image:"sv, "{image:"sv, "{ image:"sv, "\"image\":"sv};
    const auto begins = [line](std::string_view word) { return line.starts_with(word); };
    if (std::any_of(kLogWords.begin(), kLogWords.end(), begins)) return &kLog;
    if (std::any_of(kPoseWords.begin(), kPoseWords.end(), begins)) return &kPoses;
    if (std::any_of(kYamlWords.begin(), kYamlWords.end(), begins)) return &kMapYaml;
    return nullptr;
}

const FileNature* nature_of_text(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        if (const FileNature* found = nature_of_line(text.substr(0, length))) return found;
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return nullptr;
}

/// Without what editors put before text.
std::string_view without_blanks(std::string_view text) {
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    return text;
}

FileNature find_plain_nature(std::string_view bytes, std::string_view lower_name) {
    if (is_image(bytes)) return kImage;
    if (const FileNature* found = find_sign(kSignsOfContent, bytes, lower_name)) return *found;
    if (const FileNature* found = nature_of_text(without_blanks(bytes))) return *found;
    if (bytes.find("<svg") != std::string_view::npos) {
        return foreign("an SVG drawing", kDraw);
    }
    if (const FileNature* found = find_sign(kSignsOfName, bytes, lower_name)) return *found;
    return {};
}

}  // namespace

FileNature find_file_nature(std::string_view bytes, std::string_view name) {
    const std::string lower_name = lower_case(name);
    bytes = bytes.substr(0, kBeginningBytes);
    if (!is_gzip(bytes)) return find_plain_nature(bytes, lower_name);
    std::string_view inner_name = lower_name;
    if (inner_name.ends_with(".gz")) inner_name.remove_suffix(3);
    const std::string inner = unpack_beginning(bytes);
    const FileNature nature = find_plain_nature(inner, inner_name);
    return nature.what.empty() ? find_plain_nature(inner, lower_name) : nature;
}

std::string describe_refusal(std::string_view bytes, const std::string& name,
                             std::string_view expected) {
    if (bytes.empty()) return name + ": the file is empty, expected " + std::string(expected);
    FileNature nature = find_file_nature(bytes, name);
    // A name may promise what the bytes do not keep; poses are told by it alone.
    const bool is_by_name = find_file_nature(bytes, "").what.empty();
    const bool is_promise = nature.kind != FileKind::unknown && nature.kind != FileKind::poses;
    if (is_by_name && is_promise) nature = {};
    std::string text = name + ": is ";
    text += nature.what.empty() ? "of no kind that is known" : nature.what;
    text += ", expected ";
    text += expected;
    if (!nature.way_out.empty()) text += "; " + std::string(nature.way_out);
    return text;
}

}  // namespace quadcut::io
