#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Scores each hand-made map with a door model that has not seen its building.

  tools/train/leave_one_out.py build/doors.csv

Trains, builds build/release and segments ../shared/data/rooms once for each building; at the end
the model of all buildings is in place again.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[2]
MAPS = ROOT / "../shared/data/rooms"
QUADCUT = ROOT / "build/release/quadcut"
TRAIN = ROOT / "tools/train/door_model.py"


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True, cwd=ROOT).stdout


def build(samples, left_out):
    run("/usr/bin/python3", TRAIN, samples, "--leave-out", left_out)
    run("cmake", "--build", "build/release", "--target", "quadcut")


def score(path, folder):
    name = path.stem
    truth = MAPS / (name.split(".")[0] + ".rooms.png")
    run(QUADCUT, "segment", path, "-o", folder, "--quiet")
    return json.loads(run(QUADCUT, "score", Path(folder) / "rooms.png", truth))["pq"] * 100


def main():
    samples = Path(sys.argv[1]).resolve()
    rows = {}
    for building in sorted({path.name.split(".")[0] for path in MAPS.glob("*.yaml")}):
        build(samples, building)
        for path in sorted(MAPS.glob(building + ".*.yaml")):
            with tempfile.TemporaryDirectory() as folder:
                kind = "kth" if building.startswith("kth_") else path.stem.split(".")[1]
                rows.setdefault(kind, []).append(score(path, folder))
                print(f"| {path.stem} | {rows[kind][-1]:.1f} |", flush=True)
    build(samples, "")
    for kind, values in rows.items():
        print(f"| mean, {kind} | {sum(values) / len(values):.1f} |")


if __name__ == "__main__":
    main()
