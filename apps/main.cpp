// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "apps/arguments.hpp"
#include "apps/command.hpp"
#include "apps/help.hpp"
#include "apps/message.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/base/parallel.hpp"

namespace quadcut {
namespace {

constexpr int kDone = 0;
constexpr int kBadInput = 2;
constexpr int kInternalError = 3;

void run(std::span<const std::string> words) {
    if (words.empty()) throw InputError("expected a command; 'quadcut help' lists them");
    std::string name = words[0];
    std::vector<std::string> rest(words.begin() + 1, words.end());
    if (name == "--version") name = "version";
    if (name == "help" || name == "-h" || name == kHelpFlag) {
        if (rest.empty()) {
            std::cout << help_text();
            return;
        }
        name = rest[0];
        rest = {std::string(kHelpFlag)};
    }
    const Command command = find_command(name);
    const Arguments arguments = parse_arguments(command.form, rest);
    if (arguments.has(kHelpFlag)) {
        std::cout << help_of(command.form);
        return;
    }
    command.run(arguments);
    if (const int count = num_threads_missing(); count > 0) {
        print_warnings({std::to_string(count) +
                        " of the threads that were asked for could not be "
                        "started (see 'ulimit -u' and 'ulimit -v'); fewer did the same work"});
    }
}

/// Runs the program and turns what goes wrong into one line and an exit code.
int run_safely(std::span<const std::string> words) {
    try {
        run(words);
        if (!std::cout.flush()) throw InputError("standard output: cannot be written");
        return kDone;
    } catch (const InputError& error) {
        print_error(error.what());
        return kBadInput;
    } catch (const std::filesystem::filesystem_error& error) {
        print_error(error.what());
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
