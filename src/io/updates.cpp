// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/updates.hpp"

#include "io/json_writer.hpp"
#include "io/room_events.hpp"

namespace quadcut::io {

std::string to_json_line(const FollowUpdate& update) {
    JsonWriter json;
    json.begin_object();
    json.key("scan").integer(update.scan);
    json.key("integrate_ms").number(update.integrate_ms);
    json.key("segment_ms").number(update.segment_ms);
    json.key("num_leaves").integer(update.num_leaves);
    json.key("nodes_touched").integer(update.nodes_touched);
    json.key("nodes_rebuilt").integer(update.nodes_rebuilt);
    json.key("ps").number(update.ps, 6);
    json.key("graph_nodes").integer(update.graph_nodes);
    json.key("rooms").integer(update.num_rooms);
    json.key("relabelled_m2").number(update.relabelled_m2);
    json.key("revision").integer(update.changes.revision);
    json.key("events").begin_array();
    for (const RoomEvent& event : update.events) write_event(json, event);
    json.end_array().end_object();
    return json.finish();
}

}  // namespace quadcut::io
