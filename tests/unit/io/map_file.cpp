// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_file.hpp"

#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>

#include "quadcut/base/error.hpp"
#include "tests/unit/map/log_odds.hpp"
#include "tests/unit/map/reference_tree.hpp"

namespace quadcut {
namespace {

constexpr std::size_t kVersionByte = 8;
constexpr std::size_t kLevelByte = 56;
constexpr std::size_t kWidthByte = 68;
constexpr std::size_t kFirstTileByte = 76;

OccupancyMap small_map() {
    OccupancyMap map(0.05, {1.0, -2.0, 0.25});
    map.set_state({-3, 7}, CellState::free);
    test::add_log_odds(map, {-3, 8}, 2);
    for (std::int32_t i = 0; i < 64; ++i) {
        map.set_state({100 + i % 8 + 4, 16 + i / 8}, CellState::free);
    }
    map.commit();
    return map;
}

// With the checksum made right again.
std::vector<std::byte> sealed(std::vector<std::byte> bytes) {
    std::uint64_t hash = 0xCBF2'9CE4'8422'2325U;
    for (std::size_t i = 0; i + 8 < bytes.size(); ++i) {
        hash = (hash ^ std::to_integer<std::uint64_t>(bytes[i])) * 0x0000'0100'0000'01B3U;
    }
    for (std::size_t i = 0; i < 8; ++i) {
        bytes[bytes.size() - 8 + i] = static_cast<std::byte>(hash >> (8 * i) & 0xFF);
    }
    return bytes;
}

std::string message_of(const std::vector<std::byte>& bytes) {
    try {
        static_cast<void>(io::decode_map(bytes, "test.map"));
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(MapFile, ComesBackAsItWas) {
    const OccupancyMap map = small_map();
    const std::vector<std::byte> bytes = io::encode_map(map);
    const OccupancyMap again = io::decode_map(bytes, "test.map");
    EXPECT_EQ(io::encode_map(again), bytes);
    EXPECT_EQ(again.leaves(), map.leaves());
    EXPECT_EQ(again.num_leaves(), map.num_leaves());
    EXPECT_EQ(again.root(), map.root());
    EXPECT_EQ(again.world_from_map(), map.world_from_map());
    EXPECT_EQ(again.resolution_m(), map.resolution_m());
    EXPECT_EQ(again.log_odds({-3, 8}), 2);
}

TEST(MapFile, BytesDoNotTellHowTheMapCameAbout) {
    OccupancyMap map = small_map();
    map.set_state({-60, 50}, CellState::free);
    map.set_state({120, 40}, CellState::occupied);
    map.commit();
    OccupancyMap detour = map;
    for (std::int32_t i = 0; i < 50; ++i) {
        detour.set_state({i, i}, CellState::occupied);
    }
    detour.commit();
    for (std::int32_t i = 0; i < 50; ++i) {
        detour.set_state({i, i}, map.state({i, i}));
    }
    detour.commit();
    EXPECT_EQ(io::encode_map(detour), io::encode_map(map));
}

TEST(MapFile, EmptyMapsComeBack) {
    const std::vector<std::byte> unplaced = io::encode_map(OccupancyMap(0.1));
    EXPECT_FALSE(io::decode_map(unplaced, "test.map").is_placed());
    EXPECT_EQ(io::encode_map(io::decode_map(unplaced, "test.map")), unplaced);
    const std::vector<std::byte> placed = io::encode_map(OccupancyMap(0.1, {}, Root{{-64, 0}, 9}));
    EXPECT_EQ(io::decode_map(placed, "test.map").root(), (Root{{-64, 0}, 9}));
    EXPECT_EQ(io::encode_map(io::decode_map(placed, "test.map")), placed);
}

TEST(MapFile, PendingWritesAreNotSaved) {
    OccupancyMap map(0.05);
    map.set_state({0, 0}, CellState::free);
    EXPECT_THROW(static_cast<void>(io::encode_map(map)), std::logic_error);
}

TEST(MapFile, EveryTruncationIsRefused) {
    const std::vector<std::byte> bytes = io::encode_map(small_map());
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        EXPECT_NE(message_of({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)}),
                  "")
            << size;
    }
}

TEST(MapFile, EveryFlippedBitIsRefused) {
    const std::vector<std::byte> bytes = io::encode_map(small_map());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::vector<std::byte> damaged = bytes;
        damaged[i] ^= std::byte{0x10};
        EXPECT_NE(message_of(damaged), "") << i;
    }
}

TEST(MapFile, WhatIsSealedButWrongIsRefusedOrReadExactly) {
    const std::vector<std::byte> bytes = io::encode_map(small_map());
    for (std::size_t i = 0; i + 8 < bytes.size(); ++i) {
        for (const int value : {0x00, 0x01, 0x7F, 0x80, 0xFF}) {
            std::vector<std::byte> forged = bytes;
            forged[i] = static_cast<std::byte>(value);
            forged = sealed(std::move(forged));
            try {
                EXPECT_EQ(io::encode_map(io::decode_map(forged, "test.map")), forged) << i;
            } catch (const InputError&) {
                continue;
            }
        }
    }
}

TEST(MapFile, MessagesNameFileAndPlace) {
    const std::vector<std::byte> bytes = io::encode_map(small_map());
    EXPECT_NE(message_of({}).find("test.map: byte 0"), std::string::npos);
    const char text[] = "solid this is no map at all";
    std::vector<std::byte> other(sizeof(text));
    std::memcpy(other.data(), text, sizeof(text));
    EXPECT_NE(message_of(other).find("begins with QUADMAP"), std::string::npos);
    std::vector<std::byte> damaged = bytes;
    damaged.back() ^= std::byte{1};
    EXPECT_NE(message_of(damaged).find("checksum"), std::string::npos);
    std::vector<std::byte> newer = bytes;
    newer[kVersionByte] = std::byte{2};
    EXPECT_NE(message_of(sealed(newer)).find("version is 1"), std::string::npos);
    std::vector<std::byte> deep = bytes;
    deep[kLevelByte] = std::byte{200};
    EXPECT_NE(message_of(sealed(deep)).find("level"), std::string::npos);
    std::vector<std::byte> huge = bytes;
    for (std::size_t i = 0; i < 8; ++i) {
        huge[kWidthByte + i] = std::byte{0x7F};
    }
    EXPECT_NE(message_of(sealed(huge)).find("a byte for each tile"), std::string::npos);
    std::vector<std::byte> wild = bytes;
    wild[kFirstTileByte] = std::byte{0x33};
    EXPECT_NE(message_of(sealed(wild)).find("log-odds"), std::string::npos);
}

}  // namespace
}  // namespace quadcut
