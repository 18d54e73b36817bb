// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/authorship.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <system_error>

namespace quadcut::io {
namespace {

/// All marks stand within so many bytes.
constexpr std::size_t kNumBytesLookedAt = 4096;

/// The last one is the beginning of a line of updates.jsonl, after the number of the scan.
constexpr std::array<std::string_view, 5> kMarks{
    kAuthorComment, kAuthorChunk, "\nformat_version:", "\"format_version\":", "\"integrate_ms\":"};

}  // namespace

bool begins_project(std::string_view first_bytes) {
    constexpr std::size_t kApplicationId = 68;
    return first_bytes.starts_with("SQLite format 3") &&
           first_bytes.substr(std::min(kApplicationId, first_bytes.size())).starts_with("QCUT");
}

bool is_own_work(std::string_view first_bytes) {
    if (begins_project(first_bytes)) return true;
    const std::string_view head = first_bytes.substr(0, kNumBytesLookedAt);
    return std::any_of(kMarks.begin(), kMarks.end(), [head](std::string_view mark) {
        return head.find(mark) != std::string_view::npos;
    });
}

bool is_own_file(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    // A graph has no room for a mark: some programs that read it take no comment.
    if (path.extension() == ".g2o") {
        return is_own_file(std::filesystem::path(path).replace_extension(".zones"));
    }
    std::ifstream file(path, std::ios::binary);
    std::string head(kNumBytesLookedAt, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return is_own_work(head);
}

}  // namespace quadcut::io
