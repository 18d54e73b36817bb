// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "tests/e2e/program.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/shared_folder.hpp"

extern char** environ;

namespace quadcut::test {
namespace {

std::filesystem::path own_path(const std::string& purpose) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = "quadcut_" + std::to_string(::getpid()) + "_" + info->test_suite_name() +
                       "_" + info->name() + purpose;
    std::replace(name.begin(), name.end(), '/', '_');
    return std::filesystem::temp_directory_path() / name;
}

}  // namespace

Outcome run_process(const std::string& program, const std::vector<std::string>& arguments) {
    const std::string out = own_path("_out").string();
    const std::string err = own_path("_err").string();
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    constexpr int kMode = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), kMode, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), kMode, 0600);
    pid_t child = 0;
    const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error("cannot start " + program);
    int status = 0;
    waitpid(child, &status, 0);

    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = read_bytes(out);
    outcome.err = read_bytes(err);
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return outcome;
}

Outcome run_quadcut(const std::vector<std::string>& arguments) {
    return run_process(QUADCUT_BINARY, arguments);
}

Folder::Folder() : path_(own_path("")) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string Folder::operator/(std::string_view name) const { return (path_ / name).string(); }

std::string Folder::write(std::string_view name, std::string_view bytes) const {
    const std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path.string();
}

std::string read_bytes(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::map<std::string, std::string> files_below(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        files[std::filesystem::relative(entry.path(), folder).string()] = read_bytes(entry.path());
    }
    return files;
}

std::filesystem::path shared(std::string_view relative_path) { return shared_path(relative_path); }

std::string drawn_pgm(const std::vector<std::string>& lines, int scale) {
    constexpr char kOccupied = 0;
    constexpr char kFree = static_cast<char>(254);
    constexpr char kUnknown = static_cast<char>(205);
    const auto size = static_cast<std::size_t>(scale);
    std::string pgm = "P5\n" + std::to_string(lines.at(0).size() * size) + " " +
                      std::to_string(lines.size() * size) + "\n255\n";
    for (const std::string& line : lines) {
        std::string row;
        for (const char c : line) {
            row.append(size, c == '#' ? kOccupied : c == '?' ? kUnknown : kFree);
        }
        for (std::size_t i = 0; i < size; ++i) pgm += row;
    }
    return pgm;
}

std::vector<std::string> office_drawing() {
    return {
        "????????????????????????????",  //
        "?##########################?",  //
        "?#       #        #       #?",  //
        "?#       #        #       #?",  //
        "?#       #        #       #?",  //
        "?#       #        #       #?",  //
        "?#       #        #       #?",  //
        "?#       #        #       #?",  //
        "?#       #        #       #?",  //
        "?#       #        #       #?",  //
        "?###  #######  ######  ####?",  //
        "?#                        #?",  //
        "?#                        #?",  //
        "?#                        #?",  //
        "?#                        #?",  //
        "?##########################?",  //
        "????????????????????????????",  //
    };
}

std::string office_pgm() { return drawn_pgm(office_drawing(), 8); }

std::string yaml_for(std::string_view image) {
    return "image: " + std::string(image) +
           "\n"
           "resolution: 0.05\n"
           "origin: [1.0, -2.0, 0.0]\n"
           "negate: 0\n"
           "occupied_thresh: 0.65\n"
           "free_thresh: 0.196\n";
}

}  // namespace quadcut::test
