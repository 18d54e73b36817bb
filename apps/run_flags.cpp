// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/run_flags.hpp"

#include <algorithm>
#include <vector>

#include "io/input.hpp"
#include "io/option_text.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/base/option_field.hpp"

namespace quadcut {
namespace {

constexpr const char* kFreeFlag = "--free-thresh";
constexpr const char* kOccupiedFlag = "--occupied-thresh";
constexpr const char* kNegateFlag = "--negate";
constexpr const char* kTrustFlag = "--trust-yaml";

std::optional<double> threshold_of(const Arguments& arguments, std::string_view flag,
                                   std::string_view name) {
    const std::optional<std::string> text = arguments.value(flag);
    if (!text) return std::nullopt;
    double value = 0.0;
    io::set_option({{name, "", 0.0, 1.0, "", "", &value}}, name, *text);
    return value;
}

}  // namespace

Flag resolution_flag() {
    FollowOptions defaults;
    return flag_of(option_fields(defaults), "resolution", "M");
}

std::vector<Flag> grey_flags() {
    return {{kFreeFlag, "", "X",
             "pixels up to this darkness (0 white, 1 black) are free, whatever a YAML says"},
            {kOccupiedFlag, "", "X", "pixels from this darkness on are occupied"},
            {kNegateFlag, "", "", "black is free and white is occupied"},
            {kTrustFlag, "", "",
             "read the image by its keys to the letter, also where its greys contradict them"}};
}

bool has_grey_flag(const Arguments& arguments) {
    const std::vector<Flag> flags = grey_flags();
    return std::any_of(flags.begin(), flags.end(),
                       [&](const Flag& flag) { return arguments.has(flag.name); });
}

Flag poses_flag() {
    return {"--poses", "", "FILE",
            "where the robot was, TUM or g2o; for a log, poses of the laser that replace its own, "
            "by time stamp or, when they are numbered as in g2o, by number of the scan"};
}

Flag set_flag() {
    return {std::string(kSetFlag), "", "NAME=VALUE",
            "any other option ('quadcut options' lists them); may be repeated"};
}

bool has_scan_setting(const Arguments& arguments) {
    return std::any_of(arguments.flags.begin(), arguments.flags.end(), [](const auto& flag) {
        return flag.first == kSetFlag && flag.second.starts_with("scan.");
    });
}

Flag json_flag() { return {"--json", "", "", "print the summary as JSON"}; }

Flag quiet_flag() { return {"--quiet", "", "", "no progress bar and no summary"}; }

std::optional<double> resolution_of(const Arguments& arguments) {
    const std::optional<std::string> text = arguments.value("--resolution");
    if (!text) return std::nullopt;
    FollowOptions options;
    io::set_option(option_fields(options), "resolution", *text);
    return options.resolution_m;
}

io::MapReadOptions map_read_options_of(const Arguments& arguments) {
    io::MapReadOptions options;
    options.resolution_m = resolution_of(arguments);
    options.free_thresh = threshold_of(arguments, kFreeFlag, "free_thresh");
    options.occupied_thresh = threshold_of(arguments, kOccupiedFlag, "occupied_thresh");
    options.negate = arguments.has(kNegateFlag);
    if (arguments.has(kTrustFlag)) options.trust = io::GreyTrust::keys;
    return options;
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
