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

InterruptHandlers handle_interrupts(void (*handler)(int), int flags) {
    InterruptHandlers before{};
    struct sigaction now {};
    now.sa_handler = handler;
    now.sa_flags = flags;
    sigemptyset(&now.sa_mask);
    for (std::size_t i = 0; i < kInterrupts.size(); ++i) {
        sigaction(kInterrupts[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN) sigaction(kInterrupts[i], &now, nullptr);
    }
    return before;
}

void restore_interrupts(const InterruptHandlers& handlers) {
    for (std::size_t i = 0; i < kInterrupts.size(); ++i) {
        sigaction(kInterrupts[i], &handlers[i], nullptr);
    }
}

// Blocking the signals would not do: a worker thread that does not block them would get them.
Uninterrupted::Uninterrupted() {
    interrupt_met = 0;
    before_ = handle_interrupts(remember_interrupt, SA_RESTART);
}

Uninterrupted::~Uninterrupted() {
    restore_interrupts(before_);
    if (interrupt_met != 0) raise(interrupt_met);
}

}  // namespace quadcut
