#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""All checks of `./run lint`, which installs what they need and calls this."""

import argparse
import subprocess
import sys
import time
from pathlib import Path

import budgets
import equations
import fuzz_targets
import generated
import layers
import names
import public_headers
import selftest
import tidy
from source import Tree, load_tree

ROOT = Path(__file__).resolve().parents[2]
CLANG_FORMAT = "clang-format-14"


def check_format(tree: Tree, fix: bool) -> list[str]:
    paths = [file.path for file in tree.sources()]
    mode = ["-i"] if fix else ["--dry-run", "-Werror"]
    run = subprocess.run([CLANG_FORMAT, *mode, *paths], cwd=tree.root, capture_output=True,
                         text=True, check=False)
    if run.returncode == 0:
        return []
    lines = [line for line in run.stderr.splitlines() if "error:" in line]
    bad = sorted({line.split(":")[0] for line in lines}) or [run.stderr.strip()]
    return [f"{path}:1: not formatted; ./run lint --fix does it" for path in bad]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fix", action="store_true",
                        help="write the format and the generated documentation")
    fix = parser.parse_args().fix

    failed = []

    def report(name: str, problems: list[str], note: str = "") -> None:
        for problem in problems:
            print(problem)
        print(f"lint {name}: {f'{len(problems)} to mend' if problems else 'ok'}{note}", flush=True)
        if problems:
            failed.append(name)

    report("self-test", selftest.run())
    tree = load_tree(ROOT)
    report("format", check_format(tree, fix))
    tree = load_tree(ROOT)
    report("layers", layers.check(tree))
    wings = ", ".join(f"{wing}: {budgets.num_lines(tree, wing)} of {limit} lines"
                      for wing, limit in budgets.MAX_LINES.items())
    report("budgets", budgets.check(tree), f" ({wings})")
    report("public headers", public_headers.check(tree, fix))
    report("names", names.check(tree))
    report("equations", equations.check(tree))
    report("fuzz targets", fuzz_targets.check(tree))
    program = ROOT / "build/release/quadcut"
    if program.is_file():
        report("generated", generated.check(ROOT, program, fix))
    else:
        print("lint generated: skipped, build/release/quadcut is not built")
    report("tables", generated.check_tables(ROOT, fix))
    start = time.monotonic()
    complaints, num_run = tidy.check(tree, ROOT / "build/lint")
    report("clang-tidy", complaints,
           f" ({num_run} files looked at, {time.monotonic() - start:.0f} s)")
    if failed:
        print(f"lint: failed: {', '.join(failed)}")
        return 1
    print("lint: all passed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
