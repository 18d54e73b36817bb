// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_place.hpp"

#include <gtest/gtest.h>

#include "tests/unit/io/scratch.hpp"

namespace quadcut::io {
namespace {

using test::ScratchFolder;

std::string yaml_of(const std::string& image, const std::string& resolution = "0.1") {
    return "image: " + image + "\nresolution: " + resolution +
           "\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

TEST(MapPlace, TheYamlOfTheSameStemGoesFirst) {
    const ScratchFolder folder;
    const auto image = folder.write("floor.pgm", "x");
    EXPECT_FALSE(find_yaml_beside(image));
    folder.write("a.yaml", yaml_of("floor.pgm", "0.2"));
    EXPECT_EQ(find_yaml_beside(image)->keys.resolution_m, 0.2);
    EXPECT_FALSE(find_yaml_beside(image)->other);
    folder.write("floor.YML", yaml_of("/of/another/machine/floor.pgm", "0.3"));
    EXPECT_EQ(find_yaml_beside(image)->keys.resolution_m, 0.3);
    EXPECT_EQ(find_yaml_beside(image)->path, folder.path() / "floor.YML");
    EXPECT_EQ(find_yaml_beside(image)->other, folder.path() / "a.yaml");
}

TEST(MapPlace, OtherYamlsArePassedOver) {
    const ScratchFolder folder;
    const auto image = folder.write("floor.pgm", "x");
    folder.write("floor2.pgm", "x");
    folder.write("floor.yaml", yaml_of("floor2.pgm"));
    folder.write("b.yaml", "ros__parameters: {map: floor.pgm}\n");
    folder.write("c.yaml", "{ floor.pgm");
    folder.write("d.yaml", yaml_of("floor.pgm") + std::string(100'000, '#'));
    folder.write("e.txt", yaml_of("floor.pgm"));
    std::filesystem::create_directory(folder.path() / "g.yaml");
    EXPECT_FALSE(find_yaml_beside(image));
    EXPECT_FALSE(find_yaml_beside(folder.path() / "none.pgm"));
    EXPECT_FALSE(find_yaml_beside("/dev/null"));
}

TEST(MapPlace, LinksAndLongerPathsNameTheSameImage) {
    const ScratchFolder folder;
    const auto image = folder.write("floor.pgm", "x");
    folder.write("floor.yaml", yaml_of("../" + folder.path().filename().string() + "/floor.pgm"));
    EXPECT_TRUE(find_yaml_beside(image));
}

TEST(MapPlace, AnImageThatIsNowhereStaysWhereItIsSaidToBe) {
    const ScratchFolder folder;
    const FoundImage found = find_image("/no/such/floor.pgm", folder.path() / "m.yaml", {});
    EXPECT_EQ(found.path, "/no/such/floor.pgm");
    EXPECT_FALSE(found.is_elsewhere);
    folder.write("floor.pgm", "x");
    EXPECT_TRUE(find_image("/no/such/floor.pgm", folder.path() / "m.yaml", {}).is_elsewhere);
    EXPECT_TRUE(find_image("~/floor.pgm", folder.path() / "m.yaml", "/no/home").is_elsewhere);
}

}  // namespace
}  // namespace quadcut::io
