// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/found_instead.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "io/authorship.hpp"
#include "io/nearest_word.hpp"

namespace quadcut::io {
namespace {

/// So many names say what kind of folder it is.
constexpr std::size_t kNamesShown = 3;
/// A folder of a million files is not listed for a message.
constexpr std::size_t kNamesLookedAt = 1000;

/// The names in a folder in their order; what cannot be listed has none.
std::vector<std::string> names_in(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        if (names.size() == kNamesLookedAt) break;
        names.push_back(entry->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string listed(const std::vector<std::string>& names) {
    if (names.empty()) return "it is empty";
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kNamesShown); ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() <= kNamesShown
               ? text
               : text + " and " + std::to_string(names.size() - kNamesShown) + " more";
}

std::string found_in_folder(const std::filesystem::path& folder) {
    const std::vector<std::string> names = names_in(folder);
    std::vector<std::string> results;
    for (const std::string& name : names) {
        if (results.size() < kNamesShown && has_result(folder / name)) {
            results.push_back((folder / name).string());
        }
    }
    return "no rooms.yaml in it (" + listed(names) + ")" +
           (results.empty() ? "" : ": " + did_you_mean(results));
}

}  // namespace

bool has_result(const std::filesystem::path& folder) {
    std::error_code error;
    return std::filesystem::exists(folder / "rooms.yaml", error);
}

bool is_project(const std::filesystem::path& path) {
    constexpr std::size_t kHeaderBytes = 100;
    std::error_code error;
    // A pipe would be waited for.
    if (!std::filesystem::is_regular_file(path, error)) return false;
    std::string start(kHeaderBytes, '\0');
    std::ifstream(path, std::ios::binary).read(start.data(), std::ssize(start));
    return begins_project(start);
}

std::string found_instead_of_result(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return found_in_folder(path);
    if (!std::filesystem::exists(path, error)) return "no such folder";
    const bool is_file = std::filesystem::is_regular_file(path, error);
    std::string kind = is_project(path) ? "a project of quadcut"
                       : is_file        ? "a file"
                                        : "something that is no folder";
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (has_result(folder)) kind += ": " + did_you_mean({folder.string()});
    return kind;
}

}  // namespace quadcut::io
