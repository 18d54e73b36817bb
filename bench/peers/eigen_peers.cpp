// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/peers/eigen_peers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>

#include <nlohmann/json.hpp>

#include "bench/peers/spectra_solver.hpp"
#include "io/file.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/embedding.hpp"
#include "quadcut/spectral/k_means.hpp"
#include "quadcut/spectral/laplacian.hpp"
#include "quadcut/spectral/pivoted_qr.hpp"

namespace quadcut::peers {
namespace {

constexpr LaplacianKind kKind = LaplacianKind::degree;
constexpr std::size_t kRefineSteps = 10;

/// Work on large graphs is measured fewer times.
int num_rounds(const Graph& graph) { return graph.num_nodes() > 300000 ? 2 : 7; }

double largest_residual(const Laplacian& laplacian, std::span<const double> values,
                        std::span<const double> vectors) {
    double largest = 0.0;
    std::vector<double> product(laplacian.size());
    for (std::size_t j = 0; j < values.size(); ++j) {
        const auto vector = vectors.subspan(j * product.size(), product.size());
        laplacian.apply(vector, product);
        double squared = 0.0;
        for (std::size_t i = 0; i < product.size(); ++i) {
            squared += std::pow(product[i] - values[j] * vector[i], 2);
        }
        largest = std::max(largest, std::sqrt(squared));
    }
    return largest;
}

}  // namespace

EigenRun run_ours(const Graph& graph, std::size_t count, int num_threads) {
    EigenRun run;
    run.solver = "quadcut, " + std::to_string(num_threads) + " thread";
    if (num_threads > 1) run.solver += 's';
    Eigenpairs pairs;
    run.time = shortest(num_rounds(graph), [&] {
        pairs = smallest_eigenpairs(graph, kKind, count, {}, {num_threads});
    });
    run.values = pairs.values;
    run.largest_residual = largest_residual(Laplacian(graph, kKind), pairs.values, pairs.vectors);
    return run;
}

EigenRun run_our_clustering(const Graph& graph, std::size_t count) {
    EigenRun run;
    run.solver = "quadcut, clusters too";
    run.time = shortest(num_rounds(graph), [&] {
        const Embedding samples = embed(smallest_eigenpairs(graph, kKind, count), count);
        (void)refine_k_means(samples, cluster_pivoted_qr(samples), kRefineSteps).inertia;
    });
    return run;
}

EigenRun run_spectra(const Graph& graph, std::size_t count) {
    EigenRun run;
    run.solver = "Spectra, shift-invert";
#ifdef QUADCUT_HAS_SPECTRA
    const Laplacian laplacian(graph, kKind);
    SpectraAnswer answer;
    run.time =
        shortest(num_rounds(graph) / 2, [&] { answer = solve_with_spectra(laplacian, count); });
    run.values = answer.values;
    run.largest_residual =
        largest_residual(laplacian, answer.values,
                         {answer.vectors.data(), static_cast<std::size_t>(answer.vectors.size())});
    if (!answer.is_successful) run.failure = "did not converge";
#else
    (void)graph;
    (void)count;
    run.failure = "libspectra-dev is not installed";
#endif
    return run;
}

EigenRun run_python(const std::string& method, const std::filesystem::path& graph,
                    std::size_t count, int limit_s) {
    EigenRun run;
    run.solver = method;
    const std::filesystem::path answer = graph.string() + "." + method + ".json";
    const std::string command =
        "timeout " + std::to_string(limit_s) +
        " " QUADCUT_PYTHON " '" QUADCUT_SOURCE_DIR "/bench/peers/peers.py' " + method + " '" +
        graph.string() + "' " + std::to_string(count) + " > '" + answer.string() + "'";
    const int status = std::system(command.c_str());
    if (status != 0) {
        constexpr int kTimedOut = 124;
        run.failure = WIFEXITED(status) && WEXITSTATUS(status) == kTimedOut
                          ? "not done after " + std::to_string(limit_s) + " s"
                          : "failed";
        return run;
    }
    const auto json = nlohmann::json::parse(io::read_file(answer));
    run.time = {json["wall_s"].get<double>(), json["cpu_s"].get<double>()};
    run.values = json.value("values", std::vector<double>{});
    run.largest_residual = json.value("largest_residual", 0.0);
    return run;
}

}  // namespace quadcut::peers
