// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace quadcut {

/// The time that a Pace goes by, in seconds from any beginning.
struct PaceClock {
    std::function<double()> now_s;
    std::function<void(double time_s)> sleep_until_s;
};

/// The steady clock of the machine.
[[nodiscard]] PaceClock machine_clock();

/// Plays scans in the time that their stamps say. A wait is 5 s at most: a hole of years in the
/// stamps, where a robot's clock was set, holds nobody up. Stamps may run backwards.
class Pace {
public:
    /// So many times as fast as the robot was; 0: without any wait.
    Pace(double speed, PaceClock clock);

    /// Waits until the next scan is due; `refine` is called meanwhile for as long as it is true.
    /// A scan without a stamp (not finite) is due at once.
    void wait_for(double stamp_s, const std::function<bool()>& refine);

    /// What is to be said of the holes that were shortened; nothing when there were none.
    [[nodiscard]] std::optional<std::string> warning() const;

private:
    /// When a scan of this stamp is due, by the clock.
    double due_after(double stamp_s);

    double speed_;
    PaceClock clock_;
    std::optional<double> last_stamp_s_;
    double due_s_ = 0.0;
    std::size_t num_holes_ = 0;
    double longest_hole_s_ = 0.0;
};

}  // namespace quadcut
