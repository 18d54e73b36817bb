// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "tests/e2e/terminal.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <regex>
#include <stdexcept>

#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

namespace quadcut::test {
namespace {

constexpr char kCtrlC = '\x03';

/// In the child: nothing but what may follow a fork.
[[noreturn]] void start(const std::vector<char*>& argv, const Terminal& terminal) {
    ::setenv("TERM", terminal.kind.c_str(), 1);
    ::setenv("COLUMNS", terminal.columns.c_str(), 1);
    ::execv(QUADCUT_BINARY, argv.data());
    ::_exit(127);
}

}  // namespace

Outcome run_in_terminal(const std::vector<std::string>& arguments, const Terminal& terminal) {
    std::vector<std::string> words{QUADCUT_BINARY};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    struct winsize size {};
    size.ws_row = 24;
    size.ws_col = static_cast<unsigned short>(terminal.num_columns);
    int screen = -1;
    const pid_t child = ::forkpty(&screen, nullptr, nullptr, &size);
    if (child < 0) throw std::runtime_error("no terminal");
    if (child == 0) start(argv, terminal);

    Outcome outcome;
    bool is_interrupted = terminal.interrupt_at.empty();
    std::array<char, 4096> buffer{};
    while (true) {
        const ssize_t count = ::read(screen, buffer.data(), buffer.size());
        // When the program has ended there is nobody at the other side: an error, not an end.
        if (count <= 0) break;
        outcome.out.append(buffer.data(), static_cast<std::size_t>(count));
        if (!is_interrupted && outcome.out.find(terminal.interrupt_at) != std::string::npos) {
            is_interrupted = ::write(screen, &kCtrlC, 1) == 1;
        }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(screen);
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}

std::vector<std::string> drawn_lines(const std::string& printed) {
    const std::string text =
        std::regex_replace(printed, std::regex("\x1B\\[[0-9]*[A-Za-z]"), std::string());
    std::vector<std::string> lines;
    std::size_t start = 0;
    while (start < text.size()) {
        const std::size_t end = std::min(text.find('\r', start), text.size());
        if (end > start && text[start] != '\n') lines.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return lines;
}

}  // namespace quadcut::test
