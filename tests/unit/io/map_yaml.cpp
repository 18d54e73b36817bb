// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_yaml.hpp"

#include <gtest/gtest.h>

#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;

const std::string kGood =
    "image: a.pgm\n"
    "resolution: 0.05\n"
    "origin: [-7.14, 2e1, 0.5]\n"
    "negate: 0\n"
    "occupied_thresh: 0.65\n"
    "free_thresh: 0.196\n";

MapKeys parse(const std::string& text) { return parse_map_yaml(text, "m.yaml"); }

/// kGood with the line of a key replaced (or taken out when `line` is empty).
std::string with(const std::string& key, const std::string& line) {
    std::string text = kGood;
    const std::size_t first = text.find(key + ":");
    text.replace(first, text.find('\n', first) - first + 1, line.empty() ? "" : line + "\n");
    return text;
}

std::string error_with(const std::string& key, const std::string& line) {
    return error_of([&] { (void)parse(with(key, line)); });
}

TEST(MapYaml, ReadsTheKeys) {
    const MapKeys keys = parse(kGood);
    EXPECT_EQ(keys.image, "a.pgm");
    EXPECT_EQ(keys.mode, MapMode::trinary);
    EXPECT_EQ(keys.resolution_m, 0.05);
    EXPECT_EQ(keys.map_from_image, (Pose{-7.14, 20.0, 0.5}));
    EXPECT_FALSE(keys.negate);
    EXPECT_EQ(keys.occupied_thresh, 0.65);
    EXPECT_EQ(keys.free_thresh, 0.196);
}

TEST(MapYaml, ReadsTheModes) {
    EXPECT_EQ(parse(kGood + "mode: trinary\n").mode, MapMode::trinary);
    EXPECT_EQ(parse(kGood + "mode: 'scale'\n").mode, MapMode::scale);
    EXPECT_EQ(parse(kGood + "mode: \"raw\"\n").mode, MapMode::raw);
    EXPECT_EQ(error_of([] { (void)parse(kGood + "mode: Raw2\n"); }),
              "m.yaml: line 7: mode: expected trinary, scale or raw, found \"Raw2\"");
    for (const MapMode mode : {MapMode::trinary, MapMode::scale, MapMode::raw}) {
        EXPECT_EQ(parse(kGood + "mode: " + std::string(to_text(mode))).mode, mode);
    }
}

TEST(MapYaml, ReadsNegateAsNumberOrWord) {
    for (const char* yes : {"1", "2", "true", "True", "yes", "ON"}) {
        EXPECT_TRUE(parse(with("negate", std::string("negate: ") + yes)).negate) << yes;
    }
    for (const char* no : {"0", "false", "FALSE", "no", "off"}) {
        EXPECT_FALSE(parse(with("negate", std::string("negate: ") + no)).negate) << no;
    }
    EXPECT_EQ(error_with("negate", "negate: maybe"),
              "m.yaml: line 4: negate: expected 0 or 1, true or false, found \"maybe\"");
    EXPECT_EQ(error_with("negate", "negate: [1]"),
              "m.yaml: line 4: negate: expected 0 or 1, true or false, found a list or a mapping");
}

TEST(MapYaml, TakesOtherStylesCommentsAndKeys) {
    const MapKeys keys = parse(
        "---\n# a map\n{image: 'b c.png', resolution: 1.0e-1, origin: [0, 0, 0],\r\n"
        " negate: no, occupied_thresh: 1, free_thresh: 0, author: {name: x}}\n...\n--- second\n");
    EXPECT_EQ(keys.image, "b c.png");
    EXPECT_EQ(keys.resolution_m, 0.1);
    const MapKeys listed = parse(with("origin", "origin:\n  - 1\n  - 2\n  - 3"));
    EXPECT_EQ(listed.map_from_image, (Pose{1.0, 2.0, 3.0}));
}

TEST(MapYaml, NamesAMissingKey) {
    for (const char* key :
         {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}) {
        EXPECT_EQ(error_with(key, ""), std::string("m.yaml: the key \"") + key +
                                           "\" is missing, expected it in a map_server YAML");
    }
}

TEST(MapYaml, RefusesAKeyThatIsThereTwice) {
    EXPECT_EQ(error_of([] { (void)parse(kGood + "resolution: 0.1\n"); }),
              "m.yaml: line 7: the key \"resolution\" stands there a second time");
}

TEST(MapYaml, RefusesImpossibleResolutions) {
    for (const char* value : {"0", "-0.05", "nan", "inf", "1e-9", "1e9", "NaN"}) {
        EXPECT_EQ(error_with("resolution", std::string("resolution: ") + value),
                  "m.yaml: line 2: resolution: expected a resolution of 0.001 to 10 metres a "
                  "pixel")
            << value;
    }
    for (const char* value : {"5 cm", ".nan", "''", "0x1"}) {
        EXPECT_EQ(error_with("resolution", std::string("resolution: ") + value)
                      .find("m.yaml: line 2: resolution: expected a number, found \""),
                  0U)
            << value;
    }
}

TEST(MapYaml, RefusesImpossibleOrigins) {
    EXPECT_EQ(error_with("origin", "origin: [1, 2]"),
              "m.yaml: line 3: origin: expected three numbers [x, y, yaw], found 2");
    EXPECT_EQ(error_with("origin", "origin: 3"),
              "m.yaml: line 3: origin: expected [x, y, yaw], found \"3\"");
    for (const char* value : {"nan", "inf", "1e300", "x"}) {
        EXPECT_EQ(error_with("origin", std::string("origin: [0, ") + value + ", 0]"),
                  std::string("m.yaml: line 3: origin: expected finite numbers within 10,000 km, "
                              "found \"") +
                      value + "\"");
    }
}

TEST(MapYaml, RefusesImpossibleThresholds) {
    for (const char* value : {"1.5", "-0.1", "nan", "65"}) {
        EXPECT_EQ(error_with("occupied_thresh", std::string("occupied_thresh: ") + value),
                  std::string("m.yaml: line 5: occupied_thresh: expected a number from 0 to 1, "
                              "found \"") +
                      value + "\"");
    }
    EXPECT_EQ(error_with("free_thresh", "free_thresh: 0.7"),
              "m.yaml: line 6: free_thresh: expected at most occupied_thresh, which is lower, "
              "found \"0.7\"");
}

TEST(MapYaml, RefusesWhatIsNoYaml) {
    EXPECT_EQ(error_of([] { (void)parse("image: [a\nresolution: 1\n"); }).find("m.yaml: line "),
              0U);
    EXPECT_NE(error_of([] { (void)parse("image: [a\nresolution: 1\n"); }).find("not a YAML"),
              std::string::npos);
    EXPECT_NE(error_of([] { (void)parse("image: \xff\xfe\n"); }).find("m.yaml: byte "),
              std::string::npos);
    for (const char* text : {"", "just words", "- image", "# only a comment\n"}) {
        EXPECT_EQ(error_of([&] { (void)parse(text); }),
                  "m.yaml: expected the keys of a map_server YAML (image, resolution, origin, ...)")
            << text;
    }
}

TEST(MapYaml, BoundsSizeAndDepth) {
    EXPECT_EQ(error_of([] { (void)parse(kGood + std::string(2'000'000, '#')); }),
              "m.yaml: larger than the 1048576 bytes that a YAML may have");
    EXPECT_EQ(parse(kGood + "deep: " + std::string(31, '[') + std::string(31, ']')).image, "a.pgm");
    EXPECT_EQ(error_of([] { (void)parse(kGood + "deep: " + std::string(1'000'000, '[')); }),
              "m.yaml: line 7: nested deeper than the 32 levels that are read at most");
}

TEST(MapYaml, AliasesAreNotUnfolded) {
    // Each line would double the document.
    std::string bomb = kGood + "a0: &a0 [x, x]\n";
    for (int i = 1; i < 60; ++i) {
        const std::string before = "*a" + std::to_string(i - 1);
        bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before + ", " +
                before + "]\n";
    }
    EXPECT_EQ(parse(bomb).image, "a.pgm");
    EXPECT_EQ(error_with("resolution", "x: &r 0.05\nresolution: *r"),
              "m.yaml: line 3: resolution: expected a number, found an alias");
}

}  // namespace
}  // namespace quadcut::io
