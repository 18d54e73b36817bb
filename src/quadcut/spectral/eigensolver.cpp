// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/eigensolver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "quadcut/spectral/connected_solver.hpp"

namespace quadcut {
namespace {

/// Shares of the norm: eigenvalues this close count as equal; the slack of a limit.
constexpr double kEqual = 1e-10;
constexpr double kSlack = 1e-9;

std::vector<std::vector<std::uint32_t>> nodes_by_component(const Graph& graph) {
    const std::vector<std::uint32_t> component = connected_components(graph);
    std::vector<std::vector<std::uint32_t>> nodes;
    for (std::uint32_t i = 0; i < component.size(); ++i) {
        if (component[i] >= nodes.size()) nodes.resize(component[i] + std::size_t{1});
        nodes[component[i]].push_back(i);
    }
    return nodes;
}

/// One candidate of the merged spectrum.
struct Candidate {
    /// The eigenvalue in steps of what counts as equal.
    double rank = 0.0;
    std::uint32_t component = 0;
    std::uint32_t index = 0;

    friend bool operator<(const Candidate& a, const Candidate& b) {
        if (a.rank != b.rank) return a.rank < b.rank;
        if (a.component != b.component) return a.component < b.component;
        return a.index < b.index;
    }
};

Eigenpairs solve_and_merge(const Graph& graph, LaplacianKind kind, const SpectrumRequest& request,
                           const EigenOptions& options, const Executor& executor) {
    const double norm = Laplacian(graph, kind).norm_bound();
    const auto nodes = nodes_by_component(graph);
    std::vector<std::uint32_t> by_size(nodes.size());
    std::iota(by_size.begin(), by_size.end(), 0U);
    std::stable_sort(by_size.begin(), by_size.end(), [&](std::uint32_t a, std::uint32_t b) {
        return nodes[a].size() > nodes[b].size();
    });

    // The largest component first: its spectrum limits what the others are asked for.
    std::vector<ConnectedPairs> solved(nodes.size());
    std::vector<Candidate> candidates;
    SpectrumRequest part = request;
    for (const std::uint32_t c : by_size) {
        // Each component has an eigenvalue zero, and no smaller one.
        const bool full = candidates.size() == request.max_count;
        if (full && (candidates.empty() || !(Candidate{0.0, c, 0} < candidates.back()))) continue;
        solved[c] = solve_connected(Laplacian(induced_subgraph(graph, nodes[c]), kind), part,
                                    options, executor);
        for (std::uint32_t j = 0; j < solved[c].values.size(); ++j) {
            candidates.push_back({std::round(solved[c].values[j] / (kEqual * norm)), c, j});
        }
        std::sort(candidates.begin(), candidates.end());
        if (candidates.size() < request.max_count) continue;
        candidates.resize(request.max_count);
        const Candidate& last = candidates.back();
        part.limit =
            std::min(part.limit, solved[last.component].values[last.index] + kSlack * norm);
    }

    Eigenpairs pairs;
    pairs.num_nodes = graph.num_nodes();
    pairs.vectors.assign(candidates.size() * pairs.num_nodes, 0.0);
    for (std::size_t j = 0; j < candidates.size(); ++j) {
        const Candidate& from = candidates[j];
        const ConnectedPairs& source = solved[from.component];
        const auto& members = nodes[from.component];
        pairs.values.push_back(source.values[from.index]);
        pairs.components.push_back(from.component);
        pairs.residuals.push_back(source.residuals[from.index]);
        for (std::size_t i = 0; i < members.size(); ++i) {
            pairs.vectors[j * pairs.num_nodes + members[i]] =
                source.vectors[from.index * members.size() + i];
        }
    }
    return pairs;
}

}  // namespace

Eigenpairs smallest_eigenpairs(const Graph& graph, LaplacianKind kind, std::size_t count,
                               const EigenOptions& options, const Executor& executor) {
    return solve_and_merge(graph, kind, {std::numeric_limits<double>::infinity(), count}, options,
                           executor);
}

Eigenpairs eigenpairs_below(const Graph& graph, LaplacianKind kind, double limit,
                            std::size_t max_count, const EigenOptions& options,
                            const Executor& executor) {
    if (std::isnan(limit)) throw std::logic_error("eigenpairs_below: the limit is not a number");
    return solve_and_merge(graph, kind, {limit, max_count}, options, executor);
}

}  // namespace quadcut
