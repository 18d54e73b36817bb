// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <utility>
#include <vector>

#include "opencl/device.hpp"

namespace quadcut::opencl {

/// Waits for some queues when it goes out of scope: what their commands read and write must be
/// declared before it.
class PendingCommands {
public:
    explicit PendingCommands(std::vector<Queue*> queues) : queues_(std::move(queues)) {}
    PendingCommands(const PendingCommands&) = delete;
    PendingCommands& operator=(const PendingCommands&) = delete;
    ~PendingCommands() {
        for (Queue* const queue : queues_) queue->finish();
    }

private:
    std::vector<Queue*> queues_;
};

}  // namespace quadcut::opencl
