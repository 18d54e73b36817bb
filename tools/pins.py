#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Pinned results: hashes of all that the program writes for maps, logs and simulated buildings.

  tools/pins.py check [--only REGEX]     says which case and which file differ from tests/pins
  tools/pins.py renew [--only REGEX]     writes tests/pins anew; prints scores before and after

`check` exits with 1 when something differs, and with 77 when there is nothing that it can run: most
cases need the folder of maps and logs (../shared, or QUADCUT_SHARED of the environment).
"""

import argparse
import contextlib
import hashlib
import os
import re
import sqlite3
import statistics
import subprocess
import sys
import tempfile
import zlib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

from pinned_cases import GROUPS, Case, Group

ROOT = Path(__file__).resolve().parents[1]
SKIPPED = 77
MAX_TOLD = 25  # cases: a test that fails stays readable

# What the clock says, and the release, is no result.
TIME_OR_VERSION = re.compile(rb'"(?:\w+_ms": (?:\{[^{}]*\}|[-+.\deE]+)|version": "[^"]*")')
# Options are pinned by themselves: one more or less of them leaves the results what they are.
OPTIONS = re.compile(rb'"options": \{[^{}]*\}')


class CaseFailed(Exception):
    """The program could not do what a case asks for."""


@dataclass
class Pin:
    """What a case gave."""
    files: dict[str, str] = field(default_factory=dict)  # hash by name
    score: str = ""  # panoptic quality where the truth is known


Pins = dict[str, Pin]


# ---- what files say

def rows(project: Path) -> dict[str, bytes]:
    """The rows of each table as text: the bytes of the file tell how it was written."""
    with contextlib.closing(sqlite3.connect(f"file:{project}?mode=ro", uri=True)) as database:
        tables = [name for name, in database.execute(
            "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")]
        return {table: "\n".join(map(repr, database.execute(f"SELECT * FROM {table}"))).encode()
                for table in tables}


def contents(path: Path) -> dict[str, bytes]:
    """What is pinned of a file, by suffix."""
    if path.suffix == ".quadcut":
        tables = rows(path)
        options = tables.pop("options", b"")
        text = b"\n".join(name.encode() + b"\n" + table for name, table in tables.items())
        return {".rows": TIME_OR_VERSION.sub(b"", text), ".options": options}
    text = path.read_bytes()
    if path.suffix == ".png":
        return {path.suffix: text}
    text = TIME_OR_VERSION.sub(b"", text)
    if path.name == "report.json":
        return {path.suffix: OPTIONS.sub(b"", text), ".options": b"".join(OPTIONS.findall(text))}
    return {path.suffix: text}


def hashes(folder: Path) -> dict[str, str]:
    """Of all that is below a folder but `shared` and `input`."""
    found = {}
    for path in folder.rglob("*"):
        name = path.relative_to(folder)
        if path.is_file() and name.parts[0] not in ("shared", "input"):
            for suffix, content in contents(path).items():
                found[name.with_suffix(suffix).as_posix()] = hashlib.sha256(content).hexdigest()[:16]
    return found


# ---- running

def run_program(program: Path, words: tuple[str, ...], folder: Path) -> str:
    run = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, check=False)
    allowed = (0, 1) if words[0] == "locate" else (0,)
    if run.returncode not in allowed:
        said = run.stderr.strip().splitlines() or [""]
        raise CaseFailed(f"`quadcut {' '.join(words)}` exits with {run.returncode}: {said[-1]}")
    return run.stdout


def score_of(case: Case, program: Path, folder: Path) -> str:
    own = folder / "out/score.json"
    text = run_program(program, ("score", *case.truth), folder) if case.truth else (
        own.read_text(encoding="utf-8") if own.exists() else "")
    found = re.search(r'"pq": ([-+.\deE]+)', text)
    return found.group(1) if found else ""


def run_case(case: Case, program: Path, shared: Path) -> Pin:
    """Results do not depend on the number of threads: one half of the cases has one, the other two."""
    threads = ("--threads", f"{1 + zlib.crc32(case.name.encode()) % 2}")
    with tempfile.TemporaryDirectory(prefix="quadcut_pins_") as name:
        folder = Path(name)
        (folder / "shared").symlink_to(shared)
        for number, step in enumerate(case.steps, 1):
            if callable(step):
                step(folder)
                continue
            words = step + (threads if step[0] in ("segment", "follow") else ())
            (folder / f"{number:02}.{step[0]}").write_text(run_program(program, words, folder),
                                                        encoding="utf-8")
        return Pin(hashes(folder), score_of(case, program, folder))


def run_cases(cases: list[Case], program: Path, shared: Path) -> tuple[Pins, dict[str, str]]:
    """What they gave, and why others failed, by name."""
    pins, failed = {}, {}

    def run(case: Case) -> None:
        try:
            pins[case.name] = run_case(case, program, shared)
        except CaseFailed as reason:
            failed[case.name] = str(reason)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(run, sorted(cases, key=lambda case: -case.seconds)))
    return pins, dict(sorted(failed.items()))


# ---- the files of pins: a line a case with its score, and below it a line a file

def read_pins(folder: Path) -> Pins:
    pins = {}
    for path in sorted(folder.glob("*.txt")):
        for line in path.read_text(encoding="utf-8").splitlines():
            words = line.split()
            if line.startswith(" "):
                pin.files[words[0]] = words[1]
            else:
                pin = pins[words[0]] = Pin(score=words[1] if len(words) > 1 else "")
    return pins


def write_pins(folder: Path, pins: Pins) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.glob("*.txt"):
        path.unlink()
    for name, pin in sorted(pins.items()):
        with open(folder / f"{name.split('/')[0]}.txt", "a", encoding="utf-8") as file:
            file.write(f"{name} {pin.score}".rstrip() + "\n")
            file.writelines(f"  {name} {known}\n" for name, known in sorted(pin.files.items()))


# ---- the commands

def choose(groups: dict[str, Group], shared: Path, only: str) -> list[Case]:
    """The cases of these names that can be run here."""
    return [case for group in groups.values() if shared.is_dir() or not group.needs_shared
            for case in group.cases(shared) if re.search(only, case.name)]


def choose_pins(groups: dict[str, Group], shared: Path, only: str, pins: Pins) -> tuple[Pins, Pins]:
    """The pins of these names; and of them those whose cases cannot be run here."""
    chosen = {name: pin for name, pin in pins.items() if re.search(only, name)}
    away = {name for name, group in groups.items() if group.needs_shared and not shared.is_dir()}
    return chosen, {name: pin for name, pin in chosen.items() if name.split("/")[0] in away}


def differing(pinned: Pin, found: Pin) -> list[str]:
    score = [f"score {pinned.score} -> {found.score}"] if pinned.score != found.score else []
    names = sorted(pinned.files.keys() | found.files.keys())
    return score + [name + (" (new)" if name not in pinned.files else
                            " (gone)" if name not in found.files else "")
                    for name in names if pinned.files.get(name) != found.files.get(name)]


def told(lines: dict[str, str]) -> str:
    """A line each, and not too many of them."""
    shown = [f"{name}: {line}" for name, line in list(lines.items())[:MAX_TOLD]]
    return "\n".join(shown + [f"... and {len(lines) - MAX_TOLD} more"] * (len(lines) > MAX_TOLD))


def kinds(differences: dict[str, list[str]]) -> str:
    """Files by name, whatever the folder, and in how many places each differs."""
    counts = Counter(re.sub(r"^score .*", "score", re.sub(r".*/| \(.*", "", one))
                     for what in differences.values() for one in what)
    return ", ".join(f"{kind} {count}" for kind, count in counts.most_common(10))


def tell_differences(differences: dict[str, list[str]], num_cases: int) -> None:
    print(told({name: ", ".join(what[:6] + [f"{len(what) - 6} more"] * (len(what) > 6))
                for name, what in sorted(differences.items(), key=lambda one: (-len(one[1]), one[0]))}))
    print(f"{len(differences)} of {num_cases} cases differ from tests/pins: {kinds(differences)}")
    print("Where that is meant, `tools/pins.py renew` pins what is now, in a commit of its own.")


def check(groups: dict[str, Group], program: Path, shared: Path, folder: Path, only: str) -> int:
    cases = choose(groups, shared, only)
    pinned, away = choose_pins(groups, shared, only, read_pins(folder))
    if away:
        print(f"{len(away)} cases need the maps and logs of {shared}, which is not there: skipped")
        if not cases:
            return SKIPPED
    found, failed = run_cases([case for case in cases if case.name in pinned], program, shared)
    known = {case.name for case in cases}
    failed |= {name: "there is no such case; renew forgets it" for name in sorted(pinned.keys() - away.keys() - known)}
    if known - pinned.keys():
        print(told({name: "not pinned yet" for name in sorted(known - pinned.keys())}))
    differences = {name: what for name, pin in found.items() if (what := differing(pinned[name], pin))}
    if failed:
        print(told(failed))
    if differences:
        tell_differences(differences, len(found))
    elif found and not failed:
        num_files = sum(len(pin.files) for pin in found.values())
        print(f"{len(found)} cases, {num_files} files: as pinned")
    return 0 if found and not failed and not differences else 1


def tell_scores(before: Pins, after: Pins) -> None:
    """Of the cases that gave something else than before, and the means of all sets."""
    def line(name: str, old: str, new: str) -> None:
        print(f"{name:44} {old:>8} {new:>8}")

    def mean(pins: Pins, names: list[str]) -> str:
        scores = [float(pins[name].score) for name in names if name in pins and pins[name].score]
        return f"{statistics.mean(scores):.4f}" if scores else "-"

    line("case", "before", "after")
    for name, pin in sorted(after.items()):
        if before.get(name) != pin:
            line(name, mean(before, [name]), mean(after, [name]))
    sets: dict[str, list[str]] = {}
    for name in sorted(before.keys() | after.keys()):
        sets.setdefault(name.rpartition("/")[0], []).append(name)
    for name, members in sets.items():
        if any(pins[member].score for pins in (before, after) for member in members if member in pins):
            line(f"mean of {name}", mean(before, members), mean(after, members))


def renew(groups: dict[str, Group], program: Path, shared: Path, folder: Path, only: str) -> int:
    before = read_pins(folder)
    chosen, away = choose_pins(groups, shared, only, before)
    if away:
        sys.exit(f"{shared} is not there: nothing is renewed; --only REGEX chooses other cases")
    found, failed = run_cases(choose(groups, shared, only), program, shared)
    if failed:
        sys.exit(told(failed) + "\nnothing is renewed")
    after = {name: pin for name, pin in before.items() if name not in chosen} | found
    write_pins(folder, after)
    tell_scores(before, after)
    changed = {name: what for name, pin in found.items()
               if (what := differing(before.get(name, Pin()), pin))}
    print(f"{len(changed)} of {len(found)} cases are pinned anew, {len(before.keys() - after.keys())} "
          f"are no more. What differs: {kinds(changed) or 'nothing'}")
    return 0


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=("check", "renew"))
    parser.add_argument("--only", default="", metavar="REGEX", help="cases by name")
    parser.add_argument("--program", default=ROOT / "build/release/quadcut", type=Path)
    parser.add_argument("--shared", default=ROOT.parent / "shared", type=Path,
                        help="the folder of maps and logs, unless QUADCUT_SHARED names it")
    options = parser.parse_args()
    shared = Path(os.environ.get("QUADCUT_SHARED", options.shared)).resolve() / "data"
    command = {"check": check, "renew": renew}[options.command]
    return command(GROUPS, options.program.resolve(), shared, ROOT / "tests/pins", options.only)


if __name__ == "__main__":
    sys.exit(main())
