# SPDX-License-Identifier: BSD-2-Clause
"""Projects of VisualSoar, in both of their formats, with `soarbox check`, `run` and `datamap`, and in the language server."""
import json
import unittest

from editor_client import Editor
from soarbox_command import Run, new_folder

RULES = """sp {propose*open
   (state <s> ^superstate nil ^kind door ^io.input-link <in>)
   (<in> ^lok closed)
-->
   (<s> ^operator <o> +)
   (<o> ^name open)
}

sp {apply*open
   (state <s> ^operator.name open)
-->
   (<s> ^opened yes)
}
"""
DATAMAP = """11
SOAR_ID 0
ENUMERATION 1 1 nil
SOAR_ID 2
SOAR_ID 3
ENUMERATION 4 2 open closed
ENUMERATION 5 2 door gate
SOAR_ID 6
ENUMERATION 7 1 open
ENUMERATION 8 1 yes
SOAR_ID 9
STRING 10
9
0 superstate 1
0 io 2
2 input-link 3
2 output-link 9
3 lock 4
0 kind 5
0 operator 6
6 name 7
0 opened 8
"""
LAYOUT = "VERSION 4\n/door/door.dm\n0\tROOT door door 1\n1\t0\tFOLDER all all 2\n2\t1\tOPERATOR open open.soar 3\nEND\n"


class Projects(unittest.TestCase):
    def setUp(self):
        self.folder = new_folder(self)
        self.write("door.soar", "pushd door\nsource door_source.soar\npopd\n")
        self.write("door/door_source.soar", "pushd all\nsource open.soar\npopd\n")
        self.write("door/comment.dm", "0\n" * 9)
        self.write("door/door.dm", DATAMAP)
        self.rules = self.write("door/all/open.soar", RULES)
        self.text = self.write("door.vsa", LAYOUT)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def of_datamap(self, path):
        problems = [json.loads(line) for line in Run("check", "--json", path).out.splitlines()]
        return [(one["line"], one["message"], one.get("hint")) for one in problems if "datamap" in one["message"]]

    def test_check_tells_what_the_datamap_does_not_know_and_what_was_meant(self):
        expected = [(3, "the datamap has no attribute ^lok of ^io.input-link", "did you mean lock?")]
        self.assertEqual(expected, self.of_datamap(self.text))
        self.assertEqual(expected, self.of_datamap(self.rules))
        self.rules.write_text(RULES.replace("lok closed", "lock shut"))
        self.assertEqual([(3, "the datamap has no value shut for ^lock")], [one[:2] for one in self.of_datamap(self.text)])
        self.rules.write_text(RULES.replace("^lok", "^lock"))
        self.assertEqual([], self.of_datamap(self.text))

    def test_projects_of_windows_and_choices_of_attributes(self):
        self.text.write_text(LAYOUT.replace("/door/door.dm", "\\door\\door.dm").replace("\n", "\r\n"))
        self.assertEqual(["did you mean lock?"], [one[2] for one in self.of_datamap(self.text)])
        self.rules.write_text(RULES.replace("(<in> ^lok closed)", "(<in> ^{ << lock loc >> <way> } closed)"))
        self.assertEqual([(3, "the datamap has no attribute ^loc of ^io.input-link")], [one[:2] for one in self.of_datamap(self.text)])

    def test_run_takes_a_project_of_either_format(self):
        self.rules.write_text(RULES.replace("^kind door ", "").replace("(<in> ^lok closed)", "(<in> ^time > 0)"))
        self.write("door2.vsa.json", json.dumps({"version": "6", "layout": {"type": "OPERATOR_ROOT", "folder": "door", "children": []}}))
        self.write("door2.soar", "source door.soar\n")
        for project in ("door.vsa", "door2.vsa.json"):
            run = Run("run", self.folder / project, "--headless", "--seconds", 1, code=0)
            self.assertIn("1 of them Soar", run.out + run.err)

    def test_what_datamap_writes_knows_the_rules_and_the_world(self):
        self.text.unlink()
        written = self.folder / "door.vsa.json"
        self.assertEqual(0, Run("datamap", self.folder / "door.soar", "-o", written).code)
        project = json.loads(written.read_text())
        self.assertEqual("6", project["version"])
        names = {edge["name"] for vertex in project["datamap"]["vertices"] for edge in vertex.get("outEdges", [])}
        self.assertTrue({"input-link", "waypoint", "bearing", "move-to", "opened", "lok"} <= names)
        self.assertIn("door/all/open.soar", [one["file"] for one in project["layout"]["children"]])
        self.assertEqual([], self.of_datamap(written))
        self.rules.write_text(RULES.replace("^opened yes", "^opend yes"))
        self.assertEqual([], self.of_datamap(self.folder / "door.soar"))
        self.assertIn("did you mean opened?", [one[2] for one in self.of_datamap(self.rules)])

    def test_the_language_server_knows_the_datamap(self):
        editor = Editor()
        self.addCleanup(editor.channel.close)
        uri = editor.open(self.rules)
        told = editor.wait_for(uri, lambda found: any("datamap" in one["message"] for one in found))
        problem = next(one for one in told if "datamap" in one["message"])
        self.assertEqual({"line": 2, "character": 10}, problem["range"]["start"])
        self.assertEqual(0, editor.end())

    def test_damaged_projects_are_told_with_their_line(self):
        self.text.write_text(LAYOUT.replace("1\t0\tFOLDER all all 2", "1 FOLDER"))
        for command in (("check",), ("run", "--headless")):
            run = Run(command[0], self.text, *command[1:])
            self.assertNotEqual(0, run.code)
            self.assertIn("door.vsa:4: error: expected a node of the layout", run.out + run.err)
        self.text.write_bytes(b"\x00\xff" * 50)
        run = Run("check", self.text)
        self.assertEqual("%s: error: this is not a text file: line 1 holds a zero byte\n1 error, 0 warnings\n" % self.text, run.out)
        self.assertEqual(1, run.code)

    def test_a_project_that_lies_above_by_chance_is_none_of_ours(self):
        stranger = self.write("elsewhere/scout.soar", RULES.replace("^lok", "^look"))
        self.assertNotIn("datamap", Run("check", stranger).out)
        self.text.write_bytes(b"\x00" * 50)
        self.assertNotIn("door.vsa", Run("check", stranger).out)
