// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <vector>

#include "quadcut/base/geometry.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/map/scan.hpp"
#include "sim/laser.hpp"
#include "sim/world.hpp"

namespace quadcut::sim {

struct ScannerOptions {
    LaserOptions laser;
    /// Glass returns a beam that meets it this squarely, and this share of the others.
    double square_rad = 0.15;
    double glints = 0.05;
    /// The share of beams that pass beside a leg that they meet.
    double passes = 0.0;
    /// How often a scan meets another person, who then stays for some scans.
    double people = 0.0;
};

/// A laser in a world with glass and people.
class Scanner {
public:
    Scanner(const World& world, const ScannerOptions& options, Random random);

    /// One sweep at a pose; people walk on between two.
    [[nodiscard]] Scan scan(const Pose& world_from_sensor);

private:
    struct Person {
        Point at;
        Point step;
        int num_scans = 0;
    };
    [[nodiscard]] double range_of(const Point& from, double angle);
    [[nodiscard]] std::uint8_t glass_at(const Point& p) const;
    void walk(const Pose& robot);
    void stand_in_the_way(Scan& scan) const;

    ScannerOptions options_;
    Random random_;
    double resolution_m_;
    Point origin_;
    Raster<std::uint8_t> glass_;
    RayCaster all_;
    RayCaster without_glass_;
    std::vector<Person> people_;
};

}  // namespace quadcut::sim
