# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""clang-tidy over all our .cpp files, in parallel; what passed before and is the same is skipped.

The key of a file is the hash of itself, of every header of ours it reaches, of its compile
command, of the .clang-tidy files and of clang-tidy's version.
"""

import hashlib
import json
import os
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from public_headers import reached_from
from source import Tree

CLANG_TIDY = "clang-tidy-14"
FOLDERS = ("src", "apps", "bench", "tests")


def check(tree: Tree, build: Path) -> tuple[list[str], int]:
    """What clang-tidy says, one text a file, and how many files it had to look at."""
    commands = {
        os.path.relpath(entry["file"], tree.root): entry["command"]
        for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    }
    version = subprocess.run([CLANG_TIDY, "--version"], capture_output=True, check=True).stdout
    settings = b"".join(
        file.text.encode() for path, file in tree.files.items() if path.endswith(".clang-tidy")
    )
    passed_file = build / "tidy_passed.json"
    passed = set(json.loads(passed_file.read_text()) if passed_file.is_file() else [])

    keys = {}
    for file in tree.sources(*FOLDERS):
        if file.path.endswith(".cpp"):
            parts = [version, settings, commands.get(file.path, "").encode()]
            parts += [tree.files[path].text.encode() for path in reached_from(tree, file.path)]
            keys[file.path] = hashlib.sha256(b"\0".join(parts)).hexdigest()
    pending = [path for path, key in keys.items() if key not in passed]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = dict(zip(pending, pool.map(lambda path: _tidy(tree.root, build, path), pending)))
    clean = [key for path, key in keys.items() if not complaints.get(path)]
    passed_file.write_text(json.dumps(clean), encoding="utf-8")
    return [text for text in complaints.values() if text], len(pending)


def _tidy(root: Path, build: Path, path: str) -> str:
    # The compile commands are those of g++, whose warnings clang does not all know.
    run = subprocess.run(
        [CLANG_TIDY, "-p", build, "--quiet", "--extra-arg=-Wno-unknown-warning-option", path],
        cwd=root, capture_output=True, text=True, check=False)
    if run.returncode == 0:
        return ""
    return run.stdout.strip() or run.stderr.strip()
