// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/trial.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "opencl/device.hpp"

namespace quadcut::opencl {
namespace {

constexpr char kOver = '.';

/// Nothing of what is tried is to be seen or found afterwards: no words, no core file.
void be_silent() {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
}

/// Also when the driver blocks or handles other signals, and when the parent is gone.
void end_after(unsigned limit_s) {
    std::signal(SIGALRM, SIG_DFL);
    sigset_t alarms;
    sigemptyset(&alarms);
    sigaddset(&alarms, SIGALRM);
    sigprocmask(SIG_UNBLOCK, &alarms, nullptr);
    ::alarm(limit_s);
}

[[noreturn]] void do_in_child(const std::function<void()>& work, int answers, unsigned limit_s) {
    be_silent();
    end_after(limit_s);
    try {
        work();
    } catch (...) {
        // Whoever does it himself will see the same.
    }
    const ssize_t num_written = ::write(answers, &kOver, 1);
    // Nothing of the parent's is to be ended twice.
    ::_exit(num_written == 1 ? 0 : 1);
}

bool has_answered(int answers) {
    char answer = 0;
    ssize_t num_read = 0;
    do {
        num_read = ::read(answers, &answer, 1);
    } while (num_read < 0 && errno == EINTR);
    return num_read == 1 && answer == kOver;
}

/// The wait status of a child that has ended; of one that somebody else has waited for, 0.
int status_of(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return 0;
    }
    return status;
}

std::string cause_of(int status, unsigned limit_s) {
    if (!WIFSIGNALED(status)) return "it ended the process";
    const int number = WTERMSIG(status);
    if (number == SIGALRM) return "not done after " + std::to_string(limit_s) + " s";
    return "signal " + std::to_string(number) + ", " + ::strsignal(number);
}

}  // namespace

void try_in_own_process(const std::function<void()>& work, unsigned limit_s) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw DeviceError("no process to try it in");
    const pid_t child = ::fork();
    if (child == 0) do_in_child(work, ends[1], limit_s);
    ::close(ends[1]);
    const bool is_over = child > 0 && has_answered(ends[0]);
    ::close(ends[0]);
    if (child < 0) throw DeviceError("no process to try it in");
    const int status = status_of(child);
    if (!is_over) {
        throw DeviceError("the OpenCL driver failed when it was tried (" +
                          cause_of(status, limit_s) + ")");
    }
}

}  // namespace quadcut::opencl
