// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/interrupted_line.hpp"

#include <csignal>

#include <unistd.h>

namespace quadcut {
namespace {

// A signal handler can reach nothing else.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t line_begun = 0;

/// By then the signal has its default again: raised once more it ends the program.
extern "C" void end_line(int number) {
    if (line_begun != 0) {
        line_begun = 0;
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, "\n", 1);
    }
    raise(number);
}

}  // namespace

InterruptedLine::InterruptedLine() : before_(handle_interrupts(end_line, SA_RESETHAND)) {}

InterruptedLine::~InterruptedLine() {
    end();
    restore_interrupts(before_);
}

// NOLINTNEXTLINE(readability-convert-member-functions-to-static)
void InterruptedLine::begin() { line_begun = 1; }

// NOLINTNEXTLINE(readability-convert-member-functions-to-static)
void InterruptedLine::end() { line_begun = 0; }

}  // namespace quadcut
