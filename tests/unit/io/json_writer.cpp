// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/json_writer.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace quadcut::io {
namespace {

TEST(JsonWriter, SetsMembersOnLinesOrOnOne) {
    JsonWriter json;
    json.begin_object(JsonLayout::lines).key("a").integer(1).key("b").begin_array();
    json.number(1.5).number(2.0).null().boolean(true).end_array();
    json.key("c").begin_object(JsonLayout::lines).end_object();
    json.key("d").begin_array(JsonLayout::lines).text("x").text("y").end_array().end_object();
    EXPECT_EQ(json.finish(),
              "{\n \"a\": 1,\n \"b\": [1.5, 2, null, true],\n \"c\": {},\n \"d\": [\n  \"x\",\n"
              "  \"y\"\n ]\n}\n");
}

TEST(JsonWriter, EscapesSoThatAnyTextIsReadBack) {
    std::string all;
    for (int byte = 0; byte < 128; ++byte) all += static_cast<char>(byte);
    all += "\u0085\u00E4\u2028\uFFFE\U0001F6AA";
    EXPECT_EQ(nlohmann::json::parse(json_text(all)).get<std::string>(), all);
    EXPECT_EQ(json_text("say \"\\\"\n"), "\"say \\\"\\\\\\\"\\u000a\"");
    EXPECT_EQ(nlohmann::json::parse(json_text("bad \xFF")).get<std::string>(), "bad \uFFFD");
}

TEST(JsonWriter, WritesNumbersThatJsonHas) {
    JsonWriter json;
    json.begin_array();
    json.exact_number(0.1).exact_number(std::numeric_limits<double>::infinity());
    json.number(std::numeric_limits<double>::quiet_NaN()).end_array();
    EXPECT_EQ(json.finish(), "[0.1, null, null]\n");
}

TEST(JsonWriter, RefusesToStopHalfway) {
    JsonWriter json;
    json.begin_object();
    EXPECT_THROW((void)json.finish(), std::logic_error);
    json.key("a");
    EXPECT_THROW((void)json.end_object(), std::logic_error);
    JsonWriter none;
    EXPECT_THROW((void)none.end_array(), std::logic_error);
}

}  // namespace
}  // namespace quadcut::io
