# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""The check of fuzz targets passes a good tree and fails on each way it can be bad."""

import unittest
from pathlib import Path

import fuzz_targets
from source import SourceFile, Tree

FILES = {
    fuzz_targets.TABLE: "| `parse_a` in `src/io/a.hpp` | `a` |\n| `Project::open` in `src/project/p.hpp` | `p` |\n",
    "tests/fuzz/fuzz_a.cpp": "int f() { parse_a(b); }\n",
    "tests/fuzz/fuzz_p.cpp": "int f() { Project::open(b); }\n",
    "src/io/a.hpp": "[[nodiscard]] A parse_a(std::string_view bytes);\nA read_a(const Path& path);\n"
                    "std::optional<B> parse_b(std::string_view bytes);\nC& parse_c(int x);\n",
    "src/io/a.cpp": "constexpr std::array kAll{parse_c};\nA parse_a(std::string_view bytes) {\n    parse_b(bytes);\n"
                    "}\nA read_a(const Path& path) {\n    parse_a(path);\n    parse_d(path);\n}\n",
    "src/project/p.hpp": "class Project {\n    static Project open(const Path& path);\n};\n",
}


class FuzzTargets(unittest.TestCase):
    def problems_with(self, path: str, old: str, new: str) -> int:
        files = dict(FILES)
        self.assertIn(old, files.get(path, ""))
        files[path] = files.get(path, "").replace(old, new) if old else new
        return self.problems(files)

    def problems(self, files: dict[str, str]) -> int:
        tree = Tree(Path("."), {path: SourceFile(path, text) for path, text in files.items()})
        return len(fuzz_targets.check(tree))

    def test_good(self):
        self.assertEqual(0, self.problems(FILES))

    def test_no_table(self):
        self.assertEqual(1, self.problems({}))

    def test_row_of_nothing(self):
        self.assertEqual(1, self.problems_with("tests/fuzz/fuzz_a.cpp", "parse_a", "parse_b"))
        for row in ("| `parse_a` in `src/io/a.hpp` | `x` |\n", "| `parse_a` in `src/io/b.hpp` | `a` |\n"):
            table = FILES[fuzz_targets.TABLE] + row
            self.assertEqual(1, self.problems_with(fuzz_targets.TABLE, "", table), row)

    def test_target_without_a_row(self):
        self.assertEqual(1, self.problems_with("tests/fuzz/fuzz_x.cpp", "", "int f();\n"))

    def test_reader_without_a_row(self):
        # What only a reader of files calls is reached by no target.
        self.assertEqual(1, self.problems_with("src/io/d.hpp", "", "D parse_d(const Path& path);\n"))
        self.assertEqual(1, self.problems_with("src/io/a.cpp", "parse_b(", "("))
        self.assertEqual(1, self.problems_with("src/io/a.cpp", "{parse_c}", "{}"))
        self.assertEqual(1, self.problems_with("src/project/p.hpp", "    static",
                                               "    static Project open_new(int x);\n    static"))
