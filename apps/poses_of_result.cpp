// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/poses_of_result.hpp"

#include <memory>
#include <system_error>
#include <utility>

#include "io/file.hpp"
#include "io/file_kind.hpp"
#include "io/input.hpp"
#include "io/poses.hpp"
#include "io/run_info.hpp"
#include "io/scan_source.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut {
namespace {

/// The log that was cut, if it is there.
std::optional<io::Input> find_log(const std::filesystem::path& folder, const std::string& input) {
    if (input.empty() || input == io::kStandardInput) return std::nullopt;
    for (const std::filesystem::path& path : {std::filesystem::path(input), folder / input}) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(path, error)) continue;
        io::Input file(path);
        const io::InputFile& beginning = file.beginning();
        const io::FileKind kind = io::find_file_nature(beginning.bytes, beginning.name).kind;
        if (kind == io::FileKind::laser_log) return file;
    }
    return std::nullopt;
}

}  // namespace

ResultPoses poses_of_result(const std::filesystem::path& folder, const io::StoredResult& result,
                            double resolution_m,
                            const std::optional<std::filesystem::path>& given) {
    ResultPoses found;
    if (std::optional<io::Input> log = find_log(folder, result.input)) {
        const auto source = io::open_scan_source(*std::move(log), {given, resolution_m, {}});
        while (const std::optional<Scan> scan = source->next()) {
            found.poses.push_back(scan->world_from_sensor);
        }
        const io::SourceFacts& facts = source->facts();
        const bool is_known = !result.input_hash.empty();
        if (is_known && io::hash_text(facts.content_hash) != result.input_hash) {
            found.warnings.push_back(facts.name + ": has changed since its rooms were cut");
        }
    } else if (given) {
        for (const io::TimedPose& pose : io::read_poses(*given)) found.poses.push_back(pose.pose);
    } else {
        const std::string input = result.input.empty() ? "" : ", " + result.input + ",";
        throw InputError(io::display_name(folder) + ": what its rooms were cut in" + input +
                         " is no log that is there: give the poses of its scans with --poses FILE");
    }
    return found;
}

}  // namespace quadcut
