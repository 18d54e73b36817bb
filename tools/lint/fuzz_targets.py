# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Every reader of untrusted bytes is fuzzed: the table in tests/fuzz/README.md, code and targets say the same.

A row of the table is

    | `parse_poses` in `src/io/poses.hpp` | `poses` |

The target is tests/fuzz/fuzz_poses.cpp, which names the function. A reader is a function of src/io that is
called parse_, read_ or open_ something, or one that opens a project. It has a row, or is reached from one
that has, or is called read_ something and hands the bytes of a file to one of these.
"""

import re

from source import SourceFile, Tree

TABLE = "tests/fuzz/README.md"
_ROW = re.compile(r"^\| `([\w:]+)` in `([\w/.]+)` \| `(\w+)` \|$")
_READER = re.compile(r"^(?!using|return)[\w\[][\w:<>,&* \[\]]*[ *&]((?:parse|read|open)_\w+)\(", re.MULTILINE)
_OPENS_PROJECT = re.compile(r"\bstatic Project (open\w*)\(")
# They hand bytes on as they are.
_CARRIERS = {"open_to_read", "read_all", "read_file", "read_input", "read_up_to"}
_NAME = re.compile(r"\b[A-Za-z_]\w*\b")


def check(tree: Tree) -> list[str]:
    if TABLE not in tree.files:
        return [f"{TABLE}:1: does not exist"]
    problems = []
    listed = set()  # functions, as they are called
    targets = {path for path in tree.files if re.match(r"tests/fuzz/fuzz_\w+\.cpp$", path)}
    used = set()
    for number, line in enumerate(tree.files[TABLE].lines, start=1):
        row = _ROW.match(line)
        if row is None:
            continue
        name = row.group(1).split("::")[-1]
        target = f"tests/fuzz/fuzz_{row.group(3)}.cpp"
        listed.add(name)
        used.add(target)
        header = tree.files.get(row.group(2))
        if header is None or not re.search(rf"\b{name}\(", header.code):
            problems.append(f"{TABLE}:{number}: there is no {row.group(1)} in {row.group(2)}")
        if target not in targets:
            problems.append(f"{TABLE}:{number}: there is no {target}")
        elif not re.search(rf"\b{name}\(", tree.files[target].code):
            problems.append(f"{TABLE}:{number}: {target} does not call {row.group(1)}")
    problems += [f"{path}:1: has no row in {TABLE}" for path in sorted(targets - used)]
    fuzzed = _fuzzed(tree, listed)
    for file, line, name in _readers(tree):
        if name not in fuzzed | _CARRIERS:
            problems.append(f"{file.path}:{line}: {name} reads what others wrote; no fuzz target of "
                            f"{TABLE} gets there")
    return problems


def _readers(tree: Tree) -> list[tuple[SourceFile, int, str]]:
    return [(file, file.line_of(match.start(1)), match.group(1))
            for folder, form in (("src/io/", _READER), ("src/project/", _OPENS_PROJECT))
            for file in tree.sources("src") if file.is_header and file.path.startswith(folder)
            for match in form.finditer(file.code)]


def _fuzzed(tree: Tree, listed: set[str]) -> set[str]:
    """Names that are reached, as far as names tell who calls whom."""
    uses: dict[str, set[str]] = {}
    for file in tree.sources("src"):
        if file.path.startswith(("src/io/", "src/project/")) and not file.is_header:
            for name, used in _uses(file):
                uses.setdefault(name, set()).update(used)
    fuzzed = set(listed)
    while True:
        more = {used for name in fuzzed for used in uses.get(name, ())}
        if more <= fuzzed:
            break
        fuzzed |= more
    readers = {name for _, _, name in _readers(tree)} & fuzzed
    return fuzzed | {name for name, used in uses.items()
                     if name.startswith("read_") and used & readers}


def _uses(file: SourceFile) -> list[tuple[str, set[str]]]:
    """Each function, and the names in it and in the tables of its file."""
    lines = file.code.splitlines()
    bodies = []
    for function in file.functions():
        first = function.line - 1
        body = "\n".join(lines[first:first + function.num_lines])
        lines[first:first + function.num_lines] = [""] * function.num_lines
        name = re.search(r"(\w+)\(", body)
        bodies.append((name.group(1) if name else "", body))
    shared = set(_NAME.findall("\n".join(lines)))
    return [(name, shared | set(_NAME.findall(body))) for name, body in bodies]
