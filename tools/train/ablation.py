#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""What each ingredient is worth: hand-labelled maps with one thing changed at a time.

  ./run bench ablation          or: tools/train/ablation.py [SAMPLES.csv] [-o FILE.json]

In-sample with the door model as it is; then each building with a model trained without it, from
samples of build/release/bench/measure_doors. Prints each map as it is, left out, and the table; keeps all scores in build/ablation.
"""

import argparse
import json
import signal
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parents[2]
MAPS = ROOT / "../shared/data/rooms"
BENCH = ROOT / "build/release/bench"
TREES = ROOT / "src/quadcut/rooms/door_trees.cpp"
OUT = ROOT / "build/ablation"
KINDS = ("plain", "furnished", "kth", "simulated")
NUM_SIMULATED = 72


def run(*command):
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL, cwd=ROOT)


def build():
    run("cmake", "--build", "build/release", "--target", "measure_ablation")


def scores(path):
    return json.loads(path.read_text())["rows"]


def mean(rows):
    return statistics.mean(row["pq"] for row in rows) if rows else float("nan")


def table(in_sample, left_out):
    """One row an ingredient, the mean PQ of each kind of map; then each map, left out."""
    def means(rows, kinds, variant):
        return {kind: round(mean([row for row in rows if row["kind"] == kind
                                  and row["variant"] == variant]), 6) for kind in kinds}

    def elapsed_ms(variant):
        return sum(row["elapsed_ms"] for row in in_sample if row["variant"] == variant)
    names = list(dict.fromkeys((row["ingredient"], row["variant"]) for row in in_sample))
    rows = [{"ingredient": ingredient, "variant": variant,
             "in_sample": means(in_sample, KINDS, variant),
             "left_out": means(left_out, KINDS[:3], variant),
             "time_over_first": round(elapsed_ms(variant) / elapsed_ms("as it is"), 4)}
            for ingredient, variant in names]
    rows += [{"input": row["input"], "left_out_pq": row["pq"]}
             for row in left_out if row["variant"] == "as it is"]
    return rows


def show(rows):
    for row in rows:
        if "left_out_pq" in row:
            print(f"| {row['input']} | {100 * row['left_out_pq']:.1f} |")
    print("\n| ingredient | changed | plain | furnished | KTH | simulated | left out: plain "
          "| furnished | KTH | time |\n|---|---|---|---|---|---|---|---|---|---|")
    for row in rows:
        if "variant" in row:
            cells = [*row["in_sample"].values(), *row["left_out"].values()]
            print(f"| {row['ingredient']} | {row['variant']} | "
                  + " | ".join(f"{100 * cell:.1f}" for cell in cells)
                  + f" | {row['time_over_first']:.2f} |")


def write(path, envelope, rows):
    """As bench/result_file.hpp does."""
    envelope["rows"] = []
    head = json.dumps(envelope, indent=1, ensure_ascii=False)
    lines = ",\n  ".join(json.dumps(row, separators=(",", ":")) for row in rows)
    new = path.with_name(path.name + ".new")
    new.write_text(head[:head.rindex("[]")] + "[\n  " + lines + "\n ]\n}\n")
    new.replace(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("samples", nargs="?", type=Path, default=ROOT / "build/doors.csv")
    parser.add_argument("-o", dest="output", type=Path)
    options = parser.parse_args()
    if not MAPS.exists():
        print(f"no data in {MAPS}: nothing to measure")
        return
    OUT.mkdir(parents=True, exist_ok=True)
    samples = options.samples.resolve()
    if not samples.exists():
        print("collecting decisions: about fifteen minutes", file=sys.stderr)
        run(BENCH / "measure_doors", "-o", samples, "--buildings", "120", "--cluttered", "200")
    else:
        print("decisions of", time.strftime("%Y-%m-%d %H:%M", time.localtime(
            samples.stat().st_mtime)), "from", samples, file=sys.stderr)
    trees = TREES.read_text()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    buildings = sorted({path.name.split(".")[0] for path in MAPS.glob("*.yaml")})
    try:
        for building in buildings:
            print("left out:", building, file=sys.stderr)
            run("/usr/bin/python3", ROOT / "tools/train/door_model.py", samples, "--leave-out",
                building)
            build()
            run(BENCH / "measure_ablation", building, "-o", OUT / f"without_{building}.json")
    finally:
        TREES.write_text(trees)
        build()
    run(BENCH / "measure_ablation", "--simulated", NUM_SIMULATED, "-o", OUT / "in_sample.json")

    in_sample = scores(OUT / "in_sample.json")
    left_out = [row for building in buildings
                for row in scores(OUT / f"without_{building}.json")]
    rows = table(in_sample, left_out)
    show(rows)
    if options.output:
        write(options.output, json.loads((OUT / "in_sample.json").read_text()), rows)


if __name__ == "__main__":
    main()
