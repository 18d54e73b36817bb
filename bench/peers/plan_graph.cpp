// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/peers/plan_graph.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "quadcut/map/free_leaves.hpp"
#include "quadcut/rooms/border_edges.hpp"
#include "sim/building.hpp"

namespace quadcut::peers {
namespace {

Graph largest_component(const Graph& graph) {
    const auto component = connected_components(graph);
    std::vector<std::vector<std::uint32_t>> nodes;
    for (std::uint32_t i = 0; i < component.size(); ++i) {
        if (component[i] >= nodes.size()) nodes.resize(component[i] + std::size_t{1});
        nodes[component[i]].push_back(i);
    }
    const auto largest =
        std::max_element(nodes.begin(), nodes.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    return induced_subgraph(graph, *largest);
}

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
    const GridMap map = sim::generate_building(options).map;
    const FreeLeaves leaves = free_leaves(map);
    return largest_component(
        build_graph(border_edges(leaves.table, leaves.nodes),
                    leaf_areas_m2(leaves.table, leaves.nodes, map.resolution_m)));
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
