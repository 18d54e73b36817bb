// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// How steady rooms are while a map grows: the fifteen stages of one floor (data/real/growing), each
// with the rooms of the stage before as `segment --previous` takes them:
//   measure_growing [-o FILE.json]
// Of the cells that are free and have a room in both of two stages, the share whose room has
// another id now than then. Ways: `previous`; `ids`: each stage is cut for itself, only the ids are
// handed on; `truth`: the rooms that people drew, each stage's given the ids of those of the stage
// before that they overlap most, by a best assignment. An id is given away when both stages have
// it, and most of its room's cells of then (those that have a room now) are in one of another id
// now. PQ is without the void (eval::without_void). See docs/decisions/0026-hysteresis.md.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bench/cases.hpp"
#include "bench/data_map.hpp"
#include "bench/result_file.hpp"
#include "eval/labels.hpp"
#include "eval/score.hpp"
#include "io/previous_result.hpp"
#include "quadcut/follow/track.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"

namespace quadcut {
namespace {

/// Ids of rooms on the cells of a map; 0 = none.
struct Stage {
    GridMap map;
    Raster<std::uint32_t> ids;
};

struct Change {
    std::size_t num_cells = 0;
    std::size_t num_changed = 0;
    std::size_t ids_given_away = 0;
};

Change change_between(const Stage& then, const Stage& now) {
    const Raster<std::uint32_t> earlier = labels_at(then.map, then.ids, now.map);
    std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> now_of_then;
    Change change;
    for (std::size_t i = 0; i < earlier.values.size(); ++i) {
        if (earlier.values[i] == 0 || now.ids.values[i] == 0) continue;
        ++change.num_cells;
        if (earlier.values[i] != now.ids.values[i]) ++change.num_changed;
        ++now_of_then[earlier.values[i]][now.ids.values[i]];
    }
    const std::set<std::uint32_t> ids(now.ids.values.begin(), now.ids.values.end());
    for (const auto& [id, rooms] : now_of_then) {
        std::size_t num_cells = 0;
        std::size_t most_of_another = 0;
        for (const auto& [room, count] : rooms) {
            num_cells += count;
            if (room != id) most_of_another = std::max(most_of_another, count);
        }
        if (ids.count(id) != 0 && 2 * most_of_another > num_cells) ++change.ids_given_away;
    }
    return change;
}

Raster<std::uint32_t> ids_of(const Segmentation& rooms) {
    Raster<std::uint32_t> ids(rooms.labels.box());
    for (std::size_t i = 0; i < ids.values.size(); ++i) {
        const std::uint16_t label = rooms.labels.values[i];
        if (label == 0) continue;
        ids.values[i] = static_cast<std::uint32_t>(rooms.rooms[label - std::size_t{1}].id);
    }
    return ids;
}

/// The true rooms of a stage, with the ids of those of the stage before.
Stage true_stage(const DataMap& data, const Stage* before) {
    Stage stage{data.map, as_raster(data.truth)};
    stage.ids.origin = data.map.states.origin;
    if (before == nullptr) return stage;
    std::uint32_t next_id = 1;
    for (const std::uint32_t id : before->ids.values) next_id = std::max(next_id, id + 1);
    // Numbers of the images, and ids.
    const Raster<std::uint32_t> earlier = labels_at(before->map, before->ids, data.map);
    const io::LabelImage then = as_label_image(earlier, 0);
    std::vector<std::uint32_t> id_of(then.num_regions + std::size_t{1}, 0);
    const Raster<std::uint32_t> numbers = as_raster(then);
    for (std::size_t i = 0; i < earlier.values.size(); ++i)
        id_of[numbers.values[i]] = earlier.values[i];
    std::map<std::uint32_t, std::uint32_t> id_of_now;
    for (const eval::RoomMatch& match : eval::match_rooms(then, as_label_image(stage.ids, 0))) {
        id_of_now[match.truth] = id_of[match.predicted];
    }
    for (std::uint32_t& id : stage.ids.values) {
        if (id == 0) continue;
        const auto [at, is_new] = id_of_now.try_emplace(id, next_id);
        if (is_new) ++next_id;
        id = at->second;
    }
    return stage;
}

/// A result as --previous reads it.
io::PreviousResult as_previous(const GridMap& map, const Segmentation& rooms) {
    io::PreviousResult previous;
    previous.legend.map_keys.resolution_m = map.resolution_m;
    previous.legend.map_keys.map_from_image = map.map_from_image;
    previous.legend.rooms = rooms.rooms;
    previous.legend.next_id = rooms.next_id;
    previous.labels = rooms.labels;
    previous.labels.origin = {0, 0};
    return previous;
}

enum class Way : std::uint8_t { previous, ids };

Segmentation cut_stage(const GridMap& map, Way way, const io::PreviousResult* before) {
    const RunOptions run{2};
    if (before == nullptr) return segment(map, {}, run);
    EarlierRooms earlier = io::on_cells_of(*before, map);
    Segmentation rooms =
        way == Way::previous ? segment(map, {}, run, {}, earlier.labels) : segment(map, {}, run);
    return track(std::move(rooms), earlier).segmentation;
}

double pq_of(const DataMap& data, const Segmentation& rooms) {
    return 100.0 * eval::score_rooms(eval::without_void(as_label_image(rooms.labels), data.truth,
                                                        data.surely_free),
                                     data.truth)
                       .pq;
}

Json row_of(const std::string& way, const std::string& stage) {
    Json row;
    row["way"] = way;
    row["stage"] = stage;
    return row;
}

void add_change(Json& row, const Change& change) {
    row["cells"] = change.num_cells;
    row["changed_percent"] = percent(change.num_changed, change.num_cells);
    row["ids_given_away"] = change.ids_given_away;
}

void print(const Json& row) {
    std::printf("| %-8s | %-12s |", row["way"].get<std::string>().c_str(),
                row["stage"].get<std::string>().c_str());
    if (row.contains("rooms")) {
        std::printf(" %2zu | %5.1f |", row["rooms"].get<std::size_t>(), row["pq"].get<double>());
    } else {
        std::printf("    |       |");
    }
    if (row.contains("cells")) {
        std::printf(" %5.2f | %zu |", row["changed_percent"].get<double>(),
                    row["ids_given_away"].get<std::size_t>());
    }
    std::printf("\n");
    std::fflush(stdout);
}

void measure_way(const std::vector<DataMap>& maps, Way way, Json& rows) {
    io::PreviousResult before;
    Stage then;
    for (const DataMap& data : maps) {
        const bool is_first = &data == &maps.front();
        const Segmentation rooms = cut_stage(data.map, way, is_first ? nullptr : &before);
        Stage now{data.map, ids_of(rooms)};
        Json row = row_of(way == Way::previous ? "previous" : "ids", data.name);
        row["rooms"] = rooms.rooms.size();
        row["pq"] = pq_of(data, rooms);
        if (!is_first) add_change(row, change_between(then, now));
        print(row);
        rows.push_back(std::move(row));
        before = as_previous(data.map, rooms);
        then = std::move(now);
    }
}

void measure_truth(const std::vector<DataMap>& maps, Json& rows) {
    Stage then;
    for (const DataMap& data : maps) {
        const bool is_first = &data == &maps.front();
        Stage now = true_stage(data, is_first ? nullptr : &then);
        if (!is_first) {
            Json row = row_of("truth", data.name);
            add_change(row, change_between(then, now));
            print(row);
            rows.push_back(std::move(row));
        }
        then = std::move(now);
    }
}

void print_means(const Json& rows, const std::string& way) {
    double sum = 0.0;
    double most = 0.0;
    double pq = 0.0;
    std::size_t num_steps = 0;
    std::size_t num_given_away = 0;
    for (const Json& row : rows) {
        if (row["way"] != way) continue;
        if (row.contains("pq")) pq += row["pq"].get<double>();
        if (!row.contains("cells")) continue;
        ++num_steps;
        sum += row["changed_percent"].get<double>();
        most = std::max(most, row["changed_percent"].get<double>());
        num_given_away += row["ids_given_away"].get<std::size_t>();
    }
    if (num_steps == 0) return;
    std::printf("%s: changed %.2f %% a stage, %.2f %% at worst; ids given away %zu", way.c_str(),
                sum / static_cast<double>(num_steps), most, num_given_away);
    if (pq > 0.0) std::printf("; PQ %.1f", pq / static_cast<double>(num_steps + 1));
    std::printf("\n");
}

/// All files say that their image begins at (0, 0), but three times the image has grown to the left
/// and upwards: by so many cells, at which most of the walls of both stages meet.
struct Growth {
    const char* stage;
    double left = 0.0;
    double up = 0.0;
};
constexpr std::array<Growth, 3> kGrowths{
    {{"cartesium_05", 217.0, 38.0}, {"cartesium_08", 248.0, 44.0}, {"cartesium_11", 217.0, 38.0}}};

/// The stages in one frame.
std::vector<DataMap> read_stages() {
    std::vector<DataMap> maps = read_real_maps("ubremen_cartesium");
    std::erase_if(maps, [](const DataMap& map) { return map.kind != "growing"; });
    Pose frame;
    for (DataMap& data : maps) {
        for (const Growth& growth : kGrowths) {
            if (data.name != growth.stage) continue;
            frame.x -= growth.left * data.map.resolution_m;
            frame.y += growth.up * data.map.resolution_m;
        }
        data.map.map_from_image = frame;
    }
    return maps;
}

int run(int argc, char** argv) {
    const std::vector<DataMap> maps = read_stages();
    if (maps.empty()) {
        std::fprintf(stderr, "data/real/growing is not there\n");
        return 1;
    }
    std::printf(
        "| way | stage | rooms | PQ | changed, %% | ids given away |\n|---|---|---|---|---|---|\n");
    Json rows = Json::array();
    measure_truth(maps, rows);
    for (const Way way : {Way::ids, Way::previous}) measure_way(maps, way, rows);
    for (const char* way : {"truth", "ids", "previous"}) print_means(rows, way);
    write_results(output_path(argc, argv), "growing", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
