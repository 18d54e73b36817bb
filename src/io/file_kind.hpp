// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace quadcut::io {

enum class FileKind : std::uint8_t {
    unknown,  ///< none that is read
    image,
    map_yaml,
    laser_log,
    poses
};

/// What a file is.
struct FileNature {
    FileKind kind = FileKind::unknown;
    std::string_view what;     ///< "a ROS 1 bag"; empty when nobody knows
    std::string_view way_out;  ///< what to do with it where something else is expected
};

/// What a file is, by its first bytes (in gzip: by those that it unpacks to), and where they do not
/// say by the suffix of its name. Of `bytes` the first kBeginningBytes are looked at.
[[nodiscard]] FileNature find_file_nature(std::string_view bytes, std::string_view name);

/// "NAME: is a ROS 1 bag, expected EXPECTED: WAY OUT", as far as that is known.
[[nodiscard]] std::string describe_refusal(std::string_view bytes, const std::string& name,
                                           std::string_view expected);

}  // namespace quadcut::io
