// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "formats/format.hpp"
#include "io/map_writer.hpp"

namespace quadcut::formats {

Format map_format() {
    return {"map", "the map, as map_server reads it", Part::map, io::map_files(),
            [](const Result& result) { return io::encode_map(result.map()); }};
}

}  // namespace quadcut::formats
