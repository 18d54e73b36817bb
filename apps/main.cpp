// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/arguments.hpp"
#include "apps/command.hpp"
#include "apps/command_help.hpp"
#include "apps/help.hpp"
#include "apps/message.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/base/parallel.hpp"

namespace quadcut {
namespace {

constexpr int kDone = 0;
constexpr int kBadInput = 2;
constexpr int kInternalError = 3;

bool is_help(std::string_view word) { return word == "help" || word == "-h" || word == kHelpFlag; }

/// The exit code.
int run(std::span<const std::string> words) {
    if (words.empty()) {
        throw InputError(
            "expected a command, mostly 'quadcut segment map.yaml -o rooms'; 'quadcut help' lists "
            "them all");
    }
    std::vector<std::string> line(words.begin(), words.end());
    if (line[0] == "--version") line[0] = "version";
    if (is_help(line[0])) {
        if (line.size() == 1 || is_help(line[1])) {
            std::cout << help_text();
            return kDone;
        }
        line = {line[1], std::string(kHelpFlag)};
    }
    const Command command = command_of(line);
    const Arguments arguments = parse_arguments(command.form, std::span(line).subspan(1));
    if (arguments.has(kHelpFlag)) {
        std::cout << help_of(command.form);
        return kDone;
    }
    int exit_code = kDone;
    if (command.answer != nullptr) {
        exit_code = command.answer(arguments);
    } else {
        command.run(arguments);
    }
    if (const int count = num_threads_missing(); count > 0) {
        print_warnings({std::to_string(count) +
                        " of the threads that were asked for could not be "
                        "started (see 'ulimit -u' and 'ulimit -v'); fewer did the same work"});
    }
    return exit_code;
}

/// What a file system said, without its function's name.
std::string text_of(const std::filesystem::filesystem_error& error) {
    const std::string name = error.path1().empty() ? "" : error.path1().string() + ": ";
    return name + error.code().message();
}

/// Prints what went wrong; where the ground is gone that everything stands on, this too.
void print_failure(std::string message, std::span<const std::string> words) {
    std::error_code error;
    static_cast<void>(std::filesystem::current_path(error));
    if (error) {
        message +=
            "; the working folder is no longer there (removed or renamed): 'cd' to one that is";
    }
    print_error(without_long_words(std::move(message), words));
}

/// Runs the program and turns what goes wrong into one line and an exit code.
int run_safely(std::span<const std::string> words) {
    try {
        const int exit_code = run(words);
        if (!std::cout.flush()) throw InputError("standard output: cannot be written");
        return exit_code;
    } catch (const InputError& error) {
        print_failure(error.what(), words);
        return kBadInput;
    } catch (const std::filesystem::filesystem_error& error) {
        print_failure(text_of(error), words);
        return kBadInput;
    } catch (const std::bad_alloc&) {
        print_error("out of memory: the input needs more than this machine has");
        return kInternalError;
    } catch (const NumericalError& error) {
        print_error(std::string("the computation failed: ") + error.what());
        return kInternalError;
    } catch (const std::exception& error) {
        print_error(std::string("internal error: ") + error.what());
        return kInternalError;
    }
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) {
    // A file that grows past the limit of the user is a write that fails, and says so.
    std::signal(SIGXFSZ, SIG_IGN);
    const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    return quadcut::run_safely(words);
}
