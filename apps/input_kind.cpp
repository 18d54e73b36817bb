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

io::InputFile read_unless(const std::filesystem::path& path, std::string_view expected,
                          const io::BeginningCheck& check) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) refuse_folder(path, expected);
    return io::read_input(path, check);
}

[[noreturn]] void refuse(const io::InputFile& file, std::string_view expected) {
    throw InputError(io::describe_refusal(file.bytes, file.name, expected));
}

}  // namespace

KnownInput read_map_or_log(const std::filesystem::path& path) {
    FileKind kind = FileKind::unknown;
    io::InputFile file = read_unless(path, kMapOrLog, [&kind](const io::InputFile& beginning) {
        kind = io::find_file_nature(beginning.bytes, beginning.name).kind;
        if (kind == FileKind::unknown || kind == FileKind::poses) refuse(beginning, kMapOrLog);
    });
    return {kind, std::move(file)};
}

io::InputFile read_log(const std::filesystem::path& path) {
    return read_unless(path, kLog, [](const io::InputFile& beginning) {
        const io::FileNature nature = io::find_file_nature(beginning.bytes, beginning.name);
        // A short one may be a log all the same, whose reader says what is wrong with it.
        const bool is_short = beginning.bytes.size() < io::kBeginningBytes;
        if (nature.kind == FileKind::laser_log || (nature.what.empty() && is_short)) return;
        refuse(beginning, kLog);
    });
}

}  // namespace quadcut
