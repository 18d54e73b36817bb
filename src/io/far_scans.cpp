// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/far_scans.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "io/number_text.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

/// A scan that says something.
struct Sight {
    std::size_t scan = 0;
    Point at;
    /// What it may reach.
    Box cells;
};

/// Sights whose poses are connected.
struct Part {
    std::vector<Sight> sights;
    Box cells;
    std::size_t num_squares = 0;
};

using Squares = std::map<std::pair<std::int64_t, std::int64_t>, std::vector<Sight>>;

std::int64_t num_cells(const Box& box) {
    return box.is_empty() ? 0 : std::int64_t{box.width()} * box.height();
}

Box with(Box box, const Box& other) {
    box.include(other);
    return box;
}

/// Of each coordinate.
Point median_of(const std::vector<Sight>& sights) {
    std::vector<double> xs;
    std::vector<double> ys;
    for (const Sight& sight : sights) {
        xs.push_back(sight.at.x);
        ys.push_back(sight.at.y);
    }
    const auto middle = static_cast<std::ptrdiff_t>(sights.size() / 2);
    std::nth_element(xs.begin(), xs.begin() + middle, xs.end());
    std::nth_element(ys.begin(), ys.begin() + middle, ys.end());
    return {xs[sights.size() / 2], ys[sights.size() / 2]};
}

/// Takes the squares that one can walk to out of `squares`.
Part take_part(Squares& squares) {
    Part part;
    std::vector<Squares::key_type> waiting{squares.begin()->first};
    while (!waiting.empty()) {
        const auto [x, y] = waiting.back();
        waiting.pop_back();
        const auto found = squares.find({x, y});
        if (found == squares.end()) continue;
        ++part.num_squares;
        for (const Sight& sight : found->second) {
            part.cells.include(sight.cells);
            part.sights.push_back(sight);
        }
        squares.erase(found);
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
            for (std::int64_t dx = -1; dx <= 1; ++dx) waiting.emplace_back(x + dx, y + dy);
        }
    }
    return part;
}

/// The largest first; of two as large the one that lies further left, or lower.
std::vector<Part> connected_parts(const std::vector<Sight>& sights) {
    Squares squares;
    for (const Sight& sight : sights) {
        squares[{static_cast<std::int64_t>(std::floor(sight.at.x / kPoseGapM)),
                 static_cast<std::int64_t>(std::floor(sight.at.y / kPoseGapM))}]
            .push_back(sight);
    }
    std::vector<Part> parts;
    while (!squares.empty()) parts.push_back(take_part(squares));
    const auto largest =
        std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
            return std::pair(a.num_squares, a.sights.size()) <
                   std::pair(b.num_squares, b.sights.size());
        });
    if (largest != parts.end()) std::rotate(parts.begin(), largest, largest + 1);
    return parts;
}

/// "100 km", "1.41 km" or "340 m".
std::string length_text(double length_m) {
    constexpr double kKilometre = 1000.0;
    return length_m < kKilometre ? rounded(length_m, 0) + " m"
                                 : rounded(length_m / kKilometre, 2) + " km";
}

/// Takes parts and scans into one map while they fit, and says which do not.
class Selection {
public:
    Selection(std::size_t num_scans, const ExtentLimit& limit, const Point& middle)
        : limit_(limit), middle_(middle) {
        far_.is_far.assign(num_scans, false);
    }

    void take_one_by_one(Part part) {
        std::sort(part.sights.begin(), part.sights.end(), [&](const Sight& a, const Sight& b) {
            return std::tuple(distance(a.at, middle_), a.at.x, a.at.y, num_cells(a.cells)) <
                   std::tuple(distance(b.at, middle_), b.at.x, b.at.y, num_cells(b.cells));
        });
        for (const Sight& sight : part.sights) {
            const Box box = with(box_, sight.cells);
            if (num_cells(box) <= limit_.most) {
                box_ = box;
            } else {
                leave_out(sight, box, limit_.most);
            }
        }
        num_connected_ = num_cells(box_);
    }

    void take_as_a_whole(const Part& part) {
        const Box box = with(box_, part.cells);
        const std::int64_t connected = num_connected_ + num_cells(part.cells);
        const std::int64_t allowed =
            std::min(limit_.most, limit_.scattered + limit_.scattered_per_cell * connected);
        if (num_cells(box) <= allowed) {
            box_ = box;
            num_connected_ = connected;
            return;
        }
        for (const Sight& sight : part.sights) leave_out(sight, box, allowed);
    }

    void leave_out(std::size_t scan, std::string reason) {
        if (far_.count++ == 0 || scan < far_.first) {
            far_.first = scan;
            far_.reason = std::move(reason);
        }
        far_.is_far[scan] = true;
    }

    [[nodiscard]] FarScans take() { return std::move(far_); }

private:
    void leave_out(const Sight& sight, const Box& box, std::int64_t allowed) {
        leave_out(sight.scan,
                  "the pose (" + rounded(sight.at.x, 2) + ", " + rounded(sight.at.y, 2) + ") is " +
                      length_text(distance(sight.at, middle_)) +
                      " from the middle of the others: with it the map would span " +
                      std::to_string(box.width()) + " x " + std::to_string(box.height()) +
                      " cells, expected at most " + std::to_string(allowed));
    }

    ExtentLimit limit_;
    Point middle_;
    FarScans far_;
    Box box_;
    /// Cells of the boxes around the parts that were taken.
    std::int64_t num_connected_ = 0;
};

double distance_to(const Part& part, const Point& point) {
    double nearest = HUGE_VAL;
    for (const Sight& sight : part.sights) nearest = std::min(nearest, distance(sight.at, point));
    return nearest;
}

}  // namespace

FarScans find_far_scans(std::span<const Scan> scans, double resolution_m,
                        const ExtentLimit& limit) {
    const OccupancyMap nothing(resolution_m);
    std::vector<Sight> sights;
    std::map<std::size_t, std::string> unusable;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const Pose& pose = scans[i].world_from_sensor;
        try {
            const Box cells = cells_in_reach(nothing, scans[i]);
            if (!cells.is_empty()) sights.push_back({i, {pose.x, pose.y}, cells});
        } catch (const InputError& error) {
            unusable.emplace(i, error.what());
        }
    }
    std::vector<Part> parts = connected_parts(sights);
    const Point middle = parts.empty() ? Point{} : median_of(parts.front().sights);
    Selection selection(scans.size(), limit, middle);
    for (auto& [scan, why] : unusable) selection.leave_out(scan, std::move(why));
    if (parts.empty()) return selection.take();
    selection.take_one_by_one(std::move(parts.front()));
    parts.erase(parts.begin());
    std::stable_sort(parts.begin(), parts.end(), [&](const Part& a, const Part& b) {
        return distance_to(a, middle) < distance_to(b, middle);
    });
    for (const Part& part : parts) selection.take_as_a_whole(part);
    return selection.take();
}

}  // namespace quadcut::io
