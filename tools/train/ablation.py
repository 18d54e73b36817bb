#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""What each ingredient is worth: hand-labelled maps with one thing changed at a time.

  ./run bench ablation          or: tools/train/ablation.py [SAMPLES.csv]

In-sample with the door model as it is; then each building with a model trained without it, from
samples of build/release/bench/micro_doors. The ratio of the ratio rule is chosen in the same two
ways. Prints each map as it is, left out, and the table; keeps all scores in build/ablation.
"""

import csv
import signal
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parents[2]
MAPS = ROOT / "../shared/data/rooms"
BENCH = ROOT / "build/release/bench"
TREES = ROOT / "src/quadcut/segment/door_trees.cpp"
OUT = ROOT / "build/ablation"
KINDS = ("plain", "furnished", "kth", "simulated")
NUM_SIMULATED = 72


def run(*command):
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL, cwd=ROOT)


def build():
    run("cmake", "--build", "build/release", "--target", "micro_ablation")


def scores(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def is_ratio(row):
    return row["variant"].startswith("ratio ")


def mean(rows):
    return statistics.mean(float(row["pq"]) for row in rows) if rows else float("nan")


def with_best_ratio(rows, judges):
    """The rows, those of the ratio rule only with the ratio that has the best mean for `judges`."""
    ratios = sorted({row["variant"] for row in judges if is_ratio(row)})
    best = max(ratios, key=lambda ratio: mean([r for r in judges if r["variant"] == ratio]))
    kept = [dict(row) for row in rows if not is_ratio(row) or row["variant"] == best]
    for row in kept:
        if is_ratio(row):
            row["variant"] = "one ratio, the best of " + str(len(ratios))
    return kept


def main():
    if not MAPS.exists():
        print(f"no data in {MAPS}: nothing to measure")
        return
    OUT.mkdir(parents=True, exist_ok=True)
    samples = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/doors.csv").resolve()
    if not samples.exists():
        print("collecting decisions: about ten minutes", file=sys.stderr)
        run(BENCH / "micro_doors", "-o", samples, "--buildings", "600")
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
            run(BENCH / "micro_ablation", building, "-o", OUT / f"without_{building}.csv")
    finally:
        TREES.write_text(trees)
        build()
    run(BENCH / "micro_ablation", "--simulated", NUM_SIMULATED, "-o", OUT / "in_sample.csv")

    in_sample = scores(OUT / "in_sample.csv")
    hand_made = [row for row in in_sample if row["kind"] != "simulated"]
    left_out = []
    for building in buildings:
        others = [row for row in hand_made if row["map"].split(".")[0] != building]
        left_out += with_best_ratio(scores(OUT / f"without_{building}.csv"), others)
    in_sample = with_best_ratio(in_sample, hand_made)

    for row in left_out:
        if row["variant"] == "as it is":
            print(f"| {row['map']} | {float(row['pq']):.1f} |")
    print("\n| ingredient | changed | plain | furnished | KTH | simulated | left out: plain "
          "| furnished | KTH | time |\n|---|---|---|---|---|---|---|---|---|---|")
    base_ms = sum(float(row["ms"]) for row in in_sample if row["variant"] == "as it is")
    names = list(dict.fromkeys((row["ingredient"], row["variant"]) for row in in_sample))
    for ingredient, variant in names:
        def of(rows, kind):
            return mean([r for r in rows if r["kind"] == kind and r["variant"] == variant])
        ms = sum(float(row["ms"]) for row in in_sample if row["variant"] == variant)
        cells = [of(in_sample, kind) for kind in KINDS] + [of(left_out, k) for k in KINDS[:3]]
        print(f"| {ingredient} | {variant} | " + " | ".join(f"{cell:.1f}" for cell in cells)
              + f" | {ms / base_ms:.2f} |")


if __name__ == "__main__":
    main()
