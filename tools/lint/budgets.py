# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Budgets: each wing of the core, each file and each function stay small; no function macros, no raw
new. A wing's limit is a ratchet: at most RATCHET lines above its count, so that deleting lowers it and
raising it shows in review."""

import re

from source import Tree

# The door model's trees are data that tools/train/door_model.py writes, not code.
CORE_DATA = "src/quadcut/rooms/door_trees.cpp"
WINGS = {
    "rooms": ("base", "map", "spectral", "rooms", "segment"),
    "paper": ("paper",),
    "live": ("follow",),
    "above": ("zones", "route", "explain"),
}
MAX_LINES = {"rooms": 9860, "paper": 931, "live": 3123, "above": 2245}
RATCHET = 25
MAX_FILE_LINES = 400
MAX_FUNCTION_LINES = 60


def num_lines(tree: Tree, wing: str) -> int:
    folders = tuple(f"src/quadcut/{folder}/" for folder in WINGS[wing])
    return sum(f.num_code_lines() for f in tree.sources("src")
               if f.path.startswith(folders) and f.path != CORE_DATA)


def check_wings(tree: Tree) -> list[str]:
    problems = []
    for wing, limit in MAX_LINES.items():
        count = num_lines(tree, wing)
        if count > limit:
            problems.append(f"tools/lint/budgets.py: wing {wing}: {count} lines of code; "
                            f"the budget is {limit}")
        elif count < limit - RATCHET:
            problems.append(f"tools/lint/budgets.py: wing {wing}: {count} lines of code; "
                            f"lower its budget of {limit} to {count + RATCHET} or less")
    return problems


def check(tree: Tree) -> list[str]:
    return check_wings(tree) + check_files(tree)


def check_files(tree: Tree) -> list[str]:
    problems = []
    for file in tree.sources("src", "apps"):
        if len(file.lines) > MAX_FILE_LINES and file.path != CORE_DATA:
            problems.append(f"{file.path}:1: {len(file.lines)} lines; "
                            f"a file has at most {MAX_FILE_LINES}")
        for function in file.functions():
            if function.num_lines > MAX_FUNCTION_LINES:
                problems.append(f"{file.path}:{function.line}: a function of {function.num_lines} "
                                f"lines; at most {MAX_FUNCTION_LINES}")
        for match in re.finditer(r"^[ \t]*#[ \t]*define[ \t]+(\w+)\(", file.code, re.MULTILINE):
            problems.append(f"{file.path}:{file.line_of(match.start())}: "
                            f"function macro {match.group(1)}; write a function")
        for match in re.finditer(r"(?<!<)\bnew\b", file.code):
            problems.append(f"{file.path}:{file.line_of(match.start())}: raw new; "
                            "use a container or make_unique")
    return problems
