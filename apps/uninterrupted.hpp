// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <array>
#include <csignal>

namespace quadcut {

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
    std::array<struct sigaction, 3> before_{};
};

}  // namespace quadcut
