// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_yaml.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "io/fields.hpp"
#include "io/yaml.hpp"
#include "io/yaml_keys.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::string_view kWhere = "a map_server YAML";

/// By MapMode.
constexpr std::array<std::string_view, 3> kModes{"trinary", "scale", "raw"};

double fraction(const YamlKeys& keys, std::string_view key) {
    const double value = keys.number(key);
    if (!(value >= 0.0 && value <= 1.0)) keys.fail(keys.require(key), key, "a number from 0 to 1");
    return value;
}

Pose pose(const YamlKeys& keys, std::string_view key) {
    const YamlNode& node = keys.require(key);
    if (node.kind != YamlKind::list) keys.fail(node, key, "[x, y, yaw]");
    std::array<double, 3> values{};
    if (node.items.size() != values.size()) {
        throw InputError(keys.place(node, key) + "expected three numbers [x, y, yaw], found " +
                         std::to_string(node.items.size()));
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        constexpr double kMaxDistance = 1e7;
        const YamlNode& item = node.items[i];
        const std::optional<double> value =
            item.kind == YamlKind::scalar ? parse_number(item.text) : std::nullopt;
        if (!value || !(std::abs(*value) <= kMaxDistance)) {
            keys.fail(item, key, "finite numbers within 10,000 km");
        }
        values[i] = *value;
    }
    return {values[0], values[1], values[2]};
}

/// A whole number, 0 = no, or a word.
bool flag(const YamlKeys& keys, std::string_view key) {
    const YamlNode& node = keys.require(key);
    if (const std::optional<std::int64_t> number = parse_integer(node.text)) return *number != 0;
    const std::string text = lower_case(node.text);
    if (text == "true" || text == "yes" || text == "on" || text == "y") return true;
    if (text == "false" || text == "no" || text == "off" || text == "n") return false;
    keys.fail(node, key, "0 or 1, true or false");
}

MapMode mode_of(const YamlKeys& keys, std::string_view key) {
    const YamlNode* node = keys.find(key);
    if (node == nullptr) return MapMode::trinary;
    const auto found = std::find(kModes.begin(), kModes.end(), node->text);
    if (found == kModes.end()) keys.fail(*node, key, "trinary, scale or raw");
    return static_cast<MapMode>(found - kModes.begin());
}

std::string path(const YamlKeys& keys, std::string_view key) {
    const YamlNode& node = keys.require(key);
    if (node.text.empty() || node.text.find('\0') != std::string::npos) {
        keys.fail(node, key, "the path of an image");
    }
    return node.text;
}

}  // namespace

std::string_view to_text(MapMode mode) { return kModes[static_cast<std::size_t>(mode)]; }

void check_resolution(double resolution_m, const std::string& place) {
    constexpr double kMin = 0.001;
    constexpr double kMax = 10.0;
    if (resolution_m >= kMin && resolution_m <= kMax) return;
    throw InputError(place + "expected a resolution of 0.001 to 10 metres a pixel");
}

MapKeys parse_map_yaml(std::string_view bytes, const std::string& name) {
    return map_keys_of(parse_yaml(bytes, name), name);
}

MapKeys map_keys_of(const YamlNode& root, const std::string& name) {
    if (root.kind != YamlKind::mapping) {
        throw InputError(name + ": expected the keys of " + std::string(kWhere) +
                         " (image, resolution, origin, ...)");
    }
    const YamlKeys reader(root, name, kWhere);
    MapKeys keys;
    keys.image = path(reader, "image");
    keys.mode = mode_of(reader, "mode");
    keys.resolution_m = reader.number("resolution");
    check_resolution(keys.resolution_m, reader.place(reader.require("resolution"), "resolution"));
    keys.map_from_image = pose(reader, "origin");
    keys.negate = flag(reader, "negate");
    keys.occupied_thresh = fraction(reader, "occupied_thresh");
    keys.free_thresh = fraction(reader, "free_thresh");
    if (keys.free_thresh > keys.occupied_thresh) {
        reader.fail(reader.require("free_thresh"), "free_thresh",
                    "at most occupied_thresh, which is lower");
    }
    return keys;
}

}  // namespace quadcut::io
