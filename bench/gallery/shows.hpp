// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/gallery/index_page.hpp"

namespace quadcut::gallery {

/// Maps with true rooms: `NAME.KIND.yaml` beside `NAME.rooms.png`.
[[nodiscard]] Section show_true_maps(const std::filesystem::path& data,
                                     const std::filesystem::path& output);
/// Maps as robots scan them, each with what is wrong: those of one kind of bench/data_map.hpp.
[[nodiscard]] Section show_real_maps(const std::string& kind, const std::string& title,
                                     const std::filesystem::path& output);
/// Laser logs, mapped; intel.log and its dense form beside their truth.
[[nodiscard]] Section show_logs(const std::filesystem::path& data,
                                const std::filesystem::path& output);
/// Maps without a truth.
[[nodiscard]] Section show_other_maps(const std::filesystem::path& data,
                                      const std::filesystem::path& output);
/// Simulated buildings, and from them the pictures of README and docs: `pictures/gallery.png`, and
/// of the demo's building `before.png` and `after.png`.
[[nodiscard]] Section show_simulated(const std::filesystem::path& output);

}  // namespace quadcut::gallery
