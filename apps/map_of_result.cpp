// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/map_of_result.hpp"

#include <cstdint>
#include <system_error>
#include <utility>

#include "io/authorship.hpp"
#include "io/file.hpp"
#include "io/file_kind.hpp"
#include "io/input.hpp"
#include "io/run_info.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr const char* kMapYaml = "map.yaml";
constexpr const char* kMapImage = "map.pgm";

/// A file, if it is there and a map: of a log, its own map beside the result is meant.
std::optional<io::InputFile> read_if_map(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    io::InputFile file = io::read_input(path);
    const io::FileKind kind = io::find_file_nature(file.bytes, file.name).kind;
    if (kind != io::FileKind::map_yaml && kind != io::FileKind::image) return std::nullopt;
    return file;
}

io::InputFile find_map(const std::filesystem::path& folder, const std::string& input) {
    const bool is_piped = input == io::kStandardInput;
    const std::filesystem::path cut = is_piped ? "" : input;
    if (!cut.empty()) {
        if (auto map = read_if_map(cut)) return std::move(*map);
        if (auto map = read_if_map(folder / cut)) return std::move(*map);
    }
    if (auto map = read_if_map(folder / kMapYaml)) return std::move(*map);
    const std::string where = is_piped      ? " came through standard input"
                              : cut.empty() ? " is not in it"
                                            : ", " + input + ", is not there any more";
    throw InputError(io::display_name(folder) + ": its map" + where +
                     ": say where it is with --map FILE");
}

void check_size(const io::StoredResult& result, const GridMap& map, const std::string& name) {
    const Raster<CellState>& states = map.states;
    const Raster<std::uint16_t>& labels = result.rooms.labels;
    if (states.width == labels.width && states.height == labels.height) return;
    throw InputError(name + ": has " + std::to_string(states.width) + " x " +
                     std::to_string(states.height) + " cells, and the rooms were cut in " +
                     std::to_string(labels.width) + " x " + std::to_string(labels.height) +
                     ": say with --map FILE which map it was");
}

}  // namespace

io::MapFile map_of_result(const std::filesystem::path& folder, const io::StoredResult& result,
                          const std::optional<std::string>& given) {
    io::InputFile file = given ? io::read_input(*given) : find_map(folder, result.input);
    const std::string name = file.name;
    const bool was_cut = file.path == result.input;
    io::MapFile map = io::parse_map_as_before(std::move(file), result.map_keys);
    check_size(result, map.map, name);
    const bool is_known = !result.input_hash.empty();
    if (was_cut && is_known && io::hash_text(map.content_hash) != result.input_hash) {
        map.warnings.push_back(name + ": has changed since its rooms were cut");
    }
    return map;
}

bool is_part_of_result(const std::filesystem::path& folder, const io::MapFile& map) {
    return map.has_yaml && map.image_path == folder / kMapImage &&
           io::is_own_file(folder / kMapYaml) && io::is_own_file(map.image_path);
}

}  // namespace quadcut
