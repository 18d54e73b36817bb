// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/product_stage.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "opencl/kernel_sources.hpp"
#include "opencl/pending_commands.hpp"

namespace quadcut::opencl {
namespace {

/// Vectors that go up, are worked on and come down together.
constexpr std::size_t kPartVectors = 4;

/// What is on its way of one part, and the memory for it.
struct Slot {
    Buffer block;
    Buffer result;
    Event worked;
    Event down;
};

}  // namespace

ProductStage::ProductStage(const Device& device)
    : device_(device),
      kernel_(device.build(product_kernels(), {"multiply"})[0]),
      uploads_(device.make_queue()),
      work_(device.make_queue()),
      downloads_(device.make_queue()) {}

void ProductStage::multiply(const MatrixRows& matrix, std::span<const double> block,
                            std::span<double> result) {
    static_assert(sizeof(std::size_t) == sizeof(std::uint64_t));
    const std::size_t num_rows = matrix.diagonal.size();
    if (num_rows > std::numeric_limits<std::uint32_t>::max()) {
        throw DeviceError("more rows than its kernel can count");
    }
    const PendingCommands pending({&uploads_, &work_, &downloads_});
    const auto send = [&](auto source) {
        Buffer buffer = device_.allocate(source.size_bytes());
        uploads_.write(buffer, source.data(), source.size_bytes());
        return buffer;
    };
    const Buffer diagonal = send(matrix.diagonal);
    const Buffer row_begin = send(matrix.row_begin);
    const Buffer row_length = send(matrix.row_length);
    const Buffer columns = send(matrix.columns);
    const Buffer values = send(matrix.values);
    // Three of them: one goes up, one is worked on, one comes down.
    std::array<Slot, 3> slots;
    const std::size_t part = kPartVectors * num_rows;
    for (Slot& slot : slots) {
        slot.block = device_.allocate(part * sizeof(double));
        slot.result = device_.allocate(part * sizeof(double));
    }
    Event last;
    for (std::size_t first = 0; first < block.size(); first += part) {
        Slot& slot = slots[first / part % slots.size()];
        const std::size_t count = std::min(part, block.size() - first);
        // The block is free when the kernel before has read it, the result when it is down.
        Queue::Events free;
        const Queue::Events read =
            slot.worked.handle ? Queue::Events{slot.worked} : Queue::Events{};
        if (slot.down.handle) free.push_back(slot.down);
        free.push_back(uploads_.write(slot.block, &block[first], count * sizeof(double), read));
        uploads_.flush();
        kernel_.set(diagonal, row_begin, row_length, columns, values, slot.block, slot.result,
                    static_cast<std::uint32_t>(num_rows));
        slot.worked = work_.launch(kernel_, num_rows, count / num_rows, free);
        work_.flush();
        slot.down =
            downloads_.read(slot.result, &result[first], count * sizeof(double), {slot.worked});
        downloads_.flush();
        last = slot.down;
    }
    if (last.handle) downloads_.wait(last);
}

}  // namespace quadcut::opencl
