# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Tables say what the files of results say; bench/compare finds the same rows and what differs."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import generated
import results

COMPARE = Path(__file__).resolve().parents[2] / "bench/compare"


def file_of(rows: list[dict], **changes) -> dict:
    return {"format_version": 1, "benchmark": "speed",
            "machine": {"cpu": "x86", "cores": 2, "memory_gib": 8.0}, "commit": "abc1234",
            "command": "./run bench speed", "date": "2026-01-02T03:04:05Z", "rows": rows, **changes}


def speed_row(name: str, segment_ms: float, transform_ms: float = 2.0) -> dict:
    return {"input": name, "cells": 1000000, "segment_ms": segment_ms,
            "distance_transform_ms": transform_ms, "ratio": segment_ms / transform_ms, "cpu_ratio": 10.0,
            "stages_ms": {"fuse": 0.75 * segment_ms, "doors": 0.25 * segment_ms}}


def scored_row(name: str, method: str, pq: float) -> dict:
    return {"input": name, "method": method, "rooms": 3, "elapsed_ms": 7.0, "pq": pq, "f1_70": pq,
            "cover": 0.99, "true_rooms": 4}


class Tables(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        (self.root / "docs/results").mkdir(parents=True)

    def write(self, page: str, text: str, **files: dict):
        (self.root / page).write_text(text, encoding="utf-8")
        for name, file in files.items():
            (self.root / f"docs/results/{name}.json").write_text(json.dumps(file), encoding="utf-8")

    def page(self, name: str) -> str:
        return (self.root / name).read_text(encoding="utf-8")

    def test_written_and_checked(self):
        self.write("docs/results.md", "before\n<!-- bench:speed -->\nold\n<!-- /bench:speed -->\nafter\n",
                   speed=file_of([speed_row("lab", 30.0), speed_row("hall", 50.0)]))
        self.assertEqual(["docs/results.md:2: table 'speed' is not what docs/results says; "
                          "./run lint --fix writes it"], generated.check_tables(self.root, fix=False))
        self.assertIn("\nold\n", self.page("docs/results.md"))
        self.assertEqual([], generated.check_tables(self.root, fix=True))
        self.assertEqual([], generated.check_tables(self.root, fix=False))
        text = self.page("docs/results.md")
        self.assertTrue(text.startswith("before\n<!-- bench:speed -->\n| map |"))
        self.assertIn("| lab | 1.00 | 30.0 | 2.0 | 15.0 | 10.0 |\n"
                      "| hall | 1.00 | 50.0 | 2.0 | 25.0 | 10.0 |\n", text)
        self.assertIn("Median 20.0, worst 25.0; of the CPU times 10.0 and 10.0. "
                      "Of the time: fuse 75 %, doors 25 %.", text)
        self.assertIn("commit abc1234, 2026-01-02, x86, 2 cores*\n<!-- /bench:speed -->\nafter\n", text)
        (self.root / "docs/results.md").write_text(text.replace("30.0", "29.0"), encoding="utf-8")
        self.assertEqual(1, len(generated.check_tables(self.root, fix=False)))

    def test_real_maps_by_their_sets(self):
        def row(name: str, kind: str, pq: float, **more) -> dict:
            return {"input": name, "kind": kind, "pq": pq, "rooms": 3, "true_rooms": 4, "ceiling": 0.9,
                    "joined_ceiling": 0.8, "pq_joined_right": 0.75, "pq_cut_right": 0.65, **more}
        doors = {"found": 4, "true": 5, "precision": 0.75, "recall": 0.6, "f1": 2 / 3,
                 "f1_at_doorway": 0.8}
        self.write("docs/results.md", "<!-- bench:real -->\n<!-- /bench:real -->\n",
                   real=file_of([row("hall", "campus", 0.83, doors=doors), row("a", "real", 0.5),
                                 row("b", "real", 0.7, segment_ms=60.4, ratio=8.0, cpu_ratio=9.5)]))
        self.assertEqual([], generated.check_tables(self.root, fix=True))
        text = self.page("docs/results.md")
        self.assertIn("| a | 50.0 | 3 | 4 | 75.0 | 65.0 | 90.0 | 80.0 | – | – | – |\n"
                      "| b | 70.0 | 3 | 4 | 75.0 | 65.0 | 90.0 | 80.0 | 60 | 8.0 | 9.5 |\n"
                      "| **scanned, mean of 2** | **60.0** |  |  | **75.0** | **65.0** | **90.0** | **80.0** |  |  |  |\n"
                      "| hall | 83.0 |", text)
        self.assertIn("hall: 4 doors found of 5, precision 75.0, recall 60.0, F1 66.7; either end of a "
                      "deep doorway allowed: F1 80.0.", text)

    def test_without_its_file_a_table_stays(self):
        text = "<!-- bench:follow -->\nold\n<!-- /bench:follow -->\n"
        self.write("docs/results.md", text)
        self.assertEqual([], generated.check_tables(self.root, fix=True))
        self.assertEqual(text, self.page("docs/results.md"))

    def test_unknown_table(self):
        self.write("docs/results.md", "<!-- bench:sped -->\n<!-- /bench:sped -->\n")
        with self.assertRaisesRegex(ValueError, "'sped'"):
            generated.check_tables(self.root, fix=False)

    def test_rows_of_others_and_columns_of_other_files_are_kept(self):
        quality = file_of([scored_row(f"{name}.{kind}", method, pq) for name, kind, pq in
                           (("a", "plain", 0.9), ("a", "furnished", 0.8), ("kth_b", "plain", 0.7))
                           for method in ("rooms", "paper", "paper, told K")])
        self.write("README.md", "<!-- bench:readme-quality -->\n| | plain | furnished | KTH |\n"
                   "|---|---|---|---|\n| **quadcut** | **1** | **2** | **3** |\n"
                   "| peer | 4 | 5 | 6 |\n<!-- /bench:readme-quality -->\n")
        self.write("docs/results.md", "<!-- bench:each-building -->\n| building | plain | left out "
                   "| furnished | left out |\n|---|---|---|---|---|\n| a | 1 | 2.5 | 3 | 4.5 |\n"
                   "<!-- /bench:each-building -->\n", quality=quality)
        generated.check_tables(self.root, fix=True)
        self.assertIn("| **quadcut** | **90.0** | **80.0** | **70.0** |\n| peer | 4 | 5 | 6 |\n",
                      self.page("README.md"))
        self.assertIn("| a | 90.0 | 2.5 | 80.0 | 4.5 |\n| kth_b | 70.0 | – | – | – |\n",
                      self.page("docs/results.md"))

    def test_left_out_of_the_training(self):
        ablation = file_of([
            {"ingredient": "", "variant": "as it is", "time_over_first": 1.0,
             "in_sample": {"plain": 0.95, "furnished": 0.9, "kth": 0.8, "simulated": 0.7},
             "left_out": {"plain": 0.94, "furnished": 0.89, "kth": 0.79}},
            {"input": "a.plain", "left_out_pq": 0.85}])
        quality = file_of([scored_row("a.plain", method, 0.9)
                           for method in ("rooms", "paper", "paper, told K")])
        self.write("docs/results.md", "".join(f"<!-- bench:{name} -->\n<!-- /bench:{name} -->\n"
                                              for name in ("quality", "each-building", "ablation")),
                   quality=quality, ablation=ablation)
        generated.check_tables(self.root, fix=True)
        text = self.page("docs/results.md")
        self.assertIn(f"| {results.LEFT_OUT} | 94.0 | 89.0 | 79.0 |  |\n", text)
        self.assertIn("| a | 90.0 | 85.0 | – | – |\n", text)
        self.assertIn("|  | **as it is** | 95.0 | 90.0 | 80.0 | 70.0 | 94.0 | 89.0 | 79.0 | 1.00 |\n", text)


class Compare(unittest.TestCase):
    def compare(self, a, b, *options: str) -> subprocess.CompletedProcess:
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(folder) / "a.json", Path(folder) / "b.json"]
            for path, file in zip(paths, (a, b)):
                path.write_text(file if isinstance(file, str) else json.dumps(file), encoding="utf-8")
            return subprocess.run([sys.executable, COMPARE, *paths, *options], capture_output=True,
                                  text=True, check=False)

    def test_side_by_side(self):
        run = self.compare(file_of([speed_row("lab", 30.0), speed_row("hall", 50.0)]),
                           file_of([speed_row("hall", 25.0), speed_row("lab", 30.0)]),
                           "--only", "segment")
        self.assertEqual(0, run.returncode, run.stderr)
        self.assertEqual(["               A   B    B/A", "lab", "  segment_ms  30  30      1",
                          "hall", "  segment_ms  50  25  0.500"], run.stdout.splitlines()[2:])

    def test_all_numbers_of_a_row(self):
        row = {"input": "x", "part": "log", "n": 4, "deep": {"a": [1.5, {"b": 2}]}, "is_new": True}
        run = self.compare(file_of([row]), file_of([dict(row, n=0)]))
        self.assertIn("x, log\n", run.stdout)
        self.assertRegex(run.stdout, r"  n +4 +0 +0\.000\n")
        self.assertRegex(run.stdout, r"  deep\.a\[0\] +1\.5 +1\.5 +1\n")
        self.assertRegex(run.stdout, r"  deep\.a\[1\]\.b +2 +2 +1\n")
        self.assertNotIn("is_new", run.stdout)

    def test_rows_without_another(self):
        run = self.compare(file_of([speed_row("lab", 1.0), speed_row("lab", 2.0)]),
                           file_of([speed_row("lab", 1.0), speed_row("hall", 2.0)]))
        self.assertIn("only in A: lab (2)\nonly in B: hall\n", run.stdout)

    def test_warnings(self):
        def warned(**changes) -> list[str]:
            run = self.compare(file_of([]), file_of([], **changes))
            return [line for line in run.stdout.splitlines() if line.startswith("warning: ")]
        self.assertEqual([], warned())
        self.assertEqual(["warning: different benchmarks: speed, scale"], warned(benchmark="scale"))
        self.assertEqual(["warning: different machines, cores: 2, 4"],
                         warned(machine={"cpu": "x86", "cores": 4, "memory_gib": 8.0}))
        self.assertEqual(["warning: different commits: abc1234, def-dirty",
                          "warning: B had changes that are in no commit"],
                         warned(commit="def-dirty"))

        self.assertEqual(["warning: B was measured while others used 1.5 of 2 cores"],
                         warned(cores_of_others=1.5))

    def test_no_file_of_results(self):
        for bad in ("[]", "{", "{}"):
            run = self.compare(file_of([]), bad)
            self.assertEqual(2, run.returncode)
            self.assertIn("b.json", run.stderr)
            self.assertNotIn("Traceback", run.stderr)
