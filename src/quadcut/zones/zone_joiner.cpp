// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/zones/zone_joiner.hpp"

#include <cstdint>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace quadcut {
namespace {

class ZoneJoiner {
public:
    ZoneJoiner(const Graph& graph, const Embedding& samples)
        : means_(samples),
          weight_(graph.num_nodes(), 0.0),
          cluster_(graph.num_nodes()),
          version_(graph.num_nodes(), 0),
          neighbours_(graph.num_nodes()) {
        std::iota(cluster_.begin(), cluster_.end(), 0U);
        for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) {
            for (const double weight : graph.neighbour_weights(node)) weight_[node] += weight;
            for (const std::uint32_t other : graph.neighbours(node)) {
                if (other != node) neighbours_[node].insert(other);
            }
        }
        for (std::uint32_t node = 0; node < graph.num_nodes(); ++node) push_all(node, node);
    }

    /// The least costly join that there is; whether there was one.
    bool join_next() {
        while (!queue_.empty()) {
            const Candidate top = queue_.top();
            queue_.pop();
            if (version_[top.a] != top.version_a || version_[top.b] != top.version_b) continue;
            join(top.a, top.b);
            return true;
        }
        return false;
    }

    [[nodiscard]] const std::vector<std::uint32_t>& clusters() const { return cluster_; }

private:
    struct Candidate {
        double cost = 0.0;
        std::uint32_t a = 0;
        std::uint32_t b = 0;
        std::uint32_t version_a = 0;
        std::uint32_t version_b = 0;
        /// Least first; ties by node, so that the order is the same everywhere.
        friend bool operator<(const Candidate& p, const Candidate& q) {
            return std::tie(p.cost, p.a, p.b) > std::tie(q.cost, q.a, q.b);
        }
    };

    /// What joining two clusters adds to the weighted sum of squares.
    [[nodiscard]] double cost(std::uint32_t a, std::uint32_t b) const {
        double squared = 0.0;
        for (std::size_t j = 0; j < means_.num_dims; ++j) {
            const double apart = means_.row(a)[j] - means_.row(b)[j];
            squared += apart * apart;
        }
        return squared * weight_[a] * weight_[b] / (weight_[a] + weight_[b]);
    }

    /// The neighbours from `first` on.
    void push_all(std::uint32_t cluster, std::uint32_t first) {
        for (auto at = neighbours_[cluster].lower_bound(first); at != neighbours_[cluster].end();
             ++at) {
            const auto [a, b] = std::minmax(cluster, *at);
            queue_.push({cost(a, b), a, b, version_[a], version_[b]});
        }
    }

    void join(std::uint32_t into, std::uint32_t from) {
        const double sum = weight_[into] + weight_[from];
        for (std::size_t j = 0; j < means_.num_dims; ++j) {
            double& mean = means_.values[into * means_.num_dims + j];
            mean = (weight_[into] * mean + weight_[from] * means_.row(from)[j]) / sum;
        }
        weight_[into] = sum;
        for (std::uint32_t& cluster : cluster_) {
            if (cluster == from) cluster = into;
        }
        for (const std::uint32_t other : neighbours_[from]) {
            neighbours_[other].erase(from);
            if (other == into) continue;
            neighbours_[other].insert(into);
            neighbours_[into].insert(other);
        }
        neighbours_[from].clear();
        ++version_[into];
        ++version_[from];
        push_all(into, 0);
    }

    Embedding means_;
    std::vector<double> weight_;
    std::vector<std::uint32_t> cluster_;
    std::vector<std::uint32_t> version_;
    std::vector<std::set<std::uint32_t>> neighbours_;
    std::priority_queue<Candidate> queue_;
};

}  // namespace

Clustering join_into_zones(const Graph& graph, const Embedding& samples, std::size_t count) {
    ZoneJoiner joiner(graph, samples);
    for (std::size_t left = graph.num_nodes(); left > count; --left) {
        if (!joiner.join_next()) break;
    }
    return numbered_by_first_sample(joiner.clusters(), graph.num_nodes());
}

}  // namespace quadcut
