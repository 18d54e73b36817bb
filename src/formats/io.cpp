// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/io.hpp"

#include <utility>

#include "formats/results.hpp"
#include "io/carmen.hpp"
#include "io/file_batch.hpp"
#include "io/map_server.hpp"
#include "io/map_writer.hpp"
#include "quadcut/version.hpp"

namespace quadcut {

MapInFile read_map(const std::filesystem::path& path) {
    io::MapFile file = io::read_map(path);
    return {std::move(file.map), std::move(file.warnings)};
}

std::vector<std::string> read_scans(const std::filesystem::path& path,
                                    const std::function<void(const Scan&)>& visit) {
    const io::LogFile log = io::read_carmen_log(path);
    for (const Scan& scan : log.scans) visit(scan);
    return log.warnings;
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
