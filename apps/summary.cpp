// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "apps/summary.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include <unistd.h>

#include "io/json_writer.hpp"
#include "io/number_text.hpp"
#include "io/room_events.hpp"

namespace quadcut {
namespace {

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

void print_text(const RunSummary& run) {
    const Segmentation& rooms = run.rooms;
    const io::RoomTotals totals = io::totals_of(rooms);
    std::cout << counted(totals.num_rooms, "room") << ", " << counted(rooms.doors.size(), "door")
              << ", " << io::rounded(totals.area_m2, 1) << " m²; ";
    if (totals.num_glimpses > 0) {
        const bool is_one = totals.num_glimpses == 1;
        std::cout << totals.num_glimpses << (is_one ? " glimpse; " : " glimpses; ");
    }
    std::cout << io::rounded(ms_since(run.begun_at), 0) << " ms\n";
    if (run.events) std::cout << io::events_text(*run.events) << "\n";
    if (is_for_people() && !rooms.rooms.empty()) {
        std::cout << "\n" << io::room_table(rooms, kTerminalTable) << "\n";
    }
    std::cout << files_line(run.folder, run.files);
    const auto plan = std::find(run.files.begin(), run.files.end(), "rooms.svg");
    if (is_for_people() && plan != run.files.end()) {
        std::cout << "open " << (std::filesystem::path(run.folder) / *plan).string() << "\n";
    }
}

void print_json(const RunSummary& run) {
    io::JsonWriter json;
    json.begin_object(io::JsonLayout::lines);
    io::write_rooms_and_doors(json, run.rooms);
    if (run.events) {
        json.key("previous");
        io::write_events(json, *run.events);
    }
    json.key("elapsed_ms").number(ms_since(run.begun_at));
    json.key("output").text(run.folder);
    json.key("files").begin_array();
    for (const std::string& file : run.files) json.text(file);
    json.end_array();
    json.end_object();
    std::cout << json.finish();
}

}  // namespace

bool is_for_people() { return ::isatty(STDOUT_FILENO) == 1; }

std::string files_line(const std::string& folder, const std::vector<std::string>& files) {
    std::string line = folder + ":";
    for (const std::string& file : files) line += " " + file;
    return line + "\n";
}

void print_summary(const RunSummary& run, SummaryStyle style) {
    if (style == SummaryStyle::text) print_text(run);
    if (style == SummaryStyle::json) print_json(run);
}

}  // namespace quadcut
