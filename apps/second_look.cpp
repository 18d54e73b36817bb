// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/second_look.hpp"

namespace quadcut {

std::vector<Sighting> look_again(io::ScanSource& source, const GridMap& map,
                                 const Segmentation& rooms, const IntegrateOptions& options,
                                 const RunOptions& run) {
    source.rewind();
    return sightings_of([&source] { return source.next(); }, map, rooms, options, run.executor());
}

}  // namespace quadcut
