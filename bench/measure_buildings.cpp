// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Rooms, doors, borders and kinds on simulated buildings that the door model has not seen: empty,
// half furnished and full; straight and turned; mapped perfectly and from the scans of a robot.
//   measure_buildings [-o FILE.json] [--buildings N] [--case I] [--details]
// With --details the file also has each door that was matched, missed or invented.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bench/building_case.hpp"
#include "bench/building_score.hpp"
#include "bench/cases.hpp"
#include "bench/door_score.hpp"
#include "bench/result_file.hpp"
#include "io/room_text.hpp"

namespace quadcut {
namespace {

constexpr double kMaxWidthErrorM = 0.1;
constexpr double kMaxBorderRatio = 1.05;
constexpr std::size_t kNumWorst = 12;

/// Right, missed and invented doors.
struct Rates {
    std::size_t right = 0;
    std::size_t missed = 0;
    std::size_t extra = 0;

    void add(const Rates& other) {
        right += other.right;
        missed += other.missed;
        extra += other.extra;
    }
    [[nodiscard]] double precision() const { return percent(right, right + extra); }
    [[nodiscard]] double recall() const { return percent(right, right + missed); }
    [[nodiscard]] double f1() const { return percent(2 * right, 2 * right + missed + extra); }
};

Rates all_openings(const CaseResult& result) {
    return {result.matched.size(), result.doors.missed.size(), result.doors.extra.size()};
}

/// What is matched with an open passage is neither right nor wrong.
Rates doors_proper(const CaseResult& result) {
    Rates rates{0, 0, result.doors.extra.size()};
    for (const MatchedDoor& door : result.matched) rates.right += door.is_open_passage ? 0 : 1;
    for (const DoorError& door : result.doors.missed) rates.missed += door.is_open_passage ? 0 : 1;
    return rates;
}

void print_quality_row(const std::string& name, const std::vector<const CaseResult*>& results) {
    double pq = 0.0;
    double baseline_pq = 0.0;
    double cover = 1.0;
    const CaseResult* worst = results.front();
    Rates all;
    Rates proper;
    std::size_t num_within = 0;
    for (const CaseResult* result : results) {
        pq += result->rooms.pq;
        baseline_pq += result->baseline.pq;
        cover = std::min(cover, result->rooms.cover);
        if (result->rooms.pq < worst->rooms.pq) worst = result;
        all.add(all_openings(*result));
        proper.add(doors_proper(*result));
        for (const MatchedDoor& door : result->matched) {
            num_within += std::abs(door.width_error_m) <= kMaxWidthErrorM ? 1 : 0;
        }
    }
    const auto count = static_cast<double>(results.size());
    std::printf(
        "| %-32s | %3zu | %5.1f | %5.1f (%lu) | %5.1f | %5.1f | %5.1f %5.1f %5.1f | "
        "%5.1f %5.1f %5.1f | %5.1f |\n",
        name.c_str(), results.size(), 100.0 * pq / count, 100.0 * worst->rooms.pq,
        static_cast<unsigned long>(worst->chosen.seed), 100.0 * baseline_pq / count, 100.0 * cover,
        all.precision(), all.recall(), all.f1(), proper.precision(), proper.recall(), proper.f1(),
        percent(num_within, all.right));
}

void print_quality(const std::vector<CaseResult>& results) {
    std::printf(
        "| buildings | n | PQ | worst (seed) | distance transform PQ | least cover | "
        "openings P R F1 | doors proper P R F1 | width within 0.1 m |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    const auto row = [&](const std::string& name,
                         const std::function<bool(const BuildingCase&)>& is_of) {
        std::vector<const CaseResult*> chosen;
        for (const CaseResult& result : results) {
            if (is_of(result.chosen)) chosen.push_back(&result);
        }
        if (!chosen.empty()) print_quality_row(name, chosen);
    };
    for (std::size_t i = 0; i < kNumCombinations; ++i) {
        const std::string name = name_of(building_case(i));
        row(name, [&](const BuildingCase& chosen) { return name_of(chosen) == name; });
    }
    for (const double furniture : kFurniture) {
        row("furniture " + std::to_string(furniture).substr(0, 3),
            [&](const BuildingCase& chosen) { return chosen.furniture == furniture; });
    }
    row("straight", [](const BuildingCase& chosen) { return !chosen.is_turned; });
    row("turned", [](const BuildingCase& chosen) { return chosen.is_turned; });
    row("perfect", [](const BuildingCase& chosen) { return !chosen.is_scanned; });
    row("scanned", [](const BuildingCase& chosen) { return chosen.is_scanned; });
    row("all", [](const BuildingCase&) { return true; });
}

void print_quantiles(const char* name, std::vector<double> values) {
    std::sort(values.begin(), values.end());
    std::printf("%-44s %zu:", name, values.size());
    for (const double q : {0.0, 0.05, 0.25, 0.5, 0.75, 0.95, 1.0}) {
        std::printf(" %+.3f", quantile(values, q));
    }
    std::printf("\n");
}

/// Widths and borders of the matched doors, by the way the building is mapped.
void print_geometry(const std::vector<CaseResult>& results) {
    std::printf("\nMatched doors; quantiles 0, 5, 25, 50, 75, 95 and 100 %%\n");
    for (const bool is_scanned : {false, true}) {
        const std::string mapped = is_scanned ? ", scanned" : ", perfect";
        std::vector<double> away;
        std::array<std::vector<double>, 2> widths;
        std::vector<double> on_map;
        std::vector<double> beyond_map;
        std::vector<double> ratios;
        std::vector<double> over_width;
        for (const CaseResult& result : results) {
            if (result.chosen.is_scanned != is_scanned) continue;
            for (const MatchedDoor& door : result.matched) {
                away.push_back(door.distance_m);
                widths[door.is_open_passage ? 1 : 0].push_back(door.width_error_m);
                on_map.push_back(door.map_error_m);
                beyond_map.push_back(door.width_error_m - door.map_error_m);
                ratios.push_back(door.border_ratio);
                over_width.push_back(door.border_over_width);
            }
        }
        const auto num_straight = static_cast<std::size_t>(std::count_if(
            ratios.begin(), ratios.end(), [](double ratio) { return ratio <= kMaxBorderRatio; }));
        double sum = 0.0;
        for (const double ratio : ratios) sum += ratio;
        print_quantiles(("distance of the middles, m" + mapped).c_str(), away);
        print_quantiles(("width error of doors proper, m" + mapped).c_str(), widths[0]);
        print_quantiles(("width error of open passages, m" + mapped).c_str(), widths[1]);
        print_quantiles(("width of the map less the truth, m" + mapped).c_str(), on_map);
        print_quantiles(("width found less that of the map, m" + mapped).c_str(), beyond_map);
        print_quantiles(("border over its chord" + mapped).c_str(), ratios);
        print_quantiles(("border over the door's width" + mapped).c_str(), over_width);
        std::printf("%-44s mean %.4f, %.1f %% at most %.2f\n",
                    ("border over its chord" + mapped).c_str(),
                    ratios.empty() ? 0.0 : sum / static_cast<double>(ratios.size()),
                    percent(num_straight, ratios.size()), kMaxBorderRatio);
    }
}

void print_kinds(const std::vector<CaseResult>& results) {
    KindCounts sum{};
    std::size_t num_right = 0;
    std::size_t num_all = 0;
    for (const CaseResult& result : results) {
        for (std::size_t truth = 0; truth < 4; ++truth) {
            for (std::size_t found = 0; found < 4; ++found) {
                sum[truth][found] += result.kinds[truth][found];
                num_all += result.kinds[truth][found];
                if (truth == found) num_right += result.kinds[truth][found];
            }
        }
    }
    std::printf("\nKinds of matched rooms: %.1f %% of %zu are right\n", percent(num_right, num_all),
                num_all);
    std::printf("| truth | found: room | corridor | hall |\n|---|---|---|---|\n");
    for (std::size_t truth = 1; truth < 4; ++truth) {
        std::printf("| %s | %zu | %zu | %zu |\n", io::to_text(static_cast<RoomKind>(truth)).data(),
                    sum[truth][1], sum[truth][2], sum[truth][3]);
    }
}

void print_causes(const std::vector<CaseResult>& results) {
    std::map<std::string, std::size_t> causes;
    std::map<std::string, std::size_t> rooms;
    std::size_t num_unseen = 0;
    for (const CaseResult& result : results) {
        num_unseen += result.doors.num_unseen;
        for (const DoorError& error : result.doors.missed) {
            const std::string kind = error.is_open_passage ? "missed passage: " : "missed door: ";
            ++causes[kind + error.cause];
            ++rooms[kind + error.rooms];
        }
        for (const DoorError& error : result.doors.extra) {
            ++causes["extra: " + error.cause];
            ++rooms["extra: " + error.rooms];
        }
    }
    const auto print = [](const char* title, const std::map<std::string, std::size_t>& counts) {
        std::vector<std::pair<std::size_t, std::string>> sorted;
        for (const auto& [name, count] : counts) sorted.emplace_back(count, name);
        std::sort(sorted.rbegin(), sorted.rend());
        std::printf("\n%s\n", title);
        for (std::size_t i = 0; i < std::min<std::size_t>(sorted.size(), 20); ++i) {
            std::printf("%5zu  %s\n", sorted[i].first, sorted[i].second.c_str());
        }
    };
    print("Wrong doors by cause", causes);
    print("Wrong doors by the rooms on their sides", rooms);
    std::printf("%zu true openings left out: the map does not show both sides\n", num_unseen);
    double pq = 0.0;
    std::size_t num_in_shafts = 0;
    for (const CaseResult& result : results) {
        pq += result.pq_without_shafts();
        num_in_shafts += result.num_in_shafts;
    }
    std::printf("%zu rooms are shafts that a map draws free; without them PQ %.1f\n", num_in_shafts,
                100.0 * pq / static_cast<double>(results.size()));
}

void print_worst(const std::vector<CaseResult>& results) {
    std::vector<const CaseResult*> sorted;
    for (const CaseResult& result : results) sorted.push_back(&result);
    const auto print = [&](const char* title, const std::function<double(const CaseResult&)>& key) {
        std::stable_sort(sorted.begin(), sorted.end(),
                         [&](auto* p, auto* q) { return key(*p) < key(*q); });
        std::printf("\n%s\n", title);
        for (std::size_t i = 0; i < std::min(sorted.size(), kNumWorst); ++i) {
            const CaseResult& result = *sorted[i];
            std::printf(
                "seed %lu, %s: PQ %.1f, baseline %.1f, %u rooms for %u; openings F1 %.1f, "
                "missed %zu, extra %zu\n",
                static_cast<unsigned long>(result.chosen.seed), name_of(result.chosen).c_str(),
                100.0 * result.rooms.pq, 100.0 * result.baseline.pq, result.rooms.rooms,
                result.rooms.truth, all_openings(result).f1(), result.doors.missed.size(),
                result.doors.extra.size());
        }
    };
    print("Worst rooms", [](const CaseResult& result) { return result.rooms.pq; });
    print("Worst doors", [](const CaseResult& result) { return all_openings(result).f1(); });
}

Json errors_of(const std::vector<DoorError>& errors) {
    Json list = Json::array();
    for (const DoorError& error : errors) {
        list.push_back({{"cause", error.cause},
                        {"x", error.at.x},
                        {"y", error.at.y},
                        {"width_m", error.width_m},
                        {"open_passage", error.is_open_passage},
                        {"rooms", error.rooms}});
    }
    return list;
}

Json counts_of(const Rates& rates) {
    return {{"right", rates.right}, {"missed", rates.missed}, {"extra", rates.extra}};
}

void add_details(const CaseResult& result, Json& row) {
    row["matched"] = Json::array();
    for (const MatchedDoor& door : result.matched) {
        row["matched"].push_back({{"door", door.truth},
                                  {"distance_m", door.distance_m},
                                  {"width_error_m", door.width_error_m},
                                  {"map_width_error_m", door.map_error_m},
                                  {"border_over_chord", door.border_ratio},
                                  {"border_over_width", door.border_over_width},
                                  {"open_passage", door.is_open_passage}});
    }
    row["missed"] = errors_of(result.doors.missed);
    row["extra"] = errors_of(result.doors.extra);
}

Json row_of(const CaseResult& result) {
    Json row;
    row["input"] = "seed " + std::to_string(result.chosen.seed);
    row["num_rooms"] = result.chosen.num_rooms;
    row["furniture"] = result.chosen.furniture;
    row["turned"] = result.chosen.is_turned;
    row["scanned"] = result.chosen.is_scanned;
    row["pq"] = result.rooms.pq;
    row["in_shafts"] = result.num_in_shafts;
    row["pq_without_shafts"] = result.pq_without_shafts();
    row["f1_70"] = result.rooms.f1_70;
    row["cover"] = result.rooms.cover;
    row["rooms"] = result.rooms.rooms;
    row["true_rooms"] = result.rooms.truth;
    row["baseline_pq"] = result.baseline.pq;
    row["kinds"] = result.kinds;
    row["unseen_openings"] = result.doors.num_unseen;
    row["openings"] = counts_of(all_openings(result));
    row["doors_proper"] = counts_of(doors_proper(result));
    std::size_t num_within = 0;
    double sum = 0.0;
    double largest = 0.0;
    for (const MatchedDoor& door : result.matched) {
        num_within += std::abs(door.width_error_m) <= kMaxWidthErrorM ? 1 : 0;
        sum += door.border_ratio;
        largest = std::max(largest, door.border_ratio);
    }
    row["widths_within_100_mm"] = num_within;
    row["border_over_chord_sum"] = sum;
    row["border_over_chord_max"] = largest;
    return row;
}

int run(int argc, char** argv) {
    std::size_t num_buildings = 200;
    std::size_t first = 0;
    bool has_details = false;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "--details") has_details = true;
        if (i + 1 == argc) break;
        if (std::string(argv[i]) == "--buildings") num_buildings = std::stoul(argv[i + 1]);
        if (std::string(argv[i]) == "--case") {
            first = std::stoul(argv[i + 1]);
            num_buildings = 1;
        }
    }
    Progress progress(num_buildings);
    const auto results = run_cases<CaseResult>(num_buildings, [&](std::size_t i) {
        CaseResult result = measure(building_case(first + i));
        char text[128];
        std::snprintf(text, sizeof text, "seed %lu, %s: PQ %.1f, baseline %.1f",
                      static_cast<unsigned long>(result.chosen.seed),
                      name_of(result.chosen).c_str(), 100.0 * result.rooms.pq,
                      100.0 * result.baseline.pq);
        progress.note(text);
        return result;
    });
    print_quality(results);
    print_geometry(results);
    print_kinds(results);
    print_causes(results);
    print_worst(results);
    Json rows = Json::array();
    for (const CaseResult& result : results) {
        rows.push_back(row_of(result));
        if (has_details) add_details(result, rows.back());
    }
    write_results(output_path(argc, argv), "buildings", std::move(rows));
    return 0;
}

}  // namespace
}  // namespace quadcut

int main(int argc, char** argv) { return quadcut::run(argc, argv); }
