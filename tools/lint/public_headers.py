# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""The library's door: which headers are public, that each is in docs/api.md with a program that runs, and
that what a program includes stays light."""

import re
from pathlib import Path

from layers import PUBLIC, resolve
from source import Tree

PAGE = "docs/api.md"
# The most headers of ours that a public header may include, directly or not.
MAX_REACHED = {"segment": 11, "follower": 15}
EXAMPLE = re.compile(r"<!-- example:(\w+\.\w+) -->\n(.*?)<!-- /example:\1 -->\n", re.DOTALL)


def reached_from(tree: Tree, path: str) -> list[str]:
    """The file and the headers of ours it includes, directly or not."""
    reached = [path]
    for current in reached:
        for include in tree.files[current].includes():
            path = resolve(tree, include.target)
            if path is not None and path not in reached:
                reached.append(path)
    return sorted(reached)


def check(tree: Tree, fix: bool) -> list[str]:
    return _check_list(tree) + _check_reach(tree) + _check_page(tree, fix)


def _check_list(tree: Tree) -> list[str]:
    there = {path.removeprefix("include/quadcut/").split(".")[0]: path
             for path in tree.files if path.startswith("include/")}
    problems = [f"{there[name]}:1: a public header that tools/lint/layers.py does not list"
                for name in there.keys() - PUBLIC.keys()]
    problems += [f"tools/lint/layers.py:1: there is no public header '{name}'"
                 for name in PUBLIC.keys() - there.keys()]
    page = tree.files[PAGE].text if PAGE in tree.files else ""
    for name in sorted(PUBLIC):
        if (f"`<quadcut/{name}.hpp>`" not in page or f"example:{name}.cpp" not in page
                or f"examples/{name}.cpp" not in tree.files):
            problems.append(f"{PAGE}:1: quadcut/{name}.hpp has no line, or no program")
    return problems


def _check_reach(tree: Tree) -> list[str]:
    problems = []
    for name in PUBLIC:
        header = f"include/quadcut/{name}.hpp"
        if header not in tree.files:
            continue
        reached = [path for path in reached_from(tree, header) if path != header]
        limit = MAX_REACHED.get(name, len(reached))
        if len(reached) > limit:
            problems.append(f"{header}:1: includes {len(reached)} headers, at most {limit}: "
                            + ", ".join(reached))
        # What is installed beside the public headers; one of another folder would be missing.
        problems += [f"{header}:1: reaches {path}, which is not installed" for path in reached
                     if not path.startswith(("include/", "src/quadcut/", "src/project/"))]
    return problems


def _check_page(tree: Tree, fix: bool) -> list[str]:
    """The programs stand in the page as they are in examples/."""
    if PAGE not in tree.files:
        return []

    def embedded(match: re.Match) -> str:
        name = match.group(1)
        source = tree.files.get(f"examples/{name}")
        if source is None:
            return match.group(0)
        code = source.text.split("developers\n", 1)[1]
        return f"<!-- example:{name} -->\n```cpp\n{code}```\n<!-- /example:{name} -->\n"

    text = tree.files[PAGE].text
    right = EXAMPLE.sub(embedded, text)
    if right == text:
        return []
    if fix:
        (Path(tree.root) / PAGE).write_text(right, encoding="utf-8")
        return []
    return [f"{PAGE}:1: its programs are not those of examples/; ./run lint --fix writes them"]
