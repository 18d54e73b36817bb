# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""The cases whose results are pinned: what tools/pins.py runs.

A case runs in a folder of its own, where `shared` is the folder of maps and logs; all it writes is
pinned but what is below `input/`. Paths are relative, so that no file says where it was made.
"""

import gzip
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

Step = tuple[str, ...] | Callable[[Path], None]  # words for the program, or what to do in the folder


@dataclass(frozen=True)
class Case:
    name: str  # GROUP/SET/WHAT
    steps: tuple[Step, ...]
    truth: tuple[str, ...] = ()  # what `score` compares: labels, true labels, map
    seconds: float = 1.0  # about how long it takes: the longest run first


@dataclass(frozen=True)
class Group:
    cases: Callable[[Path], Iterator[Case]]  # from the folder of maps and logs
    needs_shared: bool = True


def first_lines(log: str, num_lines: int) -> Step:
    """Makes input/part.log of a log."""
    def make(folder: Path) -> None:
        (folder / "input").mkdir(exist_ok=True)
        opened = gzip.open if log.endswith(".gz") else open
        with opened(folder / log, "rb") as lines, open(folder / "input/part.log", "wb") as part:
            part.writelines(islice(lines, num_lines))
    return make


def with_another_wall(source: str, target: str) -> Step:
    """A copy of a map.pgm with its map.yaml, across the middle of which a wall with a gap runs."""
    def make(folder: Path) -> None:
        (folder / target).mkdir(parents=True)
        pgm = bytearray((folder / source / "map.pgm").read_bytes())
        width, height = map(int, re.search(rb"\n(\d+) (\d+)\n255\n", pgm).groups())
        half = width // 2 - 20
        row = len(pgm) - width * (height - height // 2)
        for start in (row, row + width - half):
            pgm[start:start + half] = bytes(half)
        (folder / target / "map.pgm").write_bytes(pgm)
        (folder / target / "map.yaml").write_bytes((folder / source / "map.yaml").read_bytes())
    return make


# ---- maps

SPARSE = ("intel.log", "mit_csail.log", "aces.log")
# How many lines of the dense ones are followed: some seconds each.
DENSE = {"intel_dense.log.gz": 3000, "aces_dense.log.gz": 3000, "mit_csail_dense.log.gz": 500,
         "mit_killian_dense.log.gz": 1000, "intel_robotlaser.log.gz": 1200}


def stem(path: str | Path) -> str:
    return Path(path).name.split(".")[0]


def maps(shared: Path) -> Iterator[tuple[str, tuple[str, ...], tuple[str, ...]]]:
    """SET/NAME of each map, the words that name it to the program, and its truth if there is one."""
    sets = {"rooms": None, "real": "real", "real/growing": "growing", "maps": "maps", "field": "field"}
    for folder, its_set in sets.items():
        for path in sorted((shared / folder).glob("*.yaml")):
            name = stem(path)
            kind = its_set or ("kth" if name.startswith("kth_") else path.stem.split(".")[1])
            at = f"shared/{folder}"
            truth = ((f"{at}/{name}.rooms.png", f"{at}/{path.stem}.png")
                     if (path.parent / f"{name}.rooms.png").exists() else ())
            yield f"{kind}/{name}", (f"{at}/{path.name}",), truth
    yield "maps/willow_full_stage", ("shared/maps/willow_full_stage.pgm", "--resolution", "0.1"), ()
    for name in ("stage_hospital", "rangelibc_gigantic_map"):
        yield f"maps/{name}", (f"shared/maps/{name}.png", "--resolution", "0.05"), ()
    for log in (*SPARSE, *DENSE):
        yield f"logs/{stem(log)}", (f"shared/logs/{log}",), ()


def segmented(name: str, words: tuple[str, ...], truth: tuple[str, ...], seconds: float) -> Case:
    return Case(name, (("segment", *words, "-o", "out", "--json"),),
                ("out/rooms.png", *truth) if truth else (), seconds)


def in_rooms(shared: Path) -> Iterator[Case]:
    for name, words, truth in maps(shared):
        yield segmented(f"rooms/{name}", words, truth, 10 if "gigantic" in name else 0.2)


def in_paper(shared: Path) -> Iterator[Case]:
    """All of them: the largest has 1.57 million leaves and takes a third of the time."""
    long = {"maps/rangelibc_gigantic_map": 40, "logs/mit_killian_dense": 9}
    for name, words, truth in maps(shared):
        yield segmented(f"paper/{name}", (*words, "--preset", "paper"), truth, long.get(name, 2))


def nested(shared: Path) -> Iterator[Case]:
    for name, words, _ in maps(shared):
        if name.split("/")[0] in ("furnished", "real"):
            yield segmented(f"hierarchy/{name}", (*words, "--hierarchy"), (), 0.3)


def grown(shared: Path) -> Iterator[Case]:
    """Each stage of a map that grows takes ids and names from the one before."""
    stages = [path.stem for path in sorted((shared / "real/growing").glob("*.yaml"))]
    previous = [()] + [("--previous", stage) for stage in stages]
    yield Case("previous/growing/cartesium", tuple(
        ("segment", f"shared/real/growing/{stage}.yaml", "-o", stage, *earlier, "--json")
        for stage, earlier in zip(stages, previous)), (), 4)
    for name in ("lab_ipa", "office_a", "NLB"):
        yield Case(f"previous/furnished/{name}", (
            ("segment", f"shared/rooms/{name}.plain.yaml", "-o", "input", "--json"),
            ("segment", f"shared/rooms/{name}.furnished.yaml", "-o", "out", "--previous", "input",
             "--json")))


# ---- logs

def mapped(_: Path) -> Iterator[Case]:
    for log in (*SPARSE, *DENSE):
        yield Case(f"map/logs/{stem(log)}", (("map", f"shared/logs/{log}", "-o", "out", "--json"),))


def followed(_: Path) -> Iterator[Case]:
    follow = ("follow", "input/part.log", "-o", "out", "--json")
    for log in SPARSE:
        yield Case(f"follow/sparse/{stem(log)}",
                   (("follow", f"shared/logs/{log}", "-o", "out", "--json"),), (), 11)
    for log, num_lines in DENSE.items():
        yield Case(f"follow/dense/{stem(log)}",
                   (first_lines(f"shared/logs/{log}", num_lines), follow), (), 8)
    yield Case("follow/project/intel", (first_lines("shared/logs/intel.log", 300),
                                        (*follow, "--project", "project.quadcut")), (), 3)
    yield Case("follow/fine/aces", (first_lines("shared/logs/aces.log", 150), (
        *follow, "--granularity", "0.8", "--resolution", "0.1", "--every", "50")), (), 3)


# ---- simulated buildings

def simulated(_: Path) -> Iterator[Case]:
    for seed in range(1, 21):
        building = ("simulate", "-o", "building", "--seed", f"{seed}", "--rooms", f"{5 + seed}",
                    "--furniture", f"{seed % 5 / 4}", "--json")
        truth = ("out/rooms.png", "building/rooms.png", "building/map.pgm")
        of_map = ("segment", "building/map.yaml", "-o", "out", "--json")
        yield Case(f"simulated/rooms/{seed:02}", (
            building, of_map,
            ("segment", "building/robot.log", "-o", "of_log", "--json"),
            ("follow", "building/robot.log", "-o", "followed", "--json")), truth, 2 + seed / 10)
        yield Case(f"simulated/paper/{seed:02}", (
            (*building[:2], "input", *building[3:]),
            ("segment", "input/map.yaml", "-o", "out", "--preset", "paper", "--json")),
            ("out/rooms.png", "input/rooms.png", "input/map.pgm"), 2)


    yield from with_options()


def with_options() -> Iterator[Case]:
    """Options that users turn, one building each."""
    options = (("--granularity", "0"), ("--granularity", "1"), ("--door-width", "1"),
               ("--preset", "paper", "--submaps", "6"), ("--preset", "paper", "--set", "seed=2"),
               ("--resolution", "0.1"), ("--poses", "input/true_poses.tum"))
    for seed, words in enumerate(options, 31):
        source = "input/map.yaml" if words[0] not in ("--resolution", "--poses") else "input/robot.log"
        yield Case(f"simulated/options/{seed}", (
            ("simulate", "-o", "input", "--seed", f"{seed}", "--json"),
            ("segment", source, "-o", "out", *words, "--json")))


def demonstrated(_: Path) -> Iterator[Case]:
    for seed in range(1, 5):
        yield Case(f"demo/default/{seed:02}", (
            ("demo", "-o", "out", "--seed", f"{seed}", "--json"),), (), 3)


SMALL_BUILDING = ("simulate", "-o", "input", "--seed", "5", "--rooms", "8", "--json")


def changed(_: Path) -> Iterator[Case]:
    """What is made of a building that people changed, or that was mapped again."""
    project = "project.quadcut"
    edits = (("rename", "5", "Hall"), ("merge", "6", "9"), ("split", "-2.5", "-6", "-2.5", "8"),
             ("lock", "2"), ("rename", "2", "Office"), ("undo",), ("undo",), ("redo",), ("history",))
    looks = (("rooms", project, "--json"), ("locate", project, "9.4", "0.6", "--json"),
             ("locate", project, "90", "0", "--json"), ("export", project, "-o", "exported", "--json"))
    yield Case("project/edits/05", (
        SMALL_BUILDING, ("follow", "input/robot.log", "-o", "out", "--project", project, "--json"),
        *(("edit", project, *edit, "--json") for edit in edits), *looks), (), 2)
    yield Case("project/folder/05", (
        SMALL_BUILDING, ("segment", "input/map.yaml", "-o", "out", "--json"), ("rooms", "out", "--json"),
        ("locate", "out", "9.4", "0.6", "--json"), ("export", "out", "-o", "exported", "--json")))
    yield Case("project/mapped_again/05", (
        SMALL_BUILDING, with_another_wall("input", "input/again"),
        ("segment", "input/map.yaml", "-o", "out", "--json"),
        ("segment", "input/again/map.yaml", "-o", "again", "--previous", "out", "--hierarchy", "--json"),
        ("segment", "input/again/map.yaml", "-o", "again", "--previous", "again", "--set",
         "preset=paper", "--json")), (), 2)
    yield Case("project/paper/05", (
        SMALL_BUILDING, first_lines("input/robot.log", 120),
        ("follow", "input/part.log", "-o", "out", "--set", "preset=paper", "--json")), (), 4)


GROUPS = {
    "rooms": Group(in_rooms),
    "paper": Group(in_paper),
    "hierarchy": Group(nested),
    "previous": Group(grown),
    "map": Group(mapped),
    "follow": Group(followed),
    "simulated": Group(simulated, needs_shared=False),
    "demo": Group(demonstrated, needs_shared=False),
    "project": Group(changed, needs_shared=False),
}
