// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/input_kind.hpp"

#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "apps/input_folder.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

using io::FileKind;

constexpr std::string_view kMapOrLog = "a map (map.yaml, or its image) or a laser log (CARMEN)";
constexpr std::string_view kLog = "a laser log (CARMEN)";

io::Input open_unless_folder(const std::filesystem::path& path, std::string_view expected) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) refuse_folder(path, expected);
    return io::Input(path);
}

[[noreturn]] void refuse(const io::InputFile& file, std::string_view expected) {
    throw InputError(io::describe_refusal(file.bytes, file.name, expected));
}

}  // namespace

KnownInput open_map_or_log(const std::filesystem::path& path) {
    io::Input input = open_unless_folder(path, kMapOrLog);
    const io::InputFile& beginning = input.beginning();
    const FileKind kind = io::find_file_nature(beginning.bytes, beginning.name).kind;
    if (kind == FileKind::unknown || kind == FileKind::poses) refuse(beginning, kMapOrLog);
    return {kind, std::move(input)};
}

io::Input open_log(const std::filesystem::path& path) {
    io::Input input = open_unless_folder(path, kLog);
    const io::InputFile& beginning = input.beginning();
    const io::FileNature nature = io::find_file_nature(beginning.bytes, beginning.name);
    // A short one may be a log all the same, whose reader says what is wrong with it.
    const bool is_short = beginning.bytes.size() < io::kBeginningBytes;
    const bool is_log = nature.kind == FileKind::laser_log || (nature.what.empty() && is_short);
    if (!is_log) refuse(beginning, kLog);
    return input;
}

}  // namespace quadcut
