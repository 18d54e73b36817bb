# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Names and marks of files: licence lines, forbidden names, notes left for later."""

import re
from pathlib import PurePosixPath

from source import SourceFile, Tree

LICENCE = "SPDX-License-Identifier: Apache-2.0"
COPYRIGHT = "SPDX-FileCopyrightText: The quadcut developers"
LICENSED_SUFFIXES = {".cpp", ".hpp", ".cl", ".py", ".sh", ".in", ".cmake", ".js", ".ts", ".css"}
LICENSED_NAMES = {"CMakeLists.txt", "run"}
FORBIDDEN_NAMES = {"util", "utils", "common", "helper", "helpers", "detail", "details", "misc"}
LATER = re.compile(r"\b(TO" r"DO|FIX" r"ME)\b")


def check(tree: Tree) -> list[str]:
    problems = []
    for file in tree.files.values():
        problems += _check_licence(file)
        path = PurePosixPath(file.path)
        for part in (*path.parts[:-1], path.name.split(".")[0]):
            if part.lower() in FORBIDDEN_NAMES:
                problems.append(f"{file.path}:1: '{part}' names no idea; call it by what it does")
        if file.is_source:
            if not re.fullmatch(r"[a-z0-9_]+\.[ch]pp", path.name):
                problems.append(f"{file.path}:1: file names are snake_case")
            if file.is_header and not re.search(r"^#pragma once$", file.text, re.MULTILINE):
                problems.append(f"{file.path}:1: no #pragma once")
        for match in LATER.finditer(file.text):
            problems.append(f"{file.path}:{file.line_of(match.start())}: {match.group()} "
                            "left in; do it, or drop it")
    return problems


def _check_licence(file: SourceFile) -> list[str]:
    path = PurePosixPath(file.path)
    if path.suffix not in LICENSED_SUFFIXES and path.name not in LICENSED_NAMES:
        return []
    if file.is_source:
        if file.lines[:2] != [f"// {LICENCE}", f"// {COPYRIGHT}"]:
            return [f"{file.path}:1: the first two lines are not the SPDX lines"]
    elif LICENCE not in file.text[:400] or COPYRIGHT not in file.text[:400]:
        return [f"{file.path}:1: no SPDX lines on top"]
    return []
