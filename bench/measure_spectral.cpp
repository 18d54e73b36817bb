// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// The spectral stages over sizes of floor plans: eigenpairs by our solver and, where libspectra-dev
// is installed, by Spectra; clustering by pivoted QR and by k-means; silhouettes.
//
//   micro_spectral [-o FILE.json] [MAP ...]      maps as `quadcut segment` takes them

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "bench/border_graph.hpp"
#include "bench/result_file.hpp"
#include "bench/spectra_solver.hpp"
#include "io/map_server.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/graph.hpp"
#include "quadcut/spectral/k_means.hpp"
#include "quadcut/spectral/pivoted_qr.hpp"
#include "quadcut/spectral/silhouette.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kRounds = 5;
/// Work that takes longer is measured once.
constexpr double kLongMs = 1500.0;

double read_ms(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

/// The median of five calls, of the CPU time of all threads together: it does not grow when others
/// use the machine, or hardly.
template <typename Work>
double median_ms(const Work& work) {
    std::vector<double> times;
    while (times.size() < kRounds) {
        const double start = read_ms(CLOCK_PROCESS_CPUTIME_ID);
        work();
        times.push_back(read_ms(CLOCK_PROCESS_CPUTIME_ID) - start);
        if (times.back() > kLongMs) break;
    }
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

/// Square rooms of 120 cells a side in rows, walls of 3 cells, a door of 18 cells in each inner
/// wall, and pieces of furniture of 1 to 8 cells a side.
GridMap office(std::int32_t num_rooms_a_side, std::size_t pieces_a_room) {
    constexpr std::int32_t kStep = 123;
    Random random(1);
    GridMap map;
    map.resolution_m = 0.05;
    const std::int32_t side = num_rooms_a_side * kStep + 3;
    map.states = Raster<CellState>({0, 0}, side, side, CellState::free);
    const auto fill = [&](Cell low, std::int32_t width, std::int32_t height, CellState state) {
        for (std::int32_t y = low.y; y < std::min(side, low.y + height); ++y) {
            for (std::int32_t x = low.x; x < std::min(side, low.x + width); ++x) {
                map.states.at({x, y}) = state;
            }
        }
    };
    const auto below = [&](std::int32_t count) {
        return static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(count)));
    };
    for (std::int32_t k = 0; k <= num_rooms_a_side; ++k) {
        fill({k * kStep, 0}, 3, side, CellState::occupied);
        fill({0, k * kStep}, side, 3, CellState::occupied);
    }
    for (std::int32_t k = 1; k < num_rooms_a_side; ++k) {
        for (std::int32_t room = 0; room < num_rooms_a_side; ++room) {
            fill({k * kStep, room * kStep + 10 + below(80)}, 3, 18, CellState::free);
            fill({room * kStep + 10 + below(80), k * kStep}, 18, 3, CellState::free);
        }
    }
    const auto num_rooms = static_cast<std::size_t>(num_rooms_a_side * num_rooms_a_side);
    for (std::size_t i = 0; i < pieces_a_room * num_rooms; ++i) {
        fill({below(side), below(side)}, 1 + below(8), 1 + below(8), CellState::occupied);
    }
    return map;
}

#ifdef QUADCUT_HAS_SPECTRA
Json measure_spectra(const Graph& graph, const Eigenpairs& reference) {
    const Laplacian laplacian(graph, LaplacianKind::area);
    SpectraAnswer answer;
    Json json;
    json["cpu_ms"] = median_ms([&] { answer = solve_with_spectra(laplacian, reference.size()); });
    json["says_successful"] = answer.is_successful;
    double error = answer.values.size() == reference.size() ? 0.0 : 1.0;
    for (std::size_t j = 0; j < std::min(answer.values.size(), reference.size()); ++j) {
        error = std::max(error, std::abs(answer.values[j] - reference.values[j]));
    }
    json["largest_difference"] = error / laplacian.norm_bound();
    return json;
}

/// What Spectra makes of eight rooms without doors, for a few numbers of pairs.
Json measure_disconnected() {
    std::vector<WeightedEdge> edges;
    constexpr std::uint32_t kSide = 30;
    for (std::uint32_t i = 0; i < 8 * kSide * kSide; ++i) {
        if (i % kSide + 1 < kSide) edges.push_back({i, i + 1, 1.0});
        if (i % (kSide * kSide) + kSide < kSide * kSide) edges.push_back({i, i + kSide, 1.0});
    }
    const Graph rooms = build_graph(edges, std::vector<double>(8 * kSide * kSide, 1.0));
    const auto num_zeros = [](const std::vector<double>& values) {
        return std::count_if(values.begin(), values.end(),
                             [](double value) { return std::abs(value) < 1e-9; });
    };
    Json json = Json::array();
    for (const std::size_t count : {8U, 10U, 16U, 40U}) {
        const SpectraAnswer answer =
            solve_with_spectra(Laplacian(rooms, LaplacianKind::area), count);
        Json row;
        row["pairs"] = count;
        row["spectra_says_successful"] = answer.is_successful;
        row["spectra_zeros"] = num_zeros(answer.values);
        row["our_zeros"] = num_zeros(smallest_eigenpairs(rooms, LaplacianKind::area, count).values);
        json.push_back(row);
    }
    return json;
}
#endif

Json measure_eigenpairs(const Graph& graph, std::size_t count) {
    Json json;
    json["pairs"] = count;
    Eigenpairs pairs;
    for (const int num_threads : {1, 2}) {
        std::vector<double> wall_ms;
        const double cpu_ms = median_ms([&] {
            const double start = read_ms(CLOCK_MONOTONIC);
            pairs = smallest_eigenpairs(graph, LaplacianKind::area, count, {}, {num_threads});
            wall_ms.push_back(read_ms(CLOCK_MONOTONIC) - start);
        });
        std::sort(wall_ms.begin(), wall_ms.end());
        if (num_threads == 1) json["cpu_ms"] = cpu_ms;
        json[num_threads == 1 ? "one_thread_wall_ms" : "two_threads_wall_ms"] =
            wall_ms[wall_ms.size() / 2];
    }
    json["largest_eigenvalue_per_m2"] = pairs.values.back();
    const double norm = Laplacian(graph, LaplacianKind::area).norm_bound();
    json["largest_residual_of_norm"] =
        *std::max_element(pairs.residuals.begin(), pairs.residuals.end()) / norm;
    const double limit = pairs.values.back() * (1.0 + 1e-6);
    json["below_limit_cpu_ms"] =
        median_ms([&] { (void)eigenpairs_below(graph, LaplacianKind::area, limit, count).size(); });
#ifdef QUADCUT_HAS_SPECTRA
    if (static_cast<double>(count) * static_cast<double>(graph.num_nodes()) < 3e6) {
        json["spectra"] = measure_spectra(graph, pairs);
    }
#endif
    return json;
}

Json measure_clustering(const Graph& graph, std::size_t count) {
    const Eigenpairs pairs = smallest_eigenpairs(graph, LaplacianKind::area, count);
    const Embedding samples = embed(pairs, count);
    Json json;
    json["clusters"] = count;
    Clustering clusters;
    KMeansResult result;
    json["pivoted_qr_ms"] = median_ms([&] { clusters = cluster_pivoted_qr(samples); });
    json["refine_ten_steps_ms"] =
        median_ms([&] { result = refine_k_means(samples, clusters, 10); });
    json["refined_inertia"] = result.inertia;
    json["k_means_five_starts_ms"] = median_ms([&] { result = cluster_k_means(samples, count); });
    json["k_means_inertia"] = result.inertia;
    json["mean_silhouette_ms"] =
        median_ms([&] { (void)mean_silhouette(samples, result.clustering); });
    if (count == 30) {
        ChosenClustering chosen;
        json["choose_num_clusters_ms"] = median_ms([&] { chosen = choose_num_clusters(pairs); });
        json["chosen"] = chosen.clustering.num_clusters;
    }
    return json;
}

Json measure(const std::string& name, const GridMap& map) {
    const Graph graph = border_graph(map);
    Json json;
    json["input"] = name;
    json["num_nodes"] = graph.num_nodes();
    json["num_entries"] = graph.columns.size();
    const Laplacian laplacian(graph, LaplacianKind::area);
    const std::vector<double> x(graph.num_nodes(), 1.0);
    std::vector<double> product(graph.num_nodes());
    json["laplacian_ms"] =
        median_ms([&] { (void)Laplacian(graph, LaplacianKind::area).norm_bound(); });
    json["apply_ms"] = median_ms([&] { laplacian.apply(x, product); });
    std::printf("%s: %zu nodes\n", name.c_str(), graph.num_nodes());
    for (const std::size_t count : {2U, 10U, 24U, 50U, 100U, 300U}) {
        if (10 * count > graph.num_nodes()) continue;
        const Json row = measure_eigenpairs(graph, count);
        json["eigenpairs"].push_back(row);
        std::printf("  %3zu pairs: %8.1f ms of CPU, %8.1f ms on two threads, below a limit %8.1f",
                    count, row["cpu_ms"].get<double>(), row["two_threads_wall_ms"].get<double>(),
                    row["below_limit_cpu_ms"].get<double>());
        if (row.contains("spectra")) {
            std::printf(", Spectra %8.1f (differs by %.0e)", row["spectra"]["cpu_ms"].get<double>(),
                        row["spectra"]["largest_difference"].get<double>());
        }
        std::printf("\n");
    }
    for (const std::size_t count : {24U, 30U, 56U}) {
        if (20 * count > graph.num_nodes()) continue;
        const Json row = measure_clustering(graph, count);
        json["clustering"].push_back(row);
        std::printf(
            "  %3zu clusters: pivoted QR %.1f ms, ten steps %.1f, k-means %.1f, "
            "silhouette %.1f",
            count, row["pivoted_qr_ms"].get<double>(), row["refine_ten_steps_ms"].get<double>(),
            row["k_means_five_starts_ms"].get<double>(), row["mean_silhouette_ms"].get<double>());
        if (row.contains("choose_num_clusters_ms")) {
            std::printf(", choice of 2 to 30 %.1f", row["choose_num_clusters_ms"].get<double>());
        }
        std::printf("\n");
    }
    std::fflush(stdout);
    return json;
}

std::vector<std::string> maps_to_measure() {
    const std::filesystem::path folder(QUADCUT_SHARED_DIR);
    std::vector<std::string> found;
    for (const std::string_view name :
         {"data/rooms/lab_intel.plain.yaml", "data/rooms/NLB.furnished.yaml",
          "data/rooms/kth_50015847.plain.yaml"}) {
        if (std::filesystem::exists(folder / name)) found.push_back((folder / name).string());
    }
    return found;
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
    for (const std::int32_t rooms : {2, 4, 8, 18}) {
        const std::string name = "office of " + std::to_string(rooms * rooms) + " rooms";
        all.push_back(measure(name, office(rooms, 10)));
    }
    for (const std::string& path : maps) {
        const std::string name = std::filesystem::path(path).filename().string();
        all.push_back(measure(name, io::read_map(path).map));
    }
#ifdef QUADCUT_HAS_SPECTRA
    const Json disconnected = measure_disconnected();
    all.push_back({{"input", "eight rooms without doors"}, {"eigenpairs", disconnected}});
    for (const Json& row : disconnected) {
        std::printf("eight rooms, %zu pairs: Spectra %s, %zu zeros of 8; ours %zu\n",
                    row["pairs"].get<std::size_t>(),
                    row["spectra_says_successful"].get<bool>() ? "successful" : "not successful",
                    row["spectra_zeros"].get<std::size_t>(), row["our_zeros"].get<std::size_t>());
    }
#endif
    write_results(output, "spectral", std::move(all));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) {
    try {
        return quadcut::run(std::vector<std::string>(argv + 1, argv + argc));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "micro_spectral: %s\n", error.what());
        return 2;
    }
}
