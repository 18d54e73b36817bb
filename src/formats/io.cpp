// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/io.hpp"

#include <optional>
#include <utility>

#include "formats/registry.hpp"
#include "io/file_batch.hpp"
#include "io/map_server.hpp"
#include "io/map_writer.hpp"
#include "io/scan_source.hpp"
#include "quadcut/version.hpp"

namespace quadcut {

MapInFile read_map(const std::filesystem::path& path) {
    io::MapFile file = io::read_map(path);
    return {std::move(file.map), std::move(file.warnings)};
}

std::vector<std::string> read_scans(const std::filesystem::path& path,
                                    const std::function<void(const Scan&)>& visit) {
    const auto source = io::open_scan_source(io::Input(path), {});
    while (const std::optional<Scan> scan = source->next()) visit(*scan);
    return source->facts().warnings;
}

void write_map(const std::filesystem::path& folder, const GridMap& map) {
    io::FileBatch batch(folder);
    io::add_map(batch, map);
    batch.commit();
}

void write_rooms(const std::filesystem::path& folder, const GridMap& map,
                 const Segmentation& segmentation) {
    io::RunInfo info;
    info.version = kVersion;
    formats::write_results(folder, map, segmentation, info);
}

}  // namespace quadcut
