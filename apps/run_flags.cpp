// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/run_flags.hpp"

#include <vector>

#include "io/file.hpp"
#include "io/option_text.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/base/option_field.hpp"

namespace quadcut {
namespace {

std::vector<OptionField> resolution_fields(double& resolution_m) {
    return {{"resolution", "m", 0.001, 10.0, "side of a cell", "", &resolution_m}};
}

}  // namespace

Flag resolution_flag() {
    double resolution_m = kLogResolution;
    return flag_of(resolution_fields(resolution_m)[0], "M");
}

Flag poses_flag() {
    return {"--poses", "", "FILE",
            "where the robot was, TUM or g2o; for a log, poses of the laser that replace its own, "
            "by time stamp or, when they are numbered as in g2o, by number of the scan"};
}

Flag json_flag() { return {"--json", "", "", "print the summary as JSON"}; }

Flag quiet_flag() { return {"--quiet", "", "", "no progress bar and no summary"}; }

std::optional<double> resolution_of(const Arguments& arguments) {
    const std::optional<std::string> text = arguments.value("--resolution");
    if (!text) return std::nullopt;
    double resolution_m = 0.0;
    io::set_option(resolution_fields(resolution_m), "resolution", *text);
    return resolution_m;
}

std::optional<std::filesystem::path> poses_of(const Arguments& arguments) {
    const std::optional<std::string> poses = arguments.value("--poses");
    if (poses == io::kStandardInput && arguments.operands.at(0) == io::kStandardInput) {
        throw InputError("standard input: given twice, expected the poses or the other in a file");
    }
    return poses;
}

ProgressStyle progress_style_of(const Arguments& arguments) {
    return progress_style(arguments.has("--quiet") ? ProgressStyle::none : ProgressStyle::bar);
}

SummaryStyle summary_style_of(const Arguments& arguments) {
    if (arguments.has("--json")) return SummaryStyle::json;
    return arguments.has("--quiet") ? SummaryStyle::none : SummaryStyle::text;
}

}  // namespace quadcut
