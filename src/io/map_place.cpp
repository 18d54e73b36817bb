// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_place.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <utility>
#include <vector>

#include <pwd.h>
#include <unistd.h>

#include "io/fields.hpp"
#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::uint64_t kMostBytesBeside = std::uint64_t{1} << 16U;

std::filesystem::path home_of_user() {
    constexpr std::size_t kBufferBytes = std::size_t{1} << 14U;
    std::vector<char> buffer(kBufferBytes);
    passwd entry{};
    passwd* found = nullptr;
    if (::getpwuid_r(::getuid(), &entry, buffer.data(), buffer.size(), &found) != 0 ||
        found == nullptr || found->pw_dir == nullptr) {
        return {};
    }
    return found->pw_dir;
}

std::filesystem::path as_written(const std::string& image, const std::filesystem::path& yaml,
                                 const std::filesystem::path& home_folder) {
    if (image != "~" && !image.starts_with("~/")) {
        return yaml.parent_path() / image;  // An absolute path stays as it is.
    }
    const std::filesystem::path home = home_folder.empty() ? home_of_user() : home_folder;
    if (home.empty()) {
        throw InputError(display_name(yaml) + ": image: " + image +
                         ": no home folder is known, expected a path without ~");
    }
    return image.size() <= 2 ? home : home / image.substr(2);
}

bool is_file(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

/// A YAML that is small enough, is one of a map, and names the image.
std::optional<YamlBeside> read_yaml_of(const std::filesystem::path& image,
                                       const std::filesystem::path& yaml) {
    try {
        YamlBeside found{yaml, read_file(yaml, kMostBytesBeside), {}, {}};
        if (found.bytes.find(image.filename().string()) == std::string::npos) return std::nullopt;
        found.keys = parse_map_yaml(found.bytes, display_name(yaml));
        std::error_code error;
        const std::filesystem::path named = find_image(found.keys.image, yaml, {}).path;
        if (!std::filesystem::equivalent(named, image, error)) return std::nullopt;
        return found;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// The YAMLs in the folder of an image, that of the same stem first.
std::vector<std::filesystem::path> yamls_beside(const std::filesystem::path& image) {
    std::vector<std::filesystem::path> yamls;
    std::error_code error;
    const std::filesystem::path folder = image.parent_path();
    for (std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, error), end;
         !error && entry != end; entry.increment(error)) {
        const std::filesystem::path path = folder / entry->path().filename();
        if (has_yaml_name(path) && is_file(path)) yamls.push_back(path);
    }
    std::sort(yamls.begin(), yamls.end());
    std::stable_partition(yamls.begin(), yamls.end(), [&](const std::filesystem::path& yaml) {
        return yaml.stem() == image.stem();
    });
    return yamls;
}

}  // namespace

bool has_yaml_name(const std::filesystem::path& path) {
    const std::string suffix = lower_case(path.extension().string());
    return suffix == ".yaml" || suffix == ".yml";
}

FoundImage find_image(const std::string& image, const std::filesystem::path& yaml,
                      const std::filesystem::path& home_folder) {
    std::filesystem::path written = as_written(image, yaml, home_folder);
    std::error_code ignored;
    if (std::filesystem::exists(written, ignored)) return {std::move(written), false};
    // The other machine may have been one with backslashes.
    std::filesystem::path beside = yaml.parent_path() / image.substr(image.find_last_of("/\\") + 1);
    if (is_file(beside)) return {std::move(beside), true};
    return {std::move(written), false};
}

std::optional<YamlBeside> find_yaml_beside(const std::filesystem::path& image) {
    if (!is_file(image)) return std::nullopt;
    std::optional<YamlBeside> first;
    for (const std::filesystem::path& yaml : yamls_beside(image)) {
        std::optional<YamlBeside> found = read_yaml_of(image, yaml);
        if (!found) continue;
        if (first) {
            first->other = yaml;
            return first;
        }
        first = std::move(found);
    }
    return first;
}

}  // namespace quadcut::io
