# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Equation marks in the code and the table in docs/equations.md say the same.

A mark is a comment `// Eq. (3): ...`. A row of the table is

    | (3) threshold | `threshold` in `src/quadcut/paper/visibility.cpp` | `Visibility.Threshold` |

Further columns are free. A row may name several functions, each followed by its file, and several
tests; a row whose first cell names no number belongs to no mark and is left alone.
"""

import re
from dataclasses import dataclass

from source import Tree

TABLE = "docs/equations.md"
_MARK = re.compile(r"//[/!<]*[^\n]*?\bEq\. \((\w+)\)")
_FORM = re.compile(r"//[^\n]*\bEqs?\.(?! \(\w+\))")
_TEST = re.compile(r"\b(?:TEST|TEST_F|TEST_P|TYPED_TEST)\(\s*(\w+)\s*,\s*(\w+)\s*\)")
_IN_TICKS = re.compile(r"`([^`]+)`")


@dataclass
class Row:
    line: int
    equation: str
    functions: list[tuple[str, str]]  # function, file
    tests: list[str]


def check(tree: Tree) -> list[str]:
    problems = []
    marks: dict[str, set[str]] = {}  # equation -> files
    for file in tree.sources("src"):
        for match in _MARK.finditer(file.text):
            marks.setdefault(match.group(1), set()).add(file.path)
        for match in _FORM.finditer(file.text):
            problems.append(f"{file.path}:{file.line_of(match.start())}: "
                            "an equation mark is written `// Eq. (3): ...`")
    if TABLE not in tree.files:
        if marks:
            problems.append(f"{TABLE}:1: does not exist, yet the code marks equations "
                            + ", ".join(sorted(marks)))
        return problems
    rows = _rows(tree.files[TABLE].lines)
    listed = {row.equation for row in rows}
    for equation, files in sorted(marks.items()):
        if equation not in listed:
            problems.append(f"{sorted(files)[0]}:1: equation ({equation}) is not in {TABLE}")
    tests = {".".join(m) for f in tree.sources("tests") for m in _TEST.findall(f.text)}
    for row in rows:
        problems += _check_row(tree, row, marks.get(row.equation, set()), tests)
    return problems


def _rows(lines: list[str]) -> list[Row]:
    rows = []
    for number, line in enumerate(lines, start=1):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        equation = re.search(r"\((\w+)\)", cells[0])
        if not line.lstrip().startswith("|") or len(cells) < 3 or equation is None:
            continue
        functions = []
        names: list[str] = []
        for token in _IN_TICKS.findall(cells[1]):
            if re.search(r"\.[ch]pp$", token):
                functions += [(name, token) for name in names]
                names = []
            else:
                names.append(re.sub(r"\(.*\)$", "", token))
        functions += [(name, "") for name in names]
        rows.append(Row(number, equation.group(1), functions, _IN_TICKS.findall(cells[2])))
    return rows


def _check_row(tree: Tree, row: Row, marked: set[str], tests: set[str]) -> list[str]:
    problems = []
    place = f"{TABLE}:{row.line}: equation ({row.equation})"
    if not row.functions:
        problems.append(f"{place} names no function (`name` in `src/....cpp`)")
    for function, path in row.functions:
        if path not in tree.files:
            problems.append(f"{place} names no existing file for `{function}` ('{path}')")
            continue
        last_name = function.split("::")[-1]
        if not re.search(rf"\b{re.escape(last_name)}\b", tree.files[path].code):
            problems.append(f"{place}: there is no `{function}` in {path}")
        if path not in marked:
            problems.append(f"{place}: {path} has no mark `// Eq. ({row.equation})`")
    if not row.tests:
        problems.append(f"{place} names no test (`Suite.Name`)")
    problems += [f"{place}: there is no test `{t}`" for t in row.tests if t not in tests]
    return problems
