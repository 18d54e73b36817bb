// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "io/map_yaml.hpp"

namespace quadcut::io {

/// Whether the suffix is .yaml or .yml, in letters of either case.
[[nodiscard]] bool has_yaml_name(const std::filesystem::path& path);

struct FoundImage {
    std::filesystem::path path;
    /// Whether it is not where the YAML says.
    bool is_elsewhere = false;
};

/// Where the image of a YAML is: as it is written (relative to the YAML, absolute, or under ~),
/// and when nothing is there, the file of that name beside the YAML, if there is one: files are
/// copied together from one machine to another. `home_folder` is what ~ stands for; when empty,
/// the user's entry in the system's user database. Throws InputError for ~ without a home.
[[nodiscard]] FoundImage find_image(const std::string& image, const std::filesystem::path& yaml,
                                    const std::filesystem::path& home_folder);

/// A YAML in the folder of an image whose `image` is that file.
struct YamlBeside {
    std::filesystem::path path;
    std::string bytes;
    MapKeys keys;
    /// Another YAML that names the image too.
    std::optional<std::filesystem::path> other;
};

/// The one of the same stem first, then the first by name. YAMLs that cannot be read or are of
/// another kind are passed over; nothing is looked for beside what is no regular file.
/// O(YAMLs in the folder), those above 64 KiB left out.
[[nodiscard]] std::optional<YamlBeside> find_yaml_beside(const std::filesystem::path& image);

}  // namespace quadcut::io
