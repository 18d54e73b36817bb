// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace quadcut {

/// A path in the folder of maps and logs that some tests read: QUADCUT_SHARED of the environment,
/// or else ../shared beside the repository. It need not be there.
inline std::filesystem::path shared_path(std::string_view relative_path) {
    const char* const folder = std::getenv("QUADCUT_SHARED");
    return std::filesystem::path(folder != nullptr ? folder : QUADCUT_SHARED_DIR) / relative_path;
}

}  // namespace quadcut
