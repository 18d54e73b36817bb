// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// The OpenCL device against the CPU: the edge stage on maps, and the block product of the
// eigensolver on the graphs of these; the least of rounds that take turns. And what the
// roofline estimate says of the same maps on a GPU.
//
//   measure_opencl [-o FILE.json] [MAP ...]      maps as `quadcut segment` takes them

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "bench/cases.hpp"
#include "bench/cpu_time.hpp"
#include "bench/result_file.hpp"
#include "io/map_server.hpp"
#include "opencl/accelerator.hpp"
#include "opencl/roofline.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/paper/visibility.hpp"
#include "quadcut/spectral/laplacian.hpp"
#include "reproduce/timing.hpp"
#include "sim/building.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kRounds = 25;
constexpr std::size_t kVectors = 30;

struct Times {
    double wall_ms = std::numeric_limits<double>::infinity();
    /// Of all threads together, PoCL's with them: does not grow when others use the machine.
    double cpu_ms = std::numeric_limits<double>::infinity();
};

Times times_of(const std::function<void()>& work) {
    const double cpu_before_ms = cpu_ms();
    const double wall_ms = elapsed_ms(work);
    return {wall_ms, cpu_ms() - cpu_before_ms};
}

/// The shortest times of each of some works that take turns.
std::vector<Times> shortest_times(const std::vector<std::function<void()>>& works) {
    std::vector<Times> shortest(works.size());
    for (std::size_t round = 0; round < kRounds; ++round) {
        for (std::size_t i = 0; i < works.size(); ++i) {
            const Times times = times_of(works[i]);
            shortest[i].wall_ms = std::min(shortest[i].wall_ms, times.wall_ms);
            shortest[i].cpu_ms = std::min(shortest[i].cpu_ms, times.cpu_ms);
        }
    }
    return shortest;
}

Json as_json(const std::vector<Times>& times) {
    Json json;
    const char* const names[] = {"cpu_1", "cpu_2", "device"};
    for (std::size_t i = 0; i < times.size(); ++i) {
        json[names[i]] = {{"wall", times[i].wall_ms}, {"cpu", times[i].cpu_ms}};
    }
    return json;
}

/// The device, which must do what it is asked for.
class Measured {
public:
    Measured()
        : accelerator_({.accept_cpu = true}, [this](const std::string& why) { why_ = why; }) {}

    std::vector<WeightedEdge> edges(const FreeLeaves& leaves, double resolution_m) {
        auto found = accelerator_.sight_edges(leaves.table, leaves.nodes, resolution_m,
                                              SelfLoops::own_weight);
        if (!found.has_value()) throw std::runtime_error(why_);
        return std::move(*found);
    }
    opencl::OpenClAccelerator& accelerator() { return accelerator_; }

private:
    std::string why_ = "declined";
    opencl::OpenClAccelerator accelerator_;
};

Json on(const StageWork& work, MachineRates machine) {
    const double with_start_s = stage_s(work, machine);
    machine.start_s = 0.0;
    return {{"ms", 1e3 * stage_s(work, machine)}, {"with_start_ms", 1e3 * with_start_s}};
}

/// Edges with the same first end, which are together: finish_edges is quadratic in them.
std::size_t longest_row(const std::vector<WeightedEdge>& edges) {
    std::size_t longest = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (edges[i].a != edges[first].a) first = i;
        longest = std::max(longest, i + 1 - first);
    }
    return longest;
}

Json measure(const std::string& name, const GridMap& map, Measured& device) {
    const FreeLeaves leaves = free_leaves(map);
    const double resolution_m = map.resolution_m;
    const auto on_cpu = [&](int num_threads) {
        return sight_edges(leaves.table, leaves.nodes, resolution_m, SelfLoops::own_weight,
                           {num_threads});
    };
    const std::vector<WeightedEdge> edges = on_cpu(1);
    const std::vector<WeightedEdge> of_device = device.edges(leaves, resolution_m);
    const auto same = [](const WeightedEdge& p, const WeightedEdge& q) {
        return p.a == q.a && p.b == q.b && p.weight == q.weight;
    };
    if (!std::equal(edges.begin(), edges.end(), of_device.begin(), of_device.end(), same)) {
        throw std::runtime_error(name + ": the edges differ");
    }
    const std::vector<Times> edge_times =
        shortest_times({[&] { (void)on_cpu(1).size(); }, [&] { (void)on_cpu(2).size(); },
                        [&] { (void)device.edges(leaves, resolution_m).size(); }});
    const opencl::Traffic traffic = device.accelerator().traffic();

    const Laplacian laplacian(
        build_graph(edges, leaf_areas_m2(leaves.table, leaves.nodes, resolution_m)),
        LaplacianKind::degree);
    std::vector<double> block(kVectors * laplacian.size());
    for (std::size_t i = 0; i < block.size(); ++i) block[i] = std::sin(static_cast<double>(i));
    std::vector<double> product(block.size());
    const auto multiply = [&](const Executor& executor) {
        return [&, executor] { laplacian.apply_block(block, product, executor); };
    };
    const std::vector<Times> product_times =
        shortest_times({multiply({1}), multiply({2}), multiply({1, &device.accelerator()})});

    const std::size_t num_entries = 2 * (edges.size() - leaves.nodes.size());
    const EdgeStageSize size{leaves.nodes.size(), leaves.table.leaves().size(), edges.size(),
                             leaves.table.directory().values.size(), leaves.table.tiles().size()};
    const StageWork stage = edge_stage(size);
    const StageWork block_work = block_product(laplacian.size(), num_entries, kVectors);
    Json json;
    json["map"] = name;
    json["num_nodes"] = leaves.nodes.size();
    json["num_leaves"] = leaves.table.leaves().size();
    json["num_tiles"] = size.num_tiles;
    json["num_mixed_tiles"] = size.num_mixed_tiles;
    json["num_edges"] = edges.size();
    json["longest_row"] = longest_row(edges);
    json["edges_ms"] = as_json(edge_times);
    json["bytes_up"] = traffic.bytes_up;
    json["bytes_down"] = traffic.bytes_down;
    json["product_ms"] = as_json(product_times);
    json["estimate"] = {
        {"bytes_up", stage.bytes_up},
        {"bytes_down", stage.bytes_down},
        {"edges_cpu_2_ms", 1e3 * edge_stage_on_cpu_s(edges.size(), 2)},
        {"edges_discrete", on(stage, discrete_gpu())},
        {"edges_integrated", on(stage, integrated_gpu())},
        {"product_cpu_2_ms", 1e3 * block_product_on_cpu_s(num_entries, kVectors, 2)},
        {"product_discrete", on(block_work, discrete_gpu())},
        {"product_integrated", on(block_work, integrated_gpu())}};
    return json;
}

void print(const Json& json) {
    const auto number = [&](const char* pointer) {
        return json.at(Json::json_pointer(pointer)).get<double>();
    };
    std::printf("%s: %.0f nodes, %.0f edges, %.2f MB up, %.2f MB down\n",
                json["map"].get<std::string>().c_str(), number("/num_nodes"), number("/num_edges"),
                1e-6 * number("/bytes_up"), 1e-6 * number("/bytes_down"));
    for (const std::string kind : {"edges", "product"}) {
        const std::string measured = "/" + kind + "_ms/";
        const std::string estimate = "/estimate/" + kind + "_";
        std::printf(
            "  %-8s CPU %8.2f ms, two threads %8.2f ms, device %8.2f ms; of CPU time %8.2f ms and "
            "%8.2f ms; estimate: two threads %8.2f ms, discrete GPU %7.2f ms, integrated %7.2f "
            "ms\n",
            kind.c_str(), number((measured + "cpu_1/wall").c_str()),
            number((measured + "cpu_2/wall").c_str()), number((measured + "device/wall").c_str()),
            number((measured + "cpu_1/cpu").c_str()), number((measured + "device/cpu").c_str()),
            number((estimate + "cpu_2_ms").c_str()), number((estimate + "discrete/ms").c_str()),
            number((estimate + "integrated/ms").c_str()));
    }
}

/// Free leaves from which on a machine that has yet to start beats two threads, to a tenth; maps
/// like one that was measured. 0: never.
double smallest_that_pays(const Json& json, const MachineRates& machine) {
    for (double factor = 0.01; factor < 1e5; factor *= 1.1) {
        const auto scaled = [&](const char* name) {
            return static_cast<std::size_t>(factor * json.at(name).get<double>());
        };
        const EdgeStageSize size{scaled("num_nodes"), scaled("num_leaves"), scaled("num_edges"),
                                 scaled("num_tiles"), scaled("num_mixed_tiles")};
        if (stage_s(edge_stage(size), machine) < edge_stage_on_cpu_s(size.num_edges, 2)) {
            return static_cast<double>(size.num_nodes);
        }
    }
    return 0.0;
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

/// A building that is larger than any of the data.
GridMap large_building() {
    sim::BuildingOptions options;
    options.seed = 5001;
    options.num_rooms = 400;
    options.furniture = 0.5;
    return sim::generate_building(options).map;
}

int run(int argc, char** argv) {
    std::vector<std::string> maps;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "-o") {
            ++i;
        } else {
            maps.emplace_back(argv[i]);
        }
    }
    const bool is_standard = maps.empty();
    if (is_standard) maps = maps_to_measure();
    Measured device;
    FreeLeaves tiny =
        free_leaves(GridMap{0.05, {}, Raster<CellState>({0, 0}, 8, 8, CellState::free)});
    const double start_ms = times_of([&] { (void)device.edges(tiny, 0.05).size(); }).wall_ms;
    std::printf("start: library, device, kernels, check: %.1f ms\n", start_ms);
    Json all = {{"start_ms", start_ms}, {"maps", Json::array()}};
    const auto add = [&](const std::string& name, const GridMap& map) {
        all["maps"].push_back(measure(name, map, device));
        print(all["maps"].back());
    };
    for (const std::string& path : maps) {
        add(std::filesystem::path(path).filename().string(), io::read_map(path).map);
    }
    if (is_standard) add("building of 400 rooms", large_building());
    for (const auto& [name, machine] :
         {std::pair{"discrete", discrete_gpu()}, std::pair{"integrated", integrated_gpu()}}) {
        const double pays_from = smallest_that_pays(all["maps"].back(), machine);
        std::printf("estimate: with its start, a GPU (%s) pays from %.0f free leaves (0: never)\n",
                    name, pays_from);
        all["pays_from_nodes"][name] = pays_from;
    }
    Json rows = all["maps"];
    rows.push_back({{"map", "start"},
                    {"start_ms", all["start_ms"]},
                    {"pays_from_nodes", all["pays_from_nodes"]}});
    write_results(output_path(argc, argv), "opencl", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
