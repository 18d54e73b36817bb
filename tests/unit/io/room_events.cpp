// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/room_events.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace quadcut::io {
namespace {

TEST(RoomEvents, AreToldInALine) {
    std::vector<RoomEvent> events{{RoomChange::retired, RoomId{12}, {}, "", ""},
                                  {RoomChange::split, RoomId{24}, RoomId{7}, "", ""},
                                  {RoomChange::born, RoomId{23}, {}, "", ""},
                                  {RoomChange::merged, RoomId{9}, RoomId{4}, "", ""}};
    for (int i = 0; i < 18; ++i) events.push_back({RoomChange::kept, RoomId{1}, {}, "", ""});
    EXPECT_EQ(events_text(events),
              "18 rooms kept, 1 born (23), 1 split (24 from 7), 1 merged (9 into 4), "
              "1 retired (12)");
}

TEST(RoomEvents, WhatDidNotHappenIsNotTold) {
    EXPECT_EQ(events_text({}), "0 rooms kept");
    EXPECT_EQ(events_text(std::vector<RoomEvent>{{RoomChange::kept, RoomId{3}, {}, "", ""}}),
              "1 room kept");
}

TEST(RoomEvents, OfManyTheFirstAreNamed) {
    std::vector<RoomEvent> events;
    for (std::uint32_t id = 1; id <= 8; ++id) {
        events.push_back({RoomChange::born, RoomId{id}, {}, "", ""});
    }
    EXPECT_EQ(events_text(events), "0 rooms kept, 8 born (1, 2, 3, 4, 5, 6, 7, 8)");
    events.push_back({RoomChange::born, RoomId{9}, {}, "", ""});
    EXPECT_EQ(events_text(events), "0 rooms kept, 9 born (1, 2, 3, 4, 5, 6, 7, 8, ...)");
}

}  // namespace
}  // namespace quadcut::io
