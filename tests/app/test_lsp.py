# SPDX-License-Identifier: BSD-2-Clause
"""`soarbox lsp` as an editor uses it, and `soarbox format` and `soarbox datamap`."""
import json
import pathlib
import random
import unittest

from editor_client import Channel, Editor, applied, at
from soarbox_command import Run, new_folder

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent

MAIN = """# Große Übersicht 😀
source "moves.soar"

sp {scout*propose*seek
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^agent <a>)
   (<a> ^relation enemy ^range < 30 ^name <n>)
-->
   (<s> ^operator <o> +)
   (<o> ^name seek ^foe <n>)
}
"""
MOVES = """sp {scout*apply*seek
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name seek ^foe <n>)
-->
   (<out> ^move-to <m>)
   (<m> ^agent <n>)
}
"""


class WithFolder(unittest.TestCase):
    def setUp(self):
        self.folder = new_folder(self)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path


class LanguageServer(WithFolder):
    def setUp(self):
        super().setUp()
        self.main, self.moves = self.write("main.soar", MAIN), self.write("moves.soar", MOVES)
        self.editor = Editor()
        self.addCleanup(self.editor.channel.close)

    def place(self, path, text, word, nth=0, offset=0):
        return {"textDocument": {"uri": path.as_uri()}, "position": at(text, word, nth, offset)}

    def labels(self, path, text, word, nth=0, offset=0):
        found = self.editor.ask("textDocument/completion", self.place(path, text, word, nth, offset))
        return [item["label"] for item in found["items"]]

    def test_operators_and_datamap_of_a_program_are_trees(self):
        self.write("below.soar", "sp {scout*propose*look\n   (state <s> ^superstate.operator.name seek)\n-->\n"
                   "   (<s> ^operator <o> +)\n   (<o> ^name look)}\nsp {plain (state <s> ^superstate nil) --> (<s> ^here yes)}\n")
        main = self.write("main.soar", MAIN.replace('source "moves.soar"', 'source "moves.soar"\nsource "below.soar"'))
        asked = {"textDocument": {"uri": main.as_uri()}}
        operators = {one["name"]: one for one in self.editor.ask("soarbox/operators", asked)}
        self.assertEqual(set(operators), {"", "seek", "look"})
        self.assertEqual([(rule["name"], rule["role"]) for rule in operators["seek"]["rules"]],
                         [("scout*propose*seek", "proposes"), ("scout*apply*seek", "applies")])
        self.assertEqual((operators["seek"]["parents"], operators["look"]["parents"]), ([], ["seek"]))
        self.assertEqual([rule["name"] for rule in operators[""]["rules"]], ["plain"])
        location = operators["seek"]["rules"][1]["location"]
        self.assertEqual((location["uri"], location["range"]["start"]["line"]), (self.moves.as_uri(), 0))

        def find(nodes, *path):
            node = next(one for one in nodes if one["name"] == path[0])
            return node if len(path) == 1 else find(node["children"], *path[1:])

        datamap = self.editor.ask("soarbox/datamap", asked)
        self.assertEqual(find(datamap, "here")["detail"], "text")
        self.assertIn("number", find(datamap, "io", "input-link", "agent", "range")["detail"])
        self.assertTrue(find(datamap, "io", "output-link", "move-to")["children"])

    def test_files_that_are_not_open_are_checked_too(self):
        self.write("other/main.soar", MAIN.replace("^relation enemy", "^relaton enemy"))
        self.write("other/moves.soar", MOVES)
        other = (self.folder / "other" / "main.soar").as_uri()
        editor = Editor(folders=[self.folder])
        self.addCleanup(editor.channel.close)

        def has(word):
            return lambda found: any(word in one["message"] for one in found)

        # No file is open.
        editor.wait_for(other, has("relaton"))
        # A file that is closed remains known, with its text on the disk.
        uri = editor.open(self.folder / "other" / "main.soar")
        editor.change(uri, {"text": MAIN.replace("^range < 30", "^rage < 30")})
        editor.wait_for(other, has("rage"))
        editor.tell("textDocument/didClose", {"textDocument": {"uri": uri}})
        editor.wait_for(other, has("relaton"))
        # Files that change on the disk.
        self.write("other/main.soar", MAIN.replace(" ^range < 30", ""))
        editor.tell("workspace/didChangeWatchedFiles", {"changes": [{"uri": other, "type": 2}]})
        editor.wait_for(other, lambda found: not found)
        self.write("other/main.soar", MAIN.replace("^relation enemy", "^relaton enemy"))
        editor.tell("workspace/didChangeWatchedFiles", {"changes": [{"uri": other, "type": 2}]})
        editor.wait_for(other, has("relaton"))
        (self.folder / "other" / "main.soar").unlink()
        editor.tell("workspace/didChangeWatchedFiles", {"changes": [{"uri": other, "type": 3}]})
        editor.wait_for(other, lambda found: not found)

    def test_only_what_is_wrong_is_told_and_the_server_ends_as_it_should(self):
        sound = MAIN.replace(" ^range < 30", "")
        self.assertEqual("0 errors, 0 warnings\n", Run("check", self.write("sound/main.soar", sound), self.write("sound/moves.soar", MOVES)).out)
        self.main.write_text(sound.replace("^relation", "^relaton"))
        uri = self.editor.open(self.main)
        told = self.editor.wait_for(uri, lambda found: any("relaton" in one["message"] for one in found))
        self.assertEqual(1, len(told), told)
        # After the correction it is valid again.
        where = at(self.main.read_text(), "^relaton", offset=6)
        self.editor.change(uri, {"range": {"start": where, "end": where}, "text": "i"})
        self.editor.wait_for(uri, lambda found: not found)
        self.assertEqual(0, self.editor.end())

    def test_an_error_is_told_while_somebody_types_at_its_place_in_utf_16(self):
        uri = self.editor.open(self.main)
        where = at(MAIN, "(<o> ^name seek")
        self.editor.change(uri, {"range": {"start": where, "end": where}, "text": "😀 (<x> ^bad 1)\n   "})
        self.editor.change(uri, {"range": {"start": where, "end": dict(where, character=where["character"] + 3)},
                                 "text": ""})
        problem = self.editor.wait_for(uri, lambda found: found)[0]
        self.assertEqual(1, problem["severity"])
        self.assertIn("<x>", problem["message"])
        self.assertEqual(where["line"], problem["range"]["start"]["line"])

    def test_it_says_what_check_says(self):
        text = MAIN.replace("^relation enemy", "^relaton enemy").replace("^range < 30", "^range < |30|")
        self.main.write_text(text)
        uri = self.editor.open(self.main)
        told = self.editor.wait_for(uri, lambda found: any("relaton" in one["message"] for one in found))
        checked = [json.loads(line) for line in Run("check", "--json", self.main).out.splitlines()]
        self.assertEqual(sorted((one["line"], one["message"]) for one in checked),
                         sorted((one["range"]["start"]["line"] + 1, one["message"].split("\n")[0]) for one in told))

    def test_a_remedy_is_an_edit(self):
        text = MAIN.replace("^relation enemy", "^relaton enemy")
        self.main.write_text(text)
        uri = self.editor.open(self.main)
        told = self.editor.wait_for(uri, lambda found: any("relaton" in one["message"] for one in found))
        problem = next(one for one in told if "relaton" in one["message"])
        actions = self.editor.ask("textDocument/codeAction", {"textDocument": {"uri": uri}, "range": problem["range"],
                                                              "context": {"diagnostics": [problem]}})
        self.assertEqual(["Write relation"], [action["title"] for action in actions])
        self.assertEqual(MAIN, applied(text, actions[0]["edit"]["changes"][uri]))

    def test_it_completes_percepts_commands_and_names_by_the_kind_of_object(self):
        self.editor.open(self.main)
        self.editor.open(self.moves)
        self.assertEqual({"name", "range", "bearing", "relation"},
                         {"name", "range", "bearing", "relation"} & set(self.labels(self.main, MAIN, "^relation", offset=1)))
        self.assertNotIn("waypoint", self.labels(self.main, MAIN, "^relation", offset=1))
        self.assertIn("enemy", self.labels(self.main, MAIN, "enemy"))
        self.assertIn("move-to", self.labels(self.moves, MOVES, "^move-to", offset=1))
        self.assertIn("waypoint", self.labels(self.moves, MOVES, "^agent", offset=1))
        self.assertIn("foe", self.labels(self.moves, MOVES, "^foe", offset=1))
        self.assertIn("seek", self.labels(self.moves, MOVES, "^name seek", offset=6))
        self.assertIn("input-link", self.labels(self.main, MAIN, "input-link"))
        self.assertIn("<out>", self.labels(self.moves, MOVES, "<out> ^move", offset=1))

    def test_it_completes_in_a_rule_that_is_being_typed(self):
        uri = self.editor.open(self.main)
        text = MAIN + "\nsp {new*rule\n   (state <s> ^io.input-link <in>)\n   (<in> ^wayp"
        self.editor.change(uri, {"text": text})
        found = self.editor.ask("textDocument/completion", self.place(self.main, text, "^wayp", offset=5))
        item = next(one for one in found["items"] if one["label"] == "waypoint")
        self.assertTrue(applied(text, [item["textEdit"]]).endswith("(<in> ^waypoint"))

    def test_it_explains_a_rule_a_percept_with_its_unit_and_an_operator(self):
        self.editor.open(self.main)

        def hover(word, **where):
            return self.editor.ask("textDocument/hover", self.place(self.main, MAIN, word, **where))["contents"]["value"]

        self.assertIn("proposes `seek`", hover("scout*propose", offset=3))
        self.assertRegex(hover("range < 30"), r"Distance to where .*\nm$")
        self.assertIn("applied by `scout*apply*seek`", hover("seek ^foe"))
        self.assertIn("`^io.input-link.agent`", hover("<a> ^relation"))

    def test_it_finds_definitions_and_references_across_files(self):
        self.editor.open(self.moves)
        found = self.editor.ask("textDocument/definition", self.place(self.moves, MOVES, "foe"))
        self.assertEqual([self.main.as_uri()], [one["uri"] for one in found])
        found = self.editor.ask("textDocument/references",
                                dict(self.place(self.moves, MOVES, "foe"), context={"includeDeclaration": True}))
        self.assertEqual({self.main.as_uri(), self.moves.as_uri()}, {one["uri"] for one in found})
        found = self.editor.ask("textDocument/definition", self.place(self.main, MAIN, "moves.soar"))
        self.assertEqual([self.moves.as_uri()], [one["uri"] for one in found])

    def test_it_renames_attributes_operators_rules_and_variables(self):
        self.editor.open(self.main)

        def renamed(word, to, **where):
            edit = self.editor.ask("textDocument/rename", dict(self.place(self.main, MAIN, word, **where), newName=to))
            return [applied(text, edit["changes"].get(path.as_uri(), []))
                    for path, text in ((self.main, MAIN), (self.moves, MOVES))]

        self.assertEqual([MAIN.replace("^foe", "^prey"), MOVES.replace("^foe", "^prey")], renamed("foe", "prey"))
        self.assertEqual([MAIN.replace("^name seek", "^name hunt"), MOVES.replace("^name seek", "^name hunt")],
                         renamed("seek ^foe", "hunt"))
        self.assertEqual([MAIN.replace("<n>", "<who>"), MOVES], renamed("<n>", "<who>"))
        self.assertEqual([MAIN.replace("scout*propose*seek", "go"), MOVES], renamed("scout*propose*seek", "go"))
        for word, to in (("relation", "kind"), ("input-link", "in"), ("foe", "two words"), ("<n>", "<a>")):
            answer = self.editor.answer("textDocument/rename", dict(self.place(self.main, MAIN, word), newName=to))
            self.assertIn("error", answer, word)

    def test_outline_folding_and_colours(self):
        uri = self.editor.open(self.main)
        document = {"textDocument": {"uri": uri}}
        self.assertEqual(["scout*propose*seek"], [one["name"] for one in self.editor.ask("textDocument/documentSymbol", document)])
        self.assertEqual([(3, 10)], [(one["startLine"], one["endLine"]) for one in self.editor.ask("textDocument/foldingRange", document)])
        data = self.editor.ask("textDocument/semanticTokens/full", document)["data"]
        self.assertEqual(0, len(data) % 5)
        # The comment of the first line, with its sign outside of the basic plane.
        self.assertEqual([0, 0, len("# Große Übersicht 😀".encode("utf-16-le")) // 2, 0, 0], data[:5])

    def test_lenses_tell_how_often_rules_fired_in_the_last_run(self):
        recording = self.folder / "last.soarrec"
        Run("run", SOURCE / "scenarios" / "soar_seek", "--headless", "--seconds", 3, "--record", recording,
            "--record-level", "all", code=0)
        rules = next((SOURCE / "scenarios" / "soar_seek").glob("*.soar"))
        path = self.write("seek.soar", rules.read_text() + "\nsp {never*fires (state <s> ^no-such thing) --> (<s> ^x y)}\n")
        uri = self.editor.open(path)
        titles = [one["command"]["title"] for one in self.editor.ask("textDocument/codeLens", {"textDocument": {"uri": uri}})]
        self.assertIn("never fired in last.soarrec", titles)
        self.assertTrue(any("times in last.soarrec" in one for one in titles), titles)

    def test_damaged_messages_are_answered_and_end_nothing(self):
        channel = self.editor.channel
        for damaged in (b"Content-Length: 5\r\n\r\n{\"a\":", b"Content-Length: no\r\n\r\n", b"Nonsense\r\n\r\n",
                        b"Content-Length: 2\r\n\r\n[]", b"Content-Length: 4\r\n\r\n\xff\xfe\x00\x01"):
            channel.send_bytes(damaged)
            self.assertIn("error", channel.receive())
        for method, params in (("textDocument/hover", None), ("textDocument/hover", {"textDocument": 3}),
                               ("textDocument/completion", {"textDocument": {"uri": "file:///no/such"}, "position": {}}),
                               ("textDocument/rename", []), ("no/such", {}), ("initialize", {})):
            self.assertIn("error", self.editor.answer(method, params), method)
        rng = random.Random(1)
        uri = self.editor.open(self.main)
        good = json.dumps({"jsonrpc": "2.0", "id": 1, "method": "textDocument/hover",
                           "params": self.place(self.main, MAIN, "foe")}).encode()
        for _ in range(300):
            body = bytearray(good)
            for _ in range(rng.randrange(1, 6)):
                body[rng.randrange(len(body))] = rng.randrange(256)
            channel.send_bytes(b"Content-Length: %d\r\n\r\n%s" % (len(body), bytes(body)))
        self.editor.number = 1000
        self.assertIn("attribute", self.editor.ask("textDocument/hover", self.place(self.main, MAIN, "foe"))["contents"]["value"])
        self.editor.change(uri, {"range": {"start": {"line": 10 ** 9, "character": 10 ** 9},
                                           "end": {"line": 10 ** 9, "character": 10 ** 9}}, "text": "x"})
        self.assertEqual(0, self.editor.end())

    def test_a_client_that_goes_away_ends_it_with_a_code_that_the_help_names(self):
        channel = Channel("lsp")
        self.addCleanup(channel.close)
        channel.process.stdin.close()
        self.assertEqual(1, channel.process.wait(30))
        self.assertRegex(Run("lsp", "--help", code=0).out, r"\n  1 +The connection ended without the request shutdown\n")
        channel.process.stdin = open("/dev/null", "wb")


class Format(WithFolder):
    def test_our_own_rules_mean_the_same_afterwards_and_stay_as_they_are_the_second_time(self):
        files = sorted((SOURCE / "scenarios").glob("*/*.soar"))[:12]
        self.assertGreater(len(files), 5)
        for file in files:
            path = self.write(file.name, "\n".join("  " + line if line.startswith("   ") else line + "  "
                                                   for line in file.read_text().split("\n")))

            def printed(of):
                shell = self.write("print.soar", f"source {of.name}\nprint --all --full\n")
                return Run("soar", shell, cwd=self.folder).out.split("sp {", 1)[-1]

            before = printed(path)
            self.assertIn("(state ", before, file)
            self.assertEqual(0, Run("format", path).code)
            self.assertEqual(before, printed(path), file)
            self.assertEqual("", Run("format", "--check", path).out)

    def test_check_names_files_and_changes_nothing(self):
        path = self.write("a.soar", "sp {a\n(state <s> ^superstate nil\n^b c)\n-->\n(<s> ^d e)\n}\n\n\n\n# end")
        before = path.read_text()
        run = Run("format", "--check", self.folder)
        self.assertEqual((1, f"{path}\n"), (run.code, run.out))
        self.assertEqual(before, path.read_text())
        self.assertEqual(0, Run("format", self.folder).code)
        self.assertEqual("sp {a\n   (state <s> ^superstate nil\n              ^b c)\n-->\n   (<s> ^d e)\n}\n\n# end\n", path.read_text())

    def test_what_cannot_be_read_is_named(self):
        run = Run("format", self.folder / "none.soar", code=1)
        self.assertIn("cannot be read", run.err)
