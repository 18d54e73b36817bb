// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// In place of src/opencl where that is left out of the build.
#include "opencl/accelerators.hpp"

namespace quadcut {

std::unique_ptr<Accelerator> make_accelerator(DeviceKind kind, int /*num_threads*/,
                                              const DeviceNote& note) {
    if (kind != DeviceKind::cpu && note) note("this quadcut was built without OpenCL");
    return nullptr;
}

}  // namespace quadcut
