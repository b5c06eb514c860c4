# SPDX-License-Identifier: BSD-2-Clause
"""Runs in pages: lessons, worlds, recordings, and what remains of them when a process is killed."""
import base64
import json
import os
import signal
import struct
import unittest
import zlib

from web_client import LESSONS, BrowserRun, ServeCase, printed


def first_file(edit):
    return edit["files"][0]["file"]


class Runs(ServeCase):
    def test_a_world_is_shown_and_its_time_goes_on(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "agents", "mind")
        hello = page.messages[-1]
        self.assertEqual((hello["what"], hello["is_recording"], hello["seed"]), ("scenario:soar_hallway", False, 1))
        self.assertTrue(hello["minds"])
        page.until_contents("mind", lambda mind: "Goal stack" in json.dumps(mind["document"]))
        page.until(lambda message: message["message"] == "flow" and message["time_s"] > 1 and len(page.blocks) > 10)
        self.assertEqual(page.blocks[0][:2], b"\x53\x01")
        self.assertTrue(page.blocks[0][2] & 1, "the first block is full")
        self.assertFalse(all(block[2] & 1 for block in page.blocks), "others are differences")

    def test_time_stops_steps_and_goes_back(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "agents")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 5)
        page.ask(request="flow", what="pause")
        tick = page.until(lambda message: message["message"] == "flow" and message["paused"])["tick"]
        page.ask(request="flow", what="step-tick")
        page.until(lambda message: message["message"] == "flow" and message["tick"] == tick + 1)
        page.ask(request="flow", what="step-decision")
        page.until(lambda message: message["message"] == "told" and "one decision" in message["text"])
        page.ask(request="seek", tick=2)
        page.until_contents("moment", lambda moment: moment["time"]["shown_tick"] == 2 and not moment["time"]["is_live"])
        page.ask(request="live")
        page.until_contents("moment", lambda moment: moment["time"]["is_live"])
        page.ask(request="flow", what="next-seed")
        self.assertEqual(page.until_message("hello")["seed"], 2)

    def test_a_step_of_a_game_is_a_turn(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:eaters", "agents")
        self.assertEqual(page.messages[-1]["turn_ticks"], 10)
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)
        page.ask(request="flow", what="pause")
        tick = page.until(lambda message: message["message"] == "flow" and message["paused"])["tick"]
        page.ask(request="flow", what="step-turn")
        page.until(lambda message: message["message"] == "flow" and message["tick"] == (tick // 10 + 1) * 10)
        page.ask(request="flow", what="step-turn")
        page.until(lambda message: message["message"] == "flow" and message["tick"] == (tick // 10 + 2) * 10)

    def test_what_an_agent_imagines_is_shown_and_drawn(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hide", "imagery")
        page.ask(request="select", agent="hider")

        def answers(content):
            """The value and the record of each answer that can be drawn."""
            trees = [node for node in content["document"] if node["is"] == "tree"]
            spans = [row["s"][0] for tree in trees for row in tree["rows"]]
            return [(span[0], span[2][0]["record"]) for span in spans if isinstance(span, list) and "picture" in span[-1]]

        content = page.until_contents("imagery", answers)
        drawn = next(node for node in content["document"] if node["is"] == "line")
        self.assertEqual([button["label"] for button in drawn["nodes"] if button.get("on")], ["made up"])
        page.ask(request="flow", what="pause")
        page.until(lambda message: message["message"] == "flow" and message["paused"])
        answer = answers(page.until_contents("imagery", answers))[0]
        page.ask(request="imagine", record=answer[1])
        ghosts = page.until_contents("ghosts", lambda ghosts: ghosts["answer"]["lines"])
        self.assertEqual(float(ghosts["answer"]["text"]), float(answer[0]))
        self.assertEqual(set(ghosts["answer"]["lines"][0]), {"from", "to", "is_crossed"})
        page.ask(request="imagine", state="S1")
        ghosts = page.until_contents("ghosts", lambda ghosts: ghosts["shapes"])
        self.assertEqual(ghosts["answer"]["lines"], [], "no answer is looked at any more")
        shapes = {shape["name"]: shape for shape in ghosts["shapes"]}
        self.assertEqual((shapes["self"]["kind"], shapes["self"]["state"]), ("sensed", "S1"))
        self.assertEqual((len(shapes["self"]["points"]), len(shapes["self"]["edges"])), (24, 24), "a box")
        page.ask(request="imagine", state="S1", recrod="R1")
        self.assertIn("did you mean 'record'?", page.until_message("error")["hint"])

    def test_what_there_is_to_draw_is_told_once_and_to_late_pages_too(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "scenario:soar_skirmish", "agents")
        page.until_contents("shapes:body/soldier")
        self.assertEqual(page.contents["shapes:mesh/models/soarbox/soldier.mesh"], {"body": "body/soldier"})
        soldier = page.contents["shapes:body/soldier"]
        self.assertEqual(len(soldier["bones"]), 21)
        mesh = zlib.decompress(base64.b64decode(soldier["coarse"]))
        corners, numbers, has_skin = struct.unpack_from("<III", mesh)
        self.assertEqual((has_skin, numbers % 3), (1, 0))
        self.assertEqual(len(mesh), 12 + 4 * numbers + 6 * (8 + 2 * corners) + 8 * corners)
        page.until(lambda message: message["message"] == "flow" and message["time_s"] > 1)
        told = [name for message in page.messages for name in message.get("contents", {}) if name.startswith("shapes:")]
        self.assertEqual(len(told), len(set(told)))
        late = self.page(server, place)
        late.until_contents("shapes:body/soldier")

    def test_two_servers_do_not_run_the_world_of_one_place(self):
        one, other = self.serve(), self.serve()
        place = one.new_place()
        self.opened(one, place, "scenario:soar_hallway", "agents")
        late = self.page(other, place)
        late.until_message("none")
        late.ask(request="open", what="scenario:soar_hallway")
        self.assertIn("another server runs a world of this place", late.until_message("error")["error"])
        one.kill()
        late.ask(request="open", what="scenario:soar_hallway")
        late.until_message("hello")

    def test_a_lesson_is_solved_by_typing(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "lesson:01-a-rule", "mission", "edit", "problems")
        lesson = page.until_contents("mission", lambda mission: mission["lesson"])["lesson"]
        self.assertFalse(lesson["is_passed"])
        files = page.until_contents("edit", lambda edit: edit["files"])
        page.ask(request="edit", file=first_file(files))
        page.until_contents("edit", lambda edit: edit["edit"]["text"])
        page.ask(request="lesson", what="hint")
        page.until_contents("mission", lambda mission: len(mission["lesson"]["hints"]) == 1)
        # Text that does not parse changes nothing and is reported with its place.
        page.ask(request="edit-text", what="apply", text="sp {broken (state <s> --> }")
        broken = page.until_contents("edit", lambda edit: edit["edit"]["problems"])["edit"]
        self.assertEqual(broken["problems"][0]["line"], 1)
        self.assertIn("previous version keeps running", broken["notice"])
        solution = next((LESSONS / "01-a-rule" / "solution").glob("*.soar")).read_text(encoding="utf-8")
        page.ask(request="edit-text", what="apply", text=solution)
        page.until_contents("edit", lambda edit: "Reloaded" in edit["edit"]["notice"])
        page.ask(request="edit-text", what="save", text=solution)
        page.until_contents("edit", lambda edit: edit["edit"]["notice"] == "Saved.")
        page.ask(request="lesson", what="grade")
        page.until_contents("mission", lambda mission: mission["lesson"]["is_graded"])
        page.ask(request="lesson", what="cancel")
        cancelled = page.until_contents("mission", lambda mission: not mission["lesson"]["is_graded"])["lesson"]
        self.assertEqual(cancelled["grade"], ["Grading was cancelled. There is no verdict."])
        self.assertFalse(cancelled["is_passed"])
        page.ask(request="lesson", what="grade")
        done = page.until_contents("mission", lambda mission: mission["lesson"]["is_passed"])["lesson"]
        self.assertIn("Passed", " ".join(done["grade"]))
        about = server.json("GET", f"/api/p/{place}")[1]
        self.assertEqual([lesson["is_passed"] for lesson in about["lessons"]][:2], [True, False])

    def test_lessons_of_other_courses_open_as_well(self):
        server = self.serve()
        place = server.new_place()
        lesson = next(lesson["name"] for lesson in server.json("GET", f"/api/p/{place}")[1]["lessons"] if lesson["course"] == "eaters")
        page = self.opened(server, place, "lesson:" + lesson, "mission")
        self.assertEqual(page.until_contents("mission", lambda mission: mission["lesson"])["lesson"]["name"], lesson)

    def test_a_run_goes_on_where_it_was_when_its_page_comes_again(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "scenario:soar_hallway", "agents")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 10)
        page.ask(request="flow", what="pause")
        tick = page.until(lambda message: message["message"] == "flow" and message["paused"])["tick"]
        page.close()
        again = self.page(server, place)
        hello = again.until_message("hello")
        self.assertEqual(hello["what"], "scenario:soar_hallway")
        self.assertGreaterEqual(again.until_message("flow")["tick"], tick)
        again.until_contents("agents")
        again.ask(request="scene")
        again.ask(request="flow", what="go-on")
        again.until(lambda message: message["message"] == "flow" and message["tick"] > tick + 5)
        self.assertTrue(again.blocks[0][2] & 1)

    def test_a_page_that_comes_to_a_paused_run_gets_its_scene_after_any_amount_of_text(self):
        world = self.folder / "wordy"
        world.mkdir()
        (world / "scenario.toml").write_text('[[agent]]\nname = "one"\nrules = "one.soar"\n', encoding="utf-8")
        rules = "".join(f"sp {{{'wordy' * 20}*{i} (state <s> ^a {i}) --> (<s> ^b {i})}}\n" for i in range(2000))
        (world / "one.soar").write_text(rules, encoding="utf-8")
        server = self.serve(world)
        place = server.new_place()
        page = self.opened(server, place, "scenario:wordy", "rules")
        page.until_contents("rules", lambda rules: len(json.dumps(rules)) > 200_000)
        page.ask(request="flow", what="pause")
        page.until(lambda message: message["message"] == "flow" and message["paused"])
        late = self.page(server, place)
        late.until_contents("rules")
        late.until(lambda message: message["message"] == "flow" and late.blocks)
        self.assertTrue(late.blocks[0][2] & 1, "the first block is full")

    def test_a_world_of_ones_own_is_served_and_every_place_gets_a_copy(self):
        world = self.folder / "my_world"
        world.mkdir()
        (world / "scenario.toml").write_text("[[agent]]\nname = \"scout\"\nrules = \"scout.soar\"\n", encoding="utf-8")
        (world / "scout.soar").write_text("sp {go (state <s> ^superstate nil) --> (<s> ^a b)}\n", encoding="utf-8")
        server = self.serve(world)
        place = server.new_place()
        self.assertEqual(server.json("GET", f"/api/p/{place}")[1]["opens"], "scenario:my_world")
        page = self.opened(server, place, "scenario:my_world", "agents")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)
        files = [file["path"] for file in server.json("GET", f"/api/p/{place}")[1]["files"]]
        self.assertEqual(files, ["worlds/my_world/scenario.toml", "worlds/my_world/scout.soar"])
        with self.assertRaisesRegex(AssertionError, "there is no scenario 'nowhere' to serve"):
            self.serve("nowhere")

    def test_a_run_in_the_browser_ends_with_its_page(self):
        server = BrowserRun(self.folder, "run", "soar_hallway", "--seed", "7")
        self.addCleanup(lambda: server.process.poll() is None and server.kill())
        self.assertEqual(server.json("POST", "/api/places", b"")[0], 401, "it is the user's own")
        place = server.new_place(Authorization="Bearer " + server.token)
        page = self.page(server, place, protocol="soarbox." + server.token)
        page.until_message("none")
        page.ask(request="open", what="scenario:thesis")
        page.until_message("error")
        page.ask(request="open", what="run:soar_hallway")
        self.assertEqual(page.until_message("hello")["seed"], 7)
        page.close()
        self.assertEqual(server.process.wait(120), 0)
        server.close()

    def test_two_pages_of_a_place_see_the_same_run(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "scenario:soar_hallway", "agents")
        other = self.page(server, place)
        other.until_message("hello")
        page.ask(request="flow", what="pause")
        other.until(lambda message: message["message"] == "flow" and message["paused"])

    def test_an_engine_that_is_killed_takes_nothing_with_it(self):
        server = self.serve()
        place, neighbour = server.new_place(), server.new_place()
        beside = self.opened(server, neighbour, "scenario:soar_hallway", "agents")
        before = server.engines()
        page = self.opened(server, place, "lesson:01-a-rule", "edit")
        page.ask(request="edit", file=first_file(page.until_contents("edit", lambda edit: edit["files"])))
        page.until_contents("edit", lambda edit: edit["edit"]["text"])
        page.ask(request="edit-text", what="type", text="# half a thought\n")
        drafts = self.folder / "state" / "places" / place / "state"
        self.wait_for(lambda: any("half a thought" in file.read_text(encoding="utf-8", errors="replace")
                                  for file in drafts.rglob("*") if file.is_file() and "recordings" not in file.parts),
                      "what is typed is kept on the disk")
        victim = (set(server.engines()) - set(before)).pop()
        os.kill(victim, signal.SIGKILL)
        ended = page.until_message("ended")
        self.assertIn("crashed", ended["text"])
        beside.until(lambda message: message["message"] == "flow" and message["tick"] > 0)
        page.ask(request="open", what="lesson:01-a-rule")
        page.until_message("hello")
        page.ask(request="look", panels=["edit"])
        page.ask(request="edit", file=first_file(page.until_contents("edit", lambda edit: edit["files"])))
        page.until_contents("edit", lambda edit: "half a thought" in edit["edit"]["text"])
        self.assertTrue(server.json("GET", f"/api/p/{place}")[1]["recordings"])

    def test_a_server_that_is_killed_finds_all_places_again(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "scenario:soar_hallway", "agents")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 30)
        engines = server.engines()
        server.kill()
        self.wait_for(lambda: not any(os.path.exists(f"/proc/{number}/root") and is_running(number) for number in engines),
                      "engines end with their server")
        again = self.serve()
        recordings = again.json("GET", f"/api/p/{place}")[1]["recordings"]
        self.assertEqual(len(recordings), 1)
        shown = self.opened(again, place, "recording:" + recordings[0]["name"], "agents", "timeline")
        self.assertTrue(shown.messages[-1]["is_recording"])
        shown.until_contents("moment", lambda moment: moment["time"]["last_tick"] > 20)
        shown.ask(request="seek", tick=3)
        shown.until_contents("moment", lambda moment: moment["time"]["shown_tick"] == 3)

    def test_a_server_that_is_stopped_says_so(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "agents")
        code = server.stop()
        self.assertIn("being stopped", page.until_message("ended")["text"])
        self.assertEqual(code, 0)

    def test_there_is_a_limit_to_runs_and_it_is_told(self):
        server = self.serve("--sessions", "1")
        self.opened(server, server.new_place(), "scenario:soar_hallway", "agents")
        late = self.page(server, server.new_place())
        self.assertEqual(late.status, 503)

    def test_what_cannot_be_opened_is_told_and_the_run_goes_on(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "agents")
        for what in ("lesson:../01-a-rule", "scenario:/etc", "scenario:..", "recording:../../x", "nothing", "", "lesson:"):
            page.ask(request="open", what=what, id=what)
            self.assertEqual(page.until_message("error")["id"], what)
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)

    def test_a_world_that_cannot_begin_says_why(self):
        server = self.serve()
        place = server.new_place()
        for path, text in (("worlds/mine/scenario.toml", b'[world]\nfloor = "none'), ):
            self.assertEqual(server.json("PUT", f"/api/p/{place}/files/{path}", text)[0], 200)
        page = self.page(server, place)
        page.ask(request="open", what="scenario:mine")
        ended = page.until_message("ended")
        self.assertRegex(ended["text"], "(?i)string|quote|toml")

    def test_a_console_reads_no_files_and_starts_nothing(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "console")
        agent = page.messages[-1] and next(message for message in page.messages if message["message"] == "hello")["minds"][0]
        page.ask(request="console", agent=agent, line="print s1")
        page.until_printed("^io")
        written = self.folder / "stolen.txt"
        for line in (f"output log {written}", "source /etc/passwd", f"rete-net --save {written}", "visualize",
                     f"save percepts --open {written}"):
            page.ask(request="console", agent=agent, line=line)
        page.ask(request="console", agent=agent, line="echo the end")
        page.until_printed("the end")
        self.assertFalse(written.exists())

    def test_a_line_is_begun_until_it_is_sent_and_each_agent_has_its_own_count_of_lines(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "lesson:01-a-rule", "console")
        one, other = next(message for message in page.messages if message["message"] == "hello")["minds"][:2]

        def transcript(console):
            return console["document"][0]

        def begun(console):
            return console["document"][1]["nodes"][-1]["fields"][0].get("value", "")

        def shown_of(agent, accepts=lambda console: True):
            page.ask(request="select", agent=agent)
            return page.until_contents("console", lambda console: transcript(console).get("key") == f"output {agent}" and accepts(console))

        page.ask(request="select", agent=one)
        page.ask(request="keep-line", agent=one, line="print s1")
        shown_of(one, lambda console: begun(console) == "print s1")
        before = transcript(shown_of(other))["count"]
        # A page keeps the whole line, and then sends it.
        page.ask(request="console", agent=one, line="print s1")
        after = shown_of(one, lambda console: "print s1" in printed(console))
        self.assertEqual(begun(after), "")
        self.assertGreater(transcript(after)["count"], 0)
        self.assertEqual(transcript(shown_of(other))["count"], before)

    def test_rules_are_completed_as_in_an_editor(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "lesson:01-a-rule", "edit")
        file = first_file(page.until_contents("edit", lambda edit: edit["files"]))

        def language(method, params, number=None):
            message = {"jsonrpc": "2.0", "method": method, "params": params}
            if number is None:
                return page.ask(request="language", message=message)
            page.ask(request="language", message={**message, "id": number})
            return page.until(lambda message: message["message"] == "language"
                              and message["content"].get("id") == number)["content"]
        self.assertTrue(language("initialize", {"capabilities": {}}, 1)["result"]["capabilities"])
        language("initialized", {})
        text = "sp {go (state <s> ^io.input-link.)\n-->\n(<s> ^a b)}\n"
        language("textDocument/didOpen", {"textDocument": {"uri": "file://" + file, "languageId": "soar", "version": 1, "text": text}})
        items = language("textDocument/completion", {"textDocument": {"uri": "file://" + file},
                                                     "position": {"line": 0, "character": text.index(".)") + 1}}, 2)["result"]
        labels = [item["label"] for item in (items["items"] if isinstance(items, dict) else items)]
        self.assertIn("self", labels)
        # Files outside the place are not read.
        secret = self.folder / "secret.soar"
        secret.write_text("sp {secret*rule (state <s> ^secret-word) --> (<s> ^a b)}\n", encoding="utf-8")
        language("textDocument/didChange", {"textDocument": {"uri": "file://" + file, "version": 2},
                                            "contentChanges": [{"text": f"source {secret}\n" + text}]})
        symbols = language("workspace/symbol", {"query": "secret"}, 3)
        self.assertNotIn("secret*rule", str(symbols))

    def test_a_program_of_its_own_is_no_editor(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "edit", "problems")
        page.ask(request="edit", file="/etc/passwd")
        page.until_contents("problems", lambda problems: "not made from this file" in str(problems))
        page.ask(request="open-run", what="/etc", id=1)
        page.ask(request="no-such-request", id=2)
        self.assertEqual(page.until(lambda message: message.get("id") == 2)["message"], "error")


def is_running(number):
    try:
        with open(f"/proc/{number}/stat", encoding="utf-8") as stat:
            return stat.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


if __name__ == "__main__":
    unittest.main()
