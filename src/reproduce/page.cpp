// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <string>
#include <string_view>

#include "io/markup.hpp"
#include "io/number_text.hpp"
#include "reproduce/report.hpp"
#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

constexpr std::string_view kHead = R"(<!DOCTYPE html>
<!-- Written by quadcut -->
<html lang="en" xmlns="http://www.w3.org/1999/xhtml">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta name="color-scheme" content="light dark"/>
<title>quadcut: the paper's experiments</title>
<style>
:root { color-scheme: light dark; --ink: #2d3642; --soft: #5d6874; --paper: #f5f5f2;
        --card: #fdfdfb; --line: #dcdfe3; --link: #a8452a; --good: #23703a; --bad: #a8452a;
        --good-back: #e2f1e5; --bad-back: #f9e6df; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e2e6ea; --soft: #a8b2bd; --paper: #14181c; --card: #1d2228; --line: #343b44;
          --link: #f0956f; --good: #8fd6a2; --bad: #f5ab8c; --good-back: #1d3325;
          --bad-back: #3c271e; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1200px; padding: 1rem; font: 16px/1.5 system-ui, sans-serif;
       color: var(--ink); background: var(--paper); overflow-wrap: break-word; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .5rem 0; }
h2 { font-size: 1.2rem; line-height: 1.3; margin: 0 0 .5rem; }
h3 { font-size: 1rem; margin: 1.2rem 0 .3rem; }
a { color: var(--link); text-decoration: none; }
a:hover { text-decoration: underline; }
section { background: var(--card); border: 1px solid var(--line); border-radius: 10px;
          padding: 1.1rem; margin: 1.2rem 0; }
p { margin: .4rem 0; }
.soft { color: var(--soft); }
.number { color: var(--soft); font-weight: 500; }
nav { display: flex; flex-wrap: wrap; gap: .4rem .9rem; margin: .8rem 0; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; margin: .3rem 0; }
th, td { padding: .25rem .9rem .25rem 0; text-align: right; vertical-align: top;
         border-bottom: 1px solid var(--line); }
th { color: var(--soft); font-weight: 600; }
th:first-child, td:first-child { text-align: left; min-width: 11rem; }
.unit { color: var(--soft); }
.pictures { display: grid; gap: 1rem; margin: .9rem 0;
            grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); }
figure { margin: 0; }
figure img { display: block; max-width: 100%; height: auto; margin: 0 auto; border-radius: 6px;
             border: 1px solid var(--line); }
figcaption { color: var(--soft); font-size: .9rem; margin-top: .3rem; }
.full { grid-column: 1 / -1; }
.claims { width: 100%; }
.claims th, .claims td { text-align: left; padding: .3rem .6rem; }
.claims td:nth-child(4) { color: var(--soft); font-size: .9rem; }
.mark { font-weight: 600; white-space: nowrap; }
.good { background: var(--good-back); } .good .mark { color: var(--good); }
.bad { background: var(--bad-back); } .bad .mark { color: var(--bad); }
code { overflow-wrap: anywhere; }
</style>
</head>
<body>
)";

std::string text_of(const Value& value) {
    if (!value.number) return value.words.empty() ? "–" : io::escaped(value.words);
    return with_commas(io::with_decimals(*value.number, value.decimals));
}

/// "15-17" as the end of an address.
std::string anchor(const Figure& figure) { return "fig" + figure.number; }

std::string heading(const Figure& figure) {
    const bool is_several = figure.number.find_first_not_of("0123456789") != std::string::npos;
    std::string number;
    for (const char c : figure.number) number += c == '-' ? std::string("–") : std::string(1, c);
    return (is_several ? "Figs " : "Fig ") + number;
}

void append_table(std::string& page, const Table& table) {
    if (!table.title.empty()) page += "<h3>" + io::escaped(table.title) + "</h3>\n";
    page += "<div class=\"scroll\"><table>\n<tr><th></th>";
    for (const std::string& column : table.columns) page += "<th>" + io::escaped(column) + "</th>";
    page += "</tr>\n";
    for (const Row& row : table.rows) {
        page += "<tr><td>" + io::escaped(row.quantity);
        if (!row.unit.empty())
            page += "<span class=\"unit\">, " + io::escaped(row.unit) + "</span>";
        page += "</td>";
        for (const Value& value : row.values) page += "<td>" + text_of(value) + "</td>";
        page += "</tr>\n";
    }
    page += "</table></div>\n";
}

void append_pictures(std::string& page, const Figure& figure) {
    if (figure.pictures.empty()) return;
    page += "<div class=\"pictures\">\n";
    for (const Picture& picture : figure.pictures) {
        const std::string file = io::escaped(picture.file);
        const std::string caption = io::escaped(picture.caption);
        page.append(picture.span == Span::full ? "<figure class=\"full\">" : "<figure>");
        page.append("<a href=\"").append(file);
        page.append("\"><img loading=\"lazy\" src=\"").append(file);
        page.append("\" alt=\"").append(caption);
        page.append("\"/></a><figcaption>").append(caption).append("</figcaption></figure>\n");
    }
    page += "</div>\n";
}

/// "agrees in 3 of 4" as a cell of its colour.
std::string mark_of(const std::vector<Claim>& claims) {
    return "<span class=\"mark\">" + std::string(agrees(claims) ? "✓" : "✗") + " in " +
           std::to_string(count_held(claims)) + " of " + std::to_string(claims.size()) + "</span>";
}

/// Each claim with what was measured, its limit and why that is its limit.
void append_claims(std::string& page, const std::vector<Claim>& claims) {
    page +=
        "<h3>Agrees " + mark_of(claims) +
        "</h3>\n<div class=\"scroll\"><table class=\"claims\">\n<tr><th>what the paper says, as "
        "a number</th><th>measured</th><th>limit</th><th>why this limit</th></tr>\n";
    for (const Claim& claim : claims) {
        const bool is_held = holds(claim);
        page += std::string("<tr class=\"") + (is_held ? "good" : "bad") +
                "\"><td><span class=\"mark\">" + (is_held ? "✓" : "✗") + "</span> " +
                io::escaped(claim.quantity) + "</td><td>" + io::escaped(measured_text(claim)) +
                "</td><td>" + io::escaped(limit_text(claim)) + "</td><td>" +
                io::escaped(claim.reason) + "</td></tr>\n";
    }
    page += "</table></div>\n";
}

void append_figure(std::string& page, const Figure& figure) {
    page += "<section id=\"" + anchor(figure) + "\">\n<h2><span class=\"number\">" +
            heading(figure) + "</span> " + io::escaped(figure.title) + "</h2>\n";
    page += "<p><strong>The paper.</strong> " + io::escaped(figure.paper) + "</p>\n";
    page += "<p class=\"soft\"><strong>Here.</strong> " + io::escaped(figure.setting) + "</p>\n";
    append_pictures(page, figure);
    for (const Table& table : figure.tables) append_table(page, table);
    append_claims(page, figure.claims);
    page += "</section>\n";
}

/// "284 times as fast".
std::string in_column(const Headline& line) {
    const std::string text = speed_against(line.quadcut_ms, line.paper_ms);
    return text.substr(0, text.rfind(" as"));
}

void append_headlines(std::string& page, const Report& report) {
    page +=
        "<div class=\"scroll\"><table>\n<tr><th></th><th>the paper, ms</th>"
        "<th>quadcut, ms</th><th>quadcut is</th></tr>\n";
    for (const Headline& line : report.headlines) {
        page += "<tr><td>" + io::escaped(line.what) + "<br/><span class=\"soft\">" +
                io::escaped(line.setting) + "</span></td><td>" + in_words(line.paper_ms) +
                "</td><td>" + in_words(line.quadcut_ms) + "</td><td>" + in_column(line) +
                "</td></tr>\n";
    }
    page += "</table></div>\n";
}

void append_run(std::string& page, const Report& report) {
    const auto row = [&page](const char* name, const std::string& text) {
        page += std::string("<tr><td>") + name + "</td><td style=\"text-align:left\">" + text +
                "</td></tr>\n";
    };
    page += "<h3>This run</h3>\n<div class=\"scroll\"><table>\n";
    row("command", "<code>" + io::escaped(report.command) + "</code>");
    row("version", "quadcut " + io::escaped(report.version) + ", commit <code>" +
                       io::escaped(report.commit) + "</code>, " +
                       io::escaped(report.machine.compiler));
    row("machine", io::escaped(report.machine.cpu) + ", " +
                       std::to_string(report.machine.num_cores) +
                       (report.machine.num_cores == 1 ? " core" : " cores") + "; " +
                       std::to_string(report.num_threads) + " threads unless it says otherwise");
    row("load at its begin", io::rounded(report.machine.load, 1) +
                                 " other programs that want a core; they make times longer");
    row("the paper's machine", "i7-4700MQ, Windows 7, Python 2.7 with SciPy and NetworkX");
    std::string worlds;
    for (const std::string& world : report.worlds) {
        worlds += (worlds.empty() ? "" : "<br/>") + io::escaped(world);
    }
    row("data", worlds);
    row("took", io::rounded(report.elapsed_s, 0) + " s");
    page += "</table></div>\n";
}

void append_overview(std::string& page, const Report& report) {
    page +=
        "<h3>All figures</h3>\n<div class=\"scroll\"><table class=\"claims\">\n<tr><th>figure</th>"
        "<th>agrees</th><th>what differs from the paper</th></tr>\n";
    for (const Figure& figure : report.figures) {
        page += std::string("<tr class=\"") + (agrees(figure.claims) ? "good" : "bad") +
                "\"><td><a href=\"#" + anchor(figure) + "\">" + heading(figure) + ": " +
                io::escaped(figure.title) + "</a></td><td>" + mark_of(figure.claims) + "</td><td>";
        for (const Claim& claim : figure.claims) {
            if (!holds(claim)) page += "<div>" + io::escaped(claim.quantity) + "</div>";
        }
        page += "</td></tr>\n";
    }
    page += "</table></div>\n";
}

}  // namespace

std::string html_page(const Report& report) {
    std::string page(kHead);
    page +=
        "<h1>The paper's experiments, measured again</h1>\n"
        "<p class=\"soft\">Tian, Wang, Li, Zhao: “A fast incremental map segmentation "
        "algorithm based on spectral clustering and quadtree”. Each figure below stands beside "
        "what the paper says of it; the preset <em>paper</em> is the method as published, "
        "<em>rooms</em> what quadcut does by default. The numbers as data: "
        "<a href=\"reproduce.json\">reproduce.json</a>.</p>\n";
    if (report.is_simulated) {
        page +=
            "<p><strong>No measured data was given (--data): all worlds are simulated, and "
            "stand in for the paper’s. Times and quality are not those of its data "
            "sets.</strong></p>\n";
    }
    page += "<section id=\"summary\">\n<h2>Summary</h2>\n";
    append_headlines(page, report);
    append_overview(page, report);
    append_run(page, report);
    page += "</section>\n";
    for (const Figure& figure : report.figures) append_figure(page, figure);
    return page + "</body>\n</html>\n";
}

}  // namespace quadcut::reproduce
