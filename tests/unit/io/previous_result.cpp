// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/previous_result.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "formats/registry.hpp"
#include "io/image.hpp"
#include "quadcut/base/error.hpp"
#include "tests/unit/io/floor_drawing.hpp"
#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::drawn_floor;
using test::DrawnFloor;
using test::error_of;
using test::ScratchFolder;

const std::string kKeys =
    "image: rooms.png\n"
    "resolution: 0.05\n"
    "origin: [1, 2, 0]\n"
    "negate: 0\n"
    "occupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";
const std::string kKitchen =
    "  - {value: 4, id: 7, name: Kitchen, kind: hall, color: \"#0a1bFF\"}\n";
const std::string kGood =
    kKeys + "format_version: 1\nnext_id: 12\nlabels:\n" + kKitchen +
    "  - {value: 9, id: 3, name: \"room 3\", kind: room, area_m2: 99, whatever: [1]}\n";

RoomsLegend parse(const std::string& text) { return parse_rooms_yaml(text, "r.yaml"); }

/// kGood with one text in place of another.
std::string with(const std::string& from, const std::string& to) {
    std::string text = kGood;
    text.replace(text.find(from), from.size(), to);
    return text;
}

std::string error_with(const std::string& from, const std::string& to) {
    return error_of([&] { (void)parse(with(from, to)); });
}

TEST(PreviousResult, ReadsALegendThatSomebodyEdited) {
    const RoomsLegend legend = parse(kGood);
    ASSERT_EQ(legend.rooms.size(), 2U);
    EXPECT_EQ(index(legend.rooms[0].id), 7U);
    EXPECT_EQ(legend.rooms[0].name, "Kitchen");
    EXPECT_EQ(legend.rooms[0].kind, RoomKind::hall);
    EXPECT_EQ(legend.values, (std::vector<std::uint16_t>{4, 9}));
    EXPECT_EQ(legend.colors, (std::map<RoomId, Rgb>{{RoomId{7}, {0x0A, 0x1B, 0xFF}}}));
    EXPECT_EQ(legend.next_id, 12U);
    EXPECT_EQ(legend.map_keys.map_from_image, (Pose{1.0, 2.0, 0.0}));
}

TEST(PreviousResult, WithoutNextIdItIsOneMoreThanTheHighest) {
    EXPECT_EQ(parse(with("next_id: 12\n", "")).next_id, 8U);
    EXPECT_EQ(parse(kKeys + "format_version: 1\nlabels: []\n").next_id, 1U);
}

TEST(PreviousResult, RefusesALegendWithDefects) {
    const std::string first = "r.yaml: line 10: ";
    const std::string second = "r.yaml: line 11: ";
    EXPECT_EQ(error_with("value: 9", "value: 4"),
              second + "value: expected a number that no other room has, found \"4\"");
    EXPECT_EQ(error_with("id: 3", "id: 7"),
              second + "id: expected a number that no other room has, found \"7\"");
    EXPECT_EQ(error_with("id: 7", "id: 65536"),
              first + "id: expected a whole number from 1 to 65535, found \"65536\"");
    EXPECT_EQ(error_with("value: 4", "value: 0"),
              first + "value: expected a whole number from 1 to 65535, found \"0\"");
    EXPECT_EQ(error_with("id: 7", "id: seven"),
              first + "id: expected a whole number from 1 to 65535, found \"seven\"");
    EXPECT_EQ(error_with("name: Kitchen", "name: [a]"),
              first + "name: expected a text, found a list or a mapping");
    EXPECT_EQ(error_with("name: Kitchen, ", ""),
              "r.yaml: the key \"name\" is missing, expected it in each of labels, also that of "
              "line 10");
    EXPECT_EQ(error_with("kind: hall", "kind: cave"),
              first + "kind: expected room, corridor, hall or unknown, found \"cave\"");
    for (const std::string color : {"red", "#12345", "#1234567", "#12345g", "0123456"}) {
        EXPECT_EQ(error_with("#0a1bFF", color),
                  first + "color: expected a colour as in \"#a0b1c2\", found \"" + color + "\"");
    }
    EXPECT_EQ(error_with("next_id: 12", "next_id: 7"),
              "r.yaml: line 8: next_id: expected more than the highest id, 7, found \"7\"");
    EXPECT_EQ(error_with("next_id: 12", "next_id: 99999").find("r.yaml: line 8: next_id: "), 0U);
    EXPECT_EQ(error_with("format_version: 1", "format_version: 2"),
              "r.yaml: line 7: format_version: expected at most 1, all that this version reads, "
              "found \"2\"");
    EXPECT_EQ(error_with("format_version: 1\n", "").find("r.yaml: the key \"format_version\""), 0U);
    EXPECT_EQ(error_with(kKitchen, "  - Kitchen\n"),
              "r.yaml: line 10: labels: expected value, id, name, ..., found \"Kitchen\"");
    EXPECT_EQ(error_of([] { (void)parse(kKeys + "format_version: 1\nlabels: 3\n"); }),
              "r.yaml: line 8: labels: expected a list of rooms, found \"3\"");
    EXPECT_EQ(error_with("[1, 2, 0]", "[.nan, 2, 0]").find("r.yaml: line 3: origin: "), 0U);
    EXPECT_EQ(error_with("0.05", "1e9").find("r.yaml: line 2: resolution: "), 0U);
    EXPECT_EQ(error_of([] { (void)parse("[1, 2"); }).find("r.yaml: line "), 0U);
}

TEST(PreviousResult, RefusesAnImageThatDoesNotFitTheLegend) {
    const auto png = [](int channels, int max_value, std::uint16_t sample) {
        return encode_png({3, 2, channels, max_value},
                          [&](std::int32_t y, std::span<std::uint16_t> samples) {
                              for (auto& value : samples) value = 0;
                              if (y == 1) samples.back() = sample;
                          });
    };
    const auto parse_png_of = [](const std::string& bytes) {
        return parse_label_png(bytes, "r.png", parse(kGood), "r.yaml");
    };
    EXPECT_NEAR(parse_png_of(png(1, 255, 9)).legend.rooms[1].area_m2, 0.0025, 1e-12);
    EXPECT_EQ(parse_png_of(png(1, 65535, 4)).labels.values,
              (Raster<std::uint16_t>::Values{0, 0, 1, 0, 0, 0}))
        << "the lowest row is the first";
    EXPECT_EQ(error_of([&] { (void)parse_png_of(png(1, 65535, 5)); }),
              "r.png: row 2, column 3: expected 0 or a value of the labels in r.yaml, found 5");
    EXPECT_EQ(error_of([&] { (void)parse_png_of(png(3, 255, 4)); }),
              "r.png: expected the grey image of a result's labels, found 3 channels");
    const std::string whole = png(1, 65535, 4);
    for (std::size_t size = 0; size < whole.size() - 12; size += 7) {
        EXPECT_EQ(error_of([&] { (void)parse_png_of(whole.substr(0, size)); }).find("r.png: "), 0U);
    }
}

/// The rooms of `floor` as a result, read back.
PreviousResult written(const ScratchFolder& folder, const DrawnFloor& floor) {
    formats::write_results(folder.path() / "out", floor.map, floor.segmentation, {});
    return read_previous_result(folder.path() / "out");
}

TEST(PreviousResult, ReadsBackWhatWasWritten) {
    const ScratchFolder folder;
    DrawnFloor floor = drawn_floor({"aab", "aab", "cc#"}, 2);
    floor.segmentation.rooms[0].id = RoomId{20};
    floor.segmentation.rooms[2].name = "\"C\" # \u00E9\n";
    floor.segmentation.next_id = 31;
    floor.segmentation.doors.push_back({RoomId{20}, RoomId{3}, {}, {}, 0.4, 0.5});
    const PreviousResult previous = written(folder, floor);
    EXPECT_EQ(previous.labels.values, floor.segmentation.labels.values);
    EXPECT_EQ(previous.legend.next_id, 31U);
    ASSERT_EQ(previous.legend.rooms.size(), 3U);
    EXPECT_EQ(index(previous.legend.rooms[0].id), 20U);
    EXPECT_EQ(previous.legend.rooms[2].name, "\"C\" # \u00E9\n");
    EXPECT_NEAR(previous.legend.rooms[0].area_m2, 16 * 0.0025, 1e-12);
    EXPECT_EQ(previous.legend.colors.size(), 3U);
    const Image image = read_image(folder.path() / "out" / "rooms.png");
    EXPECT_EQ(image.samples.at(0), 20) << "other programs find the id";
}

/// The earlier labels on the cells of `now`.
auto labels_on(const PreviousResult& previous, const DrawnFloor& now) {
    return on_cells_of(previous, now.map).labels.values;
}

TEST(PreviousResult, RoomsAreFoundWhereTheyAreInTheMapFrame) {
    const ScratchFolder folder;
    const PreviousResult previous = written(folder, drawn_floor({"aab", "aab", "ccb"}, 4));

    DrawnFloor shifted = drawn_floor({"....", ".aab", ".aab", ".ccb"}, 4);
    shifted.map.map_from_image = {-0.2, 0.0, 0.0};
    EXPECT_EQ(labels_on(previous, shifted), shifted.segmentation.labels.values);

    DrawnFloor turned = drawn_floor({"caa", "caa", "bbb"}, 4);
    turned.map.map_from_image = {0.6, 0.0, std::numbers::pi / 2.0};
    EXPECT_EQ(labels_on(previous, turned), turned.segmentation.labels.values);

    const DrawnFloor coarse = drawn_floor({"aab", "aab", "ccb"}, 2, 0.1);
    EXPECT_EQ(labels_on(previous, coarse), coarse.segmentation.labels.values);
    const DrawnFloor fine = drawn_floor({"aab", "aab", "ccb"}, 10, 0.02);
    EXPECT_EQ(labels_on(previous, fine), fine.segmentation.labels.values);

    DrawnFloor far = drawn_floor({"aab", "aab", "ccb"}, 4);
    far.map.map_from_image = {-9e6, 9e6, 1.0};
    EXPECT_EQ(labels_on(previous, far), Raster<std::uint16_t>::Values(144, 0));
}

TEST(PreviousResult, ACellHasTheRoomAtItsCentre) {
    const ScratchFolder folder;
    DrawnFloor before = drawn_floor({"aab", "aab", "ccb"}, 4);
    before.map.map_from_image = {0.3, -0.2, -0.4};
    const PreviousResult previous = written(folder, before);
    GridMap map;
    map.resolution_m = 0.03;
    map.map_from_image = {0.35, 0.1, 0.9};
    map.states = Raster<CellState>({-15, -9}, 40, 30);
    const Raster<std::uint16_t> cells(map.states.box());
    const EarlierRooms earlier = on_cells_of(previous, map);
    EXPECT_EQ(earlier.resolution_m, 0.03);
    std::size_t num_labelled = 0;
    for (std::size_t i = 0; i < cells.values.size(); ++i) {
        const Cell cell = cells.cell(i);
        const Point at = transform(
            inverse(before.map.map_from_image),
            transform(map.map_from_image, {(cell.x + 0.5) * 0.03, (cell.y + 0.5) * 0.03}));
        const Cell old{static_cast<std::int32_t>(std::floor(at.x / 0.05)),
                       static_cast<std::int32_t>(std::floor(at.y / 0.05))};
        const Raster<std::uint16_t>& labels = before.segmentation.labels;
        ASSERT_EQ(earlier.labels.values[i], labels.contains(old) ? labels.at(old) : 0) << i;
        if (earlier.labels.values[i] != 0) ++num_labelled;
    }
    EXPECT_GT(num_labelled, 100U);
}

TEST(PreviousResult, RoomsAreTheSameAtAnotherResolution) {
    const ScratchFolder folder;
    DrawnFloor before = drawn_floor({"aab", "aab", "ccb"}, 4);
    before.segmentation.rooms[0].id = RoomId{9};
    const PreviousResult previous = written(folder, before);
    const DrawnFloor coarse = drawn_floor({"bba", "bba", "cca"}, 2, 0.1);
    const Tracked tracked = track(coarse.segmentation, on_cells_of(previous, coarse.map));
    ASSERT_EQ(tracked.events.size(), 3U);
    EXPECT_EQ(index(tracked.events[0].room), 2U);
    EXPECT_EQ(index(tracked.events[1].room), 9U);
    EXPECT_EQ(index(tracked.events[2].room), 3U);
    for (const RoomEvent& event : tracked.events) EXPECT_EQ(event.change, RoomChange::kept);
}

TEST(PreviousResult, NamesTheFileThatIsNotThere) {
    const ScratchFolder folder;
    const auto error = [](const std::filesystem::path& path) {
        return error_of([&] { (void)read_previous_result(path); });
    };
    const std::string none = (folder.path() / "none").string();
    EXPECT_EQ(error(none),
              none + ": expected a folder with an earlier result, found no such folder");
    EXPECT_EQ(error(folder.path()), folder.path().string() +
                                        ": expected a folder with an earlier result, found no "
                                        "rooms.yaml in it (it is empty)");
    folder.write("rooms.yaml", kGood);
    EXPECT_EQ(error(folder.path()).find((folder.path() / "rooms.png").string() + ": "), 0U);
    folder.write("rooms.png", "no image");
    EXPECT_EQ(error(folder.path()).find((folder.path() / "rooms.png").string() + ": "), 0U);
}

}  // namespace
}  // namespace quadcut::io
