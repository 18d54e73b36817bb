// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/format_version.hpp"
#include "io/json_writer.hpp"
#include "reproduce/report.hpp"

namespace quadcut::reproduce {
namespace {

constexpr int kDecimals = 6;

void write_value(io::JsonWriter& json, const Value& value) {
    if (value.number) {
        json.number(*value.number, kDecimals);
    } else if (!value.words.empty()) {
        json.text(value.words);
    } else {
        json.null();
    }
}

void write_table(io::JsonWriter& json, const Table& table) {
    json.begin_object(io::JsonLayout::lines);
    json.key("title").text(table.title);
    json.key("rows").begin_array(io::JsonLayout::lines);
    for (const Row& row : table.rows) {
        json.begin_object();
        json.key("quantity").text(row.quantity);
        json.key("unit").text(row.unit);
        json.key("values").begin_object();
        for (std::size_t i = 0; i < row.values.size(); ++i) {
            json.key(table.columns[i]);
            write_value(json, row.values[i]);
        }
        json.end_object();
        json.end_object();
    }
    json.end_array();
    json.end_object();
}

void write_claim(io::JsonWriter& json, const Claim& claim) {
    json.begin_object();
    json.key("quantity").text(claim.quantity);
    json.key("holds").boolean(holds(claim));
    json.key("measured").text(measured_text(claim));
    json.key("limit").text(limit_text(claim));
    json.key("reason").text(claim.reason);
    json.end_object();
}

void write_figure(io::JsonWriter& json, const Figure& figure) {
    json.begin_object(io::JsonLayout::lines);
    json.key("number").text(figure.number);
    json.key("title").text(figure.title);
    json.key("paper").text(figure.paper);
    json.key("setting").text(figure.setting);
    json.key("agrees").boolean(agrees(figure.claims));
    json.key("verdict").text(verdict(figure.claims));
    json.key("claims").begin_array(io::JsonLayout::lines);
    for (const Claim& claim : figure.claims) write_claim(json, claim);
    json.end_array();
    json.key("pictures").begin_array();
    for (const Picture& picture : figure.pictures) json.text(picture.file);
    json.end_array();
    json.key("tables").begin_array(io::JsonLayout::lines);
    for (const Table& table : figure.tables) write_table(json, table);
    json.end_array();
    json.end_object();
}

}  // namespace

std::string to_json(const Report& report) {
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    json.key("format_version").integer(io::kFormatVersion);
    json.key("version").text(report.version);
    json.key("commit").text(report.commit);
    json.key("command").text(report.command);
    json.key("seed").integer(report.seed);
    json.key("threads").integer(report.num_threads);
    json.key("machine").begin_object();
    json.key("cpu").text(report.machine.cpu);
    json.key("cores").integer(report.machine.num_cores);
    json.key("compiler").text(report.machine.compiler);
    json.key("load").number(report.machine.load);
    json.end_object();
    json.key("simulated").boolean(report.is_simulated);
    json.key("worlds").begin_array(io::JsonLayout::lines);
    for (const std::string& world : report.worlds) json.text(world);
    json.end_array();
    json.key("elapsed_ms").number(report.elapsed_s * 1e3);
    json.key("summary").begin_array(io::JsonLayout::lines);
    for (const Headline& line : report.headlines) {
        json.begin_object();
        json.key("what").text(line.what);
        json.key("paper_ms").number(line.paper_ms);
        json.key("quadcut_ms").number(line.quadcut_ms);
        json.key("setting").text(line.setting);
        json.end_object();
    }
    json.end_array();
    json.key("figures").begin_array(io::JsonLayout::lines);
    for (const Figure& figure : report.figures) write_figure(json, figure);
    json.end_array();
    json.end_object();
    return json.finish();
}

}  // namespace quadcut::reproduce
