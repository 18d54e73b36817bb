// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// The graph of leaves: CPU time of the edges, four tests of line of sight on the same pairs, and
// the weights as a dense matrix, by diagonals and in compressed rows (the paper's Fig. 6).
//
//   micro_graph [-o FILE.json] [MAP ...]      maps as `quadcut segment` takes them

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/result_file.hpp"
#include "eval/dia.hpp"
#include "io/map_server.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/map/occupancy_map.hpp"
#include "quadcut/paper/line_of_sight.hpp"
#include "quadcut/paper/visibility.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kRounds = 9;
/// No matrix larger than this is built: bytes are computed, the product is not timed.
constexpr std::size_t kMaxMatrixBytes = std::size_t{256} << 20U;

/// Milliseconds on a clock of the system.
double read_ms(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

struct Times {
    double cpu_ms = 0.0;  ///< of all threads together: does not grow when others use the machine
    double wall_ms = 0.0;
};

/// The medians of nine calls.
template <typename Work>
Times median_times(const Work& work) {
    std::array<double, kRounds> cpu_ms{};
    std::array<double, kRounds> wall_ms{};
    for (std::size_t i = 0; i < kRounds; ++i) {
        const double cpu_start_ms = read_ms(CLOCK_PROCESS_CPUTIME_ID);
        const double wall_start_ms = read_ms(CLOCK_MONOTONIC);
        work();
        wall_ms[i] = read_ms(CLOCK_MONOTONIC) - wall_start_ms;
        cpu_ms[i] = read_ms(CLOCK_PROCESS_CPUTIME_ID) - cpu_start_ms;
    }
    std::sort(cpu_ms.begin(), cpu_ms.end());
    std::sort(wall_ms.begin(), wall_ms.end());
    return {cpu_ms[kRounds / 2], wall_ms[kRounds / 2]};
}

template <typename Work>
double median_cpu_ms(const Work& work) {
    return median_times(work).cpu_ms;
}

void fill(GridMap& map, Cell low, Cell high, CellState state) {
    for (std::int32_t y = low.y; y <= high.y; ++y) {
        for (std::int32_t x = low.x; x <= high.x; ++x) map.states.at({x, y}) = state;
    }
}

/// Four rooms on a corridor, thin walls in a free square: five inner submaps and about 800 leaves,
/// like the paper's simulated workplace.
GridMap workplace() {
    GridMap map;
    map.resolution_m = 0.25;
    map.states = Raster<CellState>({0, 0}, 128, 128, CellState::free);
    for (const std::int32_t y : {24, 56, 68, 100}) fill(map, {32, y}, {96, y}, CellState::occupied);
    for (const std::int32_t x : {32, 96}) fill(map, {x, 24}, {x, 100}, CellState::occupied);
    fill(map, {60, 24}, {60, 56}, CellState::occupied);
    fill(map, {72, 68}, {72, 100}, CellState::occupied);
    for (const std::int32_t y : {56, 68}) {
        fill(map, {44, y}, {47, y}, CellState::free);
        fill(map, {84, y}, {87, y}, CellState::free);
    }
    return map;
}

/// The segment between two centres column by column, each cell looked up in the table: the plain
/// way, kept here as the measure of the other.
class ColumnWalk {
public:
    explicit ColumnWalk(const LeafTable& table) : table_(table) {}

    [[nodiscard]] bool sees(HalfCell a, HalfCell b, std::int64_t clear_a,
                            std::int64_t clear_b) const {
        const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
        if (steep) {
            std::swap(a.x, a.y);
            std::swap(b.x, b.y);
        }
        if (b.x < a.x) {
            std::swap(a, b);
            std::swap(clear_a, clear_b);
        }
        const std::int64_t du = b.x - a.x;
        const std::int64_t dv = b.y - a.y;
        // The height at u, in cells, is height(u) / (2 du).
        const auto height = [&](std::int64_t u) { return a.y * du + (u - a.x) * dv; };
        for (std::int64_t u = a.x + clear_a; u <= b.x - clear_b; u += 2 - (u & 1)) {
            if ((u & 1) == 0 && height(u) % (2 * du) == 0 &&
                is_pinched(steep, u >> 1, height(u) / (2 * du))) {
                return false;
            }
            const std::int64_t next = std::min(u + 2 - (u & 1), b.x - clear_b);
            if (next <= u) break;
            const std::int64_t low = std::min(height(u), height(next));
            const std::int64_t high = std::max(height(u), height(next));
            const std::int64_t first = floor_divide(low, 2 * du);
            if (low == high && first * 2 * du == low) {
                if (blocked(steep, u >> 1, first - 1) && blocked(steep, u >> 1, first))
                    return false;
                continue;
            }
            for (std::int64_t row = first; row * 2 * du < high; ++row) {
                if (blocked(steep, u >> 1, row)) return false;
            }
        }
        return true;
    }

private:
    static std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
        return a / b - (a % b < 0 ? 1 : 0);
    }
    [[nodiscard]] bool blocked(bool steep, std::int64_t u, std::int64_t v) const {
        const Cell cell{static_cast<std::int32_t>(steep ? v : u),
                        static_cast<std::int32_t>(steep ? u : v)};
        const std::optional<LeafId> id = table_.find(cell);
        return !id.has_value() || table_.leaf(*id).state != CellState::free;
    }
    [[nodiscard]] bool is_pinched(bool steep, std::int64_t u, std::int64_t v) const {
        return (blocked(steep, u - 1, v - 1) && blocked(steep, u, v)) ||
               (blocked(steep, u, v - 1) && blocked(steep, u - 1, v));
    }

    const LeafTable& table_;
};

Json measure_line_of_sight(const LeafTable& table, const std::vector<LeafId>& nodes,
                           const std::vector<WeightedEdge>& edges) {
    Cell low = table.root().lower_left;
    const std::int32_t reach = table.root().side_cells() - 1;
    const BlockedCells blocked(table, low, {low.x + reach, low.y + reach});
    const ColumnWalk walk(table);
    const auto count = [&](const auto& test) {
        std::size_t num_clear = 0;
        for (const WeightedEdge& edge : edges) {
            num_clear += test(table.leaf(nodes[edge.a]), table.leaf(nodes[edge.b])) ? 1 : 0;
        }
        return num_clear;
    };
    const auto by_columns = [&](const Leaf& a, const Leaf& b) {
        return walk.sees(centre(a), centre(b), 0, 0);
    };
    const auto by_columns_between = [&](const Leaf& a, const Leaf& b) {
        return walk.sees(centre(a), centre(b), a.side_cells(), b.side_cells());
    };
    const auto by_bits = [&](const Leaf& a, const Leaf& b) {
        return blocked.sees(centre(a), centre(b));
    };
    const auto by_bits_between = [&](const Leaf& a, const Leaf& b) {
        return blocked.sees(centre(a), centre(b), a.side_cells(), b.side_cells());
    };
    const auto nanoseconds = [&](const auto& test) {
        std::size_t num_clear = 0;
        const double time_ms = median_cpu_ms([&] { num_clear = count(test); });
        if (num_clear != edges.size()) {
            throw std::logic_error("the tests of line of sight do not agree");
        }
        return time_ms * 1e6 / static_cast<double>(edges.size());
    };
    Json json;
    json["cells_ns"] = nanoseconds(by_columns);
    json["cells_between_the_leaves_ns"] = nanoseconds(by_columns_between);
    json["bits_ns"] = nanoseconds(by_bits);
    json["bits_between_the_leaves_ns"] = nanoseconds(by_bits_between);
    json["bits_build_ms"] = median_cpu_ms([&] {
        (void)BlockedCells(table, low, {low.x + reach, low.y + reach});
    });
    return json;
}

std::vector<double> multiply_dense(const std::vector<double>& matrix,
                                   const std::vector<double>& x) {
    std::vector<double> y(x.size(), 0.0);
    for (std::size_t row = 0; row < x.size(); ++row) {
        double sum = 0.0;
        for (std::size_t column = 0; column < x.size(); ++column) {
            sum += matrix[row * x.size() + column] * x[column];
        }
        y[row] = sum;
    }
    return y;
}

Json measure_storage(const Graph& graph) {
    const std::vector<double> x(graph.num_nodes(), 1.0);
    double sink = 0.0;
    Json json;
    json["num_entries"] = graph.columns.size();
    json["num_diagonals"] = diagonal_offsets(graph).size();
    json["dense_bytes"] = dense_bytes(graph);
    json["dia_bytes"] = dia_bytes(graph);
    json["csr_bytes"] = csr_bytes(graph);
    json["dense_product_ms"] = nullptr;
    json["dia_product_ms"] = nullptr;
    if (dense_bytes(graph) <= kMaxMatrixBytes) {
        std::vector<double> dense(graph.num_nodes() * graph.num_nodes(), 0.0);
        for (std::size_t row = 0; row < graph.num_nodes(); ++row) {
            for (std::size_t k = graph.row_begin[row]; k < graph.row_begin[row + 1]; ++k) {
                dense[row * graph.num_nodes() + graph.columns[k]] = graph.weights[k];
            }
        }
        json["dense_product_ms"] = median_cpu_ms([&] { sink += multiply_dense(dense, x)[0]; });
    }
    if (dia_bytes(graph) <= kMaxMatrixBytes) {
        const DiaMatrix matrix = build_dia(graph, kMaxMatrixBytes);
        json["dia_product_ms"] = median_cpu_ms([&] { sink += multiply(matrix, x)[0]; });
    }
    json["csr_product_ms"] = median_cpu_ms([&] { sink += multiply(graph, x)[0]; });
    // So that no product is optimised away.
    if (sink < 0.0) std::puts("negative weights");
    return json;
}

Json measure_edges(std::size_t num_nodes, const auto& edges_of) {
    std::size_t num_edges = 0;
    const Times one = median_times([&] { num_edges = edges_of(Executor{1}).size(); });
    const Times two = median_times([&] { num_edges = edges_of(Executor{2}).size(); });
    const auto count = static_cast<double>(num_edges);
    Json json;
    json["num_edges"] = num_edges;
    json["entries_per_node"] = 2.0 * count / static_cast<double>(num_nodes);
    json["cpu_ms"] = one.cpu_ms;
    json["one_thread_wall_ms"] = one.wall_ms;
    json["two_threads_wall_ms"] = two.wall_ms;
    json["edges_per_cpu_s"] = count / one.cpu_ms * 1000.0;
    return json;
}

Json measure(const std::string& name, const GridMap& map) {
    const OccupancyMap occupancy = OccupancyMap::from_grid(map);
    const LeafTable table(occupancy.leaves(), occupancy.root());
    std::vector<LeafId> nodes;
    for (std::uint32_t i = 0; i < table.leaves().size(); ++i) {
        if (table.leaves()[i].state == CellState::free) nodes.push_back(LeafId{i});
    }
    Json json;
    json["input"] = name;
    json["width"] = map.states.width;
    json["height"] = map.states.height;
    json["num_leaves"] = table.leaves().size();
    json["num_nodes"] = nodes.size();
    if (nodes.empty()) return json;
    json["sight"] = measure_edges(nodes.size(), [&](const Executor& executor) {
        return sight_edges(table, nodes, map.resolution_m, SelfLoops::none, executor);
    });
    const std::vector<WeightedEdge> edges =
        sight_edges(table, nodes, map.resolution_m, SelfLoops::own_weight);
    const std::vector<double> areas_m2 = leaf_areas_m2(table, nodes, map.resolution_m);
    json["build_graph_ms"] = median_cpu_ms([&] { (void)build_graph(edges, areas_m2).num_nodes(); });
    std::vector<WeightedEdge> pairs = edges;
    std::erase_if(pairs, [](const WeightedEdge& edge) { return edge.a == edge.b; });
    json["line_of_sight"] = measure_line_of_sight(table, nodes, pairs);
    json["storage"] = measure_storage(build_graph(edges, areas_m2));
    return json;
}

std::vector<std::string> maps_to_measure() {
    const std::filesystem::path folder(QUADCUT_SHARED_DIR);
    std::vector<std::string> found;
    for (const std::string_view name :
         {"data/rooms/lab_intel.plain.yaml", "data/rooms/office_e.furnished.yaml",
          "data/rooms/NLB.furnished.yaml", "data/rooms/kth_50015847.plain.yaml"}) {
        if (std::filesystem::exists(folder / name)) found.push_back((folder / name).string());
    }
    return found;
}

void print(const Json& json) {
    std::printf("%s: %zu free of %zu leaves\n", json["input"].get<std::string>().c_str(),
                json["num_nodes"].get<std::size_t>(), json["num_leaves"].get<std::size_t>());
    if (!json.contains("sight")) return;
    const Json& edges = json["sight"];
    std::printf(
        "  %9zu edges, %5.1f entries a node, %8.2f ms of CPU, %8.2f ms on one thread, "
        "%8.2f ms on two\n",
        edges["num_edges"].get<std::size_t>(), edges["entries_per_node"].get<double>(),
        edges["cpu_ms"].get<double>(), edges["one_thread_wall_ms"].get<double>(),
        edges["two_threads_wall_ms"].get<double>());
    const Json& sight = json["line_of_sight"];
    std::printf(
        "  one line of sight: cells %.0f ns, between the leaves %.0f ns; bits %.0f ns, "
        "between the leaves %.0f ns\n",
        sight["cells_ns"].get<double>(), sight["cells_between_the_leaves_ns"].get<double>(),
        sight["bits_ns"].get<double>(), sight["bits_between_the_leaves_ns"].get<double>());
    const Json& storage = json["storage"];
    for (const std::string kind : {"dense", "dia", "csr"}) {
        std::printf("  %-5s %14zu bytes", kind.c_str(),
                    storage[kind + "_bytes"].get<std::size_t>());
        const Json& product_ms = storage[kind + "_product_ms"];
        if (product_ms.is_null()) {
            std::printf(", not built\n");
        } else {
            std::printf(", product %9.4f ms\n", product_ms.get<double>());
        }
    }
}

int run(const std::vector<std::string>& arguments) {
    std::string output;
    std::vector<std::string> maps;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == "-o" && i + 1 < arguments.size()) {
            output = arguments[++i];
        } else {
            maps.push_back(arguments[i]);
        }
    }
    if (maps.empty()) maps = maps_to_measure();
    Json all = Json::array();
    all.push_back(measure("workplace", workplace()));
    print(all.back());
    for (const std::string& path : maps) {
        const std::string name = std::filesystem::path(path).filename().string();
        all.push_back(measure(name, io::read_map(path).map));
        print(all.back());
    }
    write_results(output, "graph", std::move(all));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) {
    try {
        return quadcut::run(std::vector<std::string>(argv + 1, argv + argc));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "micro_graph: %s\n", error.what());
        return 2;
    }
}
