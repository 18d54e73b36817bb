// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/previous_result.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "io/fields.hpp"
#include "io/file.hpp"
#include "io/format_version.hpp"
#include "io/found_instead.hpp"
#include "io/image.hpp"
#include "io/number_text.hpp"
#include "io/room_text.hpp"
#include "io/yaml.hpp"
#include "io/yaml_keys.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/lost_frame.hpp"
#include "quadcut/rooms/previous.hpp"

namespace quadcut::io {
namespace {

/// Room for kMaxRoomId rooms with long names.
constexpr std::size_t kMaxLegendBytes = std::size_t{1} << 24U;

RoomKind kind_of(const YamlKeys& keys) {
    if (const std::optional<RoomKind> kind = room_kind(keys.text("kind"))) return *kind;
    keys.fail(keys.require("kind"), "kind", "room, corridor, hall or unknown");
}

/// The whole in results that do not say.
Seen seen_in(const YamlKeys& keys) {
    const YamlNode* node = keys.find("seen");
    if (node == nullptr) return Seen::whole;
    if (const std::optional<Seen> seen = seen_of(keys.text("seen"))) return *seen;
    keys.fail(*node, "seen", "whole, partly or glimpse");
}

/// The origin where there is none.
Point point_of(const YamlKeys& keys, std::string_view key) {
    const YamlNode* node = keys.find(key);
    if (node == nullptr) return {};
    std::array<std::optional<double>, 2> values;
    if (node->kind == YamlKind::list && node->items.size() == values.size()) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const YamlNode& item = node->items[i];
            if (item.kind == YamlKind::scalar) values[i] = parse_number(item.text);
        }
    }
    if (values[0] && values[1] && std::isfinite(*values[0]) && std::isfinite(*values[1])) {
        return {*values[0], *values[1]};
    }
    keys.fail(*node, key, "a point [x, y]");
}

std::optional<Rgb> color_of(const YamlKeys& keys) {
    const YamlNode* node = keys.find("color");
    if (node == nullptr) return std::nullopt;
    constexpr std::size_t kLength = 7;
    std::uint32_t color = 0;
    const char* const end = node->text.data() + node->text.size();
    const bool has_form = node->text.size() == kLength && node->text.front() == '#';
    if (!has_form || std::from_chars(node->text.data() + 1, end, color, 16).ptr != end) {
        keys.fail(*node, "color", "a colour as in \"#a0b1c2\"");
    }
    const auto channel = [color](unsigned shift) {
        return static_cast<std::uint8_t>(color >> shift & 0xFFU);
    };
    return Rgb{channel(16), channel(8), channel(0)};
}

/// Reads numbers that may not come twice.
class UniqueNumbers {
public:
    std::uint16_t read(const YamlKeys& keys, std::string_view key) {
        const auto number = static_cast<std::uint16_t>(keys.integer(key, 1, kMaxRoomId));
        if (is_taken_[number]) keys.fail(keys.require(key), key, "a number that no other room has");
        is_taken_[number] = true;
        return number;
    }

private:
    std::vector<bool> is_taken_ = std::vector<bool>(kMaxRoomId + 1, false);
};

void check_version(const YamlKeys& keys) {
    const YamlNode& node = keys.require("format_version");
    if (keys.integer("format_version", 1, INT32_MAX) > kFormatVersion) {
        keys.fail(node, "format_version",
                  "at most " + std::to_string(kFormatVersion) + ", all that this version reads");
    }
}

}  // namespace

RoomsLegend parse_rooms_yaml(std::string_view bytes, const std::string& name) {
    const YamlNode root = parse_yaml(bytes, name, kMaxLegendBytes);
    RoomsLegend legend;
    legend.map_keys = map_keys_of(root, name);
    const YamlKeys keys(root, name, "the rooms.yaml of a result");
    check_version(keys);
    const YamlNode& labels = keys.require("labels");
    if (labels.kind != YamlKind::list) keys.fail(labels, "labels", "a list of rooms");
    UniqueNumbers values;
    UniqueNumbers ids;
    std::uint32_t highest_id = 0;
    for (const YamlNode& entry : labels.items) {
        if (entry.kind != YamlKind::mapping) keys.fail(entry, "labels", "value, id, name, ...");
        const std::string where = "each of labels, also that of line " + std::to_string(entry.line);
        const YamlKeys room_keys(entry, name, where);
        Room room;
        legend.values.push_back(values.read(room_keys, "value"));
        room.id = RoomId{ids.read(room_keys, "id")};
        room.name = room_keys.text("name");
        room.kind = kind_of(room_keys);
        room.seen = seen_in(room_keys);
        if (room_keys.find("open_border") != nullptr) {
            room.open_border = room_keys.number("open_border");
        }
        room.centroid = point_of(room_keys, "centroid");
        room.label_point = point_of(room_keys, "label_point");
        if (const std::optional<Rgb> color = color_of(room_keys)) legend.colors[room.id] = *color;
        highest_id = std::max(highest_id, static_cast<std::uint32_t>(room.id));
        legend.rooms.push_back(std::move(room));
    }
    legend.next_id = highest_id + 1;
    if (const YamlNode* node = keys.find("next_id")) {
        const std::int64_t next_id = keys.integer("next_id", 1, kMaxRoomId + 1);
        if (next_id <= highest_id) {
            keys.fail(*node, "next_id", "more than the highest id, " + std::to_string(highest_id));
        }
        legend.next_id = static_cast<std::uint32_t>(next_id);
    }
    return legend;
}

PreviousResult parse_label_png(std::string_view bytes, const std::string& name, RoomsLegend legend,
                               const std::string& legend_name) {
    std::vector<std::uint16_t> label_of_value(kMaxRoomId + 1, 0);
    for (std::size_t i = 0; i < legend.values.size(); ++i) {
        label_of_value[legend.values[i]] = static_cast<std::uint16_t>(i + 1);
    }
    std::vector<std::size_t> num_cells(legend.rooms.size() + 1, 0);
    Raster<std::uint16_t> labels;
    const auto fail_at = [&](std::int32_t y, std::size_t x, std::uint16_t value) {
        std::string message = name + ": row " + std::to_string(y + 1) + ", column ";
        message += std::to_string(x + 1) + ": expected 0 or a value of the labels in ";
        message += legend_name + ", found " + std::to_string(value);
        throw InputError(message);
    };
    const auto take_row = [&](const ImageHeader& header, std::int32_t y,
                              std::span<const std::uint16_t> samples) {
        if (header.channels != 1) {
            throw InputError(name + ": expected the grey image of a result's labels, found " +
                             std::to_string(header.channels) + " channels");
        }
        if (y == 0) labels = Raster<std::uint16_t>({}, header.width, header.height);
        const std::size_t first = labels.offset({0, header.height - 1 - y});
        for (std::size_t x = 0; x < samples.size(); ++x) {
            const std::uint16_t label = label_of_value[samples[x]];
            if (label == 0 && samples[x] != 0) fail_at(y, x, samples[x]);
            labels.values[first + x] = label;
            ++num_cells[label];
        }
    };
    parse_png(bytes, name, take_row);
    // Multiplied as describe_rooms does: half of a room is to be exactly half.
    const double side_m = legend.map_keys.resolution_m;
    for (std::size_t i = 0; i < legend.rooms.size(); ++i) {
        legend.rooms[i].area_m2 = static_cast<double>(num_cells[i + 1]) * side_m * side_m;
    }
    return {std::move(legend), std::move(labels)};
}

PreviousResult read_previous_result(const std::filesystem::path& folder) {
    const std::filesystem::path yaml = folder / "rooms.yaml";
    if (!has_result(folder)) {
        throw InputError(display_name(folder) +
                         ": expected a folder with an earlier result, found " +
                         found_instead_of_result(folder));
    }
    const std::string yaml_name = display_name(yaml);
    RoomsLegend legend = parse_rooms_yaml(read_file(yaml, kMaxLegendBytes), yaml_name);
    const std::filesystem::path image = folder / legend.map_keys.image;
    return parse_label_png(read_file(image), display_name(image), std::move(legend), yaml_name);
}

EarlierRooms on_cells_of(const PreviousResult& previous, const GridMap& map) {
    const Box cells = map.states.box();
    EarlierRooms earlier{Raster<std::uint16_t>(cells), map.resolution_m, previous.legend.rooms,
                         previous.legend.next_id};
    const MapKeys& keys = previous.legend.map_keys;
    const Pose old_from_new = compose(inverse(keys.map_from_image), map.map_from_image);
    const double scale = map.resolution_m / keys.resolution_m;
    const double step_x = std::cos(old_from_new.yaw_rad) * scale;
    const double step_y = std::sin(old_from_new.yaw_rad) * scale;
    const Point origin{old_from_new.x / keys.resolution_m, old_from_new.y / keys.resolution_m};
    const double width = previous.labels.width;
    const double height = previous.labels.height;
    std::size_t to = 0;
    for (std::int32_t row = 0; row < cells.height(); ++row) {
        const double v = cells.low.y + row + 0.5;
        for (std::int32_t column = 0; column < cells.width(); ++column, ++to) {
            const double u = cells.low.x + column + 0.5;
            const double x = origin.x + step_x * u - step_y * v;
            const double y = origin.y + step_y * u + step_x * v;
            // Compared before they are made whole: another map may be anywhere.
            if (!(x >= 0.0 && x < width && y >= 0.0 && y < height)) continue;
            earlier.labels.values[to] =
                previous.labels.at({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)});
        }
    }
    return earlier;
}

PlacedRooms place_on_map(PreviousResult previous, const GridMap& map) {
    PlacedRooms placed{on_cells_of(previous, map), {}};
    MapKeys& keys = previous.legend.map_keys;
    const bool is_alike = keys.resolution_m == map.resolution_m &&
                          keys.map_from_image.yaw_rad == map.map_from_image.yaw_rad;
    if (!is_alike || !rooms_still_there(placed.rooms.labels, map.states).values.empty()) {
        return placed;
    }
    const std::optional<Cell> shift = find_shift(previous.labels, map.states);
    if (!shift) return placed;
    const Point before{keys.map_from_image.x, keys.map_from_image.y};
    keys.map_from_image = compose(map.map_from_image,
                                  {shift->x * map.resolution_m, shift->y * map.resolution_m, 0.0});
    placed.rooms = on_cells_of(previous, map);
    placed.warnings.push_back(
        "the earlier result fits the map when it is moved by " +
        with_decimals(keys.map_from_image.x - before.x, 2) + ", " +
        with_decimals(keys.map_from_image.y - before.y, 2) +
        " m, and not where its own frame has it: it was moved; mend the origin of one of the maps");
    return placed;
}

}  // namespace quadcut::io
