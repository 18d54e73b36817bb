// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/input_folder.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <system_error>
#include <vector>

#include "io/file.hpp"
#include "io/file_kind.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxNamed = 3;
constexpr std::size_t kMaxLookedAt = 1000;

/// Names of the folder's regular files, in alphabetical order.
std::vector<std::string> file_names(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end;
         !error && entry != end && names.size() < kMaxLookedAt; entry.increment(error)) {
        std::error_code no_file;
        if (entry->is_regular_file(no_file)) names.push_back(entry->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

bool has_suffix(const std::vector<std::string>& names, std::string_view suffix) {
    return std::any_of(names.begin(), names.end(),
                       [suffix](const std::string& name) { return name.ends_with(suffix); });
}

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The names of what could be meant, by suffix: YAML before logs before images.
std::vector<std::string> candidates(const std::vector<std::string>& names) {
    std::vector<std::string> found;
    for (const io::FileKind kind :
         {io::FileKind::map_yaml, io::FileKind::laser_log, io::FileKind::image}) {
        for (const std::string& name : names) {
            if (io::find_file_nature("", name).kind == kind) found.push_back(name);
        }
    }
    return found;
}

std::string named(const fs::path& folder, const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMaxNamed); ++i) {
        text += (i == 0 ? "" : ", ") + io::display_name(folder / names[i]);
    }
    if (names.size() > kMaxNamed) {
        text += " and " + std::to_string(names.size() - kMaxNamed) + " more";
    }
    return text;
}

/// What a folder is, and the way out.
std::string describe(const fs::path& folder) {
    const std::vector<std::string> names = file_names(folder);
    if (has(names, "metadata.yaml") && (has_suffix(names, ".db3") || has_suffix(names, ".mcap"))) {
        return "is a ROS 2 bag; " + std::string(io::find_file_nature("", "bag.mcap").way_out);
    }
    if (has(names, "rooms.yaml") && has(names, "rooms.png")) {
        const std::string map = has(names, "map.yaml") ? "map.yaml" : "rooms.yaml";
        return "is a folder with a result of quadcut; its map is " + named(folder, {map}) +
               ", and --previous takes the folder";
    }
    const std::vector<std::string> found = candidates(names);
    if (found.empty()) return "is a folder without a map or a log in it";
    return "is a folder; in it are " + named(folder, found);
}

}  // namespace

void refuse_folder(const fs::path& folder, std::string_view expected) {
    throw InputError(io::display_name(folder) + ": expected " + std::string(expected) +
                     ", but it " + describe(folder));
}

}  // namespace quadcut
