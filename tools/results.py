#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Tables of README.md and docs/results.md, from the files in docs/results.

  tools/results.py             writes what stands between <!-- bench:NAME --> and <!-- /bench:NAME -->
  tools/results.py --check     says what is out of date instead

A table whose file is not there stays as it is; so does a column that another file would give.
"""

import argparse
import json
import re
import statistics
import sys
from pathlib import Path

MARK = re.compile(r"(<!-- bench:([\w-]+) -->\n)(.*?)(<!-- /bench:\2 -->)", re.DOTALL)
PAGES = ("README.md", "docs/results.md", "docs/api.md")
KINDS = ("plain", "furnished", "kth")
DASH = "–"


def read_results(root: Path) -> dict[str, dict]:
    """By the name of the benchmark."""
    return {path.stem: json.loads(path.read_text(encoding="utf-8"))
            for path in sorted((root / "docs/results").glob("*.json"))}


def table(head: list[str], rows: list[list[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines).replace("| --- ", "|---"
                                                                     ).replace("--- |", "---|")


def old_rows(old: str) -> dict[str, list[str]]:
    """The cells of a table by those of its first column, without bold."""
    rows = {}
    for line in old.splitlines():
        if line.startswith("|") and not line.startswith("|---"):
            cells = [cell.strip().replace("**", "") for cell in line.strip("|").split("|")]
            rows[cells[0]] = cells
    return rows


def source(*files: dict) -> str:
    """Where numbers come from, below their table."""
    said = []
    for file in files:
        machine = file["machine"]
        said.append(f"`{file['command']}`, commit {file['commit']}, {file['date'][:10]}, "
                    f"{machine['cpu']}, {machine['cores']} cores"
                    + (f" of which others used {file['cores_of_others']:.1f}"
                       if file.get("cores_of_others", 0) >= 0.05 else ""))
    return "\n*" + "; ".join(said) + "*\n"


def kind_of(name: str) -> str:
    return "kth" if name.startswith("kth_") else name.split(".")[-1]


def mean_percent(rows: list[dict], key: str, kind: str) -> str:
    values = [100 * row[key] for row in rows if kind_of(row["input"]) == kind]
    return f"{statistics.mean(values):.1f}" if values else DASH


def scored(file: dict, method: str) -> list[dict]:
    """The rows of hand-made maps."""
    return [row for row in file["rows"]
            if row["method"] == method and "pq" in row and ".log" not in row["input"]]


def left_out_means(files: dict) -> list[str] | None:
    for row in files.get("ablation", {"rows": []})["rows"]:
        if row.get("variant") == "as it is" and "left_out" in row:
            return [f"{100 * row['left_out'][kind]:.1f}" for kind in KINDS]
    return None


def quality(files: dict, old: str) -> str | None:
    if "quality" not in files:
        return None
    file = files["quality"]
    old_left_out = old_rows(old).get(LEFT_OUT, [LEFT_OUT, DASH, DASH, DASH])[1:4]

    def row_of(name: str, method: str, bold: str = "") -> list[str]:
        rows = scored(file, method)
        means = [bold + mean_percent(rows, "pq", kind) + bold for kind in KINDS]
        least = f"{100 * min(row['cover'] for row in rows):.1f}" if bold else ""
        return [name, *means, least]
    rows = [row_of("`rooms`", "rooms", "**"),
            [LEFT_OUT, *(left_out_means(files) or old_left_out), ""],
            row_of("`paper`, told the true number of rooms", "paper, told K"),
            row_of("`paper`, told nothing", "paper")]
    f1 = scored(file, "rooms")
    return (table(["method", "ten maps, plain", "ten maps, furnished", "four KTH floors",
                   "least cover"], rows)
            + f"\nF1 at IoU 0.7 of `rooms`: {mean_percent(f1, 'f1_70', 'plain')} plain, "
              f"{mean_percent(f1, 'f1_70', 'furnished')} furnished.\n" + source(file))


LEFT_OUT = "`rooms`, the building left out of the training (`./run bench ablation`)"


def readme_quality(files: dict, old: str) -> str | None:
    """Only the rows of quadcut; those of others are kept."""
    if "quality" not in files:
        return None
    rows = scored(files["quality"], "rooms")
    ours = [mean_percent(rows, "pq", kind) for kind in KINDS]
    left_out = left_out_means(files)
    lines = []
    for line in old.splitlines(keepends=True):
        name = line.split("|")[1].strip() if line.startswith("|") else ""
        if name == "**quadcut**":
            line = "| **quadcut** | " + " | ".join(f"**{cell}**" for cell in ours) + " |\n"
        elif name.startswith("quadcut, the door model trained without") and left_out:
            line = f"| {name} | " + " | ".join(left_out) + " |\n"
        lines.append(line)
    return "".join(lines)


def each_building(files: dict, old: str) -> str | None:
    if "quality" not in files:
        return None
    in_training = {row["input"]: f"{100 * row['pq']:.1f}" for row in scored(files["quality"], "rooms")}
    left_out = {row["input"]: f"{100 * row['left_out_pq']:.1f}"
                for row in files.get("ablation", {"rows": []})["rows"] if "left_out_pq" in row}
    before = old_rows(old)
    rows = []
    for building in sorted({name.split(".")[0] for name in in_training}):
        cells = [building]
        for column, kind in ((2, "plain"), (4, "furnished")):
            name = f"{building}.{kind}"
            kept = before.get(building, [])[column:column + 1] or [DASH]
            cells += [in_training.get(name, DASH), left_out.get(name, kept[0])]
        rows.append(cells)
    return table(["building", "plain", "left out", "furnished", "left out"], rows)


def every_input(files: dict, old: str) -> str | None:
    del old
    if "quality" not in files:
        return None
    rows = []
    for row in files["quality"]["rows"]:
        scores = [f"{100 * row[key]:.1f}" if key in row else DASH for key in ("pq", "f1_70", "cover")]
        rows.append([row["input"], row["method"], *scores, str(row["rooms"]),
                     str(row.get("true_rooms", DASH)), f"{row['elapsed_ms']:.0f}"])
    return (table(["input", "method", "PQ", "F1 0.7", "cover", "rooms", "true", "ms"], rows)
            + source(files["quality"]))


def f1_of(rows: list[dict], key: str) -> str:
    right, missed, extra = (sum(row[key][part] for row in rows)
                            for part in ("right", "missed", "extra"))
    return f"{200 * right / max(1, 2 * right + missed + extra):.1f}"


def buildings(files: dict, old: str) -> str | None:
    del old
    if "buildings" not in files:
        return None
    every = files["buildings"]["rows"]
    groups = [("furniture 0", lambda row: row["furniture"] == 0),
              ("furniture 0.5", lambda row: row["furniture"] == 0.5),
              ("furniture 1", lambda row: row["furniture"] == 1),
              ("straight", lambda row: not row["turned"]), ("turned", lambda row: row["turned"]),
              ("mapped perfectly", lambda row: not row["scanned"]),
              ("mapped from scans", lambda row: row["scanned"]), ("all", lambda row: True)]
    lines = []
    for name, is_of in groups:
        rows = [row for row in every if is_of(row)]
        if not rows:
            continue
        pq = [100 * row["pq"] for row in rows]
        matched = sum(row["openings"]["right"] for row in rows)
        within = 100 * sum(row["widths_within_100_mm"] for row in rows) / max(1, matched)
        lines.append([name, f"{statistics.mean(pq):.1f}", f"{min(pq):.1f}",
                      f"{100 * statistics.mean(row['baseline_pq'] for row in rows):.1f}",
                      f1_of(rows, "openings"), f1_of(rows, "doors_proper"), f"{within:.1f} %"])
    kinds = [(truth == found, row["kinds"][truth][found])
             for row in every for truth in range(4) for found in range(4)]
    num_kinds = sum(count for _, count in kinds)
    num_right = sum(count for is_right, count in kinds if is_right)
    num_matched = sum(row["openings"]["right"] for row in every)
    border = sum(row["border_over_chord_sum"] for row in every) / max(1, num_matched)
    longest = max(row["border_over_chord_max"] for row in every)
    shafts = sum(row["in_shafts"] for row in every)
    without = 100 * statistics.mean(row["pq_without_shafts"] for row in every)
    return (table(["buildings", "PQ", "least", "watershed", "openings F1", "doors proper F1",
                   "widths within 0.1 m"], lines)
            + f"\n{len(every)} buildings. Kinds of matched rooms: "
              f"{100 * num_right / max(1, num_kinds):.1f} % of {num_kinds:,} are right. Borders over "
              f"their chords: mean {border:.3f}, longest {longest:.3f}. {shafts} of the rooms are "
              f"shafts without a door that a perfect map draws free; without them the mean is "
              f"{without:.1f}.\n" + source(files["buildings"]))


def invariance(files: dict, old: str) -> str | None:
    del old
    if "invariance" not in files:
        return None
    rows = files["invariance"]["rows"]

    def mean(change: str, kind: str) -> float:
        return statistics.mean(100 * row["pq"] for row in rows
                               if row["change"] == change and row["kind"] == kind)
    changes = list(dict.fromkeys(row["change"] for row in rows if row["change"] != "unchanged"))
    lines = [[change, *(f"{mean(change, kind) - mean('unchanged', kind):+.1f}" for kind in KINDS)]
             for change in changes]
    return table(["change", "plain", "furnished", "KTH"], lines) + source(files["invariance"])


def ablation(files: dict, old: str) -> str | None:
    del old
    if "ablation" not in files:
        return None
    lines = []
    for row in files["ablation"]["rows"]:
        if "variant" not in row:
            continue
        bold = "**" if row["variant"] == "as it is" else ""
        cells = [f"{100 * row['in_sample'][kind]:.1f}" for kind in (*KINDS, "simulated")]
        cells += [f"{100 * row['left_out'][kind]:.1f}" for kind in KINDS]
        lines.append([row["ingredient"], bold + row["variant"] + bold, *cells,
                      f"{row['time_over_first']:.2f}"])
    return (table(["ingredient", "changed", "plain", "furnished", "KTH", "simulated",
                   "left out: plain", "furnished", "KTH", "time"], lines)
            + source(files["ablation"]))


def speed(files: dict, old: str) -> str | None:
    del old
    if "speed" not in files:
        return None
    rows = files["speed"]["rows"]
    lines = [[row["input"], f"{1e-6 * row['cells']:.2f}", f"{row['segment_ms']:.1f}",
              f"{row['distance_transform_ms']:.1f}", f"{row['ratio']:.1f}",
              f"{row['cpu_ratio']:.1f}"] for row in rows]
    ratios = [row["ratio"] for row in rows]
    cpu_ratios = [row["cpu_ratio"] for row in rows]
    stages = {}
    for row in rows:
        for stage, ms in row["stages_ms"].items():
            stages[stage] = stages.get(stage, 0.0) + ms
    shares = ", ".join(f"{stage} {100 * ms / sum(stages.values()):.0f} %"
                       for stage, ms in sorted(stages.items(), key=lambda item: -item[1]))
    return (table(["map", "megacells", "`segment()` ms", "distance transform ms", "ratio", "of CPU times"],
                  lines)
            + f"\nMedian {statistics.median(ratios):.1f}, worst {max(ratios):.1f}; of the CPU times "
              f"{statistics.median(cpu_ratios):.1f} and {max(cpu_ratios):.1f}. Of the time: {shares}.\n"
            + source(files["speed"]))


def real(files: dict, old: str) -> str | None:
    del old
    if "real" not in files:
        return None
    rows = files["real"]["rows"]
    shares = ("pq", "pq_joined_right", "pq_cut_right", "ceiling", "joined_ceiling")
    sets = [("scanned", "real"), ("growing", "growing"), ("drawn", "campus")]
    lines = []
    for text, kind in sets:
        of_kind = [row for row in rows if row["kind"] == kind]
        lines += [[row["input"], f"{100 * row['pq']:.1f}", str(row["rooms"]), str(row["true_rooms"]),
                   *(f"{100 * row[key]:.1f}" for key in shares[1:]),
                   f"{row['segment_ms']:.0f}" if "segment_ms" in row else DASH,
                   f"{row['ratio']:.1f}" if "ratio" in row else DASH,
                   f"{row['cpu_ratio']:.1f}" if "cpu_ratio" in row else DASH] for row in of_kind]
        if len(of_kind) > 1:
            means = [f"**{100 * statistics.mean(row[key] for row in of_kind):.1f}**"
                     for key in shares]
            lines.append([f"**{text}, mean of {len(of_kind)}**", means[0], "", "", *means[1:], "", "", ""])
    doors = "".join(f"\n{row['input']}: {row['doors']['found']} doors found of {row['doors']['true']}, "
                    f"precision {100 * row['doors']['precision']:.1f}, recall "
                    f"{100 * row['doors']['recall']:.1f}, F1 {100 * row['doors']['f1']:.1f}; either end of "
                    f"a deep doorway allowed: F1 {100 * row['doors']['f1_at_doorway']:.1f}.\n"
                    for row in rows if "doors" in row)
    return (table(["map", "PQ", "rooms", "true", "joined right", "cut right", "ceiling",
                   "after the spectral cut", "`segment()` ms", "ratio", "of CPU times"], lines) + doors + source(files["real"]))


def scale(files: dict, old: str) -> str | None:
    del old
    if "scale" not in files:
        return None
    rows = [row for row in files["scale"]["rows"] if "kind" in row]
    shown = [row for row in rows if row["kind"] != "data" or row["cells"] > 2e6]
    lines = [[row["input"], f"{1e-6 * row['cells']:.2f}", f"{1e-6 * row['free_cells']:.2f}",
              str(row["rooms"]), f"{row['segment_ms']:.0f}", f"{row['segment_cpu_ms']:.0f}",
              f"{row['distance_transform_ms']:.0f}", f"{row['ratio']:.1f}", f"{row['cpu_ratio']:.1f}",
              f"{row['peak_mib']:.0f}"] for row in shown]
    fits = [[row["fit"], f"{row['exponent']:.3f}", str(row["maps"]), f"{row['largest_deviation']:.2f}"]
            for row in files["scale"]["rows"] if "fit" in row]
    return (table(["map", "megacells", "free", "rooms", "`segment()` ms", "of CPU, all threads",
                   "distance transform ms", "ratio", "of CPU times", "peak MiB"], lines) + "\n"
            + table(["from 10^6 cells on", "exponent", "maps", "within a factor"], fits)
            + source(files["scale"]))


def stages(files: dict, old: str) -> str | None:
    del old
    if "stages" not in files:
        return None
    lines = [[row["method"], row["fit"], f"{row['exponent_over_cells']:.2f}",
              f"{row['exponent_over_free_cells']:.2f}", f"{row['largest_deviation']:.2f}",
              f"{row['exponent_over_cells_from_1e6']:.2f} ({row['sizes_from_1e6']} sizes)"]
             for row in files["stages"]["rows"] if "fit" in row]
    return (table(["method", "stage", "exponent over cells", "over free cells", "within a factor",
                   "over cells, from 10^6 on"], lines) + source(files["stages"]))


def updates(files: dict, old: str) -> str | None:
    del old
    if "updates" not in files:
        return None
    lines = [[row["input"], row["map"], f"{row['ms_a_scan']:.3f}", f"{row['over_flat_grid']:.2f}",
              f"{row['over_quadcut']:.2f}", f"{row['known_m2']:,.0f}", f"{row['bytes_a_known_m2']:,.0f}"]
             for row in files["updates"]["rows"]]
    return (table(["log", "map", "CPU ms a scan", "over flat grid", "over quadcut", "known m²",
                   "bytes a known m²"], lines) + source(files["updates"]))


def overhead(files: dict, old: str) -> str | None:
    del old
    if "overhead" not in files:
        return None
    rows = files["overhead"]["rows"]
    maps = [row for row in rows if "cells" in row]
    lines = [[row["input"], f"{1e-6 * row['cells']:.2f}", f"{row['processing_ms']:.1f}",
              f"{row['read_ms']:.1f}", f"{row['write_ms']:.1f}", f"{row['wall_ms']:.1f}",
              f"{row['ratio']:.2f}", f"{row['median_ratio']:.2f}",
              f"{row['peak_bytes'] / 2**20:.1f}"] for row in maps]
    start = next(row for row in rows if row["input"] == "version")
    return (table(["map", "megacells", "processing ms", "read ms", "write ms", "whole process ms",
                   "ratio", "median ratio", "peak MiB"], lines)
            + f"\n`quadcut version` takes {start['version_ms']:.2f} ms, `/bin/true` "
              f"{start['true_ms']:.2f}: {start['ratio']:.1f} times.\n" + source(files["overhead"]))


def bounds(files: dict, old: str) -> str | None:
    del old
    if "bounds" not in files:
        return None
    rows = files["bounds"]["rows"]
    logs = [[row["input"], row["command"], f"{row['cpu_ms']:.0f}", f"{row['peak_bytes'] / 2**20:.1f}",
             f"{row['time_ratio']:.2f}", f"{row['memory_ratio']:.2f}"]
            for row in rows if "memory_ratio" in row]
    images = [[row["input"], f"{1e-6 * row['cells']:,.0f}", f"{row['ns_per_cell']:.0f}",
               f"{row['bytes_per_cell']:.1f}", f"{row['time_ratio']:.2f}"]
              for row in rows if "bytes_per_cell" in row]
    return (table(["log", "command", "CPU ms", "peak MiB", "time / without", "memory / without"], logs)
            + "\n" + table(["image", "megacells", "CPU ns a cell", "bytes a cell",
                            "time / building"], images) + source(files["bounds"]))


def peers(files: dict, old: str) -> str | None:
    del old
    if "peers" not in files:
        return None
    rows = files["peers"]["rows"]

    def of(kind: str) -> list[dict]:
        return [row for row in rows if row["measured"] == kind]

    def seconds(row: dict, key: str) -> str:
        return f"{row[key]:.3f}" if key in row else row.get("failure", DASH)
    cuts = [[row["graph"], row["solver"], seconds(row, "wall_s"), seconds(row, "cpu_s"),
             f"{row['normalised_cut']:.4f}"] for row in of("cut")]
    pairs = [[row["graph"], row["solver"], seconds(row, "wall_s"), seconds(row, "cpu_s"),
              f"{row['largest_residual']:.0e}" if row.get("largest_residual") else DASH]
             for row in of("eigenpairs")]
    products = [[row["graph"], str(row["threads"]), f"{row['product_ms']:.2f}",
                 f"{1e-6 * row['product_bytes'] / row['product_ms']:.1f}",
                 f"{1e-9 * row['read_bytes_per_s']:.1f}",
                 f"{100 * row['product_bytes'] / (1e-3 * row['product_ms']) / row['read_bytes_per_s']:.0f} %"]
                for row in of("product")]
    # Of results up to commit 67dd59b, the last one with a cut by levels.
    of_cuts = table(["cut into 256", "by", "wall s", "CPU s", "normalised cut"], cuts) + "\n" if cuts else ""
    return (of_cuts
            + table(["16 eigenpairs", "by", "wall s", "CPU s", "residual"], pairs) + "\n"
            + table(["sparse product", "threads", "ms", "GB/s", "GB/s of a sum", "share"], products)
            + source(files["peers"]))


def bold_if(is_short: bool, text: str) -> str:
    return f"**{text}**" if is_short else text


def follow(files: dict, old: str) -> str | None:
    del old
    logs = [row for row in files.get("follow", {"rows": []})["rows"] if row["part"] == "log"]
    if not logs:
        return None
    makers = [
        ("scans, known area", lambda r: f"{r['scans']:,}, {r['mapped_m2']:,.0f} m²"),
        ("after the last scan", lambda r: bold_if(r["at_end"]["pq"] < 96, f"{r['at_end']['pq']:.1f}")
         + ", " + bold_if(r["at_end"]["ari"] < 0.97, f"{r['at_end']['ari']:.3f}")),
        ("at the tenths, PQ", lambda r: bold_if(
            min(r["tenths_pq"]) < 90, f"{min(r['tenths_pq']):.0f}") + f" to {max(r['tenths_pq']):.0f}"),
        ("ids that change, per 100 scans", lambda r: f"{r['id_switches_a_100_scans']:.2f}"),
        ("relabelled by a cut, median, of the known area", lambda r: bold_if(
            r["relabelled_median_percent"] > 0.5, f"{r['relabelled_median_percent']:.2f} %")),
        ("cuts; median, 99 %",
         lambda r: f"{r['cuts']:,}; {r['cut_median_ms']:.0f}, {r['cut_p99_ms']:.0f} ms"),
        ("largest local graph in the last quarter, of the batch's nodes", lambda r: bold_if(
            r["largest_local_graph"] > r["batch_nodes"] / 4 and r["mapped_m2"] > 2000,
            f"{100 * r['largest_local_graph'] / r['batch_nodes']:.0f} %")),
        ("its 99 % in the last quarter over the second",
         lambda r: f"{r['local_graph_p99_last_quarter'] / r['local_graph_p99_second_quarter']:.2f}"),
        ("99 % of the cuts' times over the ray caster's, last quarter over second",
         lambda r: f"{r['cut_p99_over_ray_caster_last_quarter'] / r['cut_p99_over_ray_caster_second_quarter']:.2f}"),
        ("integration over a flat-grid ray caster",
         lambda r: f"{r['integrate_ms_a_scan'] / r['ray_caster_ms_a_scan']:.1f}"),
        ("followed at", lambda r: f"{r['times_real_time']:.0f} x real time"),
        ("ps, median; at most 25 % in", lambda r: f"{r['ps_median_percent']:.0f} %; "
                                                  f"{r['ps_at_most_25_percent_of_scans']:.0f} % of the scans"),
        ("nodes touched, median", lambda r: f"{r['nodes_touched_median_percent']:.1f} %"),
        ("a scan into the quadtree; KD-tree of the obstacles built anew",
         lambda r: f"{r['integrate_ms_a_scan']:.2f}; {r['kd_tree_ms_a_scan']:.1f} ms"),
        ("bytes per known m² over the log",
         lambda r: f"{r['bytes_a_m2_least']:,.0f} to {r['bytes_a_m2_most']:,.0f}")]
    lines = [[name, *(cell_of(row) for row in logs)] for name, cell_of in makers]
    return table(["", *(row["input"] for row in logs)], lines) + source(files["follow"])


def headers(files: dict, old: str) -> str | None:
    del old
    if "headers" not in files:
        return None
    lines = [[f"`{row['header']}`", str(row["num_headers"]), f"{row['standard_ms']:.0f}",
              f"{row['compile_ms']:.0f}", f"{row['compile_ms'] - row['standard_ms']:.0f}"]
             for row in files["headers"]["rows"]]
    return (table(["header", "headers of quadcut", "standard ms", "with it ms", "more ms"], lines)
            + source(files["headers"]))


def independence(files: dict, old: str) -> str | None:
    del old
    if "independence" not in files:
        return None

    def independent(pairs: dict) -> str:
        return f"{pairs['independent']} → {pairs['independent_given_doors']} of {pairs['pairs']}"
    lines = [[row["input"], row["parts"], str(row["num_parts"]), f"{100 * row['seen_outside']:.1f} %",
              f"{100 * row['largest_share']:.0f} %", independent(row["all"]),
              independent(row["seen_together"]), independent(row["with_doors"])]
             for row in files["independence"]["rows"]]
    return (table(["log", "parts", "number", "seen outside", "largest part",
                   "independent pairs", "of those seen together", "of those with a door"], lines)
            + source(files["independence"]))


def zones(files: dict, old: str) -> str | None:
    del old
    if "zones" not in files:
        return None
    lines = []
    for kind, text in (("campus", "wings joined by walkways"),
                       ("building", "wings that go over into each other")):
        rows = [row for row in files["zones"]["rows"] if row["kind"] == kind]
        told = [row["ari_told"] for row in rows]
        found = [row["ari"] for row in rows]
        right = sum(row["zones"] == row["wings"] for row in rows)
        lines.append([text, f"{statistics.mean(told):.3f} ({min(told):.2f})",
                      f"{statistics.mean(found):.3f} ({min(found):.2f})", f"{right} of {len(rows)}"])
    return (table(["simulated campuses", "ARI told the number (least)", "ARI by eigengap (least)",
                   "the number right"], lines) + source(files["zones"]))


def realism(files: dict, old: str) -> str | None:
    """What each method has on clean and on scanned maps, simulated and real."""
    del old
    if "realism" not in files:
        return None
    rows = files["realism"]["rows"]

    def mean(method: str, kind: str) -> float | None:
        values = [row["pq"] for row in rows if row["method"] == method and row["kind"] == kind]
        return 100 * statistics.mean(values) if values else None

    def text(value: float | None) -> str:
        return DASH if value is None else f"{value:.1f}"
    lines = []
    for method in dict.fromkeys(row["method"] for row in rows):
        line = [method]
        for world in ("simulated", "real"):
            clean, scanned = (mean(method, f"{world}, {kind}") for kind in ("clean", "scanned"))
            drop = None if clean is None or scanned is None else clean - scanned
            line += [text(clean), text(scanned), text(drop)]
        lines.append(line)
    return (table(["method", "simulated: drawn", "scanned", "loss", "real: cleaned", "scanned", "loss"],
                  lines) + source(files["realism"]))


def paper(files: dict, old: str) -> str | None:
    del old
    if "paper" not in files:
        return None
    rows = files["paper"]["rows"]
    same = {(row["input"], row["rule"]): row for row in rows if row["part"] == "same"}
    lines = []
    for row in rows:
        if row["part"] != "follow":
            continue
        other = same.get((row["input"], row["rule"]))
        lines.append([row["input"], row["rule"], f"{row['pq']:.1f}",
                      f"{row['rooms']} / {row['batch_rooms']}",
                      f"{row['nodes_mean']} / {row['nodes_most']} / {row['batch_nodes']}",
                      f"{row['true_pq_batch']:.1f}" if "true_pq_batch" in row else "",
                      f"{other['order_pq']:.1f}" if other else "",
                      f"{other['origin_pq']:.1f}" if other else ""])
    return (table(["input", "map rule", "followed against the whole map, PQ", "submaps",
                   "nodes of a cut: mean / most / whole map", "whole map against the truth",
                   "other order of scans", "other origin"], lines) + source(files["paper"]))


def route(files: dict, old: str) -> str | None:
    del old
    if "route" not in files:
        return None
    lines = [[row["input"], f"{1e-6 * row['cells']:.1f}", str(row["pairs"]), f"{row['mean_length_m']:.0f}",
              f"{row['length_over_cells']:.3f} ({row['length_over_cells_most']:.2f})",
              f"{row['length_over_pulled']:.3f} ({row['length_over_pulled_most']:.2f})",
              f"{row['cells_read_by_cells']:,.0f}", f"{row['cells_read']:,.0f}",
              f"{row['cells_percent']:.1f} %", f"{row['entries_read']:,.0f}",
              f"{row['ms_by_cells']:.2f}", f"{row['time_percent']:.1f} %", f"{row['prepare_over_a_search']:,.0f}"]
             for row in files["route"]["rows"]]
    return (table(["map", "megacells", "pairs", "mean m", "length over A* (most)", "over A* pulled straight (most)",
                   "cells read by A*", "by `route`", "share", "entries of graphs", "A* ms", "time",
                   "all rooms prepared, in searches"], lines) + source(files["route"]))


def closure(files: dict, old: str) -> str | None:
    del old
    if "closure" not in files:
        return None
    lines = [[row["log"], row["range"], f"{row['scans']:,}", str(row["rooms"]), f"{row['pairs_in_range']:,}",
              f"{row['candidates']:,}", f"{row['saved_percent']:.1f} %", f"{row['true_closures']:,}",
              f"{row['kept_percent']:.2f} %", f"{row['us_a_pose']:.0f}"] for row in files["closure"]["rows"]]
    return (table(["log", "range", "scans", "rooms", "pairs in range", "candidates", "saved",
                   "true closures", "kept", "µs a pose"], lines) + source(files["closure"]))


def growing(files: dict, old: str) -> str | None:
    del old
    if "growing" not in files:
        return None
    lines = []
    for way, text in (("truth", "drawn by people"), ("ids", "cut anew, ids handed on"),
                      ("previous", "`--previous`")):
        rows = [row for row in files["growing"]["rows"] if row["way"] == way]
        changed = [row["changed_percent"] for row in rows if "cells" in row]
        pq = [row["pq"] for row in rows if "pq" in row]
        lines.append([text, f"{statistics.mean(changed):.2f} %", f"{max(changed):.2f} %",
                      str(sum(row.get("ids_given_away", 0) for row in rows)),
                      f"{statistics.mean(pq):.1f}" if pq else ""])
    return (table(["rooms of fifteen stages", "changed a stage", "at worst", "ids given away", "PQ"],
                  lines) + source(files["growing"]))


MAKERS = {"quality": quality, "readme-quality": readme_quality, "each-building": each_building,
          "every-input": every_input, "buildings": buildings, "invariance": invariance,
          "ablation": ablation, "speed": speed, "real": real, "scale": scale, "stages": stages,
          "updates": updates, "overhead": overhead, "bounds": bounds, "peers": peers, "follow": follow,
          "headers": headers, "independence": independence, "zones": zones, "paper": paper,
           "route": route, "closure": closure, "realism": realism, "growing": growing}


def renewed(text: str, files: dict) -> tuple[str, list[tuple[int, str]]]:
    """The page with all its tables as the files say; line and name of each that was not."""
    changed = []

    def replace(match: re.Match) -> str:
        head, name, old, tail = match.groups()
        if name not in MAKERS:
            raise ValueError(f"no table is called '{name}'; there are: {', '.join(MAKERS)}")
        try:
            new = MAKERS[name](files, old)
        except KeyError as error:
            raise ValueError(f"table '{name}': a file in docs/results has no {error}; "
                             "./run bench writes it anew") from error
        if new is None or new == old:
            return match.group(0)
        changed.append((text.count("\n", 0, match.start()) + 1, name))
        return head + new + tail
    return MARK.sub(replace, text), changed


def check(root: Path, fix: bool) -> list[str]:
    """What is out of date; with `fix`, writes it anew instead."""
    problems = []
    files = read_results(root)
    for name in PAGES:
        path = root / name
        if not path.is_file():
            continue
        text = path.read_text(encoding="utf-8")
        new, changed = renewed(text, files)
        if fix and changed:
            path.write_text(new, encoding="utf-8")
        elif changed:
            problems += [f"{name}:{line}: table '{table_name}' is not what docs/results says; "
                         "./run lint --fix writes it" for line, table_name in changed]
    return problems


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="say what is out of date, write nothing")
    fix = not parser.parse_args().check
    problems = check(Path(__file__).resolve().parents[1], fix)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
