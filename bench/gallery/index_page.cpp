// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "bench/gallery/index_page.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "io/markup.hpp"
#include "io/number_text.hpp"

namespace quadcut::gallery {
namespace {

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>quadcut: gallery</title>
<style>
:root { color-scheme: light dark; --ink: #2d3642; --soft: #69737f; --paper: #fdfdfb;
        --line: #dcdfe3; --link: #a8452a; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e2e6ea; --soft: #9aa5b1; --paper: #171b20; --line: #343b44; --link: #f0956f; }
}
body { margin: 0 auto; max-width: 1280px; padding: 1.5rem; font: 16px/1.5 system-ui, sans-serif;
       color: var(--ink); background: var(--paper); }
a { color: var(--link); text-decoration: none; }
a:hover { text-decoration: underline; }
p, .soft { color: var(--soft); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .2rem .8rem .2rem 0; text-align: right; border-bottom: 1px solid var(--line);
         white-space: nowrap; }
th { color: var(--soft); font-weight: 600; }
th:first-child, td:first-child, th:last-child, td:last-child { text-align: left; }
figure { margin: 2.5rem 0; }
figcaption { margin-bottom: .5rem; }
figure img { max-width: 100%; height: auto; border-radius: 6px; border: 1px solid var(--line); }
</style>
</head>
<body>
<h1>quadcut: gallery</h1>
<p>The truth at the left, the result at the right. A room that was found (IoU above 0.5, one to one)
has one colour on both sides; what has no match is hatched in red and says why. Thin dark lines
over the result are the borders of the truth, orange ones are doors. Of maps as robots scan them, a
third picture has what a person would cut otherwise: red is cut too much, blue missed. A picture
leads to its full size.</p>
)";

/// One decimal, always, so that columns line up.
std::string percent(double share) {
    std::string text = io::rounded(100.0 * share, 1);
    if (text.find('.') == std::string::npos) text += ".0";
    return text;
}

std::string cell(const std::string& text) { return "<td>" + text + "</td>"; }

std::string name_cell(const Entry& entry, const std::string& id) {
    std::string text = "<td><a href=\"#" + id + "\">" + io::escaped(entry.name) + "</a>";
    if (!entry.note.empty()) text += " <span class=\"soft\">" + io::escaped(entry.note) + "</span>";
    return text + "</td>";
}

void append_table(std::string& page, const Section& section, const std::string& id) {
    const bool any_scored = std::any_of(section.entries.begin(), section.entries.end(),
                                        [](const Entry& e) { return e.comparison.has_value(); });
    page += "<div class=\"scroll\"><table>\n<tr><th>input</th>";
    if (any_scored) page += "<th>PQ</th><th>F1 at 0.7</th><th>true rooms</th>";
    page += "<th>rooms</th><th>doors</th>";
    page += any_scored ? "<th>errors</th></tr>\n" : "<th></th></tr>\n";
    for (std::size_t i = 0; i < section.entries.size(); ++i) {
        const Entry& entry = section.entries[i];
        page += "<tr>" + name_cell(entry, id + std::to_string(i));
        if (entry.comparison) {
            const eval::RoomScore& score = entry.comparison->score;
            page += cell(percent(score.pq)) + cell(percent(score.f1_70)) +
                    cell(std::to_string(score.truth));
        } else if (any_scored) {
            page += cell("–") + cell("–") + cell("–");
        }
        page += cell(std::to_string(entry.num_rooms)) + cell(std::to_string(entry.num_doors)) +
                cell(entry.comparison ? io::escaped(error_text(*entry.comparison)) : "") +
                "</tr>\n";
    }
    page += "</table></div>\n";
}

void append_pictures(std::string& page, const Section& section, const std::string& id) {
    for (std::size_t i = 0; i < section.entries.size(); ++i) {
        const Entry& entry = section.entries[i];
        page += "<figure id=\"" + id + std::to_string(i) + "\"><figcaption><strong>" +
                io::escaped(entry.name) + "</strong> <span class=\"soft\">" +
                io::escaped(entry.note) + (entry.note.empty() ? "" : ": ");
        page += entry.comparison ? figures_text(*entry.comparison)
                                 : std::to_string(entry.num_rooms) + " rooms, " +
                                       std::to_string(entry.num_doors) + " doors";
        page += "</span></figcaption>\n<a href=\"" + io::escaped(entry.image) +
                "\"><img loading=\"lazy\" src=\"" + io::escaped(entry.image) +
                "\" alt=\"Rooms of " + io::escaped(entry.name) + "\"></a></figure>\n";
    }
}

}  // namespace

std::string figures_text(const Comparison& comparison) {
    const eval::RoomScore& score = comparison.score;
    return "PQ " + percent(score.pq) + ", F1 at IoU 0.7 " + percent(score.f1_70) + ", " +
           std::to_string(score.rooms) + " rooms for " + std::to_string(score.truth) + ", " +
           error_text(comparison);
}

std::string index_page(std::vector<Section> sections) {
    std::string page(kHead);
    for (std::size_t i = 0; i < sections.size(); ++i) {
        Section& section = sections[i];
        if (section.entries.empty()) continue;
        const auto rank = [](const Entry& entry) {
            return entry.comparison ? entry.comparison->score.pq : 2.0;  // Above all others.
        };
        std::stable_sort(section.entries.begin(), section.entries.end(),
                         [&rank](const Entry& a, const Entry& b) { return rank(a) < rank(b); });
        const std::string id = "s" + std::to_string(i) + "-";
        page += "<h2>" + io::escaped(section.title) + "</h2>\n";
        append_table(page, section, id);
        append_pictures(page, section, id);
    }
    return page + "</body>\n</html>\n";
}

}  // namespace quadcut::gallery
