// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reproduce/claim.hpp"

namespace quadcut::reproduce {

/// What stands in one place of a table: a number, words, or nothing.
struct Value {
    std::optional<double> number;
    int decimals = 0;
    std::string words;
};

[[nodiscard]] inline Value number(double value, int decimals = 0) { return {value, decimals, {}}; }
[[nodiscard]] inline Value number(std::size_t value) { return {static_cast<double>(value), 0, {}}; }
[[nodiscard]] inline Value words(std::string text) { return {std::nullopt, 0, std::move(text)}; }
[[nodiscard]] inline Value none() { return {}; }
[[nodiscard]] inline Value number(const std::optional<double>& value, int decimals) {
    return value ? number(*value, decimals) : none();
}

/// One quantity in each column; a unit that ends in ms marks what differs from run to run.
struct Row {
    std::string quantity;
    std::string unit;
    std::vector<Value> values;
};

/// The columns are who says or does it: the paper, quadcut, baselines.
struct Table {
    std::string title;
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

/// How much of the page's width a picture takes: half is for two beside each other.
enum class Span : std::uint8_t { half, full };

/// A file of the page: .svg or .png.
struct Picture {
    std::string file;
    std::string bytes;
    std::string caption;
    Span span = Span::half;
};

/// The counterpart of one or several figures of the paper.
struct Figure {
    /// As the paper counts them: "4", "15-17".
    std::string number;
    std::string title;
    /// What the paper shows or says.
    std::string paper;
    /// What was measured, on what, how.
    std::string setting;
    std::vector<Picture> pictures;
    std::vector<Table> tables;
    std::vector<Claim> claims;
};

/// One line of the summary: the paper's number and ours.
struct Headline {
    std::string what;
    double paper_ms = 0.0;
    double quadcut_ms = 0.0;
    /// What ours was measured on.
    std::string setting;
};

}  // namespace quadcut::reproduce
