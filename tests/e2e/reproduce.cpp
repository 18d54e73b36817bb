// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/image.hpp"
#include "tests/e2e/program.hpp"
#include "tests/unit/io/image_file.hpp"

namespace quadcut::test {
namespace {

using Json = nlohmann::json;

const std::vector<std::string> kFigures{"4",  "6",  "7",     "11", "12",
                                        "13", "14", "15-17", "18", "20-22"};

/// Fails for every number that is not finite.
void expect_finite(const Json& json, const std::string& where) {
    if (json.is_number()) {
        EXPECT_TRUE(std::isfinite(json.get<double>())) << where;
    }
    if (json.is_structured()) {
        for (const auto& item : json.items()) {
            expect_finite(item.value(), where + "/" + item.key());
        }
    }
}

/// All values of an attribute in the page.
std::set<std::string> attributes(const std::string& page, const std::string& name) {
    std::set<std::string> values;
    const std::string begin = " " + name + "=\"";
    for (std::size_t at = page.find(begin); at != std::string::npos;
         at = page.find(begin, at + 1)) {
        const std::size_t from = at + begin.size();
        values.insert(page.substr(from, page.find('"', from) - from));
    }
    return values;
}

void expect_links_resolve(const std::string& page,
                          const std::map<std::string, std::string>& files) {
    const std::set<std::string> ids = attributes(page, "id");
    for (const char* attribute : {"href", "src"}) {
        for (const std::string& target : attributes(page, attribute)) {
            if (target.rfind('#', 0) == 0) {
                EXPECT_EQ(ids.count(target.substr(1)), 1U) << target;
            } else {
                // No network: all is beside the page.
                EXPECT_EQ(files.count(target), 1U) << target;
            }
        }
    }
    EXPECT_EQ(page.find("<script"), std::string::npos);
}

/// Whether Python's parser takes the files as XML; skipped where there is no Python.
void expect_well_formed(const Folder& folder, const std::vector<std::string>& paths) {
    const std::string script = folder.write("parse.py",
                                            "import sys, xml.dom.minidom\n"
                                            "for path in sys.argv[1:]:\n"
                                            "    xml.dom.minidom.parse(path)\n");
    if (run_process(QUADCUT_PYTHON, {"-c", "import xml.dom.minidom"}).exit_code != 0) return;
    std::vector<std::string> arguments{script};
    arguments.insert(arguments.end(), paths.begin(), paths.end());
    const Outcome outcome = run_process(QUADCUT_PYTHON, arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(SlowReproduce, SmallWorldsGiveTheWholePage) {
    const Folder folder;
    const Outcome outcome = run_quadcut({"reproduce", "-o", folder / "out", "--small", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const std::map<std::string, std::string> files = files_below(folder / "out");
    const std::string& page = files.at("index.html");
    expect_links_resolve(page, files);
    EXPECT_NE(page.find("all worlds are simulated"), std::string::npos);

    EXPECT_EQ(outcome.out, files.at("reproduce.json"));
    const Json json = Json::parse(outcome.out);
    expect_finite(json, "");
    EXPECT_EQ(json.at("simulated"), true);
    EXPECT_NE(page.find("commit <code>" + json.at("commit").get<std::string>()), std::string::npos);
    std::vector<std::string> numbers;
    std::set<std::string> pictures;
    for (const Json& figure : json.at("figures")) {
        numbers.push_back(figure.at("number"));
        EXPECT_FALSE(figure.at("verdict").get<std::string>().empty());
        EXPECT_FALSE(figure.at("tables").empty()) << numbers.back();
        EXPECT_FALSE(figure.at("claims").empty()) << numbers.back();
        for (const Json& claim : figure.at("claims")) {
            EXPECT_NE(claim.at("measured"), "not measured") << claim;
            EXPECT_EQ(claim.at("measured").get<std::string>().find("no number"), std::string::npos)
                << claim;
            EXPECT_FALSE(claim.at("reason").get<std::string>().empty()) << claim;
        }
        EXPECT_FALSE(figure.at("pictures").empty()) << numbers.back();
        for (const Json& picture : figure.at("pictures")) {
            EXPECT_TRUE(pictures.insert(picture).second) << picture;
        }
    }
    EXPECT_EQ(numbers, kFigures);
    for (const Json& line : json.at("summary")) {
        EXPECT_GT(line.at("quadcut_ms").get<double>(), 0.0);
    }
    EXPECT_EQ(json.at("summary")[0].at("paper_ms"), 17300);
    EXPECT_EQ(files.size(), pictures.size() + 2);

    std::vector<std::string> xml{folder / "out/index.html"};
    for (const std::string& picture : pictures) {
        if (picture.find(".svg") != std::string::npos) {
            xml.push_back(folder / ("out/" + picture));
        } else {
            EXPECT_GT(io::read_image(folder / ("out/" + picture)).header.width, 100) << picture;
        }
    }
    expect_well_formed(folder, xml);
}

TEST(ReproduceCommand, DataThatIsNotThereIsBadInput) {
    const Folder folder;
    const Outcome none =
        run_quadcut({"reproduce", "-o", folder / "out", "--data", folder / "nowhere"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_NE(none.err.find("nowhere/logs/mit_csail.log"), std::string::npos) << none.err;
    folder.write("part/logs/mit_csail.log", "# nothing\n");
    const Outcome part =
        run_quadcut({"reproduce", "-o", folder / "out", "--data", folder / "part"});
    EXPECT_EQ(part.exit_code, 2);
    EXPECT_NE(part.err.find("intel.log"), std::string::npos) << part.err;
    EXPECT_TRUE(files_below(folder / "out").empty());
}

}  // namespace
}  // namespace quadcut::test
