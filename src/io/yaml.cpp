// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/yaml.hpp"

#include <cstddef>
#include <new>

#include <yaml.h>

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

// libyaml's own limit is high enough for it to spend hours on a megabyte of brackets.
constexpr int kMaxDepth = 32;

/// Hands out libyaml's events, one at a time.
class EventReader {
public:
    EventReader(std::string_view bytes, const std::string& name) : name_(name) {
        if (yaml_parser_initialize(&parser_) == 0) throw std::bad_alloc();
        yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(bytes.data()),
                                     bytes.size());
    }
    EventReader(const EventReader&) = delete;
    EventReader& operator=(const EventReader&) = delete;
    ~EventReader() {
        yaml_event_delete(&event_);
        yaml_parser_delete(&parser_);
    }

    [[nodiscard]] const yaml_event_t& event() const { return event_; }
    [[nodiscard]] std::uint64_t line() const { return event_.start_mark.line + 1; }

    yaml_event_type_t next() {
        yaml_event_delete(&event_);
        if (yaml_parser_parse(&parser_, &event_) == 0) {
            const std::string problem = parser_.problem == nullptr ? "no memory" : parser_.problem;
            if (parser_.error == YAML_READER_ERROR) {
                throw InputError(name_ + ": byte " + std::to_string(parser_.problem_offset) +
                                 ": not a YAML: " + problem);
            }
            fail(parser_.problem_mark.line + 1, "not a YAML: " + problem);
        }
        return event_.type;
    }

    [[noreturn]] void fail(std::uint64_t line, const std::string& what) const {
        throw InputError(name_ + ": line " + std::to_string(line) + ": " + what);
    }

private:
    const std::string& name_;
    yaml_parser_t parser_{};
    yaml_event_t event_{};
};

/// Reads the node that the reader's event begins.
YamlNode read_node(EventReader& reader, int depth) {
    YamlNode node;
    node.line = reader.line();
    yaml_event_type_t end = YAML_NO_EVENT;
    switch (reader.event().type) {
        case YAML_SCALAR_EVENT:
            node.kind = YamlKind::scalar;
            node.text.assign(reinterpret_cast<const char*>(reader.event().data.scalar.value),
                             reader.event().data.scalar.length);
            return node;
        case YAML_SEQUENCE_START_EVENT:
            node.kind = YamlKind::list;
            end = YAML_SEQUENCE_END_EVENT;
            break;
        case YAML_MAPPING_START_EVENT:
            node.kind = YamlKind::mapping;
            end = YAML_MAPPING_END_EVENT;
            break;
        case YAML_ALIAS_EVENT:
            node.kind = YamlKind::alias;
            return node;
        default:
            return node;
    }
    if (depth >= kMaxDepth) {
        reader.fail(node.line, "nested deeper than the " + std::to_string(kMaxDepth) +
                                   " levels that are read at most");
    }
    while (reader.next() != end) node.items.push_back(read_node(reader, depth + 1));
    return node;
}

}  // namespace

YamlNode parse_yaml(std::string_view bytes, const std::string& name, std::size_t max_bytes) {
    if (bytes.size() > max_bytes) {
        throw InputError(name + ": larger than the " + std::to_string(max_bytes) +
                         " bytes that a YAML may have");
    }
    EventReader reader(bytes, name);
    while (reader.next() != YAML_DOCUMENT_START_EVENT) {
        if (reader.event().type == YAML_STREAM_END_EVENT) return {};
    }
    reader.next();
    return read_node(reader, 0);
}

}  // namespace quadcut::io
