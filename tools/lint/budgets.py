# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Budgets: the core, each file and each function stay small; no function macros, no raw new."""

import re

from source import Tree

# The door model's trees are data that tools/train/door_model.py writes, not code.
CORE_DATA = "src/quadcut/segment/door_trees.cpp"
MAX_CORE_LINES = 11520
MAX_FILE_LINES = 400
MAX_FUNCTION_LINES = 60


def num_core_lines(tree: Tree) -> int:
    return sum(f.num_code_lines() for f in tree.sources("src")
               if f.path.startswith("src/quadcut/") and f.path != CORE_DATA)


def check(tree: Tree) -> list[str]:
    problems = []
    core = num_core_lines(tree)
    if core > MAX_CORE_LINES:
        problems.append(f"src/quadcut: {core} lines of code; the budget is {MAX_CORE_LINES}")
    for file in tree.sources("src", "apps"):
        if len(file.lines) > MAX_FILE_LINES:
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
