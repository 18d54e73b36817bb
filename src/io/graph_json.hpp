// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <string>

#include "quadcut/segment/result.hpp"

namespace quadcut::io {

/// Rooms as nodes and doors as edges, in the node-link form that graph libraries read: nodes have
/// an id and lie at their room's label point, edges have source and target, two rooms may have
/// several. Metres, map frame.
[[nodiscard]] std::string to_graph_json(const Segmentation& segmentation);

}  // namespace quadcut::io
