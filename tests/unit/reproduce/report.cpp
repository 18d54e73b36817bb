// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/report.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace quadcut::reproduce {
namespace {

Report small_report() {
    Report report;
    report.version = "1.2";
    report.commit = "abc123-dirty";
    report.command = "quadcut reproduce -o DIR --data a<b";
    report.machine = {"some & CPU", 4, "g++", 0.5};
    report.worlds = {"one", "two"};
    report.headlines = {{"Whole map", 17300.0, 173.0, "here"}};
    Figure figure;
    figure.number = "15-17";
    figure.title = "A \"title\"";
    figure.paper = "says > 2";
    figure.pictures = {{"fig15.png", "bytes", "a picture"}};
    figure.tables = {{"t",
                      {"the paper", "quadcut"},
                      {{"time", "ms", {none(), number(1234.5, 1)}},
                       {"kind", "", {words("low"), number(std::size_t{7})}}}}};
    figure.claims = {{"submaps < rooms", {{"", 5.0}}, "", Bound::equal, 5.0, "as drawn"},
                     {"PQ", {{"A", 80.0}, {"B", 20.5}}, "%", Bound::at_least, 77.0, "as people"}};
    report.figures = {figure};
    return report;
}

TEST(ReproducePage, ShowsFiguresTablesAndVerdicts) {
    const std::string page = html_page(small_report());
    EXPECT_NE(page.find("Figs 15–17"), std::string::npos);
    EXPECT_NE(page.find("A &quot;title&quot;"), std::string::npos);
    EXPECT_NE(page.find("1,234.5"), std::string::npos);
    EXPECT_NE(page.find("100 times as fast<"), std::string::npos);
    EXPECT_NE(page.find("abc123-dirty"), std::string::npos);
    EXPECT_NE(page.find("src=\"fig15.png\""), std::string::npos);
    EXPECT_NE(page.find("some &amp; CPU"), std::string::npos);
    EXPECT_EQ(page.find("a<b"), std::string::npos);
}

TEST(ReproducePage, ShowsEachClaimWithItsLimitAndReasonInItsColour) {
    const std::string page = html_page(small_report());
    const std::size_t good =
        page.find("<tr class=\"good\"><td><span class=\"mark\">✓</span> submaps &lt;");
    const std::size_t bad = page.find("<tr class=\"bad\"><td><span class=\"mark\">✗</span> PQ");
    ASSERT_NE(good, std::string::npos);
    ASSERT_NE(bad, std::string::npos);
    EXPECT_NE(page.find("<td>5</td><td>5</td><td>as drawn</td>", good), std::string::npos);
    EXPECT_NE(
        page.find("<td>80 % on A, 20.5 % on B</td><td>at least 77 %</td><td>as people</td>", bad),
        std::string::npos);
    // The overview says how many, and which do not.
    EXPECT_NE(page.find("in 1 of 2</span></td><td><div>PQ</div></td>"), std::string::npos);
}

TEST(ReproducePage, SaysWhenAllIsSimulated) {
    Report report = small_report();
    EXPECT_NE(html_page(report).find("all worlds are simulated"), std::string::npos);
    report.is_simulated = false;
    EXPECT_EQ(html_page(report).find("all worlds are simulated"), std::string::npos);
}

TEST(ReproduceJson, HoldsWhatThePageShows) {
    Report report = small_report();
    report.figures[0].tables[0].rows[1].values[1] = number(std::numeric_limits<double>::infinity());
    const auto json = nlohmann::json::parse(to_json(report));
    EXPECT_EQ(json.at("summary")[0].at("paper_ms"), 17300);
    EXPECT_EQ(json.at("commit"), "abc123-dirty");
    EXPECT_EQ(json.at("machine").at("cores"), 4);
    const auto& figure = json.at("figures")[0];
    EXPECT_EQ(figure.at("number"), "15-17");
    EXPECT_EQ(figure.at("agrees"), false);
    EXPECT_EQ(figure.at("claims")[0].at("holds"), true);
    EXPECT_EQ(figure.at("claims")[1].at("holds"), false);
    EXPECT_EQ(figure.at("claims")[1].at("limit"), "at least 77 %");
    EXPECT_EQ(figure.at("claims")[1].at("reason"), "as people");
    EXPECT_EQ(figure.at("pictures")[0], "fig15.png");
    const auto& rows = figure.at("tables")[0].at("rows");
    EXPECT_EQ(rows[0].at("values").at("quadcut"), 1234.5);
    EXPECT_TRUE(rows[0].at("values").at("the paper").is_null());
    EXPECT_EQ(rows[1].at("values").at("the paper"), "low");
    EXPECT_TRUE(rows[1].at("values").at("quadcut").is_null());
}

}  // namespace
}  // namespace quadcut::reproduce
