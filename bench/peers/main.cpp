// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// The spectral stage beside its peers, on the border graphs of simulated buildings: 16 eigenpairs
// (SciPy's ARPACK, scikit-learn, Spectra), and the sparse product beside the memory's bandwidth.
//
//   peers [-o FILE.json] [--limit SECONDS] [NODES ...]
//
// NODES: 10000, 100000, 1000000, as many of them as wanted; all by default. --limit: what SciPy and
// scikit-learn may take for one solve (60): scikit-learn needs minutes at 10^5 nodes.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "bench/peers/bandwidth.hpp"
#include "bench/peers/eigen_peers.hpp"
#include "bench/peers/plan_graph.hpp"
#include "bench/result_file.hpp"
#include "io/file.hpp"
#include "quadcut/spectral/laplacian.hpp"

namespace quadcut::peers {
namespace {

constexpr std::size_t kNumPairs = 16;
constexpr LaplacianKind kKind = LaplacianKind::degree;
/// scikit-learn takes minutes at 10^5 nodes, and hours at 10^6.
constexpr std::size_t kMostForSklearn = 300000;

/// What gives a graph of about so many nodes.
struct Size {
    std::size_t num_nodes;
    int num_rooms;
    double resolution_m;
};
constexpr Size kSizes[] = {{10000, 22, 0.05}, {100000, 195, 0.05}, {1000000, 1000, 0.025}};

/// A folder of our own, gone with all that is in it at the end.
class Scratch {
public:
    Scratch() : path_(std::filesystem::temp_directory_path() / name()) {
        std::filesystem::create_directory(path_);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    static std::string name() { return "quadcut_peers_" + std::to_string(getpid()); }
    std::filesystem::path path_;
};

Json to_json(const Duration& time) { return {{"wall_s", time.wall_s}, {"cpu_s", time.cpu_s}}; }

void print_run(const EigenRun& run, const EigenRun& ours) {
    std::printf("| %s | ", run.solver.c_str());
    if (!run.failure.empty()) {
        std::printf("%s | | | | |\n", run.failure.c_str());
        return;
    }
    std::printf("%.3f | %.3f | %.2f | ", run.time.wall_s, run.time.cpu_s,
                run.time.cpu_s / ours.time.cpu_s);
    if (run.values.empty()) {
        std::printf(" | |\n");
        return;
    }
    double difference = run.values.size() == ours.values.size() ? 0.0 : 2.0;
    for (std::size_t j = 0; j < std::min(run.values.size(), ours.values.size()); ++j) {
        difference = std::max(difference, std::abs(run.values[j] - ours.values[j]));
    }
    std::printf("%.0e | %.0e |\n", run.largest_residual, difference);
}

Json compare_eigenpairs(const Graph& graph, int limit_s) {
    const Scratch scratch;
    const std::filesystem::path file = scratch.path() / "graph";
    write_graph(graph, file);
    std::vector<EigenRun> runs;
    std::printf(
        "\n| %zu eigenpairs | wall s | CPU s | CPU / ours | residual | values differ by |\n"
        "|---|---|---|---|---|---|\n",
        kNumPairs);
    const auto add = [&](EigenRun run) {
        runs.push_back(std::move(run));
        print_run(runs.back(), runs.front());
        std::fflush(stdout);
    };
    add(run_ours(graph, kNumPairs, 1));
    add(run_ours(graph, kNumPairs, 2));
    add(run_our_clustering(graph, kNumPairs));
    add(run_spectra(graph, kNumPairs));
    add(run_python("arpack", file, kNumPairs, limit_s));
    add(run_python("arpack-mmd", file, kNumPairs, limit_s));
    if (graph.num_nodes() <= kMostForSklearn) {
        add(run_python("sklearn", file, kNumPairs, limit_s));
    } else {
        EigenRun left_out;
        left_out.solver = "sklearn";
        left_out.failure = "left out: minutes at 10^5 nodes";
        add(left_out);
    }
    Json json = Json::array();
    for (const EigenRun& run : runs) {
        Json row{{"solver", run.solver}};
        if (run.failure.empty()) {
            row.update(to_json(run.time));
            row["values"] = run.values;
            row["largest_residual"] = run.largest_residual;
        } else {
            row["failure"] = run.failure;
        }
        json.push_back(row);
    }
    return json;
}

Json compare_product(const Graph& graph) {
    const Laplacian laplacian(graph, kKind);
    std::printf(
        "\n| threads | read GB/s | triad GB/s | product ms | product GB/s | of the reads | "
        "of the triad |\n|---|---|---|---|---|---|---|\n");
    Json json = Json::array();
    for (const int num_threads : {1, 2}) {
        const auto [bandwidth, product] =
            measure_product(laplacian, graph.columns.size(), {num_threads});
        const double rate = product.bytes / (1e-3 * product.ms);
        std::printf("| %d | %.1f | %.1f | %.2f | %.1f | %.0f %% | %.0f %% |\n", num_threads,
                    1e-9 * bandwidth.read, 1e-9 * bandwidth.triad, product.ms, 1e-9 * rate,
                    100.0 * rate / bandwidth.read, 100.0 * rate / bandwidth.triad);
        json.push_back({{"solver", "product, " + std::to_string(num_threads) + " threads"},
                        {"threads", num_threads},
                        {"read_bytes_per_s", bandwidth.read},
                        {"triad_bytes_per_s", bandwidth.triad},
                        {"product_ms", product.ms},
                        {"product_bytes", product.bytes}});
    }
    return json;
}

struct Arguments {
    std::string output;
    int limit_s = 60;
    std::vector<std::string> sizes;
};

Arguments read_arguments(const std::vector<std::string>& given) {
    Arguments arguments;
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (given[i] == "-o" && i + 1 < given.size()) {
            arguments.output = given[++i];
        } else if (given[i] == "--limit" && i + 1 < given.size()) {
            arguments.limit_s = std::stoi(given[++i]);
        } else {
            arguments.sizes.push_back(given[i]);
        }
    }
    return arguments;
}

int run(const Arguments& arguments) {
    Json all = Json::array();
    for (const Size& size : kSizes) {
        const std::string name = std::to_string(size.num_nodes);
        const auto& wanted = arguments.sizes;
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) {
            continue;
        }
        const Graph graph = plan_graph(size.num_rooms, size.resolution_m);
        std::printf("\n### %zu nodes, %zu entries: a building of %d rooms, cells of %g m\n",
                    graph.num_nodes(), graph.columns.size(), size.num_rooms, size.resolution_m);
        Json json{{"num_nodes", graph.num_nodes()},
                  {"num_entries", graph.columns.size()},
                  {"num_rooms", size.num_rooms},
                  {"resolution_m", size.resolution_m}};
        if (size.num_nodes >= 1000000) json["product"] = compare_product(graph);
        json["eigenpairs"] = compare_eigenpairs(graph, arguments.limit_s);
        for (const auto& [kind, rows] : json.items()) {
            if (!rows.is_array()) continue;
            for (const Json& row : rows) {
                Json whole{{"graph", name + " nodes"}, {"measured", kind}};
                whole.update(row);
                all.push_back(std::move(whole));
            }
        }
    }
    write_results(arguments.output, "peers", std::move(all));
    return 0;
}

}  // namespace
}  // namespace quadcut::peers

int main(int argc, char** argv) {
    try {
        return quadcut::peers::run(
            quadcut::peers::read_arguments(std::vector<std::string>(argv + 1, argv + argc)));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "peers: %s\n", error.what());
        return 2;
    }
}
