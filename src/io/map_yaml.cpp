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
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

std::optional<double> to_number(const YamlNode& node) {
    return node.kind == YamlKind::scalar ? parse_number(node.text) : std::nullopt;
}

/// Reads typed values by key.
class KeyReader {
public:
    KeyReader(const YamlNode& root, const std::string& name) : root_(root), name_(name) {
        if (root.kind != YamlKind::mapping) {
            throw InputError(name +
                             ": expected the keys of a map_server YAML (image, resolution, "
                             "origin, ...)");
        }
    }

    [[noreturn]] void fail(const YamlNode& node, const char* key,
                           const std::string& expected) const {
        throw InputError(place(node, key) + "expected " + expected + ", found " +
                         (node.kind == YamlKind::scalar  ? quote(node.text)
                          : node.kind == YamlKind::alias ? "an alias"
                                                         : "a list or a mapping"));
    }

    [[nodiscard]] std::string place(const YamlNode& node, const char* key) const {
        return name_ + ": line " + std::to_string(node.line) + ": " + key + ": ";
    }

    /// Null when the key is not there.
    [[nodiscard]] const YamlNode* find(std::string_view key) const {
        const YamlNode* found = nullptr;
        for (std::size_t i = 0; i + 1 < root_.items.size(); i += 2) {
            const YamlNode& candidate = root_.items[i];
            if (candidate.kind != YamlKind::scalar || candidate.text != key) continue;
            if (found != nullptr) {
                throw InputError(name_ + ": line " + std::to_string(candidate.line) + ": the key " +
                                 quote(key) + " stands there a second time");
            }
            found = &root_.items[i + 1];
        }
        return found;
    }

    [[nodiscard]] const YamlNode& require(const char* key) const {
        const YamlNode* node = find(key);
        if (node == nullptr) {
            throw InputError(name_ + ": the key " + quote(key) +
                             " is missing, expected it in a map_server YAML");
        }
        return *node;
    }

    [[nodiscard]] double number(const char* key) const {
        const YamlNode& node = require(key);
        const std::optional<double> value = to_number(node);
        if (!value) fail(node, key, "a number");
        return *value;
    }

    [[nodiscard]] double fraction(const char* key) const {
        const double value = number(key);
        if (!(value >= 0.0 && value <= 1.0)) fail(require(key), key, "a number from 0 to 1");
        return value;
    }

    [[nodiscard]] Pose pose(const char* key) const {
        const YamlNode& node = require(key);
        if (node.kind != YamlKind::list) fail(node, key, "[x, y, yaw]");
        std::array<double, 3> values{};
        if (node.items.size() != values.size()) {
            throw InputError(place(node, key) + "expected three numbers [x, y, yaw], found " +
                             std::to_string(node.items.size()));
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            constexpr double kMaxDistance = 1e7;
            const std::optional<double> value = to_number(node.items[i]);
            if (!value || !(std::abs(*value) <= kMaxDistance)) {
                fail(node.items[i], key, "finite numbers within 10,000 km");
            }
            values[i] = *value;
        }
        return {values[0], values[1], values[2]};
    }

    /// A whole number, 0 = no, or a word.
    [[nodiscard]] bool flag(const char* key) const {
        const YamlNode& node = require(key);
        std::string text = node.text;
        if (const std::optional<std::int64_t> number = parse_integer(text)) return *number != 0;
        std::transform(text.begin(), text.end(), text.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        if (text == "true" || text == "yes" || text == "on" || text == "y") return true;
        if (text == "false" || text == "no" || text == "off" || text == "n") return false;
        fail(node, key, "0 or 1, true or false");
    }

    [[nodiscard]] MapMode mode(const char* key) const {
        const YamlNode* node = find(key);
        if (node == nullptr) return MapMode::trinary;
        constexpr std::array kModes = {MapMode::trinary, MapMode::scale, MapMode::raw};
        for (const MapMode mode : kModes) {
            if (node->text == to_string(mode)) return mode;
        }
        fail(*node, key, "trinary, scale or raw");
    }

    [[nodiscard]] std::string path(const char* key) const {
        const YamlNode& node = require(key);
        if (node.text.empty() || node.text.find('\0') != std::string::npos) {
            fail(node, key, "the path of an image");
        }
        return node.text;
    }

private:
    const YamlNode& root_;
    const std::string& name_;
};

}  // namespace

std::string to_string(MapMode mode) {
    switch (mode) {
        case MapMode::scale:
            return "scale";
        case MapMode::raw:
            return "raw";
        case MapMode::trinary:
            break;
    }
    return "trinary";
}

void check_resolution(double resolution_m, const std::string& place) {
    constexpr double kMin = 0.001;
    constexpr double kMax = 10.0;
    if (resolution_m >= kMin && resolution_m <= kMax) return;
    throw InputError(place + "expected a resolution of 0.001 to 10 metres a pixel");
}

MapKeys parse_map_yaml(std::string_view bytes, const std::string& name) {
    const YamlNode root = parse_yaml(bytes, name);
    const KeyReader reader(root, name);
    MapKeys keys;
    keys.image = reader.path("image");
    keys.mode = reader.mode("mode");
    keys.resolution_m = reader.number("resolution");
    check_resolution(keys.resolution_m, reader.place(reader.require("resolution"), "resolution"));
    keys.map_from_image = reader.pose("origin");
    keys.negate = reader.flag("negate");
    keys.occupied_thresh = reader.fraction("occupied_thresh");
    keys.free_thresh = reader.fraction("free_thresh");
    if (keys.free_thresh > keys.occupied_thresh) {
        reader.fail(reader.require("free_thresh"), "free_thresh",
                    "at most occupied_thresh, which is lower");
    }
    return keys;
}

}  // namespace quadcut::io
