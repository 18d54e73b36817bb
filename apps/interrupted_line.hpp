// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include "apps/uninterrupted.hpp"

namespace quadcut {

/// While it lives, an interrupt first ends the line that has begun on standard error, so that the
/// shell's prompt gets one of its own; then it ends the program as it would have. One at a time,
/// and not begun under an Uninterrupted.
class InterruptedLine {
public:
    InterruptedLine();
    InterruptedLine(const InterruptedLine&) = delete;
    InterruptedLine& operator=(const InterruptedLine&) = delete;
    ~InterruptedLine();

    /// There is now a line without an end on the screen.
    void begin();
    /// There is none any more.
    void end();

private:
    InterruptHandlers before_{};
};

}  // namespace quadcut
