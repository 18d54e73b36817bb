# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Each check passes a good tree and fails on each way a tree can be bad."""

import tempfile
import unittest
from pathlib import Path

import budgets
import equations
import generated
import layers
import names
import selftest_fuzz_targets
import selftest_pins
import selftest_public_headers
import selftest_results
from source import SourceFile, Tree

SPDX = f"// {names.LICENCE}\n// {names.COPYRIGHT}\n"


def tree_of(**files: str) -> Tree:
    """A tree from path = text; in paths, __ stands for / and the suffix follows the last _."""
    tree = Tree(Path("."))
    for name, text in files.items():
        path = ".".join(name.replace("__", "/").rsplit("_", 1))
        tree.files[path] = SourceFile(path, text)
    return tree


class Source(unittest.TestCase):
    def test_code_has_no_comments_and_no_literals(self):
        file = SourceFile("a.cpp", 'int a = 1\'000; // new\n/* new\n */ auto b = "new \\" new";\n'
                                   'auto c = R"x(new " new)x"; char d = \'"\'; int e; // new\n')
        self.assertNotIn("new", file.code)
        self.assertEqual(file.code.count("\n"), file.text.count("\n"))
        self.assertIn("int e;", file.code)
        self.assertEqual(file.num_code_lines(), 3)

    def test_includes(self):
        file = SourceFile("a.cpp", '#include "x/y.hpp"\n#include <map>\n// #include "z.hpp"\n')
        self.assertEqual([(i.line, i.target, i.system) for i in file.includes()],
                         [(1, "x/y.hpp", False), (2, "map", True)])

    def lengths(self, text: str) -> list[tuple[int, int]]:
        return [(f.line, f.num_lines) for f in SourceFile("a.cpp", text).functions()]

    def test_functions(self):
        self.assertEqual(self.lengths("namespace a {\nint f(int x) {\n  if (x) {\n  }\n}\n}\n"),
                         [(2, 4)])
        self.assertEqual(self.lengths("struct A {\n  int x = 0;\n  std::array<int, 3> y{};\n"
                                      "  int f() const {\n    return x;\n  }\n};\n"), [(4, 3)])
        self.assertEqual(self.lengths("A::A(int x)\n    : x_{x}, y_(f({1})) {\n  g();\n}\n"), [(1, 4)])
        self.assertEqual(self.lengths("template <class T>\n    requires(sizeof(T) > 1)\nvoid f() {\n}\n"),
                         [(1, 4)])
        self.assertEqual(self.lengths("#define A {\nenum class E : int { a, b };\nint g();\n"
                                      "const std::vector<int> v = {1, 2};\n"), [])
        self.assertEqual(self.lengths("auto f = [](int x) {\n  return x;\n};\n"
                                      "auto g() -> int {\n}\n"), [(1, 3), (4, 2)])


class Layers(unittest.TestCase):
    def test_good(self):
        self.assertEqual(layers.check(tree_of(
            src__quadcut__base__a_hpp="#include <vector>\n",
            src__quadcut__map__a_hpp='#include "quadcut/base/a.hpp"\n',
            src__io__a_cpp='#include <png.h>\n#include "quadcut/map/a.hpp"\n',
            include__quadcut__segment_hpp='#include "quadcut/map/a.hpp"\n',
            apps__main_cpp='#include "apps/b.hpp"\n', apps__b_hpp="")), [])

    def test_upward(self):
        for path, target in (("src__quadcut__base__b_cpp", "quadcut/segment/a.hpp"),
                             ("src__quadcut__spectral__b_cpp", "quadcut/map/a.hpp"),
                             ("src__quadcut__segment__b_cpp", "io/a.hpp"),
                             ("src__quadcut__rooms__b_cpp", "quadcut/segment/a.hpp"),
                             ("include__quadcut__map_hpp", "quadcut/segment/a.hpp"),
                             ("src__quadcut__map__b_cpp", "quadcut/segment.hpp"),
                             ("src__io__b_cpp", "sim/a.hpp"), ("src__sim__b_cpp", "apps/a.hpp")):
            with self.subTest(path):
                self.assertEqual(1, len(layers.check(tree_of(**{
                    path: f'#include "{target}"\n', "src__quadcut__segment__a_hpp": "",
                    "include__quadcut__segment_hpp": "",
                    "src__quadcut__map__a_hpp": "", "src__io__a_hpp": "", "src__sim__a_hpp": "",
                    "apps__a_hpp": ""}))))

    def test_heavy_header(self):
        for target in ("Eigen/Dense", "png.h", "nlohmann/json.hpp"):
            self.assertEqual(1, len(layers.check(tree_of(src__io__a_hpp=f"#include <{target}>\n"))))

    def test_not_from_src(self):
        self.assertEqual(1, len(layers.check(tree_of(
            src__io__a_cpp='#include "b.hpp"\n', src__io__b_hpp=""))))

    def test_cycle(self):
        self.assertEqual(1, len(layers.check(tree_of(
            src__io__a_hpp='#include "io/b.hpp"\n', src__io__b_hpp='#include "io/a.hpp"\n'))))

    def test_unknown_folder(self):
        self.assertEqual(1, len(layers.check(tree_of(src__quadcut__new__a_hpp=""))))


class Budgets(unittest.TestCase):
    def check_files(self, **files: str) -> list[str]:
        return budgets.check_files(tree_of(**files))

    def test_good(self):
        self.assertEqual(self.check_files(
            src__io__a_cpp="int f() {\n" + "    f();\n" * 58 + "}\n"
            "// new\n#include <new>\n#define A 1\n"), [])

    def test_bad(self):
        for text in ("int f() {\n" + "    f();\n" * 59 + "}\n", "\n" * 401, "#define A(x) x\n",
                     "auto* a = new int;\n"):
            self.assertEqual(1, len(self.check_files(src__io__a_cpp=text)), text[:40])

    def test_wings(self):
        limits = budgets.MAX_LINES
        budgets.MAX_LINES = {"rooms": 400, "paper": 0, "live": 100}
        try:
            files = {"src__quadcut__map__a_cpp": "int a;\n" * 380,
                     "src__quadcut__follow__a_cpp": "int a;\n" * 100}
            self.assertEqual([], budgets.check_wings(tree_of(**files)))
            for path in ("src__quadcut__base__a_cpp", "src__quadcut__paper__a_cpp"):
                more = {**files, path: "int a;\n" * 21}
                self.assertEqual(1, len(budgets.check_wings(tree_of(**more))), path)
            files["src__quadcut__map__a_cpp"] = "int a;\n" * 374 + "// a\n\n"
            self.assertEqual(1, len(budgets.check_wings(tree_of(**files))), "the ratchet")
        finally:
            budgets.MAX_LINES = limits


class Names(unittest.TestCase):
    def test_good(self):
        self.assertEqual(names.check(tree_of(src__io__pgm_cpp=SPDX,
                                             src__io__pgm_hpp=SPDX + "#pragma once\n")), [])

    def test_bad(self):
        later = "// TO" "DO\n"
        for path, text in (("src__io__a_cpp", ""), ("src__io__a_cpp", "\n" + SPDX),
                           ("src__io__a_cpp", SPDX + later), ("src__io__utils_cpp", SPDX),
                           ("src__common__a_cpp", SPDX), ("src__io__Grid_cpp", SPDX),
                           ("src__io__a_hpp", SPDX), ("tools__a_py", "")):
            self.assertEqual(1, len(names.check(tree_of(**{path: text}))), path + text)


class Equations(unittest.TestCase):
    TABLE = "| equation | function | test |\n|---|---|---|\n"
    ROW = "| (3) threshold | `threshold` in `src/quadcut/graph/a.cpp` | `Sight.Threshold` |\n"
    CODE = "double threshold() {\n    // Eq. (3): Th\n}\n"
    TEST = "TEST(Sight, Threshold) {\n}\n"

    def check(self, code: str, table: str | None, test: str = TEST) -> int:
        files = {"src__quadcut__graph__a_cpp": code, "tests__unit__graph__a_cpp": test}
        if table is not None:
            files["docs__equations_md"] = table
        return len(equations.check(tree_of(**files)))

    def test_good(self):
        self.assertEqual(0, self.check(self.CODE, self.TABLE + self.ROW))
        self.assertEqual(0, self.check("int a;\n", None))

    def test_bad(self):
        self.assertEqual(1, self.check(self.CODE, None))
        self.assertEqual(1, self.check(self.CODE, self.TABLE))
        self.assertEqual(1, self.check("double threshold() {}\n", self.TABLE + self.ROW))
        self.assertEqual(1, self.check("int f() {\n    // Eq. (3): Th\n}\n", self.TABLE + self.ROW))
        self.assertEqual(1, self.check(self.CODE, self.TABLE + self.ROW, "TEST(Sight, Other) {}"))
        self.assertEqual(1, self.check(self.CODE, self.TABLE + self.ROW.replace("a.cpp", "b.cpp")))
        self.assertEqual(1, self.check(self.CODE + "// Eqs. 4 and 5\n", self.TABLE + self.ROW))
        for cell in ("`threshold` in `src/quadcut/graph/a.cpp`", "`Sight.Threshold`"):
            self.assertEqual(1, self.check(self.CODE, self.TABLE + self.ROW.replace(cell, "-")))


class Generated(unittest.TestCase):
    def test_out_of_date(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "docs").mkdir()
            echo = Path("/bin/echo")
            self.assertEqual(1, len(generated.check(root, echo, fix=False)))
            self.assertEqual([], generated.check(root, echo, fix=True))
            self.assertEqual([], generated.check(root, echo, fix=False))
            (root / "docs/options.md").write_text("old\n", encoding="utf-8")
            self.assertEqual(1, len(generated.check(root, echo, fix=False)))
            self.assertEqual(1, len(generated.check(root, Path("/bin/false"), fix=False)))


def run() -> list[str]:
    """What fails, one text each."""
    load = unittest.defaultTestLoader.loadTestsFromModule
    modules = (__import__(__name__), selftest_fuzz_targets, selftest_pins, selftest_public_headers,
               selftest_results)
    suite = unittest.TestSuite([load(module) for module in modules])
    result = unittest.TestResult()
    suite.run(result)
    return [f"{test}: {trace.strip()}" for test, trace in result.failures + result.errors]


if __name__ == "__main__":
    unittest.main()
