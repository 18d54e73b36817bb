// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/spectral/multilevel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <utility>

#include "quadcut/spectral/coarsen.hpp"
#include "quadcut/spectral/eigensolver.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kCoarseNodesPerPart = 32;
constexpr std::size_t kMinCoarseNodes = 1024;
/// A coarse node's volume, in average ones of the coarsest graph.
constexpr double kMaxShare = 2.0;

/// What its nodes' volumes and the weights of the edges that leave it come to.
struct Part {
    double volume = 0.0;
    double cut = 0.0;

    /// Where the volume is no more than rounding errors, too much for any cut.
    [[nodiscard]] double cost() const {
        if (cut <= 0.0) return 0.0;
        return volume > 0.0 ? cut / volume : std::numeric_limits<double>::infinity();
    }
};

/// Calls `visit(other node, weight)` for each edge of a node but loops.
template <typename Visit>
void for_each_edge(const Graph& graph, std::uint32_t node, const Visit& visit) {
    for (std::size_t k = graph.row_begin[node]; k < graph.row_begin[node + 1]; ++k) {
        if (graph.columns[k] != node) visit(graph.columns[k], graph.weights[k]);
    }
}

double degree(const Graph& graph, std::uint32_t node) {
    double sum = 0.0;
    for_each_edge(graph, node, [&](std::uint32_t, double weight) { sum += weight; });
    return sum;
}

std::vector<Part> measure_parts(const Graph& graph, std::span<const double> volumes,
                                std::span<const std::uint32_t> part_of_node) {
    std::vector<Part> parts;
    for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
        const std::uint32_t own = part_of_node[node];
        if (own >= parts.size()) parts.resize(own + std::size_t{1});
        parts[own].volume += volumes[node];
        for_each_edge(graph, node, [&](std::uint32_t other, double weight) {
            if (part_of_node[other] != own) parts[own].cut += weight;
        });
    }
    return parts;
}

/// A part of the coarsest graph, and the cheapest way found to cut it in two.
struct Split {
    /// What the cut would add to the normalised cut.
    double cost = 0.0;
    /// The nodes of the part; the cut is before `middle`.
    std::vector<std::uint32_t> nodes;
    std::size_t middle = 0;

    bool operator<(const Split& other) const { return cost > other.cost; }
};

/// Cuts along the second eigenvector, at the best of all places (Shi and Malik's sweep).
Split find_split(const Graph& graph, std::vector<std::uint32_t> nodes) {
    Split split{0.0, std::move(nodes), 0};
    if (split.nodes.size() < 2) return split;
    const Graph part = induced_subgraph(graph, split.nodes);
    const Eigenpairs pairs = smallest_eigenpairs(part, LaplacianKind::area, 2);
    std::vector<double> height(part.num_nodes());
    for (std::size_t i = 0; i < height.size(); ++i) {
        height[i] = pairs.vector(1)[i] / std::sqrt(part.area_m2[i]);
    }
    std::vector<std::uint32_t> order(part.num_nodes());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(height[a], a) < std::pair(height[b], b);
    });

    Part whole;
    for (std::uint32_t i = 0; i < part.num_nodes(); ++i) {
        whole.volume += part.area_m2[i];
        whole.cut += degree(graph, split.nodes[i]) - degree(part, i);
    }
    std::vector<char> is_below(part.num_nodes(), 0);
    Part below;
    Part above = whole;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        const std::uint32_t node = order[i];
        is_below[node] = 1;
        double to_below = 0.0;
        for_each_edge(part, node, [&](std::uint32_t other, double weight) {
            if (is_below[other] != 0) to_below += weight;
        });
        const double to_all = degree(graph, split.nodes[node]);
        below.volume += part.area_m2[node];
        below.cut += to_all - 2.0 * to_below;
        above.volume -= part.area_m2[node];
        above.cut += 2.0 * (degree(part, node) - to_below) - to_all;
        const double cost = below.cost() + above.cost() - whole.cost();
        if (split.middle == 0 || cost < split.cost) {
            split.cost = cost;
            split.middle = i + 1;
        }
    }
    for (std::uint32_t& node : order) node = split.nodes[node];
    split.nodes = std::move(order);
    return split;
}

/// Cuts the graph in two, then the part of all whose cut costs least, and so on.
std::vector<std::uint32_t> cut_coarsest(const Graph& graph, std::size_t num_parts) {
    std::vector<std::uint32_t> part_of_node(graph.num_nodes(), 0);
    std::vector<std::uint32_t> all(graph.num_nodes());
    std::iota(all.begin(), all.end(), 0U);
    std::priority_queue<Split> splits;
    const auto consider = [&](std::vector<std::uint32_t> nodes) {
        std::sort(nodes.begin(), nodes.end());
        Split split = find_split(graph, std::move(nodes));
        if (split.middle > 0) splits.push(std::move(split));
    };
    consider(std::move(all));
    for (std::uint32_t next = 1; next < num_parts && !splits.empty(); ++next) {
        const Split split = splits.top();
        splits.pop();
        const auto middle = split.nodes.begin() + static_cast<std::ptrdiff_t>(split.middle);
        std::for_each(middle, split.nodes.end(),
                      [&](std::uint32_t node) { part_of_node[node] = next; });
        consider({split.nodes.begin(), middle});
        consider({middle, split.nodes.end()});
    }
    return part_of_node;
}

/// Moves nodes between parts while that lowers the normalised cut.
class Refiner {
public:
    Refiner(const Graph& graph, std::span<const double> volumes,
            std::vector<std::uint32_t>& part_of_node)
        : graph_(graph),
          volumes_(volumes),
          part_of_node_(part_of_node),
          parts_(measure_parts(graph, volumes, part_of_node)),
          weight_to_(parts_.size(), 0.0),
          num_nodes_(parts_.size(), 0),
          is_waiting_(graph.num_nodes(), 1) {
        for (const std::uint32_t part : part_of_node) ++num_nodes_[part];
    }

    void refine() {
        std::vector<std::uint32_t> waiting(graph_.num_nodes());
        std::iota(waiting.begin(), waiting.end(), 0U);
        for (int round = 0; round < kMaxRounds && !waiting.empty(); ++round) {
            std::vector<std::uint32_t> next;
            for (const std::uint32_t node : waiting) {
                is_waiting_[node] = 0;
                if (!move(node)) continue;
                for (const std::uint32_t neighbour : graph_.neighbours(node)) {
                    if (is_waiting_[neighbour] != 0) continue;
                    is_waiting_[neighbour] = 1;
                    next.push_back(neighbour);
                }
            }
            waiting = std::move(next);
        }
    }

private:
    static constexpr int kMaxRounds = 30;
    /// A move must lower the cost of the two parts by this share of it: no rounding error does.
    static constexpr double kMinGain = 1e-9;

    /// Moves a node to the best other part, if that lowers the cost.
    bool move(std::uint32_t node) {
        const std::uint32_t from = part_of_node_[node];
        const auto neighbours = graph_.neighbours(node);
        const auto is_other = [&](std::uint32_t other) { return part_of_node_[other] != from; };
        if (num_nodes_[from] == 1 || std::none_of(neighbours.begin(), neighbours.end(), is_other)) {
            return false;
        }
        touched_.clear();
        double degree = 0.0;
        for_each_edge(graph_, node, [&](std::uint32_t other, double weight) {
            const std::uint32_t part = part_of_node_[other];
            if (weight_to_[part] == 0.0) touched_.push_back(part);
            weight_to_[part] += weight;
            degree += weight;
        });
        const auto changed = [&](std::uint32_t part, double sign) {
            const Part& old = parts_[part];
            return Part{old.volume + sign * volumes_[node],
                        old.cut + sign * (degree - 2.0 * weight_to_[part])};
        };
        const Part left = changed(from, -1.0);
        std::uint32_t best = from;
        double best_change = 0.0;
        for (const std::uint32_t to : touched_) {
            if (to == from) continue;
            const double before = parts_[from].cost() + parts_[to].cost();
            const double change = left.cost() + changed(to, 1.0).cost() - before;
            if (change < std::min(best_change, -kMinGain * before)) {
                best_change = change;
                best = to;
            }
        }
        if (best != from) {
            parts_[best] = changed(best, 1.0);
            parts_[from] = left;
            part_of_node_[node] = best;
            --num_nodes_[from];
            ++num_nodes_[best];
        }
        for (const std::uint32_t part : touched_) weight_to_[part] = 0.0;
        return best != from;
    }

    const Graph& graph_;
    std::span<const double> volumes_;
    std::vector<std::uint32_t>& part_of_node_;
    std::vector<Part> parts_;
    /// Of the node at hand, to each part.
    std::vector<double> weight_to_;
    std::vector<std::uint32_t> touched_;
    std::vector<std::size_t> num_nodes_;
    std::vector<char> is_waiting_;
};

/// What the parts' volumes are sums of; positive.
std::vector<double> volumes_of(const Graph& graph, LaplacianKind kind) {
    const bool is_area = kind == LaplacianKind::area;
    const Laplacian laplacian(graph, is_area ? kind : LaplacianKind::degree);
    std::vector<double> volumes(laplacian.null_vector().begin(), laplacian.null_vector().end());
    for (double& volume : volumes) volume *= volume;
    return volumes;
}

}  // namespace

double normalised_cut(const Graph& graph, LaplacianKind kind,
                      std::span<const std::uint32_t> part_of_node) {
    if (part_of_node.size() != graph.num_nodes()) {
        throw std::logic_error("normalised_cut: one part a node is wanted");
    }
    double cost = 0.0;
    for (const Part& part : measure_parts(graph, volumes_of(graph, kind), part_of_node)) {
        cost += part.cost();
    }
    return cost;
}

std::vector<std::uint32_t> cut_multilevel(const Graph& graph, LaplacianKind kind,
                                          std::size_t num_parts) {
    const std::vector<double> volumes = volumes_of(graph, kind);
    const std::size_t num_coarsest = std::max(kMinCoarseNodes, kCoarseNodesPerPart * num_parts);
    const double max_volume = kMaxShare * std::accumulate(volumes.begin(), volumes.end(), 0.0) /
                              static_cast<double>(num_coarsest);
    // From the finest level to the coarsest, and back.
    std::vector<Coarsening> levels;
    const auto graph_at = [&](std::size_t level) -> const Graph& {
        return level == 0 ? graph : levels[level - 1].graph;
    };
    const auto volumes_at = [&](std::size_t level) {
        return level == 0 ? std::span(volumes) : std::span<const double>(graph_at(level).area_m2);
    };
    for (std::size_t size = graph.num_nodes(); size > num_coarsest;) {
        levels.push_back(coarsen(graph_at(levels.size()), volumes_at(levels.size()), max_volume));
        const std::size_t coarser = levels.back().graph.num_nodes();
        if (20 * coarser > 19 * size) break;
        size = coarser;
    }
    Graph coarsest = graph_at(levels.size());
    coarsest.area_m2.assign(volumes_at(levels.size()).begin(), volumes_at(levels.size()).end());
    std::vector<std::uint32_t> part_of_node = cut_coarsest(coarsest, num_parts);
    Refiner(coarsest, coarsest.area_m2, part_of_node).refine();
    while (!levels.empty()) {
        std::vector<std::uint32_t> finer = std::move(levels.back().coarse_of_node);
        for (std::uint32_t& part : finer) part = part_of_node[part];
        part_of_node = std::move(finer);
        levels.pop_back();
        Refiner(graph_at(levels.size()), volumes_at(levels.size()), part_of_node).refine();
    }
    return part_of_node;
}

}  // namespace quadcut
