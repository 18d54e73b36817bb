// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "opencl/accelerators.hpp"
#include "quadcut/base/option_field.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {

/// The one field of --device, bound to `kind`, which must outlive the list.
[[nodiscard]] std::vector<OptionField> device_fields(DeviceKind& kind);
[[nodiscard]] Flag device_flag();

/// The device that a run was told to use, with what is to be said about it at the end. None of that
/// goes into a report: a result has the same bytes on any device.
class RunDevice {
public:
    /// By --device; `num_threads` say how fast the CPU is.
    RunDevice(const Arguments& arguments, std::size_t num_threads);

    /// Null for the CPU.
    [[nodiscard]] Accelerator* accelerator() const { return accelerator_.get(); }
    /// Also says so when nothing of a run with these options could be the device's.
    void print_notes(const SegmentOptions& options) const;

private:
    DeviceKind kind_ = DeviceKind::cpu;
    std::unique_ptr<std::vector<std::string>> notes_;
    std::unique_ptr<Accelerator> accelerator_;
};

}  // namespace quadcut
