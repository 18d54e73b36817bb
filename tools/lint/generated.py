# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Documentation that the program writes is as the program writes it, tables as docs/results says."""

import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
import results  # noqa: E402

# File -> the arguments that print it.
GENERATED = {"docs/options.md": ["options", "--markdown"]}


def check(root: Path, program: Path, fix: bool) -> list[str]:
    """What is out of date; with `fix`, writes it anew instead."""
    problems = []
    for name, arguments in GENERATED.items():
        run = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
        command = " ".join(["quadcut", *arguments])
        if run.returncode != 0:
            problems.append(f"{name}:1: `{command}` failed: {run.stderr.strip()}")
            continue
        path = root / name
        if path.is_file() and path.read_text(encoding="utf-8") == run.stdout:
            continue
        if fix:
            path.write_text(run.stdout, encoding="utf-8")
        else:
            problems.append(f"{name}:1: out of date; ./run lint --fix writes it (`{command}`)")
    return problems


def check_tables(root: Path, fix: bool) -> list[str]:
    """The same of the tables that are made from files of results."""
    return results.check(root, fix)
