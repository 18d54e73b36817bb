// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_server.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "io/image.hpp"
#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::error_of;
using test::ScratchFolder;

/// The states as text, the highest row first: ' ' unknown, '.' free, '#' occupied.
std::vector<std::string> draw(const GridMap& map) {
    std::vector<std::string> rows;
    for (std::int32_t y = map.states.height - 1; y >= 0; --y) {
        rows.emplace_back();
        for (std::int32_t x = 0; x < map.states.width; ++x) {
            rows.back() += " .#"[static_cast<std::size_t>(map.states.at({x, y}))];
        }
    }
    return rows;
}

using Rows = std::vector<std::string>;

/// One row of grey values as a PGM.
std::string pgm_row(const std::vector<int>& greys, int max_value = 255) {
    std::string text = "P2 " + std::to_string(greys.size()) + " 1 " + std::to_string(max_value);
    for (const int grey : greys) text += " " + std::to_string(grey);
    return text;
}

std::string read_row(const std::string& image, const MapKeys& keys) {
    return draw(parse_map_image(image, "x", keys).map).at(0);
}

std::string png(const ImageHeader& header, const std::vector<std::uint16_t>& samples) {
    return encode_png(header, [&](std::int32_t y, std::span<std::uint16_t> row) {
        const auto first =
            static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * header.row_samples());
        std::copy_n(samples.begin() + first, row.size(), row.begin());
    });
}

std::string yaml_of(const std::string& image, const std::string& more = "") {
    return "image: " + image +
           "\nresolution: 0.1\norigin: [1, 2, 0.5]\nnegate: 0\noccupied_thresh: 0.65\n"
           "free_thresh: 0.196\n" +
           more;
}

TEST(MapServer, TrinaryThresholdsIncludeTheirEnds) {
    MapKeys keys;
    // 205 / 255 is a hair within unknown at map_server's own 0.196.
    EXPECT_EQ(read_row(pgm_row({0, 89, 90, 100, 204, 205, 206, 254, 255}), keys),
              "##   "
              " ...");
    keys.occupied_thresh = 0.8;
    keys.free_thresh = 0.2;
    EXPECT_EQ(read_row(pgm_row({50, 51, 52, 203, 204, 205}), keys), "##  ..");
    keys.occupied_thresh = keys.free_thresh = 0.0;
    EXPECT_EQ(read_row(pgm_row({0, 128, 255}), keys), "###");
}

TEST(MapServer, NegateTurnsBrightIntoOccupied) {
    MapKeys keys;
    keys.negate = true;
    EXPECT_EQ(read_row(pgm_row({0, 49, 50, 165, 166, 255}), keys),
              ".. "
              " ##");
}

TEST(MapServer, GreyIsScaledByTheLargestValue) {
    const MapKeys keys;
    EXPECT_EQ(read_row(pgm_row({0, 5, 9, 10}, 10), keys), "# ..");
    EXPECT_EQ(read_row(pgm_row({0, 32768, 52685, 65535}, 65535), keys), "#  .");
    EXPECT_EQ(read_row(png({4, 1, 1, 65535}, {0, 32768, 52685, 65535}), keys), "#  .");
}

TEST(MapServer, ColoursAreAveraged) {
    const MapKeys keys;
    const std::vector<std::uint16_t> samples = {255, 255, 255, 0,   0,   0,   205, 205,
                                                205, 255, 255, 150, 255, 100, 0};
    // Means: 255, 0, 205, 220, 118.3.
    EXPECT_EQ(read_row(png({5, 1, 3, 255}, samples), keys), ".# . ");
}

TEST(MapServer, WhatIsNotOpaqueIsUnknown) {
    const std::vector<std::uint16_t> grey_alpha = {255, 255, 255, 254, 0, 255, 0, 0};
    const std::vector<std::uint16_t> rgba = {255, 255, 255, 255, 0, 0, 0, 254};
    MapKeys keys;
    for (const MapMode mode : {MapMode::trinary, MapMode::scale}) {
        keys.mode = mode;
        EXPECT_EQ(read_row(png({4, 1, 2, 255}, grey_alpha), keys), ". # ");
        EXPECT_EQ(read_row(png({2, 1, 4, 255}, rgba), keys), ". ");
    }
    keys.mode = MapMode::raw;  // Where the alpha says nothing, and 255 is unknown.
    EXPECT_EQ(read_row(png({4, 1, 2, 255}, grey_alpha), keys), "  ..");
}

TEST(MapServer, ScaleReadsTheValuesInBetweenAsMapSaverWould) {
    MapKeys keys;
    keys.mode = MapMode::scale;
    keys.occupied_thresh = 0.9;
    keys.free_thresh = 0.1;
    // occ = 0.1 + 0.8 p / 100 for the scaled value p; 25 and 65 are the last free, first occupied.
    const auto grey = [](double p) {
        return static_cast<int>(std::lround(65535.0 * (0.9 - 0.008 * p)));
    };
    EXPECT_EQ(
        read_row(pgm_row({65535, grey(1), grey(25), grey(26), grey(64), grey(65), 0}, 65535), keys),
        "...  ##");
}

TEST(MapServer, RawTakesTheByteAsTheValue) {
    MapKeys keys;
    keys.mode = MapMode::raw;
    keys.negate = true;  // Says nothing in this mode.
    EXPECT_EQ(read_row(pgm_row({0, 25, 26, 64, 65, 100, 101, 205, 255}), keys), "..  ##   ");
    EXPECT_EQ(read_row(pgm_row({0, 100 * 257, 101 * 257}, 65535), keys), ".# ");
}

TEST(MapServer, TheTopRowOfTheImageIsTheHighest) {
    const ScratchFolder folder;
    folder.write("a.pgm", "P2 3 2 255  0 254 205  254 254 0");
    const MapFile file = read_map(folder.write("a.yaml", yaml_of("a.pgm")));
    EXPECT_EQ(draw(file.map), (Rows{"#. ", "..#"}));
    EXPECT_EQ(file.map.states.at({0, 1}), CellState::occupied);
    EXPECT_EQ(file.map.states.origin, (Cell{0, 0}));
    EXPECT_EQ(file.map.resolution_m, 0.1);
    EXPECT_EQ(file.map.map_from_image, (Pose{1.0, 2.0, 0.5}));
    EXPECT_TRUE(file.has_yaml);
    EXPECT_EQ(file.image_path, folder.path() / "a.pgm");
    EXPECT_TRUE(file.warnings.empty());
}

TEST(MapServer, FindsTheImage) {
    const ScratchFolder folder;
    const auto image = folder.write("home/maps/a.pgm", pgm_row({255}));
    const auto image_of = [&](const std::string& path, const std::string& from) {
        const auto yaml = folder.write(from, yaml_of(path));
        return read_map(yaml, {.home_folder = folder.path() / "home"});
    };
    EXPECT_TRUE(
        std::filesystem::equivalent(image_of("home/maps/a.pgm", "m.yaml").image_path, image));
    EXPECT_TRUE(std::filesystem::equivalent(
        image_of("../home/maps/a.pgm", "other/m.yml").image_path, image));
    EXPECT_EQ(image_of(image.string(), "m.yaml").image_path, image);
    EXPECT_EQ(image_of("~/maps/a.pgm", "m.yaml").image_path, image);
    // Without a home folder given, the user's own.
    const auto yaml = folder.write("m.yaml", yaml_of("~/no/such/map.pgm"));
    const std::string error = error_of([&] { (void)read_map(yaml); });
    EXPECT_EQ(error.find(yaml.string() + ": image: /"), 0U) << error;
    EXPECT_NE(error.find("/no/such/map.pgm: cannot be opened"), std::string::npos) << error;
}

TEST(MapServer, NamesYamlAndImageWhenTheImageIsMissing) {
    const ScratchFolder folder;
    const auto yaml = folder.write("m.yaml", yaml_of("b.pgm"));
    EXPECT_EQ(error_of([&] { (void)read_map(yaml); }),
              yaml.string() + ": image: " + (folder.path() / "b.pgm").string() +
                  ": cannot be opened: No such file or directory; put the file beside the YAML, or "
                  "mend the key");
    folder.write("b.pgm", "P5 9 9 255\nshort");
    EXPECT_EQ(error_of([&] { (void)read_map(yaml); }),
              (folder.path() / "b.pgm").string() +
                  ": byte 11: expected 81 bytes of pixels after the PGM's header, found 5");
}

TEST(MapServer, ABareImageIsToldByItsContent) {
    const ScratchFolder folder;
    const auto path = folder.write("no_suffix", pgm_row({0, 205, 206, 254}));
    const MapFile file = read_map(path);
    EXPECT_EQ(draw(file.map), Rows{"#  ."});
    EXPECT_EQ(file.map.resolution_m, 0.05);
    EXPECT_EQ(file.map.map_from_image, Pose{});
    EXPECT_FALSE(file.has_yaml);
    EXPECT_EQ(file.image_path, path);
    EXPECT_EQ(file.keys.image, "no_suffix");
    EXPECT_EQ(file.warnings,
              Rows{path.string() + ": an image states no resolution, taken as 0.05 m a pixel"});
    const auto png_path = folder.write("b.yaml", png({1, 1, 1, 255}, {254}));
    EXPECT_EQ(draw(read_map(png_path).map), Rows{"."});
    EXPECT_EQ(
        error_of([&] { (void)read_map(folder.write("c.pgm", "hello")); }),
        (folder.path() / "c.pgm").string() +
            ": is of no kind that is known, expected an image (PNG, PGM, TIFF, BMP, JPEG, GIF)");
}

TEST(MapServer, TheResolutionMayBeGiven) {
    const ScratchFolder folder;
    const auto image = folder.write("a.pgm", pgm_row({254}));
    const MapFile bare = read_map(image, {.resolution_m = 0.02});
    EXPECT_EQ(bare.map.resolution_m, 0.02);
    EXPECT_TRUE(bare.warnings.empty());
    const auto yaml = folder.write("a.yaml", yaml_of("a.pgm"));
    EXPECT_EQ(read_map(yaml, {.resolution_m = 0.2}).map.resolution_m, 0.2);
    for (const double resolution : {0.0, -1.0, std::nan(""), 1e9}) {
        EXPECT_EQ(error_of([&] { (void)read_map(image, {.resolution_m = resolution}); }),
                  "expected a resolution of 0.001 to 10 metres a pixel");
    }
}

std::string with_free_thresh(std::string yaml, const std::string& value) {
    return yaml.replace(yaml.find("0.196"), 5, value);
}

TEST(MapServer, TheUnknownOfSaversIsUnknownWhateverTheThreshold) {
    const ScratchFolder folder;
    folder.write("a.pgm", pgm_row({205, 254, 205, 0}));
    const auto yaml = folder.write("a.yaml", with_free_thresh(yaml_of("a.pgm"), "0.25"));
    const MapFile file = read_map(yaml);
    EXPECT_EQ(draw(file.map), Rows{" . #"});
    EXPECT_EQ(file.warnings,
              Rows{yaml.string() +
                   ": grey 205 (50 %), which map_saver writes for unknown, would be free at "
                   "free_thresh 0.25; read with free_thresh 0.163; --trust-yaml, --free-thresh or "
                   "--occupied-thresh overrule this"});
    // The keys that are handed on describe what was done.
    EXPECT_EQ(draw(parse_map_image(pgm_row({205, 254, 205, 0}), "x", file.keys).map),
              draw(file.map));
    EXPECT_EQ(file.greys.count(205, 205), 2U);
}

TEST(MapServer, WhatPeopleSayThemselvesIsNotQuestioned) {
    const ScratchFolder folder;
    folder.write("a.pgm", pgm_row({205, 254, 205, 0}));
    const auto yaml = folder.write("a.yaml", with_free_thresh(yaml_of("a.pgm"), "0.25"));
    for (const MapReadOptions& options :
         {MapReadOptions{.trust = GreyTrust::keys}, MapReadOptions{.free_thresh = 0.25}}) {
        const MapFile file = read_map(yaml, options);
        EXPECT_EQ(draw(file.map), Rows{"...#"});
        EXPECT_EQ(file.warnings, Rows{});
    }
    EXPECT_EQ(draw(read_map(yaml, {.occupied_thresh = 1.0}).map), Rows{"...#"});
    EXPECT_EQ(draw(read_map(yaml, {.negate = true, .trust = GreyTrust::keys}).map), Rows{"###."});
    EXPECT_EQ(error_of([&] { (void)read_map(yaml, {.free_thresh = 0.7}); }),
              yaml.string() +
                  ": --free-thresh 0.7 is above --occupied-thresh 0.65, expected at most that; "
                  "give both");
}

TEST(MapServer, OtherModesAreReadByTheirKeys) {
    const ScratchFolder folder;
    folder.write("a.pgm", pgm_row({205, 254, 205, 0}));
    for (const std::string mode : {"scale", "raw"}) {
        const auto yaml =
            folder.write("a.yaml", with_free_thresh(yaml_of("a.pgm", "mode: " + mode), "0.25"));
        const MapFile file = read_map(yaml);
        EXPECT_EQ(draw(file.map), Rows{mode == "raw" ? "   ." : "...#"});
        EXPECT_EQ(file.warnings, Rows{});
    }
}

TEST(MapServer, AnUnknownGreyGoesBeforeTheThresholds) {
    MapKeys keys;
    keys.unknown_grey = 230;
    EXPECT_EQ(read_row(pgm_row({0, 229, 230, 231}), keys), "#. .");
    EXPECT_EQ(read_row(png({2, 1, 1, 65535}, {229 * 257, 230 * 257}), keys), ". ");
    keys.mode = MapMode::scale;
    EXPECT_EQ(read_row(pgm_row({0, 229, 230, 231}), keys), "#...");
}

TEST(MapServer, TheImageBesideTheYamlStandsInForOneOfAnotherMachine) {
    const ScratchFolder folder;
    folder.write("a.pgm", pgm_row({254, 0}));
    for (const std::string path : {"/no/such/place/a.pgm", "maps/a.pgm", "C:\\maps\\a.pgm"}) {
        const auto yaml = folder.write("m.yaml", yaml_of(path));
        const MapFile file = read_map(yaml);
        EXPECT_EQ(draw(file.map), Rows{".#"});
        EXPECT_EQ(file.warnings,
                  Rows{yaml.string() + ": image: nothing is at " + path + ", so " +
                       (folder.path() / "a.pgm").string() + " beside the YAML is read"});
    }
    // What is where the YAML says goes first.
    folder.write("maps/a.pgm", pgm_row({0, 0}));
    EXPECT_EQ(draw(read_map(folder.write("m.yaml", yaml_of("maps/a.pgm"))).map), Rows{"##"});
}

TEST(MapServer, ABareImageTakesTheValuesOfTheYamlBesideIt) {
    const ScratchFolder folder;
    const auto image = folder.write("a.pgm", pgm_row({254, 0}));
    const auto yaml = folder.write("a.yaml", yaml_of("a.pgm"));
    const MapFile file = read_map(image);
    EXPECT_EQ(file.map.resolution_m, 0.1);
    EXPECT_EQ(file.map.map_from_image, (Pose{1.0, 2.0, 0.5}));
    EXPECT_EQ(file.content_hash, read_map(yaml).content_hash);
    EXPECT_EQ(
        file.warnings,
        Rows{image.string() + ": resolution, origin and thresholds are those of " + yaml.string() +
             ", which names the image (give a YAML itself to choose another)"});
    EXPECT_EQ(read_map(image, {.resolution_m = 0.3}).map.resolution_m, 0.3);
}

TEST(MapServer, WallsOnATransparentGroundEncloseFloor) {
    // A room of 10 x 3 pixels of a metre, in a margin.
    constexpr std::int32_t kWidth = 16;
    constexpr std::int32_t kHeight = 9;
    std::vector<std::uint16_t> samples;
    for (std::int32_t y = 0; y < kHeight; ++y) {
        for (std::int32_t x = 0; x < kWidth; ++x) {
            const bool is_wall =
                x >= 2 && x <= 13 && y >= 2 && y <= 6 && (x == 2 || x == 13 || y == 2 || y == 6);
            samples.insert(samples.end(), {0, static_cast<std::uint16_t>(is_wall ? 255 : 0)});
        }
    }
    const ScratchFolder folder;
    const auto image = folder.write("a.png", png({kWidth, kHeight, 2, 255}, samples));
    const MapFile file = read_map(image, {.resolution_m = 1.0});
    EXPECT_EQ(draw(file.map).at(4), "  #..........#  ");
    EXPECT_EQ(draw(file.map).at(0), std::string(kWidth, ' '));
    EXPECT_EQ(file.warnings,
              Rows{image.string() +
                   ": walls are drawn on a transparent ground, which is taken as floor inside of "
                   "them; --trust-yaml makes it unknown"});
    const MapFile literal = read_map(image, {.resolution_m = 1.0, .trust = GreyTrust::keys});
    EXPECT_EQ(draw(literal.map).at(4), "  #          #  ");
}

TEST(MapServer, TheHashCoversYamlAndImage) {
    const ScratchFolder folder;
    folder.write("a.pgm", pgm_row({254}));
    const auto yaml = folder.write("a.yaml", yaml_of("a.pgm"));
    const std::uint64_t first = read_map(yaml).content_hash;
    EXPECT_EQ(first, hash_bytes(yaml_of("a.pgm") + pgm_row({254})));
    folder.write("a.pgm", pgm_row({253}));
    EXPECT_NE(read_map(yaml).content_hash, first);
}

TEST(MapServer, AHugeHeaderIsRefusedAtOnce) {
    const ScratchFolder folder;
    const auto image = folder.write("a.pgm", "P5\n1000000000 1000000000\n255\n");
    EXPECT_NE(error_of([&] { (void)read_map(image); }).find("1000000000 x 1000000000 pixels"),
              std::string::npos);
}

}  // namespace
}  // namespace quadcut::io
