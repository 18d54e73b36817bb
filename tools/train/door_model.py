#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Trains the door model: decisions in, src/quadcut/rooms/door_trees.cpp out.

  build/release/bench/measure_doors -o build/doors.csv --buildings 120 --cluttered 200
  tools/train/door_model.py build/doors.csv                         writes the trees
  tools/train/door_model.py build/doors.csv --leave-out NAME -o F   without the maps of one building

Needs python3-sklearn. The same samples give the same trees.
"""

import argparse
import csv
from pathlib import Path

import numpy as np
from sklearn.ensemble import HistGradientBoostingClassifier

NUM_TREES = 300
NUM_LEAVES = 6
# Hand-made truth is what counts, and there is little of it: each decision counts this often; those
# of the same maps turned and scaled, of which there are many, less, and so do simulated ones of
# plans with wide openings, where the truth is hard to see.
WEIGHTS = {"plain": 20.0, "furnished": 20.0, "kth": 20.0, "real": 25.0, "campus": 25.0,
           "growing": 5.0, "plain changed": 0.5, "furnished changed": 0.5, "kth changed": 0.5,
           "real changed": 0.5, "campus changed": 0.5, "simulated cluttered": 0.5,
           "simulated drawn": 0.5}
LEARNING_RATE = 0.2
TREES = Path(__file__).parents[2] / "src/quadcut/rooms/door_trees.cpp"

# More of these never makes a door less likely.
RISING = ("r_peak_", "_wall_", "widening_")

HEAD = """// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
// Written by tools/train/door_model.py.
#include "quadcut/rooms/door_trees.hpp"

namespace quadcut {

"""


def read(path):
    with open(path) as file:
        rows = list(csv.reader(file))
    names = rows[0][4:]
    groups = np.array([row[1] for row in rows[1:]])
    weights = np.array([WEIGHTS.get(row[2], 1.0) for row in rows[1:]])
    is_cut = np.array([int(row[3]) for row in rows[1:]])
    cues = np.array([[float(v) for v in row[4:]] for row in rows[1:]])
    return names, groups, weights, is_cut, cues


def train(names, weights, is_cut, cues):
    rising = [int(any(part in name for part in RISING)) for name in names]
    model = HistGradientBoostingClassifier(
        max_iter=NUM_TREES, max_leaf_nodes=NUM_LEAVES, learning_rate=LEARNING_RATE,
        l2_regularization=1.0, min_samples_leaf=20, monotonic_cst=rising,
        early_stopping=False, random_state=0)
    return model.fit(cues, is_cut, sample_weight=weights)


def number(value):
    text = f"{value:.5g}"
    text = text if "." in text or "e" in text else text + "."
    return text.replace("0.", ".", 1) + "F" if abs(value) < 1 and value != 0 else text + "F"


def dense(text):
    """Lines of at most 100 characters that end with commas."""
    lines = [""]
    for part in text.split(","):
        if len(lines[-1]) + len(part) + 1 > 100:
            lines.append("")
        lines[-1] += part + ","
    return "\n".join(lines)[:-1]


def tree_text(nodes):
    """Branches {cue, threshold, below, above} and leaves; see DoorTree."""
    branches = [i for i, node in enumerate(nodes) if not node["is_leaf"]]
    leaves = [i for i, node in enumerate(nodes) if node["is_leaf"]]

    def target(i):
        return f"-{leaves.index(i)}" if nodes[i]["is_leaf"] else str(branches.index(i))

    def end(i):
        text = target(i)
        return "0" if text == "-0" else text

    b = ["{%d,%s,%s,%s}" % (nodes[i]["feature_idx"], number(nodes[i]["num_threshold"]),
                                  end(nodes[i]["left"]), end(nodes[i]["right"])) for i in branches]
    v = [number(nodes[i]["value"]) for i in leaves]
    b += ["{0,0.F,0,0}"] * (NUM_LEAVES - 1 - len(b))
    v += ["0.F"] * (NUM_LEAVES - len(v))
    return "{{{" + ",".join(b) + "}},{" + ",".join(v) + "}}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("samples")
    parser.add_argument("--leave-out", default="")
    parser.add_argument("-o", "--output", default=str(TREES))
    arguments = parser.parse_args()
    names, groups, weights, is_cut, cues = read(arguments.samples)
    chosen = groups != arguments.leave_out
    model = train(names, weights[chosen], is_cut[chosen], cues[chosen])
    trees = [tree_text(stage[0].nodes) for stage in model._predictors]
    bias = float(model._baseline_prediction.ravel()[0])
    text = HEAD + f"const double kDoorBias = {bias:.6g};\n\n// clang-format off\n"
    text += f"const std::array<DoorTree, {len(trees)}> kDoorTrees{{{{\n"
    text += dense(",".join(trees)) + "}};\n// clang-format on\n\n}  // namespace quadcut\n"
    Path(arguments.output).write_text(text)
    print(f"{chosen.sum()} decisions, {len(trees)} trees: {arguments.output}")


if __name__ == "__main__":
    main()
