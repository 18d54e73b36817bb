// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <functional>

namespace quadcut::opencl {

/// Does `work` in a process of its own, silently, for drivers abort, crash and hang where they do
/// not find what they expect. Returns when it is over, also when it threw. Throws DeviceError when
/// the process died before that, took longer than `limit_s` seconds or could not be started.
void try_in_own_process(const std::function<void()>& work, unsigned limit_s);

}  // namespace quadcut::opencl
