#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""The library as a stranger meets it: installed, found, compiled against; or as a folder of his own.

  tests/install/install_test.py Install|Programs|Refusals|Subdirectory|OnlyCore SOURCE BUILD

`Install` installs BUILD into BUILD/install_test/prefix, the others use that.
"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

SOURCE, BUILD = (Path(argument).resolve() for argument in sys.argv[2:])
SCRATCH = BUILD / "install_test"
PREFIX = SCRATCH / "prefix"
# What only the libraries' own sources may include.
PRIVATE_HEADERS = re.compile(r"/(Eigen|tbb|oneapi|nlohmann|stb)/|/(sqlite3|png|zlib|tiff|jpeglib|yaml)\.h$")
IO_PACKAGES = ("PNG", "ZLIB", "TIFF", "JPEG", "LibYaml", "PkgConfig", "nlohmann_json")
DISABLED = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in (*IO_PACKAGES, "SQLite3")]
DEBUG = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O0 -Wall -Wextra -Werror"]


def run(*command, cwd=None) -> str:
    done = subprocess.run([str(word) for word in command], cwd=cwd, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} failed:\n{done.stdout}")
    return done.stdout


def require(is_so: bool, what: str) -> None:
    if not is_so:
        sys.exit(what)


def fresh(name: str) -> Path:
    folder = SCRATCH / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def require_printed(program: Path) -> None:
    """The program first prints the line that its source says at the end, if it does."""
    source = (SOURCE / "examples" / f"{program.name}.cpp").read_text(encoding="utf-8")
    printed = run(program, cwd=program.parent).splitlines()[:1]
    said = re.findall(r"^// Prints: (.*)$", source, re.MULTILINE)
    require(printed != [] and said in ([], printed), f"{program.name} prints: {printed}")


def install() -> None:
    fresh("prefix")
    run("cmake", "--install", BUILD, "--prefix", PREFIX)
    require("quadcut 0." in run(PREFIX / "bin/quadcut", "version"), "no program is installed")


def programs() -> None:
    """All of docs/api.md, from a copy of examples/ that knows the prefix and nothing else."""
    folder = fresh("stranger")
    shutil.copytree(SOURCE / "examples", folder / "examples")
    with open(folder / "examples/CMakeLists.txt", "a", encoding="utf-8") as lists:
        lists.write("add_library(plugin MODULE project.cpp)\n"
                    "target_link_libraries(plugin PRIVATE quadcut::project)\n"
                    "target_link_options(plugin PRIVATE -Wl,-z,text)\n")
    build = folder / "build"
    run("cmake", "-S", folder / "examples", "-B", build, *DEBUG, f"-DCMAKE_PREFIX_PATH={PREFIX}")
    run("cmake", "--build", build)
    headers = set(re.findall(r"^    (\S+)$", run("ninja", "-C", build, "-t", "deps"), re.MULTILINE))
    ours = [name for name in headers if "quadcut/" in name and name.endswith(".hpp")]
    require(len(ours) > 20, f"only {len(ours)} headers of quadcut are seen")
    for name in headers:
        require(not PRIVATE_HEADERS.search(name), f"a program includes {name}")
    for name in ours:
        require(Path(name).is_relative_to(PREFIX / "include/quadcut"), f"{name} is not installed")

    sources = sorted(path.stem for path in (SOURCE / "examples").glob("*.cpp"))
    for name in sources:
        if name != "io":
            require_printed(build / name)
    run(PREFIX / "bin/quadcut", "simulate", "-o", folder / "sim")
    require("m2" in run(build / "io", folder / "sim/map.yaml", folder / "rooms"), "io finds no room")
    require((folder / "rooms/rooms.geojson").is_file(), "io writes no rooms")


def refusal_of(name: str, request: str, *options: str) -> str:
    """What CMake says to a project that asks for a package it cannot have; empty if it can."""
    folder = fresh(f"refused/{name}")
    (folder / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\n"
                                           "project(stranger LANGUAGES CXX)\n"
                                           f"find_package(quadcut {request} REQUIRED)\n",
                                           encoding="utf-8")
    done = subprocess.run(["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", *options],
                          capture_output=True, text=True, check=False)
    return " ".join(done.stderr.split()) if done.returncode != 0 else ""


def require_refused(name: str, request: str, why: str, *options: str) -> None:
    said = refusal_of(name, request, *options)
    require(why in said, f"find_package(quadcut {request}) says '{said}', not '{why}'")


def refusals() -> None:
    here = f"-DCMAKE_PREFIX_PATH={PREFIX}"
    require_refused("component", "COMPONENTS kitchen",
                    "no component 'kitchen' is installed; there are: core, io, project", here)
    require_refused("newer", "0.3 COMPONENTS core", "version: 0.", here)
    require_refused("older", "0.1 COMPONENTS core", "version: 0.", here)
    require_refused("png", "0.2 COMPONENTS io", "PNG", here, "-DCMAKE_DISABLE_FIND_PACKAGE_PNG=ON")
    said = refusal_of("core", "0.2 COMPONENTS core", here, *DISABLED)
    require(said == "", f"the core needs more than threads: {said}")


def project_around(folder: Path, target: str, add_quadcut: str) -> None:
    """A project that has quadcut as a folder, and the program of docs/api.md for a target of it."""
    name = {"core": "segment"}.get(target, target)
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.25)\n"
        "project(stranger LANGUAGES CXX)\n"
        f"{add_quadcut}\n"
        f"add_executable({name} {SOURCE}/examples/{name}.cpp)\n"
        f"target_link_libraries({name} PRIVATE quadcut::{target})\n", encoding="utf-8")


def subdirectory() -> None:
    """As a folder of another project: what that asks for, no tests, no installation, no -Werror."""
    folder = fresh("subdirectory")
    project_around(folder, "project", f"add_subdirectory({SOURCE} quadcut EXCLUDE_FROM_ALL)")
    build = folder / "build"
    run("cmake", "-S", folder, "-B", build, "-G", "Ninja")
    require("Total Tests: 0" in run("ctest", "-N", "--test-dir", build), "tests for a stranger")
    steps = run("ninja", "-C", build, "-t", "commands", "all")
    require("sqlite3" in steps and "libquadcut_project.a" in steps, "quadcut::project is not built")
    require("-Werror" not in steps and "/apps/" not in steps, "more than a stranger asked for")
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    require("QUADCUT_INSTALL:BOOL=OFF" in cache, "an installation for a stranger")


def only_core() -> None:
    """With nothing but the core, which is then installed, too."""
    folder = fresh("only_core")
    project_around(folder, "core", f"add_subdirectory({SOURCE} quadcut)")
    build = folder / "build"
    run("cmake", "-S", folder, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
        "-DQUADCUT_ONLY_CORE=ON", "-DQUADCUT_INSTALL=ON", *DISABLED)
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    found = re.search(r"^(PNG|ZLIB|TIFF|JPEG|LibYaml|SQLite|STB|QUADCUT_LABEL|OPENCL|GTest|Pkg|PKG)\w*"
                      r"(?<!DISABLE_FIND_PACKAGE):", cache, re.MULTILINE)
    require(found is None, f"the core looks for {found and found.group()}")
    run("cmake", "--build", build)
    require_printed(build / "segment")

    prefix = folder / "prefix"
    run("cmake", "--install", build, "--prefix", prefix)
    headers = {path.name for path in (prefix / "include/quadcut").glob("*.hpp")}
    require("segment.hpp" in headers and not headers & {"io.hpp", "project.hpp"}, f"{headers}")
    require_refused("only_core", "COMPONENTS io",
                    "no component 'io' is installed; there are: core", f"-DCMAKE_PREFIX_PATH={prefix}")


{"Install": install, "Programs": programs, "Refusals": refusals, "Subdirectory": subdirectory,
 "OnlyCore": only_core}[sys.argv[1]]()
