// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/peers/metis_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <metis.h>

namespace quadcut::peers {
namespace {

constexpr double kWeightUnits = 100.0;
constexpr int kRounds = 5;

}  // namespace

MetisCut cut_with_metis(const Graph& graph, const MetisOptions& options) {
    auto num_nodes = static_cast<idx_t>(graph.num_nodes());
    std::vector<idx_t> row_begin(graph.row_begin.begin(), graph.row_begin.end());
    std::vector<idx_t> columns(graph.columns.begin(), graph.columns.end());
    std::vector<idx_t> weights(graph.weights.size());
    for (std::size_t k = 0; k < weights.size(); ++k) {
        weights[k] = std::max(1, static_cast<idx_t>(std::lround(kWeightUnits * graph.weights[k])));
    }
    std::vector<idx_t> node_weights(graph.num_nodes(), 0);
    for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
        for (std::size_t k = graph.row_begin[i]; k < graph.row_begin[i + 1]; ++k) {
            node_weights[i] += weights[k];
        }
    }
    std::array<idx_t, METIS_NOPTIONS> settings{};
    METIS_SetDefaultOptions(settings.data());
    settings[METIS_OPTION_UFACTOR] = options.imbalance;
    idx_t num_constraints = 1;
    idx_t num_parts = options.num_parts;
    idx_t weight_cut = 0;
    std::vector<idx_t> parts(graph.num_nodes());
    MetisCut cut;
    cut.time = shortest(kRounds, [&] {
        const int status = METIS_PartGraphKway(
            &num_nodes, &num_constraints, row_begin.data(), columns.data(),
            options.balances_weight ? node_weights.data() : nullptr, nullptr, weights.data(),
            &num_parts, nullptr, nullptr, settings.data(), &weight_cut, parts.data());
        if (status != METIS_OK) throw std::runtime_error("METIS failed");
    });
    cut.part_of_node.assign(parts.begin(), parts.end());
    return cut;
}

}  // namespace quadcut::peers
