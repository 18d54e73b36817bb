// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/uninterrupted.hpp"

namespace quadcut {
namespace {

constexpr std::array<int, 3> kInterrupts{SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing else.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
volatile std::sig_atomic_t interrupt_met = 0;

extern "C" void remember_interrupt(int number) { interrupt_met = number; }

}  // namespace

// Blocking the signals would not do: a worker thread that does not block them would get them.
Uninterrupted::Uninterrupted() {
    interrupt_met = 0;
    struct sigaction later {};
    later.sa_handler = remember_interrupt;
    later.sa_flags = SA_RESTART;
    sigemptyset(&later.sa_mask);
    for (std::size_t i = 0; i < kInterrupts.size(); ++i) {
        sigaction(kInterrupts[i], nullptr, &before_[i]);
        // What the caller of the program ignores (nohup) stays ignored.
        if (before_[i].sa_handler != SIG_IGN) sigaction(kInterrupts[i], &later, nullptr);
    }
}

Uninterrupted::~Uninterrupted() {
    for (std::size_t i = 0; i < kInterrupts.size(); ++i) {
        sigaction(kInterrupts[i], &before_[i], nullptr);
    }
    if (interrupt_met != 0) raise(interrupt_met);
}

}  // namespace quadcut
