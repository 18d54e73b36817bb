// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "opencl/device.hpp"
#include "quadcut/paper/visibility.hpp"

namespace quadcut::opencl {

/// Bytes that went to the device and came back.
struct Traffic {
    std::size_t bytes_up = 0;
    std::size_t bytes_down = 0;
};

/// The kernels of sight.cl, and the queues they and what they read and write pass through.
struct SightKernels {
    Kernel block_bits;
    Kernel see_edges;
    Kernel place_edges;
    Kernel finish_edges;
    Queue work;
    Queue transfers;
};

/// The edge stage on a device: sight.cl, four kernels.
class SightStage {
public:
    /// Compiles the kernels. The device must outlive the stage. Throws DeviceError.
    explicit SightStage(const Device& device);

    /// The edges of quadcut::sight_edges(), bit for bit. `nodes` is not empty. What is overlapped:
    /// the leaves go up while the numbers of the nodes are made here; the bits are made while those
    /// go up; each part of the edges comes down while the device makes the next and the CPU copies
    /// the one before. Throws DeviceError; nothing of the device is left busy.
    [[nodiscard]] std::vector<WeightedEdge> find(const LeafTable& table,
                                                 std::span<const LeafId> nodes, double resolution_m,
                                                 SelfLoops self_loops);

    /// Of the last call.
    [[nodiscard]] const Traffic& traffic() const { return traffic_; }

private:
    const Device& device_;
    SightKernels kernels_;
    Traffic traffic_;
};

}  // namespace quadcut::opencl
