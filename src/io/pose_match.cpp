// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/pose_match.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/number_text.hpp"

namespace quadcut::io {
namespace {

bool are_numbered(const std::vector<TimedPose>& poses, std::size_t num_scans) {
    return std::all_of(poses.begin(), poses.end(), [num_scans](const TimedPose& pose) {
        return pose.time_s == std::floor(pose.time_s) && pose.time_s >= 0.0 &&
               pose.time_s < static_cast<double>(num_scans);
    });
}

Pose between(const TimedPose& before, const TimedPose& after, double time_s) {
    const double length = after.time_s - before.time_s;
    const double share = length > 0.0 ? (time_s - before.time_s) / length : 0.0;
    // The shorter way round.
    const double turn =
        std::remainder(after.pose.yaw_rad - before.pose.yaw_rad, 2.0 * std::acos(-1.0));
    return {before.pose.x + share * (after.pose.x - before.pose.x),
            before.pose.y + share * (after.pose.y - before.pose.y),
            before.pose.yaw_rad + share * turn};
}

/// @pre poses are in order of time and not empty.
std::optional<Pose> pose_at(const std::vector<TimedPose>& poses, double time_s) {
    const auto after =
        std::lower_bound(poses.begin(), poses.end(), time_s,
                         [](const TimedPose& pose, double time) { return pose.time_s < time; });
    if (after == poses.end()) {
        if (time_s - poses.back().time_s > kPoseReach) return std::nullopt;
        return poses.back().pose;
    }
    if (after == poses.begin()) {
        if (after->time_s - time_s > kPoseReach) return std::nullopt;
        return after->pose;
    }
    return between(*(after - 1), *after, time_s);
}

std::string span_text(double first, double last) { return rounded(first) + " to " + rounded(last); }

}  // namespace

PoseMatch::PoseMatch(std::vector<TimedPose> poses, std::size_t num_scans)
    : poses_(std::move(poses)), are_numbered_(are_numbered(poses_, num_scans)) {
    std::stable_sort(poses_.begin(), poses_.end(),
                     [](const TimedPose& a, const TimedPose& b) { return a.time_s < b.time_s; });
}

std::optional<Pose> PoseMatch::pose_of(std::size_t number, double time_s) const {
    return pose_at(poses_, are_numbered_ ? static_cast<double>(number) : time_s);
}

std::string PoseMatch::why_none(double first_s, double last_s) const {
    return "the poses are of " + span_text(poses_.front().time_s, poses_.back().time_s) +
           " s, the scans of " + span_text(first_s, last_s) + " s";
}

}  // namespace quadcut::io
