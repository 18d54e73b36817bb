# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Dependency goes down the page: base <- map, base <- spectral; map + spectral <- rooms | paper, which do
not see each other; both <- segment <- zones, route, explain <- follow <- everything else."""

import re

from source import SourceFile, Tree

FLOORS = {"base", "map", "spectral"}
CORE = FLOORS | {"rooms", "paper", "segment", "zones", "route", "explain", "follow"}

# Folder -> the folders it may include, itself aside. A new folder gets a line here.
MAY_INCLUDE = {
    "base": set(),
    "map": {"base"},
    "spectral": {"base"},  # knows no map
    "rooms": FLOORS,
    "paper": FLOORS,
    "segment": FLOORS | {"rooms", "paper"},
    "zones": FLOORS | {"rooms", "segment"},
    "route": {"base", "map", "segment"},
    "explain": FLOORS | {"rooms", "segment"},
    "follow": CORE,
    "io": CORE,
    "draw": CORE | {"io"},
    "formats": CORE | {"io", "draw"},
    "project": CORE | {"io"},
    "sim": CORE | {"io"},
    "eval": CORE | {"io", "sim"},
    "opencl": CORE,
    "reproduce": CORE | {"io", "draw", "sim", "eval"},
    "apps": CORE | {"io", "draw", "formats", "project", "sim", "eval", "opencl", "reproduce"},
}

# Public header (include/quadcut) -> the layer whose door it is.
PUBLIC = {
    "version": "base", "error": "base", "executor": "base",
    "map": "map", "scan": "map",
    "result": "segment", "segment": "segment",
    "options": "follow", "follower": "follow",
    "io": "formats",
    "project": "project",
}


def folder_of(path: str) -> str:
    """The layer of a file of src/, include/ or apps/, or of an include as it is written."""
    parts = path.removeprefix("src/").removeprefix("include/").split("/")
    if parts[0] == "quadcut":
        return parts[1] if len(parts) > 2 else PUBLIC.get(parts[1].removesuffix(".hpp"), parts[1])
    return parts[0]


def check(tree: Tree) -> list[str]:
    problems = []
    for file in tree.sources("src", "include", "apps"):
        problems += _check_file(tree, file)
    problems += _include_cycles(tree)
    return problems


def _check_file(tree: Tree, file: SourceFile) -> list[str]:
    problems = []
    layer = folder_of(file.path)
    if layer not in MAY_INCLUDE:
        return [f"{file.path}:1: folder '{layer}' has no layer; give it one in tools/lint/layers.py"]
    for include in file.includes():
        place = f"{file.path}:{include.line}"
        if include.system:
            if file.is_header and re.search(r"[/.]", include.target):
                problems.append(f"{place}: <{include.target}> in a header; only the standard "
                                "library may be, include it in one .cpp")
            continue
        if resolve(tree, include.target) is None:
            problems.append(f"{place}: '{include.target}' is not a file of ours; write includes "
                            "from src/, and others' in <>")
            continue
        used = folder_of(include.target)
        if used != layer and used not in MAY_INCLUDE[layer]:
            problems.append(f"{place}: {layer} must not include {used} ('{include.target}')")
    return problems


def resolve(tree: Tree, target: str) -> str | None:
    for path in ("src/" + target, "include/" + target, f"include/{target}.in", target):
        if path in tree.files:
            return path
    return None


def _include_cycles(tree: Tree) -> list[str]:
    problems = []
    done: set[str] = set()

    def visit(path: str, trail: list[str]) -> None:
        if path in trail:
            cycle = " -> ".join(trail[trail.index(path):] + [path])
            problems.append(f"{path}:1: headers include each other: {cycle}")
        if path in done or path in trail:
            return
        for include in tree.files[path].includes():
            target = None if include.system else resolve(tree, include.target)
            if target is not None:
                visit(target, trail + [path])
        done.add(path)

    for file in tree.sources("src", "include", "apps"):
        visit(file.path, [])
    return problems
