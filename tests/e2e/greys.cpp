// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/image.hpp"
#include "tests/e2e/program.hpp"

// Maps as programs save them: the greys say more than the keys.

namespace quadcut::test {
namespace {

/// The office, of which one room has not been seen.
std::string shut_office() {
    std::vector<std::string> drawing = office_drawing();
    for (std::size_t y = 2; y < 10; ++y) drawing[y].replace(10, 8, 8, '?');
    return drawn_pgm(drawing, 8);
}

/// The same with greys of one's own; those of the floor and the walls spread over so many.
struct Colours {
    int wall = 0;
    int floor = 254;
    int unknown = 205;
    int spread = 1;
};

std::string office_with(const Colours& colours) {
    std::string pgm = shut_office();
    std::uint32_t mixed = 1;
    for (std::size_t i = pgm.find("255\n") + 4; i < pgm.size(); ++i) {
        mixed = mixed * 1'664'525 + 1'013'904'223;
        const int spread = static_cast<int>((mixed >> 16U) % static_cast<unsigned>(colours.spread));
        const auto grey = static_cast<unsigned char>(pgm[i]);
        int painted = grey == 0     ? colours.wall + spread
                      : grey == 254 ? colours.floor - spread
                                    : colours.unknown;
        if (grey == 254 && painted == colours.unknown) ++painted;
        pgm[i] = static_cast<char>(painted);
    }
    return pgm;
}

std::string yaml_with(const std::string& image, const std::string& free_thresh,
                      const std::string& negate = "0") {
    std::string yaml = yaml_for(image);
    yaml.replace(yaml.find("0.196"), 5, free_thresh);
    return yaml.replace(yaml.find("negate: 0") + 8, 1, negate);
}

/// What `segment` says of a map: its rooms are those of the office as it was drawn.
std::string expect_office(const Folder& folder, std::vector<std::string> arguments,
                          const std::string& drawn = shut_office()) {
    const std::string plain = folder.write("plain/office.pgm", drawn);
    EXPECT_EQ(run_quadcut({"segment", plain, "-o", folder / "plain/out"}).exit_code, 0);
    arguments.insert(arguments.begin(), "segment");
    arguments.insert(arguments.end(), {"-o", folder / "out"});
    const Outcome outcome = run_quadcut(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(read_bytes(folder / "out/rooms.png"), read_bytes(folder / "plain/out/rooms.png"))
        << outcome.out << outcome.err;
    return outcome.err;
}

void expect_one_line_with(const std::string& text, const std::string& words) {
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(GreysOfMaps, UnknownOfSaversIsNoHall) {
    const Folder folder;
    folder.write("map.pgm", shut_office());
    const std::string yaml = folder.write("map.yaml", yaml_with("map.pgm", "0.25"));
    expect_one_line_with(expect_office(folder, {yaml}), "--trust-yaml");
    EXPECT_NE(read_bytes(folder / "out/report.json").find("grey 205"), std::string::npos);
    EXPECT_NE(read_bytes(folder / "out/rooms.yaml").find("free_thresh: 0.163"), std::string::npos);
    for (const std::vector<std::string>& flags :
         {std::vector<std::string>{"--trust-yaml"}, {"--free-thresh", "0.25"}}) {
        std::vector<std::string> arguments = {"segment", yaml, "-o", folder / "letter"};
        arguments.insert(arguments.end(), flags.begin(), flags.end());
        const Outcome outcome = run_quadcut(arguments);
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(read_bytes(folder / "letter/rooms.png"), read_bytes(folder / "out/rooms.png"));
    }
}

TEST(GreysOfMaps, ContinuousOnesAreCutBetweenTheirHumps) {
    const Folder folder;
    const std::string yaml = folder.write("map.yaml", yaml_with("map.pgm", "0.196"));
    for (const int unknown : {127, 128, 205}) {
        folder.write("map.pgm", office_with({40, 235, unknown, 70}));
        expect_one_line_with(expect_office(folder, {yaml}), "free_thresh");
    }
}

TEST(GreysOfMaps, BlackAndWhiteMayBeExchanged) {
    const Folder folder;
    folder.write("map.pgm", office_with({255, 1, 50}));
    expect_office(folder, {folder.write("a.yaml", yaml_with("map.pgm", "0.196", "1"))});
    const std::string yaml = folder.write("b.yaml", yaml_with("map.pgm", "0.196"));
    expect_one_line_with(expect_office(folder, {yaml}), "negate 1");
    EXPECT_EQ(expect_office(folder, {yaml, "--negate"}), "");
}

TEST(GreysOfMaps, ABareImageIsReadByTheYamlBesideIt) {
    const Folder folder;
    const std::string image = folder.write("map.pgm", shut_office());
    folder.write("map.yaml", yaml_for("/home/someone/map.pgm"));
    expect_one_line_with(expect_office(folder, {image}), "map.yaml");
    EXPECT_NE(read_bytes(folder / "out/rooms.yaml").find("origin: [1.0, -2.0, 0.0]"),
              std::string::npos);
}

TEST(GreysOfMaps, TheImageOfAnotherMachineLiesBesideItsYaml) {
    const Folder folder;
    folder.write("map.pgm", shut_office());
    const std::string yaml = folder.write("map.yaml", yaml_for("/home/someone/maps/map.pgm"));
    expect_one_line_with(expect_office(folder, {yaml}), "/home/someone/maps/map.pgm");
}

TEST(GreysOfMaps, WallsOnATransparentGroundEncloseRooms) {
    const Folder folder;
    const std::string pgm = office_pgm();
    const io::ImageHeader grey = io::parse_image(pgm, "office", [](const auto&...) {}).header;
    io::ImageHeader header = grey;
    header.channels = 4;
    const std::size_t first = pgm.find("255\n") + 4;
    const auto draw_row = [&](std::int32_t y, std::span<std::uint16_t> row) {
        for (std::size_t x = 0; x < row.size() / 4; ++x) {
            const bool is_wall = pgm[first + static_cast<std::size_t>(y) * row.size() / 4 + x] == 0;
            for (std::size_t c = 0; c < 4; ++c) row[4 * x + c] = c == 3 && is_wall ? 255 : 0;
        }
    };
    folder.write("map.png", io::encode_png(header, draw_row));
    const std::string yaml = folder.write("map.yaml", yaml_for("map.png"));
    expect_one_line_with(expect_office(folder, {yaml}, pgm), "transparent");
}

TEST(GreysOfMaps, FlagsPlayNoPartForALog) {
    const Folder folder;
    const std::string log =
        folder.write("robot.log", "FLASER 3 1.0 1.0 1.0 0 0 0 0 0 0 1 host 1\n");
    const Outcome outcome = run_quadcut({"segment", log, "--trust-yaml", "-o", folder / "out"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("--trust-yaml play no part"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace quadcut::test
