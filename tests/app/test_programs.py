# SPDX-License-Identifier: BSD-2-Clause
"""Which files of rules belong together: `soarbox check` and `soarbox lsp` on programs of several files and folders."""
import json
import unittest

from editor_client import Editor, applied, at
from soarbox_command import Run, new_folder

PROPOSE = "sp {propose*%s (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name %s)}\n"
APPLY = "sp {apply*%s (state <s> ^operator.name %s) --> (<s> ^done-%s yes)}\n"
SHARED = "sp {x*y (state <s> ^superstate nil) --> (<s> ^y 1)}\n"


def propose(name):
    return PROPOSE % (name, name)


def apply(name):
    return APPLY % (name, name, name)


class Programs(unittest.TestCase):
    def setUp(self):
        self.folder = new_folder(self)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def check(self, *names):
        lines = Run("check", "--json", *names, cwd=self.folder).out.splitlines()
        return [(one["file"], one["line"], one["message"]) for one in map(json.loads, lines)]

    def editor(self, folders=None):
        editor = Editor(folders=folders)
        self.addCleanup(editor.channel.close)
        return editor


class Check(Programs):
    def test_a_program_may_climb_out_of_its_folder(self):
        self.write("p/shared.soar", SHARED)
        self.write("p/more/one.soar", apply("go"))
        self.write("p/a/cd.soar", "cd ..\nsource shared.soar\n" + propose("go") + "pushd more\nsource one.soar\npopd\n")
        self.write("p/a/pushd.soar", "pushd ../more\nsource one.soar\npopd\nsource ../shared.soar\n" + propose("go"))
        for name in ("p/a/cd.soar", "p/a/pushd.soar", self.folder / "p/a/cd.soar", "p/shared.soar", "p/more/one.soar"):
            self.assertEqual([], self.check(name), name)

    def test_a_scenario_s_rules_stay_in_its_folder(self):
        secret = self.write("secret.soar", "no rule at all: 4711\n")
        self.write("world/scenario.toml", '[[agent]]\nname = "hero"\nrules = "hero.soar"\n')
        for line in ("source ../secret.soar", f"source {secret}", "cd ..\nsource secret.soar"):
            rules = self.write("world/hero.soar", line + "\n" + SHARED)
            for named in (rules, self.folder / "world"):
                run = Run("check", named, code=1)
                self.assertNotIn("4711", run.out)
        # A file in the parent folder that sources the scenario's rules gives them no additional permissions.
        self.write("top.soar", "source world/hero.soar\n")
        self.assertNotIn("4711", Run("check", self.folder / "world/hero.soar", code=1).out)

    def test_slips_are_told_in_the_files_that_have_them(self):
        self.write("one.soar", "source top.soar\n")
        self.write("top.soar", "\n" + propose("walk"))
        told = self.check("one.soar")
        self.assertEqual([("top.soar", 2)], [(file.split("/")[-1], line) for file, line, _ in told], told)
        self.assertIn("walk", told[0][2])
        # The same result if only that file is checked.
        self.assertEqual([told[0][1:]], [one[1:] for one in self.check("top.soar")])

    def test_what_another_file_completes_is_no_slip(self):
        self.write("main.soar", "source top.soar\npushd sub\nsource sub_source.soar\npopd\n")
        self.write("top.soar", propose("walk"))
        self.write("sub/sub_source.soar", "source a.soar\n")
        self.write("sub/a.soar", apply("walk"))
        for name in ("main.soar", "top.soar", "sub/a.soar", "sub/sub_source.soar", "."):
            self.assertEqual([], self.check(name), name)
        # Each file reports its own problems.
        self.write("sub/a.soar", apply("walk") + propose("stay"))
        self.assertEqual([], self.check("top.soar"))
        for name in ("main.soar", "sub/a.soar", "."):
            self.assertEqual(["a.soar"], [file.split("/")[-1] for file, _, _ in self.check(name)], name)

    def test_a_file_of_two_programs_has_the_slips_that_both_have(self):
        self.write("one.soar", "source shared.soar\n" + apply("walk"))
        self.write("two.soar", "source shared.soar\n")
        self.write("shared.soar", propose("walk") + propose("stay"))
        for name in ("shared.soar", "."):
            told = self.check(name)
            self.assertTrue(told and all("stay" in message for _, _, message in told), told)
        self.assertEqual(2, len(self.check("two.soar")))

    def test_errors_say_error_once(self):
        self.write("a.soar", "\n\nsp {a (state <s>) --> (<s> ^b c)}\n")
        out = Run("check", self.folder / "a.soar", code=1).out
        self.assertIn("a.soar:3:", out)
        self.assertNotIn("Error:", out)

    def test_two_thousand_files(self):
        count = 2000
        for number in range(count):
            self.write(f"part{number // 100}/f{number}.soar", propose(f"op{number}") + apply(f"op{(number + 1) % count}"))
        self.write("main.soar", "".join(f"source part{number // 100}/f{number}.soar\n" for number in range(count)))
        editor = self.editor([self.folder])
        path = self.folder / "part0/f10.soar"
        text = path.read_text()
        uri = editor.open(path)
        place = {"textDocument": {"uri": uri}, "position": at(text, "name op11", offset=6)}
        self.assertEqual([(self.folder / "part0/f11.soar").as_uri()],
                         [one["uri"] for one in editor.ask("textDocument/definition", place)])
        self.assertEqual(2, len(editor.ask("textDocument/rename", dict(place, newName="other"))["changes"]))
        # A slip is found although there are many files.
        end = {"line": 2, "character": 0}
        editor.change(uri, {"range": {"start": end, "end": end}, "text": propose("nobody")})
        told = editor.wait_for(uri, lambda found: found)
        self.assertEqual([2], [one["range"]["start"]["line"] for one in told], told)
        self.assertIn("nobody", told[0]["message"])
        self.assertEqual([], editor.messages)
        self.assertEqual(0, editor.end())


class LanguageServer(Programs):
    def setUp(self):
        super().setUp()
        self.write("agent/main.soar", "source top.soar\npushd sub\nsource sub_source.soar\npopd\n")
        self.top = self.write("agent/top.soar", propose("walk"))
        self.write("agent/sub/sub_source.soar", "source a.soar\n")
        self.a = self.write("agent/sub/a.soar", apply("walk"))

    def test_a_file_in_a_folder_below_sees_its_whole_program(self):
        for folders in ([self.folder], [self.folder / "agent"], [self.folder / "agent/sub"], None):
            if folders == [self.folder / "agent/sub"]:
                continue  # That is all that the user opened.
            editor = self.editor(folders)
            text = self.a.read_text()
            uri = editor.open(self.a)
            place = {"textDocument": {"uri": uri}, "position": at(text, "name walk", offset=6)}
            edit = editor.ask("textDocument/rename", dict(place, newName="stroll"))["changes"]
            self.assertEqual({self.a.as_uri(), self.top.as_uri()}, set(edit), folders)
            self.assertEqual(propose("walk").replace("name walk", "name stroll"),
                             applied(self.top.read_text(), edit[self.top.as_uri()]))
            self.assertIn("proposed by `propose*walk`", editor.ask("textDocument/hover", place)["contents"]["value"])
            self.assertEqual([self.top.as_uri()], [one["uri"] for one in editor.ask("textDocument/definition", place)])
            found = editor.ask("textDocument/references", dict(place, context={"includeDeclaration": True}))
            self.assertEqual({self.a.as_uri(), self.top.as_uri()}, {one["uri"] for one in found})
            self.assertEqual([], editor.wait_for(uri, lambda found: True))
            self.assertEqual(0, editor.end())

    def test_slips_of_files_that_are_not_open_are_told_too(self):
        editor = self.editor([self.folder])
        self.top.write_text(propose("walk") + propose("stay"))
        editor.open(self.a)
        told = editor.wait_for(self.top.as_uri(), lambda found: found)
        self.assertEqual([1], [one["range"]["start"]["line"] for one in told])
        self.assertEqual(0, editor.end())

    def test_folders_come_and_go(self):
        other = self.write("other/top.soar", "source ../agent/sub/a.soar\n" + propose("run"))
        editor = self.editor([self.folder / "agent"])
        text = self.a.read_text()
        place = {"textDocument": {"uri": editor.open(self.a)}, "position": at(text, "apply*walk")}
        symbols = lambda: {one["name"] for one in editor.ask("workspace/symbol", {"query": ""})}
        self.assertNotIn("propose*run", symbols())
        editor.tell("workspace/didChangeWorkspaceFolders",
                    {"event": {"added": [{"uri": self.folder.as_uri(), "name": "all"}], "removed": []}})
        self.assertIn("propose*run", symbols())
        self.assertIn("rule", editor.ask("textDocument/hover", place)["contents"]["value"])
        self.assertEqual(0, editor.end())
        self.assertTrue(other.exists())

    def test_words_of_soar_are_explained(self):
        editor = self.editor([self.folder])
        path = self.write("say.soar", "sp {say (state <s> ^superstate nil) --> (write |hello|)}\n")
        text, uri = path.read_text(), editor.open(path)
        for word, offset, told in (("state", 1, "matches a state"), ("-->", 1, "Conditions come before"),
                                   ("write", 2, "Prints"), ("superstate", 2, "The state above"), ("say", 1, "calls `write`"),
                                   ("sp", 1, "Adds a rule")):
            place = {"textDocument": {"uri": uri}, "position": at(text, word, offset=offset)}
            self.assertIn(told, editor.ask("textDocument/hover", place)["contents"]["value"], word)
        self.assertEqual(0, editor.end())

    def test_lines_within_messages_are_lines_of_the_file(self):
        editor = self.editor([self.folder])
        path = self.write("wrong.soar", "\n" * 8 + "sp {wrong\n   (state <s> ^superstate nil\n-->\n   (<s> ^a b)\n}\n")
        told = editor.wait_for(editor.open(path), lambda found: found)
        checked = Run("check", path, code=1).out
        self.assertIn("line 10", checked)
        self.assertIn("line 10", told[0]["message"])
        self.assertEqual(0, editor.end())


if __name__ == "__main__":
    unittest.main()
