// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Figs 6 and 7: the matrix of the graph G, and the time that it takes.
#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "quadcut/map/integrate.hpp"
#include "quadcut/paper/line_of_sight.hpp"
#include "reproduce/experiments.hpp"
#include "reproduce/graph_storage.hpp"
#include "reproduce/judge.hpp"
#include "reproduce/machine.hpp"
#include "reproduce/map_graph.hpp"
#include "reproduce/map_picture.hpp"
#include "reproduce/plot.hpp"
#include "reproduce/sentence.hpp"
#include "reproduce/timing.hpp"

namespace quadcut::reproduce {
namespace {

/// Pairs of all nodes are tested one by one up to here.
constexpr std::size_t kMaxDenseNodes = 3000;

using Entries = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// All pairs that see each other, however far apart: the matrix before the three rules.
Entries unfiltered(const MapGraph& graph) {
    const LeafTable& table = graph.leaves.table;
    const Cell low = table.root().lower_left;
    const std::int32_t reach = table.root().side_cells() - 1;
    const BlockedCells blocked(table, low, {low.x + reach, low.y + reach});
    const std::vector<LeafId>& nodes = graph.leaves.nodes;
    Entries entries;
    for (std::uint32_t a = 0; a < nodes.size(); ++a) {
        entries.emplace_back(a, a);
        for (std::uint32_t b = a + 1; b < nodes.size(); ++b) {
            const Leaf& one = table.leaf(nodes[a]);
            const Leaf& other = table.leaf(nodes[b]);
            if (blocked.sees(centre(one), centre(other))) entries.emplace_back(a, b);
        }
    }
    return entries;
}

Entries entries_of(const Graph& graph) {
    Entries entries;
    for (std::uint32_t row = 0; row < graph.num_nodes(); ++row) {
        for (const std::uint32_t column : graph.neighbours(row)) entries.emplace_back(row, column);
    }
    return entries;
}

double percent_of_entries(const Graph& graph) {
    const auto nodes = static_cast<double>(graph.num_nodes());
    return 100.0 * static_cast<double>(graph.columns.size()) / (nodes * nodes);
}

Value percent_of_dense(double bytes, const Graph& graph) {
    return number(100.0 * bytes / static_cast<double>(dense_bytes(graph)), 2);
}

Row row_of(const std::string& name, const Graph& graph) {
    return {
        name,
        "",
        {number(graph.num_nodes()), number(graph.columns.size()),
         number(percent_of_entries(graph), 3), number(dense_bytes(graph)), number(csr_bytes(graph)),
         percent_of_dense(static_cast<double>(csr_bytes(graph)), graph), number(dia_bytes(graph)),
         percent_of_dense(static_cast<double>(dia_bytes(graph)), graph)}};
}

}  // namespace

Figure figure_6(const Worlds& worlds, const Setup& setup) {
    const GridMap coarse =
        map_from_scans(worlds.workplace.scans, worlds.workplace.paper_cell_m).to_grid();
    const MapGraph small = graph_of(coarse, SelfLoops::own_weight, setup.executor());
    const Graph& graph = small.graph;
    Figure figure;
    figure.number = "6";
    figure.title = "Dense and filtered sparse matrix";
    figure.paper =
        "795 nodes of the workplace's map; the filtered matrix has 59,462 elements and, stored by "
        "diagonals, 0.47 % of the dense matrix's memory.";
    figure.setting =
        "The graph G of three maps: leaves that see each other within the threshold of eq. (3), "
        "with loops. The workplace on coarser cells, where it has about as many nodes as in the "
        "paper, the others on cells of 5 cm. Eight bytes a weight; CSR is what quadcut stores, DIA "
        "(by diagonals) what the paper proposes.";
    figure.tables.push_back({"",
                             {"nodes", "entries", "entries, %", "dense, bytes", "CSR, bytes",
                              "CSR, % of dense", "DIA, bytes", "DIA, % of dense"},
                             {{"the paper, workplace",
                               "",
                               {number(kPaperNodes), number(kPaperEntries),
                                number(100.0 * kPaperEntries / (kPaperNodes * kPaperNodes), 3),
                                number(8.0 * kPaperNodes * kPaperNodes), none(), none(), none(),
                                number(kPaperDiaPercent, 2)}},
                              row_of(worlds.workplace.name, graph)}});
    for (const World* world : {&worlds.mit_csail, &worlds.intel}) {
        figure.tables.back().rows.push_back(row_of(
            world->name, graph_of(world->map, SelfLoops::own_weight, setup.executor()).graph));
    }
    if (graph.num_nodes() <= kMaxDenseNodes) {
        const Entries all = unfiltered(small);
        const std::size_t num_all = 2 * all.size() - graph.num_nodes();
        figure.pictures = {
            matrix_picture("fig6_dense.png", graph.num_nodes(), all,
                           "Every pair of leaves in sight of each other: " +
                               in_words(static_cast<double>(num_all)) + " entries"),
            matrix_picture("fig6_sparse.png", graph.num_nodes(), entries_of(graph),
                           "Filtered by the three rules: " +
                               in_words(static_cast<double>(graph.columns.size())) + " entries")};
    }
    const double csr =
        100.0 * static_cast<double>(csr_bytes(graph)) / static_cast<double>(dense_bytes(graph));
    const double dia =
        100.0 * static_cast<double>(dia_bytes(graph)) / static_cast<double>(dense_bytes(graph));
    figure.claims = judge(MatrixNumbers{percent_of_entries(graph), csr, dia});
    return figure;
}

Figure figure_7(const Worlds& worlds, const Setup& setup) {
    const unsigned num_cores = this_machine().num_cores;
    const std::size_t most = std::min<std::size_t>(16, std::max(4U, 2 * num_cores));
    const World& world =
        worlds.mit_csail.map.states.values.size() > worlds.intel.map.states.values.size()
            ? worlds.mit_csail
            : worlds.intel;
    const FreeLeaves leaves = free_leaves(world.map);
    std::vector<std::function<void()>> works;
    std::size_t num_edges = 0;
    for (std::size_t threads = 1; threads <= most; ++threads) {
        works.emplace_back([&, threads] {
            num_edges = sight_edges(leaves.table, leaves.nodes, world.map.resolution_m,
                                    SelfLoops::own_weight, Executor{static_cast<int>(threads)})
                            .size();
        });
    }
    const std::vector<double> times_ms = least_ms(setup.size == Size::full ? 25 : 3, works);
    Plot plot{world.name + ": edges of G", "threads", "ms", {{"measured", {}}, {"ideal", {}}}};
    plot.is_x_whole = true;
    Table table{"", {}, {{"wall time", "ms", {}}, {"times as fast as one thread", "", {}}}};
    std::size_t best = 1;
    for (std::size_t threads = 1; threads <= most; ++threads) {
        const double ms = times_ms[threads - 1];
        if (ms < times_ms[best - 1]) best = threads;
        const auto at = static_cast<double>(threads);
        plot.curves[0].points.push_back({at, ms});
        plot.curves[1].points.push_back({at, times_ms[0] / std::min<double>(at, num_cores)});
        table.columns.push_back(std::to_string(threads) + (threads == 1 ? " thread" : " threads"));
        table.rows[0].values.push_back(number(ms, 2));
        table.rows[1].values.push_back(number(times_ms[0] / ms, 2));
    }
    Figure figure;
    figure.number = "7";
    figure.title = "Time of the graph's edges against the number of threads";
    figure.paper =
        "Processes that each hold a deep copy of the tree save a lot of time; too many of them "
        "may cost some again. The values stand in a chart only.";
    figure.setting = "The " + in_words(static_cast<double>(num_edges)) + " edges of " + world.name +
                     "'s " + in_words(static_cast<double>(leaves.nodes.size())) +
                     " free leaves; threads share one read-only tree. This machine has " +
                     std::to_string(num_cores) + (num_cores == 1 ? " core" : " cores") +
                     ", so that no more than as many threads can help; the ideal is one thread's "
                     "time over them. The least of several runs in turn.";
    figure.pictures = {{"fig7.svg", to_svg(plot), "Wall time of the edge stage"}};
    figure.tables = {table};
    figure.claims = judge(ThreadNumbers{num_cores, times_ms[0] / times_ms[best - 1],
                                        times_ms.back() / times_ms[best - 1]});
    return figure;
}

}  // namespace quadcut::reproduce
