// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace quadcut {

struct OptionField;
class Accelerator;

/// How many threads a call may use, and the device that may do parts of it
/// (spectral/accelerator.hpp); not owned. The result never depends on either.
struct Executor {
    int num_threads = 1;
    Accelerator* accelerator = nullptr;
};

/// Told the name of each stage as it begins.
using StageCallback = std::function<void(std::string_view stage)>;

/// How a call runs; its result never depends on it.
struct RunOptions {
    std::size_t num_threads = 2;
    /// Does parts of the work; not owned.
    Accelerator* accelerator = nullptr;
    /// Told what a call is at, if it has stages.
    StageCallback on_stage = {};

    [[nodiscard]] Executor executor() const { return {static_cast<int>(num_threads), accelerator}; }
};

/// Adds the options of a run, bound to the members of `options`, which must outlive the list.
void add_fields(RunOptions& options, std::vector<OptionField>& fields);

}  // namespace quadcut
