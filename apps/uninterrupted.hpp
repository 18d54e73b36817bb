// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <csignal>

namespace quadcut {

/// What is done at SIGINT, SIGTERM and SIGHUP.
using InterruptHandlers = std::array<struct sigaction, 3>;

/// Has these signals call `handler`, with flags of sigaction; what the caller of the program has
/// them ignored (nohup) stays ignored. Returns what was done before.
[[nodiscard]] InterruptHandlers handle_interrupts(void (*handler)(int), int flags);
void restore_interrupts(const InterruptHandlers& handlers);

/// While it lives, an interrupt (SIGINT, SIGTERM, SIGHUP) waits; when it is gone, the interrupt
/// ends the program as it would have. Results are written under one of these, so that an
/// interrupted program has written all of them or none. One at a time.
class Uninterrupted {
public:
    Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;
    ~Uninterrupted();

private:
    InterruptHandlers before_{};
};

}  // namespace quadcut
