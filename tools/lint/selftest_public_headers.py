# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""The check of public headers passes a good tree and fails on each way it can be bad."""

import tempfile
import unittest
from pathlib import Path

import layers
import public_headers
from source import SourceFile, Tree

SPDX = "// SPDX-FileCopyrightText: The quadcut developers\n"


def good_tree() -> Tree:
    tree = Tree(Path("."))
    page = ""
    files = {"src/quadcut/map/a.hpp": "", "include/quadcut/segment.hpp": '#include "quadcut/map/a.hpp"\n'}
    for name in layers.PUBLIC:
        files.setdefault(f"include/quadcut/{name}.hpp", "")
        files[f"examples/{name}.cpp"] = SPDX + f"int {name};\n"
        page += (f"`<quadcut/{name}.hpp>`\n<!-- example:{name}.cpp -->\n```cpp\nint {name};\n```\n"
                 f"<!-- /example:{name}.cpp -->\n")
    files[public_headers.PAGE] = page
    tree.files = {path: SourceFile(path, text) for path, text in files.items()}
    return tree


class PublicHeaders(unittest.TestCase):
    def problems_with(self, path: str, text: str | None) -> int:
        tree = good_tree()
        if text is None:
            del tree.files[path]
        else:
            tree.files[path] = SourceFile(path, text)
        return len(public_headers.check(tree, fix=False))

    def test_good(self):
        self.assertEqual([], public_headers.check(good_tree(), fix=False))

    def test_bad(self):
        for path, text in (("include/quadcut/other.hpp", ""), ("include/quadcut/map.hpp", None),
                           ("examples/map.cpp", SPDX + "int other;\n"), ("examples/map.cpp", None)):
            self.assertEqual(1, self.problems_with(path, text), path)
        page = good_tree().files[public_headers.PAGE].text
        self.assertEqual(1, self.problems_with(public_headers.PAGE,
                                               page.replace("`<quadcut/map.hpp>`", "")))

    def test_reach(self):
        tree = good_tree()
        tree.files["src/io/a.hpp"] = SourceFile("src/io/a.hpp", "")
        tree.files["include/quadcut/io.hpp"] = SourceFile("", '#include "io/a.hpp"\n')
        self.assertEqual(1, len(public_headers.check(tree, fix=False)), "not installed")
        tree = good_tree()
        limit = public_headers.MAX_REACHED["segment"]
        for number, problems in ((limit, 0), (limit + 1, 1)):
            names = [f"quadcut/map/h{i}.hpp" for i in range(number)]
            tree.files |= {f"src/{name}": SourceFile("", "") for name in names}
            tree.files["include/quadcut/segment.hpp"] = SourceFile(
                "", "".join(f'#include "{name}"\n' for name in names))
            self.assertEqual(problems, len(public_headers.check(tree, fix=False)), number)

    def test_fix(self):
        with tempfile.TemporaryDirectory() as folder:
            tree = good_tree()
            tree.root = Path(folder)
            (tree.root / "docs").mkdir()
            tree.files["examples/map.cpp"] = SourceFile("", SPDX + "int other;\n")
            self.assertEqual([], public_headers.check(tree, fix=True))
            written = (tree.root / public_headers.PAGE).read_text(encoding="utf-8")
            tree.files[public_headers.PAGE] = SourceFile("", written)
            self.assertIn("int other;", written)
            self.assertEqual([], public_headers.check(tree, fix=False))
