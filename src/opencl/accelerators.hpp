// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "quadcut/spectral/accelerator.hpp"

namespace quadcut {

/// What is to do the work that an Accelerator can do. `gpu`: a GPU, or any other device that there
/// is. `automatic`: a GPU, where an estimate says that it pays (backends/roofline.hpp).
enum class DeviceKind : std::uint8_t { cpu, gpu, automatic };

/// Told why the CPU does what a device was asked for, once for each reason.
using DeviceNote = std::function<void(const std::string& reason)>;

/// The accelerator for a choice; null for the CPU, which has `num_threads`. Nothing is looked for
/// before the first call that may pay, so this costs nothing. Whatever fails from then on, the
/// device's absence included, is noted, and the CPU does the work. In a build without OpenCL that
/// is noted at once.
[[nodiscard]] std::unique_ptr<Accelerator> make_accelerator(DeviceKind kind, int num_threads,
                                                            const DeviceNote& note);

}  // namespace quadcut
