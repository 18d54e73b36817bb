// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/peers/plan_graph.hpp"

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "bench/border_graph.hpp"
#include "sim/building.hpp"

namespace quadcut::peers {
namespace {

template <typename T>
void write_all(std::ofstream& file, const std::vector<T>& values) {
    file.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(T)));
}

}  // namespace

Graph plan_graph(int num_rooms, double resolution_m) {
    sim::BuildingOptions options;
    options.num_rooms = num_rooms;
    options.resolution_m = resolution_m;
    return border_graph(sim::generate_building(options).map);
}

void write_graph(const Graph& graph, const std::filesystem::path& path) {
    std::ofstream file(path, std::ios::binary);
    write_all(file, std::vector<std::uint64_t>{graph.num_nodes(), graph.columns.size()});
    write_all(file, graph.row_begin);
    write_all(file, graph.columns);
    write_all(file, graph.weights);
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace quadcut::peers
