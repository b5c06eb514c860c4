# SPDX-License-Identifier: BSD-2-Clause
"""Lua scripts that stop at lines, in the middle of a tick, while their page goes on working."""
import json
import pathlib
import time
import unittest

from web_client import ServeCase, WebSocket

WORLD = "scenario:thesis"
SCRIPT = "SeekingLuaAgent.lua"
PATIENCE_ALONE_S = 10
LINES = (pathlib.Path(__file__).resolve().parents[2] / "scenarios" / "thesis" / SCRIPT).read_text(encoding="utf-8").split("\n")


def line_of(text):
    return next(number for number, line in enumerate(LINES, 1) if text in line)


UPDATE, BLANK = line_of("Steering_WalkToTarget("), line_of("function Agent_Update") - 1


class Scripts(ServeCase):
    def stopped_page(self, server, place, line=UPDATE):
        page = self.opened(server, place, WORLD, "edit", "script", "problems")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)
        page.ask(request="line-stop", file=SCRIPT, line=line)
        page.until_contents("edit", lambda edit: edit["stopped"])
        return page

    def stop(self, page, count):
        """The stop with this number."""
        return page.until_contents("edit", lambda edit: edit["stopped"] and edit["stopped"]["count"] >= count)

    def panel(self, page, text):
        return page.until_contents("script", lambda script: text in json.dumps(script["document"]))

    def test_a_script_stops_shows_its_variables_and_takes_steps(self):
        server = self.serve()
        page = self.stopped_page(server, server.new_place())
        edit = page.contents["edit"]
        self.assertEqual(edit["stopped"]["line"], UPDATE)
        self.assertTrue(edit["stopped"]["file"].endswith("/thesis/" + SCRIPT))
        self.assertEqual((edit["edit"]["stops"], edit["edit"]["stopped_line"], edit["edit"]["can_stop"]), ([UPDATE], UPDATE, True))
        self.assertEqual(edit["edit"]["file"], edit["stopped"]["file"], "the editor shows the place")
        self.panel(page, "deltaTimeInMillis")
        tick = page.until(lambda message: message["message"] == "flow" and message.get("stopped"))["tick"]
        page.ask(request="script-go", how="over")
        self.assertEqual(self.stop(page, 2)["stopped"]["line"], UPDATE + 1)
        page.ask(request="script-go", how="over")
        self.assertEqual(self.stop(page, 3)["stopped"]["line"], UPDATE + 2)
        page.ask(request="script-value", key="locals/target")
        page.ask(request="script-watch", what="agent:GetPosition().x < 1000")
        self.panel(page, "GetPosition().x < 1000")
        page.ask(request="script-watch", what="agent:SetHealth(3)")
        self.panel(page, "might change the world")
        page.ask(request="script-go", how="on")
        self.assertEqual(self.stop(page, 4)["stopped"]["line"], UPDATE, "in the next tick")
        flow = page.until(lambda message: message["message"] == "flow" and message.get("stopped"))
        self.assertEqual(flow["tick"], tick + 1)
        page.ask(request="script-go", how="into")
        inside = self.stop(page, 5)["stopped"]
        self.assertTrue(inside["file"].endswith("Steering.lua"), inside)
        page.ask(request="script-go", how="out")
        self.assertTrue(self.stop(page, 6)["stopped"]["file"].endswith(SCRIPT))
        page.ask(request="line-stop", file=edit["edit"]["file"], line=UPDATE, is_on=False)
        page.ask(request="flow", what="go-on")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > tick + 5 and not message["paused"])
        self.assertEqual(page.contents["edit"]["stopped"], None)

    def test_what_would_advance_the_world_is_refused_and_the_rest_is_answered(self):
        server = self.serve()
        page = self.stopped_page(server, server.new_place())
        for request in ({"request": "seek", "tick": 1}, {"request": "resume"}, {"request": "flow", "what": "step-decision"},
                        {"request": "console", "agent": "any", "line": "print s1"}):
            page.ask(**request)
            page.until(lambda message: message["message"] == "told" and "in the middle of a tick" in message["text"])
        page.ask(request="edit", file="FollowerAgent.lua")
        page.until_contents("edit", lambda edit: edit["edit"]["file"].endswith("FollowerAgent.lua"))
        page.ask(request="watch", nothing=True)
        self.assertIn("request watch", page.until_message("error")["error"])
        page.ask(request="flow", what="step-tick")
        page.until(lambda message: message["message"] == "flow" and message["paused"] and not message.get("stopped"))

    def test_the_tick_of_a_decision_stops_at_lines_too(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), WORLD, "edit", "script", "problems")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)
        page.ask(request="flow", what="pause")
        page.until(lambda message: message["message"] == "flow" and message["paused"])
        page.ask(request="edit", file=SCRIPT)
        page.ask(request="line-stop", file=SCRIPT, line=UPDATE)
        page.until_contents("edit", lambda edit: edit["edit"]["stops"] == [UPDATE])
        self.assertIsNone(page.contents["edit"]["stopped"], "the world is paused")
        for number in (1, 2):
            page.ask(request="flow", what="step-decision")
            self.assertEqual(self.stop(page, number)["stopped"]["line"], UPDATE)
            tick = page.until(lambda message: message["message"] == "flow" and message.get("stopped"))["tick"]
            page.ask(request="script-go", how="on")
            page.until(lambda message: message["message"] == "told" and ("decided" in message["text"] or "one decision" in message["text"]))
            page.until(lambda message: message["message"] == "flow" and message["paused"] and not message.get("stopped")
                       and message["tick"] == tick + 1)

    def test_a_script_goes_on_when_only_people_who_watch_are_left(self):
        server = self.serve()
        place = server.new_place()
        page = self.stopped_page(server, place)
        link = server.json("POST", f"/api/p/{place}/watch", b"")[1]["link"]
        watching = WebSocket(server, f"/api/w/{link.split('/')[2]}/watch")
        self.addCleanup(watching.close)
        tick = watching.until(lambda message: message["message"] == "flow" and message.get("stopped"))["tick"]
        left = time.monotonic()
        page.close()
        # Not in each tick again: the world runs as without stops.
        watching.until(lambda message: message["message"] == "flow" and message["tick"] > tick + 60)
        self.assertGreater(time.monotonic() - left, PATIENCE_ALONE_S - 1, "a page that is loaded again has some time")
        self.assertLess(time.monotonic() - left, 3 * PATIENCE_ALONE_S)
        back = self.page(server, place)
        back.ask(request="look", panels=["edit", "script"])
        self.stop(back, 2)

    def test_a_stop_with_a_condition_stops_when_it_is_true_or_has_no_value(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), WORLD, "edit", "script", "problems")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)
        page.ask(request="line-stop", file=SCRIPT, line=UPDATE, condition="agent:GetHealth() < 50")
        page.ask(request="edit", file=SCRIPT)
        page.until_contents("edit", lambda edit: edit["edit"].get("stop_conditions") == ["agent:GetHealth() < 50"])
        self.panel(page, "if agent:GetHealth() < 50")
        tick = page.until(lambda message: message["message"] == "flow")["tick"]
        page.until(lambda message: message["message"] == "flow" and message["tick"] > tick + 20 and not message.get("stopped"))
        page.ask(request="line-stop", file=SCRIPT, line=UPDATE, condition="agent:GetHealth() > 50")
        self.assertEqual(self.stop(page, 1)["stopped"]["line"], UPDATE)
        page.ask(request="line-stop", file=SCRIPT, line=UPDATE, condition="nothing.x")
        page.ask(request="script-go", how="on")
        self.stop(page, 2)
        self.panel(page, "the condition 'nothing.x' has no value")

    def test_a_long_stop_is_no_hang(self):
        server = self.serve("--hang", "2")
        page = self.stopped_page(server, server.new_place())
        time.sleep(5)
        page.ask(request="script-go", how="over")
        self.stop(page, 2)
        self.assertFalse([message for message in page.messages if message["message"] in ("ended", "busy")])

    def test_a_line_without_code_moves_the_stop_or_says_so(self):
        server = self.serve()
        page = self.stopped_page(server, server.new_place())
        page.ask(request="line-stop", file=SCRIPT, line=BLANK)
        page.until(lambda message: message["message"] == "told" and f"No function executes line {BLANK}" in message["text"])
        page.ask(request="line-stop", file=SCRIPT, line=4000)
        page.until(lambda message: message["message"] == "told" and "No stop at line 4000" in message["text"])
        page.ask(request="line-stop", file="followeragent.soar", line=1)
        page.until_contents("problems", lambda problems: "not a script" in json.dumps(problems))

    def test_a_changed_script_is_reloaded_after_the_tick_in_which_it_is_stopped(self):
        server = self.serve()
        page = self.stopped_page(server, server.new_place())
        text = page.contents["edit"]["edit"]["text"].replace("Steering_WalkToTarget(", "local answer = 42; Steering_WalkToTarget(")
        page.ask(request="edit-text", what="save", text=text)
        page.ask(request="edit-text", what="apply", text=text)
        page.until_contents("edit", lambda edit: edit["edit"]["notice"].startswith("Reloaded"))
        self.assertTrue(page.contents["edit"]["stopped"], "it is still stopped")
        page.ask(request="script-go", how="on")
        self.stop(page, 2)
        page.ask(request="script-go", how="over")
        self.stop(page, 3)
        self.panel(page, "answer")

    def test_the_name_of_a_chunk_opens_no_file(self):
        """A script chooses the names of the chunks that it loads: they may be those of any file."""
        server = self.serve()
        page = self.stopped_page(server, server.new_place())
        code = "loadstring('local seen = 1\\nerror(\"x\")', '@/proc/self/status')()"
        text = page.contents["edit"]["edit"]["text"].replace("Steering_WalkToTarget(", code + " Steering_WalkToTarget(")
        page.ask(request="edit-text", what="save", text=text)
        page.ask(request="edit-text", what="apply", text=text)
        page.until_contents("edit", lambda edit: edit["edit"]["notice"].startswith("Reloaded"))
        page.ask(request="line-stop", file=SCRIPT, line=UPDATE, is_on=False)
        page.ask(request="error-stop", is_on=True)
        page.ask(request="script-go", how="on")
        shown = json.dumps(self.panel(page, "seen")["document"])
        self.assertIn("/proc/self/status", shown, "the place is named")
        self.assertNotIn("VmPeak", shown)
        self.assertNotIn("/proc", json.dumps(page.contents["problems"]), "the editor does not try to open it")
        page.ask(request="line-stop", file="/proc/self/status.lua", line=1)
        page.until_contents("problems", lambda problems: "does not use this script" in json.dumps(problems))

    def test_a_wrong_call_in_a_watch_is_no_news_of_the_run(self):
        server = self.serve()
        page = self.stopped_page(server, server.new_place())
        page.ask(request="script-watch", what="agent:GetPosition(1, 2, 3)")
        self.panel(page, "GetPosition(1, 2, 3)")
        page.ask(request="script-go", how="on")
        self.stop(page, 2)
        self.assertNotIn("expected 1 arguments", json.dumps(page.contents["problems"]))

    def test_a_run_begins_again_although_a_script_is_stopped(self):
        server = self.serve()
        page = self.stopped_page(server, server.new_place())
        page.ask(request="flow", what="begin-again")
        page.until_message("hello")
        page.until_contents("edit", lambda edit: edit["edit"]["stops"] == [UPDATE])
        self.stop(page, 1)

    def test_a_page_that_closes_lets_the_world_go_on_and_nothing_hangs(self):
        server = self.serve()
        place = server.new_place()
        self.stopped_page(server, place).close()
        again = self.page(server, place)
        again.until(lambda message: message["message"] == "flow" and message.get("stopped"))
        again.close()
        time.sleep(PATIENCE_ALONE_S + 2)
        last = self.page(server, place)
        last.ask(request="look", panels=["edit", "script"])
        self.stop(last, 2)
        self.assertEqual(server.stop(), 0)


if __name__ == "__main__":
    unittest.main()
