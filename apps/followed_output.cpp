// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/followed_output.hpp"

#include <utility>

#include "io/results.hpp"

namespace quadcut {
namespace {

constexpr const char* kUpdates = "updates.jsonl";

}  // namespace

std::vector<std::string> followed_files() {
    std::vector<std::string> files = io::result_files();
    for (std::string& file : io::map_files()) files.push_back(std::move(file));
    files.emplace_back(kUpdates);
    return files;
}

void add_followed(io::FileBatch& output, const GridMap& map, const Segmentation& rooms,
                  const std::string& updates, const io::RunInfo& info) {
    io::add_map(output, map);
    io::add_results(output, map, rooms, info);
    output.add(kUpdates, updates);
}

}  // namespace quadcut
