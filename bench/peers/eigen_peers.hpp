// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/peers/stop_watch.hpp"
#include "quadcut/spectral/graph.hpp"

namespace quadcut::peers {

/// The smallest eigenpairs of a graph's normalised Laplacian, or sixteen clusters, by one solver.
struct EigenRun {
    std::string solver;
    /// Of the solve, without reading and building the graph.
    Duration time;
    /// Ascending; empty where the solver gives clusters only.
    std::vector<double> values;
    /// |L v - lambda v|, as measured by the same product for all (SciPy: by SciPy's).
    double largest_residual = 0.0;
    /// Why there is no result.
    std::string failure;
};

/// Our solver, checks included.
[[nodiscard]] EigenRun run_ours(const Graph& graph, std::size_t count, int num_threads);
/// The same and ours to cluster: pivoted QR and ten steps of k-means.
[[nodiscard]] EigenRun run_our_clustering(const Graph& graph, std::size_t count);
/// Shift-invert Lanczos on Eigen's sparse factorisation.
[[nodiscard]] EigenRun run_spectra(const Graph& graph, std::size_t count);
/// A method of peers.py on the file of write_graph(); given up after `limit_s` seconds.
[[nodiscard]] EigenRun run_python(const std::string& method, const std::filesystem::path& graph,
                                  std::size_t count, int limit_s);

}  // namespace quadcut::peers
