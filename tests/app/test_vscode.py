# SPDX-License-Identifier: BSD-2-Clause
"""The manifest of the extension for VS Code is correct: its files exist, and its patterns match the command's output."""
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from soarbox_command import Run

FOLDER = pathlib.Path(__file__).resolve().parent.parent.parent / "editors" / "vscode"


class Extension(unittest.TestCase):
    def setUp(self):
        self.package = json.loads((FOLDER / "package.json").read_text())
        self.contributes = self.package["contributes"]

    def test_all_files_that_it_names_are_there_and_are_json(self):
        self.assertTrue((FOLDER / self.package["main"]).is_file())
        for one in (*self.contributes["languages"], *self.contributes["grammars"]):
            for name in (one.get("configuration"), one.get("path")):
                if name:
                    json.loads((FOLDER / name).read_text())

    def test_its_lock_names_no_place_to_load_from(self):
        self.assertNotIn("resolved", (FOLDER / "package-lock.json").read_text())

    def test_the_problem_matcher_reads_what_check_prints(self):
        with tempfile.TemporaryDirectory() as name:
            rules = pathlib.Path(name) / "a.soar"
            rules.write_text("sp {a (state <s> ^superstate nil) --> (<x> ^y z)}\n")
            printed = Run("check", rules).out
        pattern = self.contributes["problemMatchers"][0]["pattern"]
        found = re.search(pattern["regexp"], printed, re.MULTILINE)
        self.assertIsNotNone(found, printed)
        self.assertEqual((str(rules), "1", "error"), (found[pattern["file"]], found[pattern["line"]], found[pattern["severity"]]))

    def test_its_commands_are_those_that_it_registers(self):
        script = (FOLDER / "extension.js").read_text()
        self.assertEqual({one["command"] for one in self.contributes["commands"]}, set(re.findall(r"register\('([^']+)'", script)))
        actions = self.contributes["taskDefinitions"][0]["properties"]["action"]["enum"]
        for action in actions:
            self.assertEqual(0, Run(action, "--help").code, action)

    def test_its_grammar_knows_a_rule(self):
        grammar = json.loads((FOLDER / "syntaxes" / "soar.tmLanguage.json").read_text())
        begin = next(one["begin"] for one in grammar["patterns"] if "begin" in one)
        self.assertEqual("go*west", re.match(begin, "sp {go*west").group(3))
        attribute = next(one["match"] for one in grammar["repository"]["rule"]["patterns"] if one.get("name", "").startswith("entity.other"))
        self.assertEqual("-^io.input-link.<a>.|two words|", re.search(attribute, "(<s> -^io.input-link.<a>.|two words| 3)").group())

    @unittest.skipUnless(shutil.which("node"), "node is not installed")
    def test_its_scripts_are_sound(self):
        for script in ("extension.js", "tests.js"):
            subprocess.run(["node", "--check", FOLDER / script], check=True)
