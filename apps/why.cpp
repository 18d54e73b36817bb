// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "quadcut/explain/why.hpp"

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "apps/command.hpp"
#include "apps/map_of_result.hpp"
#include "apps/message.hpp"
#include "apps/numbers.hpp"
#include "apps/run_flags.hpp"
#include "io/file.hpp"
#include "io/option_text.hpp"
#include "io/stored_result.hpp"
#include "io/why_text.hpp"
#include "project/building_at.hpp"
#include "project/project.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/segment/options.hpp"

namespace quadcut {
namespace {

/// What is asked about: a map, how it was cut, and the rooms it has.
struct Asked {
    GridMap map;
    SegmentOptions options;
    std::shared_ptr<const Snapshot> building;
};

void require_preset_rooms(const SegmentOptions& options, const std::string& name) {
    if (options.preset == Preset::rooms) return;
    throw InputError(name +
                     ": its submaps are of the preset paper, which measures no openings: expected "
                     "rooms, as 'quadcut segment MAP -o DIR' makes them without --preset paper");
}

/// As report.json tells them; those that it does not tell are as they are by themselves.
SegmentOptions options_of(const io::StoredResult& result, const std::filesystem::path& folder) {
    SegmentOptions options;
    std::vector<OptionField> fields;
    add_fields(options, fields);
    for (const OptionField& field : fields) {
        const auto told = result.options.find(std::string(field.name));
        if (told == result.options.end()) continue;
        try {
            io::set_option(fields, field.name, told->second);
        } catch (const InputError& error) {
            throw InputError(io::display_name(folder / "report.json") + ": " + error.what());
        }
    }
    return options;
}

Asked asked_in_folder(const std::filesystem::path& folder) {
    const io::StoredResult result = io::read_stored_result(folder);
    Asked asked;
    asked.options = options_of(result, folder);
    require_preset_rooms(asked.options, io::display_name(folder));
    io::MapFile file = map_of_result(folder, result, std::nullopt);
    print_warnings(file.warnings);
    asked.map = std::move(file.map);
    asked.building = building_at(folder, Wanted::rooms);
    return asked;
}

Asked asked_in_project(const std::filesystem::path& path) {
    const Project project = Project::open(path, Access::read);
    require_preset_rooms(project.options().segment, io::display_name(path));
    const std::shared_ptr<const Snapshot> building = project.snapshot();
    return {building->map(), project.options().segment, building};
}

std::string name_of(const Asked& asked, const Point& point) {
    const Place place = asked.building->place_of(point);
    if (!place.is_inside) return "no room";
    return std::to_string(index(place.room)) + ' ' + place.name;
}

void run(const Arguments& arguments) {
    const std::filesystem::path where = arguments.operands[0];
    const Point point = point_of(arguments.operands[1], arguments.operands[2]);
    const bool is_project = room_place_of(where) == RoomPlace::project;
    const Asked asked = is_project ? asked_in_project(where) : asked_in_folder(where);
    const Why answer = why(asked.map, asked.options, point);
    io::WrittenWhy written{answer, asked.options.rooms, {}};
    if (answer.border) {
        for (std::size_t i = 0; i < written.rooms.size(); ++i) {
            written.rooms[i] = name_of(asked, answer.border->sides[i]);
        }
        const bool is_told_otherwise = (answer.border->decision.verdict == Verdict::cut) ==
                                       (written.rooms[0] == written.rooms[1]);
        if (is_told_otherwise) {
            print_warnings({io::display_name(where) +
                            ": has it otherwise here than this cut, by an edit, an earlier result "
                            "or a trajectory"});
        }
    }
    std::cout << (summary_style_of(arguments) == SummaryStyle::json ? io::why_as_json(written)
                                                                    : io::why_as_text(written));
}

}  // namespace

Command why_command() {
    CommandForm form;
    form.name = "why";
    form.text =
        "Says why the map is cut at a point, or is not (metres, map frame): what was measured at "
        "the border near it, and what decided.";
    form.operands = {"DIR|PROJECT", "X", "Y"};
    form.flags = {json_flag()};
    form.flags[0].text = "as JSON, with all cues and what each added";
    form.examples = {"quadcut why build/demo 0.9 0.7",
                     "quadcut why build/demo/building.quadcut 0.9 0.7 --json"};
    return {form, run};
}

}  // namespace quadcut
