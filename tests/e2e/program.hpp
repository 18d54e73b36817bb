// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace quadcut::test {

/// How a run of a program ended.
struct Outcome {
    int exit_code = -1;
    std::string out;
    std::string err;
};

/// Runs a program (a path) with its standard output and error caught. A program that a signal ends
/// has 128 + the signal's number as exit code.
Outcome run_process(const std::string& program, const std::vector<std::string>& arguments);

/// Runs quadcut.
Outcome run_quadcut(const std::vector<std::string>& arguments);

/// An empty folder of the running test's own, gone when it ends.
class Folder {
public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();

    /// The path of an entry, as text for a command line.
    [[nodiscard]] std::string operator/(std::string_view name) const;
    /// Writes a file and returns its path.
    std::string write(std::string_view name, std::string_view bytes) const;

private:
    std::filesystem::path path_;
};

/// All bytes of a file; empty if there is none.
std::string read_bytes(const std::filesystem::path& path);

/// Every file below a folder with its bytes, by relative path; hidden ones, too.
std::map<std::string, std::string> files_below(const std::filesystem::path& folder);

/// A path in the folder of maps and logs beside the repository.
std::filesystem::path shared(std::string_view relative_path);

/// A drawing as a binary PGM: each character is a square of `scale` pixels: '#' occupied, '?'
/// unknown, anything else free. All lines have the same length.
std::string drawn_pgm(const std::vector<std::string>& lines, int scale);

/// Three rooms on a corridor, as drawn_pgm() takes them.
std::vector<std::string> office_drawing();

/// The same: rooms of about 3 x 3.2 m (at 0.05 m a pixel), with doors of 0.8 m.
std::string office_pgm();

/// A map_server YAML for an image, with its lower left corner at (1, -2).
std::string yaml_for(std::string_view image);

}  // namespace quadcut::test
