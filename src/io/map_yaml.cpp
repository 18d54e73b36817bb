// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_yaml.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <new>
#include <optional>
#include <vector>

#include <yaml.h>

#include "io/fields.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kMaxYamlBytes = std::size_t{1} << 20U;

/// The first document of a YAML text. Aliases stay references, so a text of n bytes has at most n
/// nodes, and libyaml bounds how deep they nest.
class YamlDocument {
public:
    YamlDocument(std::string_view bytes, const std::string& name) {
        if (yaml_parser_initialize(&parser_) == 0) throw std::bad_alloc();
        yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(bytes.data()),
                                     bytes.size());
        if (yaml_parser_load(&parser_, &document_) == 0) {
            const std::string problem = describe_problem();
            yaml_parser_delete(&parser_);
            throw InputError(name + ": " + problem);
        }
    }
    YamlDocument(const YamlDocument&) = delete;
    YamlDocument& operator=(const YamlDocument&) = delete;
    ~YamlDocument() {
        yaml_document_delete(&document_);
        yaml_parser_delete(&parser_);
    }

    [[nodiscard]] yaml_node_t* root() { return yaml_document_get_root_node(&document_); }
    [[nodiscard]] yaml_node_t* node(int id) { return yaml_document_get_node(&document_, id); }

private:
    [[nodiscard]] std::string describe_problem() const {
        const std::string problem = parser_.problem == nullptr ? "no memory" : parser_.problem;
        if (parser_.error == YAML_READER_ERROR) {
            return "byte " + std::to_string(parser_.problem_offset) + ": not a YAML: " + problem;
        }
        return "line " + std::to_string(parser_.problem_mark.line + 1) + ": not a YAML: " + problem;
    }

    yaml_parser_t parser_{};
    yaml_document_t document_{};
};

std::string_view text_of(const yaml_node_t& node) {
    return {reinterpret_cast<const char*>(node.data.scalar.value), node.data.scalar.length};
}

/// The values of the document's top level, by key.
class KeyReader {
public:
    KeyReader(YamlDocument& document, const std::string& name) : document_(document), name_(name) {
        root_ = document.root();
        if (root_ == nullptr || root_->type != YAML_MAPPING_NODE) {
            throw InputError(name +
                             ": expected the keys of a map_server YAML (image, resolution, "
                             "origin, ...)");
        }
    }

    [[noreturn]] void fail(const yaml_node_t& node, const char* key,
                           const std::string& expected) const {
        const bool is_scalar = node.type == YAML_SCALAR_NODE;
        throw InputError(place(node, key) + "expected " + expected + ", found " +
                         (is_scalar ? quote(text_of(node)) : "a list or a mapping"));
    }

    [[nodiscard]] std::string place(const yaml_node_t& node, const char* key) const {
        return name_ + ": line " + std::to_string(node.start_mark.line + 1) + ": " + key + ": ";
    }

    /// Null when the key is not there.
    const yaml_node_t* find(std::string_view key) {
        const yaml_node_t* found = nullptr;
        for (yaml_node_pair_t* pair = root_->data.mapping.pairs.start;
             pair != root_->data.mapping.pairs.top; ++pair) {
            const yaml_node_t* key_node = document_.node(pair->key);
            if (key_node->type != YAML_SCALAR_NODE || text_of(*key_node) != key) continue;
            if (found != nullptr) {
                throw InputError(name_ + ": line " + std::to_string(key_node->start_mark.line + 1) +
                                 ": the key " + quote(key) + " stands there a second time");
            }
            found = document_.node(pair->value);
        }
        return found;
    }

    const yaml_node_t& require(const char* key) {
        const yaml_node_t* node = find(key);
        if (node == nullptr) {
            throw InputError(name_ + ": the key " + quote(key) +
                             " is missing, expected it in a map_server YAML");
        }
        return *node;
    }

    double number(const char* key) {
        const yaml_node_t& node = require(key);
        const std::optional<double> value = to_number(node);
        if (!value) fail(node, key, "a number");
        return *value;
    }

    double fraction(const char* key) {
        const double value = number(key);
        if (!(value >= 0.0 && value <= 1.0)) fail(require(key), key, "a number from 0 to 1");
        return value;
    }

    Pose pose(const char* key) {
        const yaml_node_t& node = require(key);
        if (node.type != YAML_SEQUENCE_NODE) fail(node, key, "[x, y, yaw]");
        std::vector<double> values;
        for (const yaml_node_item_t* item = node.data.sequence.items.start;
             item != node.data.sequence.items.top; ++item) {
            const yaml_node_t& element = *document_.node(*item);
            const std::optional<double> value = to_number(element);
            constexpr double kMaxDistance = 1e7;
            if (!value || !(std::abs(*value) <= kMaxDistance)) {
                fail(element, key, "finite numbers within 10,000 km");
            }
            values.push_back(*value);
        }
        if (values.size() != 3) {
            throw InputError(place(node, key) + "expected three numbers [x, y, yaw], found " +
                             std::to_string(values.size()));
        }
        return {values[0], values[1], values[2]};
    }

    /// A whole number, 0 = no, or a word.
    bool flag(const char* key) {
        const yaml_node_t& node = require(key);
        if (node.type != YAML_SCALAR_NODE) fail(node, key, "0 or 1, true or false");
        std::string text(text_of(node));
        if (const std::optional<std::int64_t> number = parse_integer(text)) return *number != 0;
        std::transform(text.begin(), text.end(), text.begin(),
                       [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
        if (text == "true" || text == "yes" || text == "on" || text == "y") return true;
        if (text == "false" || text == "no" || text == "off" || text == "n") return false;
        fail(node, key, "0 or 1, true or false");
    }

    MapMode mode(const char* key) {
        const yaml_node_t* node = find(key);
        if (node == nullptr) return MapMode::trinary;
        constexpr std::array kModes = {MapMode::trinary, MapMode::scale, MapMode::raw};
        for (const MapMode mode : kModes) {
            if (node->type == YAML_SCALAR_NODE && text_of(*node) == to_string(mode)) return mode;
        }
        fail(*node, key, "trinary, scale or raw");
    }

    std::string path(const char* key) {
        const yaml_node_t& node = require(key);
        if (node.type != YAML_SCALAR_NODE || node.data.scalar.length == 0) {
            fail(node, key, "the path of an image");
        }
        if (text_of(node).find('\0') != std::string_view::npos) fail(node, key, "a path");
        return std::string(text_of(node));
    }

private:
    static std::optional<double> to_number(const yaml_node_t& node) {
        if (node.type != YAML_SCALAR_NODE) return std::nullopt;
        return parse_number(text_of(node));
    }

    YamlDocument& document_;
    const std::string& name_;
    yaml_node_t* root_ = nullptr;
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
    if (bytes.size() > kMaxYamlBytes) {
        throw InputError(name + ": larger than the " + std::to_string(kMaxYamlBytes) +
                         " bytes that a map_server YAML may have");
    }
    YamlDocument document(bytes, name);
    KeyReader reader(document, name);
    MapKeys keys;
    keys.image = reader.path("image");
    keys.mode = reader.mode("mode");
    keys.resolution_m = reader.number("resolution");
    const yaml_node_t& resolution = reader.require("resolution");
    check_resolution(keys.resolution_m, reader.place(resolution, "resolution"));
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
