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
#include "io/room_list.hpp"

namespace quadcut::formats {
namespace {

bool is_count(const OptionField& option, const std::string& text) {
    const CountOrWord* const count = std::get_if<CountOrWord>(&option.value);
    return count != nullptr && text == std::to_string(*count->value);
}

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
        } else if (const std::string text = io::option_text(option); is_count(option, text)) {
            json.integer(*std::get<CountOrWord>(option.value).value);
        } else {
            json.text(text);
        }
    }
    json.end_object();
}

void write_numbers(io::JsonWriter& json, const std::vector<double>& values) {
    json.begin_array();
    for (const double value : values) json.exact_number(value);
    json.end_array();
}

/// Of all pairs, those that share nothing among them, how many are independent.
void write_independence(io::JsonWriter& json, const Independence& parts) {
    const std::size_t num_left = parts.num_pairs() - parts.pairs.size();
    const auto write_shared = [&](const SharedScans& scans) {
        json.begin_object().key("either").integer(scans.either).key("both").integer(scans.both);
        json.key("share").number(scans.share()).end_object();
    };
    json.begin_object();
    json.key("num_parts").integer(parts.num_parts);
    json.key("num_scans").integer(parts.num_scans);
    json.key("seen_outside").number(parts.seen_outside);
    json.key("num_pairs").integer(parts.num_pairs());
    json.key("num_independent")
        .integer(num_left + num_independent(parts.pairs, &PairIndependence::all));
    json.key("num_independent_given_doors")
        .integer(num_left + num_independent(parts.pairs, &PairIndependence::given_doors));
    json.key("pairs").begin_array(io::JsonLayout::lines);
    for (const PairIndependence& pair : parts.pairs) {
        json.begin_object().key("a").integer(pair.a).key("b").integer(pair.b);
        json.key("num_doors").integer(pair.num_doors).key("all");
        write_shared(pair.all);
        json.key("given_doors");
        write_shared(pair.given_doors);
        json.end_object();
    }
    json.end_array().end_object();
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
    const io::RoomTotals totals = io::totals_of(result.rooms());
    json.key("num_rooms").integer(totals.num_rooms);
    json.key("num_glimpses").integer(totals.num_glimpses);
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
    if (info.independence) {
        json.key("independence").begin_object(io::JsonLayout::lines).key("zones");
        write_independence(json, info.independence->zones);
        json.key("rooms");
        write_independence(json, info.independence->rooms);
        json.end_object();
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
