# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Documentation that the program writes is as the program writes it."""

import subprocess
from pathlib import Path

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
