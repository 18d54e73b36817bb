// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <span>

#include "opencl/device.hpp"
#include "quadcut/spectral/accelerator.hpp"

namespace quadcut::opencl {

/// The product of a sparse matrix and a block of vectors on a device with doubles: product.cl.
class ProductStage {
public:
    /// Compiles the kernel. The device must outlive the stage. Throws DeviceError.
    explicit ProductStage(const Device& device);

    /// result = matrix * block, as Accelerator::multiply(). A few vectors go up while the device
    /// works on those before and the ones before these come down. Throws DeviceError; nothing of
    /// the device is left busy.
    void multiply(const MatrixRows& matrix, std::span<const double> block,
                  std::span<double> result);

private:
    const Device& device_;
    Kernel kernel_;
    Queue uploads_;
    Queue work_;
    Queue downloads_;
};

}  // namespace quadcut::opencl
