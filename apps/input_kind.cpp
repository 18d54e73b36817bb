// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/input_kind.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "io/file.hpp"
#include "io/image.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kNumBytesLookedAt = 65536;

std::string lower_suffix(const std::filesystem::path& path) {
    std::string suffix = path.extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return suffix;
}

template <std::size_t N>
bool is_one_of(std::string_view text, const std::array<std::string_view, N>& words) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

std::optional<InputKind> kind_of_suffix(const std::filesystem::path& path) {
    constexpr std::array<std::string_view, 4> kMaps{".yaml", ".yml", ".pgm", ".png"};
    constexpr std::array<std::string_view, 3> kLogs{".log", ".clf", ".gz"};
    const std::string suffix = lower_suffix(path);
    if (is_one_of(suffix, kMaps)) return InputKind::map;
    if (is_one_of(suffix, kLogs)) return InputKind::log;
    return std::nullopt;
}

/// Whether some line begins as the messages of a CARMEN log do.
bool looks_like_log(std::string_view text) {
    constexpr std::array<std::string_view, 8> kMessages{
        "FLASER", "RLASER", "ROBOTLASER", "RAWLASER", "ODOM", "PARAM", "SYNC", "TRUEPOS"};
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, length);
        text.remove_prefix(std::min(length + 1, text.size()));
        const auto begins = [line](std::string_view word) { return line.rfind(word, 0) == 0; };
        if (std::any_of(kMessages.begin(), kMessages.end(), begins)) return true;
    }
    return false;
}

std::string first_bytes(const std::filesystem::path& path, const std::string& name) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        throw InputError(name + ": is a folder; expected a map or a laser log");
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(name + ": cannot be opened: " + std::strerror(errno));
    std::string bytes(kNumBytesLookedAt, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

}  // namespace

InputKind find_input_kind(const std::filesystem::path& path) {
    if (const std::optional<InputKind> kind = kind_of_suffix(path)) return *kind;

    const std::string name = io::display_name(path);
    const std::string bytes = first_bytes(path, name);
    if (io::is_png(bytes) || io::is_pgm(bytes)) return InputKind::map;
    if (bytes.rfind("\x1F\x8B", 0) == 0) return InputKind::log;
    if (looks_like_log(bytes)) return InputKind::log;

    constexpr std::array<std::string_view, 3> kBags{".bag", ".db3", ".mcap"};
    if (is_one_of(lower_suffix(path), kBags)) {
        throw InputError(name +
                         ": ROS bags are not in this version of quadcut; expected a map "
                         "(.yaml, PGM, PNG) or a CARMEN log");
    }
    throw InputError(name + ": neither a map (.yaml, PGM, PNG) nor a laser log (CARMEN)");
}

}  // namespace quadcut
