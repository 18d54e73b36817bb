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

/// By their places among all.
using Scans = std::vector<std::uint32_t>;
using Squares = std::map<std::pair<std::int64_t, std::int64_t>, Scans>;

/// Scans whose poses are connected.
struct Part {
    Scans scans;
    std::size_t num_squares = 0;
};

Point point_of(const ScanReach& scan) { return {scan.pose.x, scan.pose.y}; }

/// What scans may reach.
class Reaches {
public:
    explicit Reaches(double resolution_m) : nothing_(resolution_m) { scan_.max_range_m = HUGE_VAL; }
    /// Throws InputError when the pose is no place.
    [[nodiscard]] Box cells_of(const ScanReach& scan) {
        scan_.world_from_sensor = scan.pose;
        scan_.ranges_m.assign(1, scan.longest_m);
        return cells_in_reach(nothing_, scan_);
    }

private:
    OccupancyMap nothing_;
    Scan scan_;
};

std::int64_t num_cells(const Box& box) {
    return box.is_empty() ? 0 : std::int64_t{box.width()} * box.height();
}

Box with(Box box, const Box& other) {
    box.include(other);
    return box;
}

/// Of each coordinate.
Point median_of(std::span<const ScanReach> all, const Scans& scans) {
    const auto median = [&](double Pose::*coordinate) {
        std::vector<double> values;
        values.reserve(scans.size());
        for (const std::uint32_t scan : scans) values.push_back(all[scan].pose.*coordinate);
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    };
    return {median(&Pose::x), median(&Pose::y)};
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
        part.scans.insert(part.scans.end(), found->second.begin(), found->second.end());
        squares.erase(found);
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
            for (std::int64_t dx = -1; dx <= 1; ++dx) waiting.emplace_back(x + dx, y + dy);
        }
    }
    return part;
}

/// The largest first; of two as large the one that lies further left, or lower.
std::vector<Part> connected_parts(Squares squares) {
    std::vector<Part> parts;
    while (!squares.empty()) parts.push_back(take_part(squares));
    const auto largest =
        std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
            return std::pair(a.num_squares, a.scans.size()) <
                   std::pair(b.num_squares, b.scans.size());
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
    Selection(std::span<const ScanReach> scans, Reaches& reaches, const ExtentLimit& limit)
        : scans_(scans), reaches_(reaches), limit_(limit) {}

    void take_one_by_one(Part part, const Point& middle) {
        middle_ = middle;
        const auto order = [&](std::uint32_t scan) {
            const ScanReach& reach = scans_[scan];
            return std::tuple(distance(point_of(reach), middle), reach.pose.x, reach.pose.y,
                              reach.longest_m);
        };
        std::sort(part.scans.begin(), part.scans.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return order(a) < order(b); });
        for (const std::uint32_t scan : part.scans) {
            const Box box = with(box_, reaches_.cells_of(scans_[scan]));
            if (num_cells(box) <= limit_.most) {
                box_ = box;
            } else {
                leave_out(scan, box, limit_.most);
            }
        }
        num_connected_ = num_cells(box_);
    }

    void take_as_a_whole(const Part& part) {
        Box cells;
        for (const std::uint32_t scan : part.scans) cells.include(reaches_.cells_of(scans_[scan]));
        const Box box = with(box_, cells);
        const std::int64_t connected = num_connected_ + num_cells(cells);
        const std::int64_t allowed =
            std::min(limit_.most, limit_.scattered + limit_.scattered_per_cell * connected);
        if (num_cells(box) <= allowed) {
            box_ = box;
            num_connected_ = connected;
            return;
        }
        for (const std::uint32_t scan : part.scans) leave_out(scan, box, allowed);
    }

    void leave_out(std::uint32_t scan, std::string reason) {
        if (far_.count++ == 0 || scan < far_.first) {
            far_.first = scan;
            far_.reason = std::move(reason);
        }
        far_.is_far.resize(scans_.size(), false);
        far_.is_far[scan] = true;
    }

    [[nodiscard]] FarScans take() { return std::move(far_); }

private:
    void leave_out(std::uint32_t scan, const Box& box, std::int64_t allowed) {
        const Point at = point_of(scans_[scan]);
        leave_out(scan, "the pose (" + rounded(at.x, 2) + ", " + rounded(at.y, 2) + ") is " +
                            length_text(distance(at, middle_)) +
                            " from the middle of the others: with it the map would span " +
                            std::to_string(box.width()) + " x " + std::to_string(box.height()) +
                            " cells, expected at most " + std::to_string(allowed));
    }

    std::span<const ScanReach> scans_;
    Reaches& reaches_;
    ExtentLimit limit_;
    Point middle_;
    FarScans far_;
    Box box_;
    /// Cells of the boxes around the parts that were taken.
    std::int64_t num_connected_ = 0;
};

/// The scans that say something, by the square that they are in; those that are nowhere are left
/// out.
Squares squares_of(std::span<const ScanReach> scans, Reaches& reaches, Selection& selection) {
    Squares squares;
    for (std::uint32_t i = 0; i < scans.size(); ++i) {
        try {
            if (reaches.cells_of(scans[i]).is_empty()) continue;
        } catch (const InputError& error) {
            selection.leave_out(i, error.what());
            continue;
        }
        squares[{static_cast<std::int64_t>(std::floor(scans[i].pose.x / kPoseGapM)),
                 static_cast<std::int64_t>(std::floor(scans[i].pose.y / kPoseGapM))}]
            .push_back(i);
    }
    return squares;
}

}  // namespace

FarScans find_far_scans(std::span<const ScanReach> scans, double resolution_m,
                        const ExtentLimit& limit) {
    Reaches reaches(resolution_m);
    Selection selection(scans, reaches, limit);
    std::vector<Part> parts = connected_parts(squares_of(scans, reaches, selection));
    if (parts.empty()) return selection.take();
    const Point middle = median_of(scans, parts.front().scans);
    selection.take_one_by_one(std::move(parts.front()), middle);
    parts.erase(parts.begin());
    std::vector<std::pair<double, const Part*>> others;
    for (const Part& part : parts) {
        double nearest = HUGE_VAL;
        for (const std::uint32_t scan : part.scans) {
            nearest = std::min(nearest, distance(point_of(scans[scan]), middle));
        }
        others.emplace_back(nearest, &part);
    }
    std::stable_sort(others.begin(), others.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [nearest, part] : others) selection.take_as_a_whole(*part);
    return selection.take();
}

}  // namespace quadcut::io
