// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <utility>
#include <variant>

#include "formats/format.hpp"
#include "io/format_version.hpp"
#include "io/json_writer.hpp"
#include "io/option_text.hpp"
#include "io/room_events.hpp"

namespace quadcut::formats {
namespace {

void write_options(io::JsonWriter& json, const std::vector<OptionField>& options) {
    json.begin_object(io::JsonLayout::lines);
    for (const OptionField& option : options) {
        json.key(option.name);
        if (double* const* real = std::get_if<double*>(&option.value)) {
            json.exact_number(**real);
        } else if (std::size_t* const* count = std::get_if<std::size_t*>(&option.value)) {
            json.integer(**count);
        } else if (int* const* whole = std::get_if<int*>(&option.value)) {
            json.number(**whole);
        } else {
            json.text(io::option_text(option));
        }
    }
    json.end_object();
}

void write_numbers(io::JsonWriter& json, const std::vector<double>& values) {
    json.begin_array();
    for (const double value : values) json.exact_number(value);
    json.end_array();
}

/// Nothing when there are none.
void write_zones(io::JsonWriter& json, const Zones& zones) {
    if (zones.count == 0) return;
    const bool is_seen = zones.weights == ZoneWeights::covisibility;
    json.key("zones").begin_object().key("count").integer(zones.count);
    json.key("weights").text(is_seen ? "covisibility" : "conductance").key("eigenvalues");
    write_numbers(json, zones.eigenvalues);
    json.key("gaps");
    write_numbers(json, zones.gaps);
    json.end_object();
}

/// What was read, with which options, what came out, and how long each stage took; all else is the
/// same for the same input.
std::string to_json(const Result& result) {
    const GridMap& map = result.map();
    const io::RunInfo& info = result.info();
    const SegmentReport& report = result.rooms().report;
    std::vector<std::pair<std::string, double>> stages_ms = report.stages_ms;
    stages_ms.emplace_back("write", result.elapsed_ms());
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    json.key("format_version").integer(io::kReportVersion);
    json.key("version").text(info.version);
    json.key("input").text(info.input);
    json.key("input_hash").text(io::hash_text(info.input_hash));
    json.key("map").begin_object();
    json.key("width").integer(static_cast<std::uint64_t>(map.states.width));
    json.key("height").integer(static_cast<std::uint64_t>(map.states.height));
    json.key("resolution_m").exact_number(map.resolution_m);
    json.end_object();
    json.key("options");
    write_options(json, info.options);
    json.key("num_rooms").integer(result.rooms().rooms.size());
    json.key("num_doors").integer(result.rooms().doors.size());
    json.key("num_leaves").integer(report.num_leaves);
    json.key("num_edges").integer(report.num_edges);
    json.key("eigen").begin_array(io::JsonLayout::lines);
    for (const EigenReport& cut : report.eigen) {
        json.begin_object().key("num_nodes").integer(cut.num_nodes).key("eigenvalues");
        write_numbers(json, cut.eigenvalues);
        json.key("residuals");
        write_numbers(json, cut.residuals);
        json.end_object();
    }
    json.end_array();
    write_zones(json, result.rooms().zones);
    json.key("warnings").begin_array(io::JsonLayout::lines);
    for (const std::string& warning : report.warnings) json.text(warning);
    json.end_array();
    if (info.events) {
        json.key("previous");
        io::write_events(json, *info.events);
    }
    json.key("stages_ms").begin_object();
    for (const auto& [stage, ms] : stages_ms) json.key(stage).number(ms);
    // Whoever reads reports finds all stages of the method: what was not needed took no time.
    for (const std::string stage : {"map", "graph", "eigen", "cluster", "fuse"}) {
        const bool is_listed =
            std::any_of(stages_ms.begin(), stages_ms.end(),
                        [&](const auto& listed) { return listed.first == stage; });
        if (!is_listed) json.key(stage).number(0.0);
    }
    return json.end_object().end_object().finish();
}

}  // namespace

Format report_format() {
    return {"report",
            "how the result was made: input, options, times",
            Part::report,
            {"report.json"},
            [](const Result& result) { return contents(to_json(result)); }};
}

}  // namespace quadcut::formats
