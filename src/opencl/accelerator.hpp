// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "opencl/accelerators.hpp"
#include "opencl/device.hpp"
#include "opencl/product_stage.hpp"
#include "opencl/roofline.hpp"
#include "opencl/sight_stage.hpp"

namespace quadcut::opencl {

struct AcceleratorOptions {
    /// What dlopen() is to find.
    std::string library = "libOpenCL.so.1";
    /// Whether a device that is a CPU will do.
    bool accept_cpu = false;
    /// Whether work that would not pay is declined.
    bool only_if_it_pays = false;
    /// Of the CPU, for that.
    int num_threads = 2;
    /// For tests.
    Fault fault = Fault::none;
};

/// The best OpenCL device there is, from the first call on that may pay. Before it is used, its
/// results for a small map are compared with those of the CPU, first in a process of its own, so
/// that a driver that dies of it is no device. After a failure it declines all.
class OpenClAccelerator final : public Accelerator {
public:
    OpenClAccelerator(AcceleratorOptions options, DeviceNote note);

    [[nodiscard]] std::optional<std::vector<WeightedEdge>> sight_edges(
        const LeafTable& table, std::span<const LeafId> nodes, double resolution_m,
        SelfLoops self_loops) override;
    [[nodiscard]] bool multiply(const MatrixRows& matrix, std::span<const double> block,
                                std::span<double> result) override;

    /// Of the last edge stage.
    [[nodiscard]] Traffic traffic() const;

private:
    /// A device that has proved itself.
    struct Ready {
        explicit Ready(Device found);

        Device device;
        SightStage sight;
        std::optional<ProductStage> product;
    };

    /// Throws DeviceError when the process that tries all that a device begins with does not
    /// survive. The trial is made once for each library.
    static void survive_trial(const AcceleratorOptions& options);
    /// Calls `body` with the device, unless the CPU is quicker; what it returns. False after any
    /// failure.
    template <typename Body>
    bool run(const StageWork& work, double cpu_s, const Body& body);
    [[nodiscard]] bool pays(const StageWork& work, double cpu_s);
    void note_once(const std::string& reason);

    AcceleratorOptions options_;
    DeviceNote note_;
    mutable std::mutex mutex_;
    bool has_failed_ = false;
    std::unique_ptr<Ready> ready_;
    std::set<std::string> noted_;
};

}  // namespace quadcut::opencl
