// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bench/shared_folder.hpp"
#include "eval/score.hpp"
#include "io/image.hpp"
#include "quadcut/base/random.hpp"
#include "tests/unit/io/image_file.hpp"
#include "tests/unit/io/scratch.hpp"

// The scores against ../shared/eval/score_rooms.py.

namespace quadcut::io {
namespace {

const std::filesystem::path kShared = shared_path("");
const std::filesystem::path kRooms = kShared / "data" / "rooms";

/// A pair of label images, and the map if its free cells count.
struct Pair {
    std::filesystem::path predicted;
    std::filesystem::path truth;
    std::filesystem::path map = {};
};

/// Whether regions mostly in the void count.
enum class Void { counts, left_out };

/// The script's scores of all pairs, from one run of Python; nothing when it cannot run.
std::optional<std::vector<nlohmann::json>> score_in_python(const test::ScratchFolder& folder,
                                                           const std::vector<Pair>& pairs,
                                                           Void void_rule) {
    std::string list;
    for (const Pair& pair : pairs) {
        list +=
            pair.predicted.string() + "\t" + pair.truth.string() + "\t" + pair.map.string() + "\n";
    }
    folder.write("pairs.txt", list);
    folder.write("all.py",
                 "import json, sys\n"
                 "sys.dont_write_bytecode = True\n"
                 "sys.path.insert(0, sys.argv[1])\n"
                 "from score_rooms import free_cells, labels, score, very_free, without_void\n"
                 "for line in open(sys.argv[2]):\n"
                 "    predicted, truth, grid = line.rstrip('\\n').split('\\t')\n"
                 "    free = free_cells(grid) if grid else None\n"
                 "    predicted, truth = labels(predicted), labels(truth)\n"
                 "    if sys.argv[3] == 'void':\n"
                 "        seen = very_free(grid) if grid else None\n"
                 "        predicted = without_void(predicted, truth, seen)\n"
                 "    print(json.dumps(score(predicted, truth, free)))\n");
    const std::string command =
        std::string(QUADCUT_PYTHON) + " " + (folder.path() / "all.py").string() + " " +
        (kShared / "eval").string() + " " + (folder.path() / "pairs.txt").string() +
        (void_rule == Void::left_out ? " void" : " all") + " > " +
        (folder.path() / "scores.txt").string() + " 2> " + (folder.path() / "errors.txt").string();
    if (std::system(command.c_str()) != 0) return std::nullopt;
    std::vector<nlohmann::json> scores;
    const std::string text = read_file(folder.path() / "scores.txt");
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        scores.push_back(nlohmann::json::parse(text.substr(begin, end - begin)));
        begin = end + 1;
    }
    return scores;
}

eval::RoomScore own_score(const Pair& pair, Void void_rule) {
    const LabelImage truth = read_label_image(pair.truth);
    LabelImage predicted = read_label_image(pair.predicted);
    std::optional<FreeMask> mask;
    std::optional<FreeMask> surely_free;
    if (!pair.map.empty()) {
        mask = read_free_mask(pair.map);
        surely_free = read_free_mask(pair.map, kSurelyFreeGrey);
    }
    if (void_rule == Void::left_out) predicted = eval::without_void(predicted, truth, surely_free);
    return eval::score_rooms(predicted, truth, mask);
}

void expect_same_scores(const std::vector<Pair>& pairs, const test::ScratchFolder& folder,
                        Void void_rule = Void::counts) {
    if (!std::filesystem::exists(kShared / "eval" / "score_rooms.py")) {
        GTEST_SKIP() << "no score_rooms.py in " << kShared;
    }
    const auto scores = score_in_python(folder, pairs, void_rule);
    if (!scores) {
        GTEST_SKIP() << QUADCUT_PYTHON
                     << " cannot run score_rooms.py: " << read_file(folder.path() / "errors.txt");
    }
    ASSERT_EQ(scores->size(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto own =
            nlohmann::ordered_json::parse(eval::to_json(own_score(pairs[i], void_rule)));
        ASSERT_EQ(own.size(), (*scores)[i].size());
        for (const auto& [key, value] : own.items()) {
            EXPECT_NEAR(value.get<double>(), (*scores)[i].at(key).get<double>(), 1e-9)
                << key << " of " << pairs[i].predicted << " against " << pairs[i].truth;
        }
    }
}

std::vector<std::string> names_of_maps() {
    std::vector<std::string> names;
    if (!std::filesystem::exists(kRooms)) return names;
    for (const auto& entry : std::filesystem::directory_iterator(kRooms)) {
        const std::string name = entry.path().filename().string();
        const std::size_t end = name.find(".rooms.png");
        if (end != std::string::npos) names.push_back(name.substr(0, end));
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// What a segmenter might have made of the true rooms.
enum class Change { moved, joined, cut_by_a_grid, only_a_grid, scattered, dropped, coloured };

Image changed(const Image& truth, Change change, Random& random) {
    Image image = truth;
    const std::int32_t width = truth.header.width;
    const std::int32_t height = truth.header.height;
    constexpr std::int32_t kSide = 60;
    const auto blocks = static_cast<std::uint16_t>(width / kSide + 1);
    std::vector<std::pair<std::int32_t, std::int32_t>> seeds;
    for (int i = 0; i < 25; ++i) {
        seeds.emplace_back(random.below(static_cast<std::uint64_t>(width)),
                           random.below(static_cast<std::uint64_t>(height)));
    }
    if (change == Change::coloured) {
        image.header = {width, height, 3, 255};
        image.samples.assign(truth.samples.size() * 3, 0);
    }
    for (std::int32_t y = 0; y < height; ++y) {
        for (std::int32_t x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x);
            const std::uint16_t room = truth.samples[i];
            const auto block = static_cast<std::uint16_t>(x / kSide + y / kSide * blocks);
            if (change == Change::moved) {
                image.samples[i] = x >= 9 && y >= 7
                                       ? truth.samples[i - 9 - 7 * static_cast<std::size_t>(width)]
                                       : std::uint16_t{0};
            } else if (change == Change::joined) {
                image.samples[i] = static_cast<std::uint16_t>((room + 1) / 2);
            } else if (change == Change::cut_by_a_grid) {
                image.samples[i] =
                    room == 0 ? 0 : static_cast<std::uint16_t>(room * 400 + block % 400);
            } else if (change == Change::only_a_grid) {
                image.samples[i] = static_cast<std::uint16_t>(block + 1);
            } else if (change == Change::scattered) {
                std::int64_t least = INT64_MAX;
                for (std::size_t seed = 0; seed < seeds.size(); ++seed) {
                    const std::int64_t dx = x - seeds[seed].first;
                    const std::int64_t dy = y - seeds[seed].second;
                    if (dx * dx + dy * dy >= least) continue;
                    least = dx * dx + dy * dy;
                    image.samples[i] = static_cast<std::uint16_t>(seed + 1);
                }
                if (room == 0) image.samples[i] = 0;
            } else if (change == Change::dropped) {
                image.samples[i] = room % 3 == 1 ? std::uint16_t{0} : room;
            } else {
                image.samples[3 * i] = static_cast<std::uint16_t>(room * 7 % 5);
                image.samples[3 * i + 1] = static_cast<std::uint16_t>(room % 251);
                image.samples[3 * i + 2] = static_cast<std::uint16_t>(room / 2 % 3);
            }
        }
    }
    return image;
}

std::vector<Pair> pairs_of(const std::string& name, const std::vector<Change>& changes,
                           const test::ScratchFolder& folder) {
    const std::filesystem::path truth = kRooms / (name + ".rooms.png");
    std::vector<Pair> pairs = {{truth, truth}, {truth, truth, kRooms / (name + ".plain.png")}};
    const Image image = read_image(truth);
    Random random(7);
    for (const Change change : changes) {
        const auto path =
            folder.path() / (name + "_" + std::to_string(static_cast<int>(change)) + ".png");
        write_png(path, changed(image, change, random));
        pairs.push_back({path, truth, kRooms / (name + ".plain.png")});
        pairs.push_back({truth, path});
    }
    return pairs;
}

TEST(ScoreOracle, AgreesOnTheTruthOfAMapAndSomethingElse) {
    if (!std::filesystem::exists(kRooms)) GTEST_SKIP() << "no maps in " << kShared;
    const test::ScratchFolder folder;
    expect_same_scores(
        pairs_of("lab_ipa", {Change::moved, Change::only_a_grid, Change::coloured}, folder),
        folder);
}

TEST(ScoreOracle, SlowAgreesOnEveryMap) {
    if (!std::filesystem::exists(kRooms)) GTEST_SKIP() << "no maps in " << kShared;
    const test::ScratchFolder folder;
    std::vector<Pair> pairs;
    for (const std::string& name : names_of_maps()) {
        for (const Pair& pair :
             pairs_of(name,
                      {Change::moved, Change::joined, Change::cut_by_a_grid, Change::only_a_grid,
                       Change::scattered, Change::dropped, Change::coloured},
                      folder)) {
            pairs.push_back(pair);
        }
    }
    expect_same_scores(pairs, folder);
}

TEST(ScoreOracle, AgreesOnWhatIsLeftOutWithTheVoid) {
    // Rooms moved, rooms that the truth does not have, and a grid over rooms and ground outside.
    if (!std::filesystem::exists(kRooms)) GTEST_SKIP() << "no maps in " << kShared;
    const test::ScratchFolder folder;
    expect_same_scores(
        pairs_of("lab_ipa", {Change::moved, Change::only_a_grid, Change::dropped}, folder), folder,
        Void::left_out);
}

TEST(ScoreOracle, AgreesWhereAssignmentsTie) {
    // Equal squares against equal squares at another pitch: whole classes of equal IoU.
    const test::ScratchFolder folder;
    std::vector<Pair> pairs;
    const auto squares = [&](std::int32_t side, std::int32_t shift) {
        Image image{{240, 180, 1, 65535}, std::vector<std::uint16_t>(240 * 180)};
        for (std::int32_t i = 0; i < 240 * 180; ++i) {
            const std::int32_t x = i % 240 + shift;
            const std::int32_t y = i / 240 + shift;
            image.samples[static_cast<std::size_t>(i)] =
                static_cast<std::uint16_t>(1 + x / side + y / side * 100);
        }
        const auto path = folder.path() / ("squares_" + std::to_string(side) + "_" +
                                           std::to_string(shift) + ".png");
        write_png(path, image);
        return path;
    };
    std::vector<std::filesystem::path> images;
    for (const std::int32_t side : {12, 15, 20, 24, 30, 40, 60}) {
        for (const std::int32_t shift : {0, 6, 10}) images.push_back(squares(side, shift));
    }
    for (const auto& predicted : images) {
        for (const auto& truth : images) pairs.push_back({predicted, truth});
    }
    expect_same_scores(pairs, folder);
}

}  // namespace
}  // namespace quadcut::io
