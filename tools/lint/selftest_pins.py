# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Pins: a changed byte, score, row or file is found; times are not."""

import contextlib
import io
import json
import tempfile
import unittest
from pathlib import Path

import generated  # noqa: F401 (finds tools/)
import pins
from pinned_cases import Case, Group

# Writes what a case writes; what a test changes stands in the file `said`, read anew each time.
PROGRAM = """#!/usr/bin/python3
import json, pathlib, sqlite3, sys
said = json.loads(pathlib.Path("@SAID@").read_text())
if sys.argv[1] == "score":
    print('{"pq": %s}' % said["score"])
    sys.exit(0)
out = pathlib.Path("out")
out.mkdir()
(out / "rooms.png").write_bytes(bytes(said["pixels"]))
(out / "report.json").write_text(json.dumps(said["report"]))
if said["more"]:
    (out / "more.txt").write_text("more")
with sqlite3.connect("project.quadcut") as database:
    database.execute("CREATE TABLE updates(line TEXT)")
    database.execute("INSERT INTO updates VALUES (?)", [json.dumps(said["row"])])
print('{"elapsed_ms": 1.5}')
sys.exit(said["exit"])
"""


class Pinned(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.shared = self.folder / "shared/data"
        self.shared.mkdir(parents=True)
        self.program = self.folder / "program"
        self.program.write_text(PROGRAM.replace("@SAID@", str(self.folder / "said")), encoding="utf-8")
        self.program.chmod(0o755)
        self.say()
        self.renewed()

    def say(self, **changes) -> None:
        said = {"pixels": [1, 2, 3], "row": {"scan": 1, "integrate_ms": 2.5}, "score": 0.75,
                "report": {"num_rooms": 3, "version": "1", "options": {"seed": 1},
                           "stages_ms": {"read": 1.0}}, "more": False, "exit": 0}
        (self.folder / "said").write_text(json.dumps(said | changes), encoding="utf-8")

    def run_command(self, command, name: str = "made/of/nothing", needs_shared: bool = True,
                    only: str = "") -> tuple[int, str]:
        case = Case(name, (("segment", "map.yaml"),), ("out/rooms.png", "true.png"))
        group = Group(lambda _: iter([case]), needs_shared)
        with contextlib.redirect_stdout(io.StringIO()) as told:
            code = command({"made": group}, self.program, self.shared, self.folder / "pins", only)
        return code, told.getvalue()

    def checked(self, **options) -> tuple[int, str]:
        return self.run_command(pins.check, **options)

    def renewed(self, **options) -> str:
        return self.run_command(pins.renew, **options)[1]

    def test_what_is_the_same(self):
        self.assertEqual((0, "1 cases, 6 files: as pinned\n"), self.checked())
        self.assertEqual("made/of/nothing 0.75",
                         (self.folder / "pins/made.txt").read_text(encoding="utf-8").splitlines()[0])

    def test_times_and_the_version_are_no_results(self):
        self.say(row={"scan": 1, "integrate_ms": 3}, report={
            "num_rooms": 3, "version": "2", "options": {"seed": 1}, "stages_ms": {"read": 2e-3, "cut": 1}})
        self.assertEqual(0, self.checked()[0])

    def test_each_difference_is_found(self):
        for said, told in (({"pixels": [1, 2, 4]}, "out/rooms.png"),
                           ({"row": {"scan": 2, "integrate_ms": 2.5}}, "project.rows"),
                           ({"more": True}, "out/more.txt (new)"),
                           ({"report": {}}, "out/report.json, out/report.options"),
                           ({"score": 0.5}, "score 0.75 -> 0.5")):
            self.say(**said)
            code, text = self.checked()
            self.assertEqual(1, code, said)
            self.assertIn(f"made/of/nothing: {told}\n1 of 1 cases differ", text)

    def test_a_file_or_a_case_that_is_no_more(self):
        self.say(more=True)
        self.renewed()
        self.say()
        self.assertIn("out/more.txt (gone)", self.checked()[1])
        code, text = self.checked(name="made/of/air")
        self.assertEqual(1, code)
        self.assertIn("made/of/nothing: there is no such case; renew forgets it\n", text)
        self.assertIn("made/of/air: not pinned yet\n", text)

    def test_nothing_to_compare_is_no_success(self):
        self.assertEqual(1, self.checked(only="^unmade")[0])

    def test_without_maps_and_logs(self):
        self.shared.rmdir()
        self.assertEqual(pins.SKIPPED, self.checked(only="of/nothing")[0])
        self.assertEqual(0, self.checked(needs_shared=False)[0])
        with self.assertRaises(SystemExit):
            self.renewed()

    def test_scores_before_and_after(self):
        self.say(score=0.5)
        text = self.renewed()
        self.assertRegex(text, r"made/of/nothing +0\.7500 +0\.5000\nmean of made/of +0\.7500 +0\.5000\n")
        self.assertEqual(0, self.checked()[0])
        self.assertNotIn("made/of/nothing", self.renewed())

    def test_what_fails_is_not_pinned(self):
        self.say(exit=3)
        code, text = self.checked()
        self.assertEqual(1, code)
        self.assertRegex(text, "made/of/nothing: `quadcut segment .*` exits with 3: \n$")
        with self.assertRaisesRegex(SystemExit, "exits with 3"):
            self.renewed()
        self.say()
        self.assertEqual(0, self.checked()[0])


if __name__ == "__main__":
    unittest.main()
