// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "reproduce/figure.hpp"
#include "reproduce/machine.hpp"

namespace quadcut::reproduce {

/// All that was measured in one run.
struct Report {
    std::string version;
    /// What it was built from: "1a2b3c4d", "-dirty" behind it when more than documents differed,
    /// "unknown" without a repository.
    std::string commit;
    std::string command;
    Machine machine;
    std::size_t num_threads = 1;
    std::uint64_t seed = 1;
    double elapsed_s = 0.0;
    /// What each experiment ran on, one line each.
    std::vector<std::string> worlds;
    /// No measured data: all worlds are simulated.
    bool is_simulated = true;
    std::vector<Headline> headlines;
    std::vector<Figure> figures;
};

/// The page: one file that needs only the pictures beside it; well-formed as XML, too.
[[nodiscard]] std::string html_page(const Report& report);

/// All figures, tables and verdicts. Numbers of rows whose unit ends in ms are times: they differ
/// from run to run.
[[nodiscard]] std::string to_json(const Report& report);

}  // namespace quadcut::reproduce
