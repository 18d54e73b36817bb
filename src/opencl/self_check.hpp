// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "opencl/product_stage.hpp"
#include "opencl/sight_stage.hpp"

namespace quadcut::opencl {

/// Compares a device with the CPU on a map of 64 x 64 cells, bit for bit. Throws DeviceError when
/// it computes something else, or fails. About a millisecond of work.
void check_against_cpu(SightStage& stage);
void check_against_cpu(ProductStage& stage);

}  // namespace quadcut::opencl
