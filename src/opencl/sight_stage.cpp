// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/sight_stage.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>

#include "opencl/kernel_sources.hpp"
#include "opencl/pending_commands.hpp"
#include "quadcut/base/geometry.hpp"
#include "quadcut/map/leaf.hpp"

namespace quadcut::opencl {
namespace {

constexpr std::uint32_t kNoNode = 0xFFFF'FFFFU;
/// Levels that a table of weights has room for; a leaf of 2^31 cells is none.
constexpr std::size_t kNumLevels = 32;
/// Edges of one part that comes down, 1 MB: large enough that the link is busy, small enough that
/// the first one comes soon.
constexpr std::size_t kPartEdges = 65'536;

// What sight.cl takes these for.
static_assert(sizeof(Leaf) == 12 && offsetof(Leaf, level) == 8 && offsetof(Leaf, state) == 9);
static_assert(sizeof(LeafTable::Tile) == 72 && offsetof(LeafTable::Tile, offsets) == 8);
static_assert(sizeof(WeightedEdge) == 16 && offsetof(WeightedEdge, weight) == 8);

/// As Scene of sight.cl.
struct Scene {
    std::int32_t root_x, root_y;
    std::int32_t directory_x, directory_y, directory_width, directory_height;
    std::int32_t low_x, low_y, high_x, high_y;
    std::uint32_t words_per_row, num_row_words, words_per_column, num_column_words;
    std::uint32_t num_nodes;
    std::int32_t max_level;
    std::int32_t loops;
    std::int32_t free_state;
};

/// The words of `length` cells and their border, and one more, as BlockedCells has them.
std::uint32_t words_for(std::int32_t length) {
    return static_cast<std::uint32_t>((length + 2 + 63) / 64 + 1);
}

struct Extent {
    Box box;
    std::int32_t min_level = std::numeric_limits<std::int32_t>::max();
    std::int32_t max_level = 0;
};

Extent extent_of(const LeafTable& table, std::span<const LeafId> nodes) {
    Extent extent;
    for (const LeafId id : nodes) {
        const Leaf& leaf = table.leaf(id);
        extent.box.include(leaf.box());
        extent.min_level = std::min<std::int32_t>(extent.min_level, leaf.level);
        extent.max_level = std::max<std::int32_t>(extent.max_level, leaf.level);
    }
    return extent;
}

Scene scene_of(const LeafTable& table, std::size_t num_nodes, const Extent& extent,
               SelfLoops self_loops) {
    const Box& box = extent.box;
    Scene scene{};
    scene.root_x = table.root().lower_left.x;
    scene.root_y = table.root().lower_left.y;
    scene.directory_x = table.directory().origin.x;
    scene.directory_y = table.directory().origin.y;
    scene.directory_width = table.directory().width;
    scene.directory_height = table.directory().height;
    scene.low_x = box.low.x;
    scene.low_y = box.low.y;
    scene.high_x = box.high.x;
    scene.high_y = box.high.y;
    scene.words_per_row = words_for(box.width());
    scene.num_row_words = scene.words_per_row * static_cast<std::uint32_t>(box.height() + 2);
    scene.words_per_column = words_for(box.height());
    scene.num_column_words = scene.words_per_column * static_cast<std::uint32_t>(box.width() + 2);
    scene.num_nodes = static_cast<std::uint32_t>(num_nodes);
    scene.max_level = extent.max_level;
    scene.loops = self_loops == SelfLoops::none ? 0 : self_loops == SelfLoops::own_weight ? 1 : 2;
    scene.free_state = static_cast<std::int32_t>(CellState::free);
    return scene;
}

/// Eq. (2) has one value for each pair of levels. The CPU computes them, so that the weights are
/// the CPU's on any device, those without doubles included (many integrated GPUs).
std::array<double, kNumLevels * kNumLevels> weights_by_level(double resolution_m) {
    std::array<double, kNumLevels * kNumLevels> weights{};
    for (std::size_t i = 0; i + 1 < kNumLevels; ++i) {
        for (std::size_t j = 0; j + 1 < kNumLevels; ++j) {
            weights[kNumLevels * i + j] = sight_weight((std::int32_t{1} << i) * resolution_m,
                                                       (std::int32_t{1} << j) * resolution_m);
        }
    }
    return weights;
}

/// Entries first .. end of the edges, which come down together.
struct Part {
    std::uint32_t first = 0;
    std::uint32_t end = 0;

    [[nodiscard]] std::size_t size() const { return end - first; }
};

/// Whole rows, so many that a part has kPartEdges at most; a longer row is a part of its own.
std::vector<Part> parts_of(const std::vector<std::uint32_t>& row_begin) {
    std::vector<Part> parts;
    for (std::size_t i = 0; i + 1 < row_begin.size(); ++i) {
        if (row_begin[i + 1] == row_begin[i]) continue;
        if (parts.empty() || row_begin[i + 1] - parts.back().first > kPartEdges) {
            parts.push_back({row_begin[i], row_begin[i]});
        }
        parts.back().end = row_begin[i + 1];
    }
    return parts;
}

/// One call. Everything that the device reads or writes here is a member, so that it holds until
/// `pending_`, the last of them, has seen both queues come to rest, also when something throws.
class SightRun {
public:
    SightRun(const Device& device, SightKernels& kernels, const LeafTable& table,
             std::span<const LeafId> nodes)
        : device_(device),
          kernels_(kernels),
          table_(table),
          nodes_(nodes),
          extent_(extent_of(table, nodes)),
          pending_({&kernels.work, &kernels.transfers}) {}

    void send(double resolution_m, SelfLoops self_loops) {
        scene_ = scene_of(table_, nodes_.size(), extent_, self_loops);
        send(scene_buffer_, std::span(&scene_, 1));
        send(directory_, table_.directory().values);
        send(tiles_, table_.tiles());
        const Event leaves_there = send(leaves_, table_.leaves());
        kernels_.transfers.flush();

        const std::size_t num_words = std::size_t{scene_.num_row_words} + scene_.num_column_words;
        bits_ = device_.allocate(num_words * sizeof(std::uint64_t));
        kernels_.block_bits.set(scene_buffer_, directory_, tiles_, leaves_, bits_);
        kernels_.work.launch(kernels_.block_bits, num_words, 1, {leaves_there});
        kernels_.work.flush();

        node_of_leaf_.assign(table_.leaves().size(), kNoNode);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            node_of_leaf_[index(nodes_[i])] = static_cast<std::uint32_t>(i);
        }
        weights_by_level_ = weights_by_level(resolution_m);
        send(node_buffer_, nodes_);
        send(weights_, weights_by_level_);
        nodes_there_ = send(node_of_leaf_buffer_, node_of_leaf_);
        kernels_.transfers.flush();
    }

    /// Sees which edges there are, and puts them into their rows.
    void make_rows() {
        const auto num_steps = static_cast<std::size_t>(extent_.max_level - extent_.min_level + 1);
        const std::size_t num_nodes = nodes_.size();
        seen_ = device_.allocate(num_steps * num_nodes * sizeof(std::uint16_t));
        counts_ = device_.allocate(num_nodes * sizeof(std::uint32_t));
        kernels_.work.fill_with_zeros(counts_);
        kernels_.see_edges.set(scene_buffer_, directory_, tiles_, leaves_, node_of_leaf_buffer_,
                               node_buffer_, bits_, seen_, counts_);
        const Event counted =
            kernels_.work.launch(kernels_.see_edges, num_nodes, num_steps, {nodes_there_});
        kernels_.work.flush();

        // The CPU adds up: it has to know the total anyway, to ask for the memory.
        row_begin_.resize(num_nodes + 1);
        traffic_.bytes_down += num_nodes * sizeof(std::uint32_t);
        const Event counts_there = kernels_.transfers.read(
            counts_, row_begin_.data() + 1, num_nodes * sizeof(std::uint32_t), {counted});
        kernels_.transfers.wait(counts_there);
        std::uint64_t num_edges = 0;
        for (std::uint32_t& end : row_begin_) {
            num_edges += end;
            end = static_cast<std::uint32_t>(num_edges);
        }
        if (num_edges > std::numeric_limits<std::uint32_t>::max()) {
            throw DeviceError("more edges than its kernels can count");
        }
        pairs_ = device_.allocate(num_edges * 2 * sizeof(std::uint32_t));
        const Event rows_there = send(row_begin_buffer_, row_begin_);
        kernels_.transfers.flush();
        kernels_.place_edges.set(scene_buffer_, directory_, tiles_, leaves_, node_of_leaf_buffer_,
                                 node_buffer_, seen_, row_begin_buffer_, counts_, pairs_);
        kernels_.work.launch(kernels_.place_edges, num_nodes, num_steps, {rows_there});
        kernels_.work.flush();
    }

    [[nodiscard]] std::vector<WeightedEdge> fetch() {
        const std::vector<Part> parts = parts_of(row_begin_);
        std::vector<WeightedEdge> edges;
        edges.reserve(row_begin_.back());
        std::size_t capacity = 0;
        for (const Part& part : parts) capacity = std::max(capacity, part.size());
        std::array<Slot, 2> slots;
        for (Slot& slot : slots) {
            slot.buffer = device_.allocate(capacity * sizeof(WeightedEdge), Placement::shared);
        }
        if (!parts.empty()) begin_part(parts[0], slots[0]);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            // The next part is made while this one comes down and is copied.
            if (i + 1 < parts.size()) begin_part(parts[i + 1], slots[(i + 1) % 2]);
            const Slot& slot = slots[i % 2];
            kernels_.transfers.wait(slot.there);
            const auto* const first = static_cast<const WeightedEdge*>(slot.mapped);
            edges.insert(edges.end(), first, first + parts[i].size());
            // In the queue of the kernels, where the next that writes there stands behind it.
            kernels_.work.unmap(slot.buffer, slot.mapped);
        }
        traffic_.bytes_down += edges.size() * sizeof(WeightedEdge);
        return edges;
    }

    [[nodiscard]] const Traffic& traffic() const { return traffic_; }

private:
    /// A part on its way.
    struct Slot {
        Buffer buffer;
        const void* mapped = nullptr;
        Event there;
    };

    template <typename Range>
    Event send(Buffer& buffer, const Range& range) {
        const std::span source(range);
        buffer = device_.allocate(source.size_bytes());
        traffic_.bytes_up += source.size_bytes();
        return kernels_.transfers.write(buffer, source.data(), source.size_bytes());
    }

    void begin_part(const Part& part, Slot& slot) {
        kernels_.finish_edges.set(scene_buffer_, leaves_, node_buffer_, row_begin_buffer_, pairs_,
                                  weights_, part.first, part.end, slot.buffer);
        const Event made = kernels_.work.launch(kernels_.finish_edges, part.size(), 1, {});
        kernels_.work.flush();
        std::tie(slot.mapped, slot.there) =
            kernels_.transfers.map(slot.buffer, part.size() * sizeof(WeightedEdge), {made});
        kernels_.transfers.flush();
    }

    const Device& device_;
    SightKernels& kernels_;
    const LeafTable& table_;
    std::span<const LeafId> nodes_;
    Extent extent_;
    Scene scene_{};
    std::vector<std::uint32_t> node_of_leaf_;
    std::vector<std::uint32_t> row_begin_;
    std::array<double, kNumLevels * kNumLevels> weights_by_level_{};
    Buffer scene_buffer_, directory_, tiles_, leaves_, node_buffer_, node_of_leaf_buffer_, weights_;
    Buffer bits_, seen_, counts_, row_begin_buffer_, pairs_;
    Event nodes_there_;
    Traffic traffic_;
    PendingCommands pending_;
};

}  // namespace

SightStage::SightStage(const Device& device)
    : device_(device), kernels_{{}, {}, {}, {}, device.make_queue(), device.make_queue()} {
    std::vector<Kernel> built =
        device.build(sight_kernels(), {"block_bits", "see_edges", "place_edges", "finish_edges"});
    kernels_.block_bits = std::move(built[0]);
    kernels_.see_edges = std::move(built[1]);
    kernels_.place_edges = std::move(built[2]);
    kernels_.finish_edges = std::move(built[3]);
}

std::vector<WeightedEdge> SightStage::find(const LeafTable& table, std::span<const LeafId> nodes,
                                           double resolution_m, SelfLoops self_loops) {
    SightRun run(device_, kernels_, table, nodes);
    run.send(resolution_m, self_loops);
    run.make_rows();
    std::vector<WeightedEdge> edges = run.fetch();
    traffic_ = run.traffic();
    return edges;
}

}  // namespace quadcut::opencl
