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
        for script in ("extension.js", "program.js", "tests.js", "trees.js"):
            subprocess.run(["node", "--check", FOLDER / script], check=True)

    @unittest.skipUnless(shutil.which("node"), "node is not installed")
    def test_its_trees_show_what_the_server_answers(self):
        code = """
            const module_ = require('module'), load = module_._load;
            module_._load = (name, ...more) => name === 'vscode' ? {} : load(name, ...more);
            const trees = require(process.argv[1]);
            const rule = (name, role) => ({name, role, location: {uri: 'file:///a.soar', range: {start: {line: 3, character: 0}}}});
            const shown = (nodes) => nodes.map((node) => [node.label, ...shown(node.children)]);
            const operators = [{name: '', parents: [], rules: [rule('e', 'elaborates')]}, {name: 'a', parents: ['b'], rules: []},
                               {name: 'b', parents: [], rules: [rule('p', 'proposes')]}, {name: 'c', parents: ['a'], rules: []}];
            const circle = [{name: 'x', parents: ['y'], rules: []}, {name: 'y', parents: ['x'], rules: []}];
            console.log(JSON.stringify([shown(trees.operatorNodes(operators)), shown(trees.operatorNodes(circle)),
                shown(trees.datamapNodes([{name: 'io', detail: '', children: [{name: 'output-link', detail: '', children: []}]}]))]));
        """
        done = subprocess.run(["node", "-e", code, FOLDER / "trees.js"], check=True, capture_output=True, text=True)
        operators, circle, datamap = json.loads(done.stdout)
        self.assertEqual(operators, [["Rules without an operator", ["e"]], ["b", ["p"], ["a", ["c"]]]])
        self.assertEqual(circle, [["x", ["y"]], ["y", ["x"]]])
        self.assertEqual(datamap, [["^io", ["^output-link"]]])

    @unittest.skipUnless(shutil.which("node"), "node is not installed")
    def test_it_finds_the_native_program_first_and_then_the_npm_package(self):
        code = """
            const {findProgram} = require(process.argv[1]), [configured, searched, folder] = process.argv.slice(2);
            console.log(JSON.stringify(findProgram(configured, searched, [folder])));
        """
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            script = folder / "node_modules" / "soarbox" / "soarbox.js"
            script.parent.mkdir(parents=True)
            script.write_text("console.log(process.argv.slice(2).join(' '));")
            (folder / "bin").mkdir()
            (folder / "bin" / "soarbox").write_text("")

            def found(configured, searched):
                done = subprocess.run(["node", "-e", code, FOLDER / "program.js", configured, searched, folder], check=True, capture_output=True, text=True)
                return json.loads(done.stdout)

            self.assertEqual(found("soarbox", str(folder / "bin"))["command"], str(folder / "bin" / "soarbox"))
            self.assertEqual(found("/some/where", str(folder / "bin"))["command"], "/some/where")
            package = found("soarbox", str(folder / "empty"))
            self.assertTrue(package["isPackage"])
            done = subprocess.run([package["command"], *package["args"], "check", "x"], env={**package["env"]}, check=True, capture_output=True, text=True)
            self.assertEqual(done.stdout, "check x\n")
            shutil.rmtree(folder / "node_modules")
            self.assertEqual(found("soarbox", str(folder / "empty")), {"args": [], "env": {}, "isPackage": False, "command": "soarbox"})

    def test_its_page_has_no_link_into_the_source(self):
        # vsce refuses to pack it: it does not know where the source is.
        self.assertEqual(re.findall(r"\]\((?!https?:)", (FOLDER / "README.md").read_text()), [])

    @unittest.skipUnless((FOLDER / "node_modules" / ".bin" / "vsce").exists(), "npm ci has not been called in editors/vscode")
    def test_it_is_packed_without_a_question(self):
        with tempfile.TemporaryDirectory() as name:
            copy = pathlib.Path(name) / "vscode"
            shutil.copytree(FOLDER, copy, symlinks=True)
            done = subprocess.run(["npx", "vsce", "package"], cwd=copy, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300, check=False)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual(len(list(copy.glob("soarbox-*.vsix"))), 1)

    def test_its_views_are_those_that_it_registers(self):
        views = {view["id"] for view in self.contributes["views"]["explorer"]}
        self.assertEqual(views, set(re.findall(r"registerTreeDataProvider\('([^']+)'", (FOLDER / "trees.js").read_text())))
