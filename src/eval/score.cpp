// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "eval/score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "eval/hungarian.hpp"
#include "io/number_text.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::eval {
namespace {

constexpr std::size_t kMaxTableEntries = std::size_t{1} << 24U;
constexpr double kFound = 0.5;
constexpr double kFoundWell = 0.7;

/// How many pixels each predicted room (row) shares with each true room (column), as doubles:
/// counts are exact in them.
struct Overlap {
    std::size_t num_rows = 0;
    std::size_t num_columns = 0;
    std::vector<double> shared;
    /// Over the pixels that have a label on both sides.
    std::vector<double> row_sums;
    std::vector<double> column_sums;
    double total = 0.0;
    /// Over all pixels.
    std::vector<double> row_areas;
    std::vector<double> column_areas;

    [[nodiscard]] double at(std::size_t row, std::size_t column) const {
        return shared[row * num_columns + column];
    }
};

void check_sizes(const io::LabelImage& predicted, const io::LabelImage& truth,
                 const std::optional<io::FreeMask>& free_mask) {
    const auto size = [](const auto& image) {
        return std::to_string(image.width) + " x " + std::to_string(image.height);
    };
    if (predicted.width != truth.width || predicted.height != truth.height) {
        throw InputError("sizes differ: predicted " + size(predicted) + ", truth " + size(truth));
    }
    if (free_mask && (free_mask->width != truth.width || free_mask->height != truth.height)) {
        throw InputError("sizes differ: map " + size(*free_mask) + ", truth " + size(truth));
    }
    if (std::size_t{predicted.num_regions} * truth.num_regions > kMaxTableEntries) {
        throw InputError("too many regions to compare: predicted " +
                         std::to_string(predicted.num_regions) + ", truth " +
                         std::to_string(truth.num_regions));
    }
}

Overlap count_overlap(const io::LabelImage& predicted, const io::LabelImage& truth) {
    Overlap overlap;
    overlap.num_rows = predicted.num_regions;
    overlap.num_columns = truth.num_regions;
    overlap.shared.resize(overlap.num_rows * overlap.num_columns);
    overlap.row_sums.resize(overlap.num_rows);
    overlap.column_sums.resize(overlap.num_columns);
    overlap.row_areas.resize(overlap.num_rows);
    overlap.column_areas.resize(overlap.num_columns);
    for (std::size_t i = 0; i < predicted.values.size(); ++i) {
        const std::size_t row = predicted.values[i];
        const std::size_t column = truth.values[i];
        if (row > 0) overlap.row_areas[row - 1] += 1.0;
        if (column > 0) overlap.column_areas[column - 1] += 1.0;
        if (row > 0 && column > 0) {
            overlap.shared[(row - 1) * overlap.num_columns + column - 1] += 1.0;
        }
    }
    for (std::size_t row = 0; row < overlap.num_rows; ++row) {
        for (std::size_t column = 0; column < overlap.num_columns; ++column) {
            overlap.row_sums[row] += overlap.at(row, column);
            overlap.column_sums[column] += overlap.at(row, column);
            overlap.total += overlap.at(row, column);
        }
    }
    return overlap;
}

double iou(const Overlap& overlap, std::size_t row, std::size_t column) {
    const double shared = overlap.at(row, column);
    return shared / std::max(overlap.row_sums[row] + overlap.column_sums[column] - shared, 1.0);
}

std::vector<Assignment> assign_rooms(const Overlap& overlap) {
    std::vector<double> costs;
    costs.reserve(overlap.shared.size());
    for (std::size_t row = 0; row < overlap.num_rows; ++row) {
        for (std::size_t column = 0; column < overlap.num_columns; ++column) {
            costs.push_back(-iou(overlap, row, column));
        }
    }
    return assign_least_cost(costs, overlap.num_rows, overlap.num_columns);
}

/// Correlation of "is in this predicted room" and "is in this true room" over the pixels labelled
/// on both sides. @pre they share a pixel.
double matthews(const Overlap& overlap, const Assignment& match) {
    const double tp = overlap.at(match.row, match.column);
    const double fp = overlap.row_sums[match.row] - tp;
    const double fn = overlap.column_sums[match.column] - tp;
    const double tn = overlap.total - tp - fp - fn;
    if (fp == 0.0 && fn == 0.0) return 1.0;
    const double d = std::sqrt((tp + fp) * (tp + fn) * (tn + fp) * (tn + fn));
    return d > 0.0 ? (tp * tn - fp * fn) / d : 0.0;
}

void score_matches(const Overlap& overlap, RoomScore& score) {
    const double half = static_cast<double>(overlap.num_rows + overlap.num_columns) / 2.0;
    double num_found = 0.0;
    double num_found_well = 0.0;
    double found_iou = 0.0;
    double matched_iou = 0.0;
    double correlation = 0.0;
    std::size_t num_correlated = 0;
    for (const Assignment& match : assign_rooms(overlap)) {
        const double value = iou(overlap, match.row, match.column);
        matched_iou += value;
        if (value > kFound) {
            num_found += 1.0;
            found_iou += value;
        }
        if (value > kFoundWell) num_found_well += 1.0;
        if (value > 0.0) {
            correlation += matthews(overlap, match);
            ++num_correlated;
        }
    }
    score.pq = found_iou / half;
    score.f1_50 = num_found / half;
    score.f1_70 = num_found_well / half;
    score.miou = matched_iou / static_cast<double>(overlap.num_columns);
    // A matched pair counts once, every other room of either side counts by itself.
    score.mcc =
        correlation / static_cast<double>(overlap.num_rows + overlap.num_columns - num_correlated);
}

void score_shares(const Overlap& overlap, RoomScore& score) {
    std::vector<double> row_best(overlap.num_rows);
    std::vector<double> column_best(overlap.num_columns);
    for (std::size_t row = 0; row < overlap.num_rows; ++row) {
        for (std::size_t column = 0; column < overlap.num_columns; ++column) {
            row_best[row] = std::max(row_best[row], overlap.at(row, column));
            column_best[column] = std::max(column_best[column], overlap.at(row, column));
        }
    }
    const auto mean_share = [](const std::vector<double>& best, const std::vector<double>& areas) {
        double sum = 0.0;
        for (std::size_t i = 0; i < best.size(); ++i) sum += best[i] / areas[i];
        return sum / static_cast<double>(best.size());
    };
    score.precision = mean_share(row_best, overlap.row_areas);
    score.recall = mean_share(column_best, overlap.column_areas);
}

/// The number of pairs of pixels that lie in the same part.
double count_pairs(const std::vector<double>& sizes) {
    double sum = 0.0;
    for (const double size : sizes) sum += size * (size - 1.0) / 2.0;
    return sum;
}

double entropy_bits(const std::vector<double>& sizes, double total) {
    double sum = 0.0;
    for (const double size : sizes) {
        const double p = size / std::max(total, 1.0);
        if (p > 0.0) sum += p * std::log2(p);
    }
    return -sum;
}

void score_partitions(const Overlap& overlap, RoomScore& score) {
    const double row_pairs = count_pairs(overlap.row_sums);
    const double column_pairs = count_pairs(overlap.column_sums);
    const double all_pairs = overlap.total * (overlap.total - 1.0) / 2.0;
    const double expected = row_pairs * column_pairs / std::max(all_pairs, 1.0);
    const double top = (row_pairs + column_pairs) / 2.0 - expected;
    score.ari = top == 0.0 ? 1.0 : (count_pairs(overlap.shared) - expected) / top;

    const double joint = entropy_bits(overlap.shared, overlap.total);
    score.vi_over = joint - entropy_bits(overlap.column_sums, overlap.total);
    score.vi_under = joint - entropy_bits(overlap.row_sums, overlap.total);
}

double find_cover(const io::LabelImage& predicted, const io::LabelImage& truth,
                  const std::optional<io::FreeMask>& free_mask) {
    std::size_t num_seen = 0;
    std::size_t num_labelled = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        if (truth.values[i] == 0 || (free_mask && free_mask->is_free[i] == 0)) continue;
        ++num_seen;
        if (predicted.values[i] > 0) ++num_labelled;
    }
    if (num_seen == 0) return std::numeric_limits<double>::quiet_NaN();
    return static_cast<double>(num_labelled) / static_cast<double>(num_seen);
}

}  // namespace

RoomScore score_rooms(const io::LabelImage& predicted, const io::LabelImage& truth,
                      const std::optional<io::FreeMask>& free_mask) {
    check_sizes(predicted, truth, free_mask);
    RoomScore score;
    score.rooms = predicted.num_regions;
    score.truth = truth.num_regions;
    if (score.rooms == 0 || score.truth == 0) return score;

    const Overlap overlap = count_overlap(predicted, truth);
    score_matches(overlap, score);
    score_shares(overlap, score);
    score_partitions(overlap, score);
    score.cover = find_cover(predicted, truth, free_mask);
    return score;
}

io::LabelImage without_void(const io::LabelImage& predicted, const io::LabelImage& truth,
                            const std::optional<io::FreeMask>& surely_free) {
    check_sizes(predicted, truth, surely_free);
    std::vector<std::size_t> num_cells(predicted.num_regions + std::size_t{1}, 0);
    std::vector<std::size_t> num_void(num_cells.size(), 0);
    for (std::size_t i = 0; i < predicted.values.size(); ++i) {
        if (surely_free && surely_free->is_free[i] == 0) continue;
        ++num_cells[predicted.values[i]];
        if (truth.values[i] == 0) ++num_void[predicted.values[i]];
    }
    std::vector<std::uint32_t> kept = predicted.values;
    for (std::uint32_t& region : kept) {
        if (2 * num_void[region] > num_cells[region]) region = 0;
    }
    return io::number_regions(predicted.width, predicted.height, kept, 0);
}

std::vector<RoomMatch> match_rooms(const io::LabelImage& predicted, const io::LabelImage& truth) {
    check_sizes(predicted, truth, std::nullopt);
    std::vector<RoomMatch> matches;
    if (predicted.num_regions == 0 || truth.num_regions == 0) return matches;
    const Overlap overlap = count_overlap(predicted, truth);
    for (const Assignment& match : assign_rooms(overlap)) {
        const double value = iou(overlap, match.row, match.column);
        if (value == 0.0) continue;
        matches.push_back({static_cast<std::uint32_t>(match.row + 1),
                           static_cast<std::uint32_t>(match.column + 1), value});
    }
    std::sort(matches.begin(), matches.end(),
              [](const RoomMatch& a, const RoomMatch& b) { return a.predicted < b.predicted; });
    return matches;
}

std::string to_json(const RoomScore& score) {
    std::string text = "{\n";
    const auto add = [&text](const char* name, double value) {
        text += std::string(" \"") + name + "\": ";
        io::append_exact(text, value);
        text += ",\n";
    };
    add("pq", score.pq);
    add("f1_50", score.f1_50);
    add("f1_70", score.f1_70);
    add("miou", score.miou);
    add("precision", score.precision);
    add("recall", score.recall);
    add("mcc", score.mcc);
    add("ari", score.ari);
    add("vi_over", score.vi_over);
    add("vi_under", score.vi_under);
    add("cover", score.cover);
    text += " \"rooms\": " + std::to_string(score.rooms) + ",\n";
    text += " \"truth\": " + std::to_string(score.truth) + "\n}";
    return text;
}

}  // namespace quadcut::eval
