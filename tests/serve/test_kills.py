# SPDX-License-Identifier: BSD-2-Clause
"""Server and world processes are killed at random moments while a user types, saves, requests hints, grades and uploads. Nothing is lost after the
server has confirmed it to the page. SOARBOX_KILLS is the number of kills; 100 take some minutes."""
import os
import pathlib
import random
import signal
import threading
import unittest

from web_client import LESSONS, Gone, Server, ServeCase, WebSocket

KILLS = int(os.environ.get("SOARBOX_KILLS", "8"))
LESSON = "01-a-rule"
SOLUTION = next((LESSONS / LESSON / "solution").glob("*.soar")).read_text(encoding="utf-8")
MARK = "# thought "


def text_of(number):
    return f"{SOLUTION}\n{MARK}{number}\n"


def number_in(text):
    return int(text.rsplit(MARK, 1)[1].split()[0]) if MARK in text else 0


def is_alive(pid):
    """Whether a process is running. Ended processes may remain as zombies."""
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


class Learner:
    """Performs one action after another until a process is killed. `kept`: the increasing numbers of the last confirmed actions."""

    def __init__(self):
        self.kept = {"typed": 0, "saved": 0, "uploaded": 0, "hints": 0, "passed": 0}
        self.number = 0

    def begin(self, server, place):
        self.server, self.place = server, place
        self.page = WebSocket(server, f"/api/p/{place}/run?tab=learner")
        self.page.ask(request="open", what="lesson:" + LESSON)
        begun = self.page.until(lambda message: message["message"] in ("hello", "error"))
        assert begun["message"] == "hello", begun
        self.page.ask(request="look", panels=["edit", "mission"])
        self.file = self.page.until_contents("edit", lambda edit: edit["files"])["files"][0]["file"]
        self.page.ask(request="edit", file=self.file)
        # The server writes the file first, then the draft.
        edit = self.page.until_contents("edit", lambda edit: number_in(edit["edit"]["text"]) >= self.kept["typed"] and edit["edit"]["text"])
        return edit["edit"]["text"]

    def until_answered(self):
        """Waits for one more answer. Requests are processed in order, so all previous ones are done then."""
        for what, is_paused in (("pause", True), ("go-on", False)):
            self.page.ask(request="flow", what=what)
            self.page.until(lambda message, is_paused=is_paused: self.goes_on(message) and message["message"] == "flow" and message["paused"] == is_paused)

    @staticmethod
    def goes_on(message):
        if message["message"] == "ended":
            raise Gone()
        return True

    def until_mission(self, accepts):
        self.page.until(lambda message: self.goes_on(message) and "mission" in self.page.contents and accepts(self.page.contents["mission"]["lesson"]))

    def type(self):
        self.page.ask(request="edit-text", what="type", text=text_of(self.number))
        self.until_answered()
        self.kept["typed"] = self.number

    def save(self):
        self.page.ask(request="edit-text", what="save", text=text_of(self.number))
        self.until_answered()
        if self.page.contents["edit"]["edit"]["notice"] == "Saved.":
            self.kept["typed"] = self.kept["saved"] = self.number

    def upload(self):
        if self.server.http("PUT", f"/api/p/{self.place}/files/notes.txt", text_of(self.number).encode())[0] == 200:
            self.kept["uploaded"] = self.number

    def hint(self):
        known = len(self.page.contents["mission"]["lesson"]["hints"]) if "mission" in self.page.contents else 0
        if known < 3:
            self.page.ask(request="lesson", what="hint")
            self.until_mission(lambda lesson: len(lesson["hints"]) > known)
            self.kept["hints"] = max(self.kept["hints"], known + 1)

    def grade(self):
        self.page.ask(request="lesson", what="grade")
        self.until_mission(lambda lesson: lesson["grade"] and not lesson["is_graded"])
        if self.page.contents["mission"]["lesson"]["is_passed"]:
            self.kept["passed"] = 1

    def work(self, chance):
        while True:
            self.number += 1
            chance.choice([self.type, self.type, self.type, self.save, self.upload, self.hint, self.grade])()


class Kills(ServeCase):
    def start(self):
        server = Server(self.folder)
        self.addCleanup(lambda: server.process.poll() is None and server.kill())
        return server

    def test_nothing_is_lost_that_was_called_kept(self):
        chance = random.Random(20261129)
        server = self.start()
        place, learner, kinds = server.new_place(), Learner(), {"server": 0, "world": 0}
        learner.begin(server, place)
        for act in (learner.type, learner.save, learner.upload, learner.hint, learner.grade):
            learner.number += 1
            act()
        for round_ in range(KILLS):
            kind = chance.choice(["server", "world", "world"])
            victim = server.process.pid if kind == "server" else server.engines()[0]
            killer = threading.Timer(chance.uniform(0, chance.choice([1, 3, 9])), os.kill, (victim, signal.SIGKILL))
            killer.start()
            try:
                learner.work(chance)
            except TimeoutError as error:
                raise AssertionError(f"no answer; the last messages: {learner.page.messages[-5:]}") from error
            except (Gone, OSError):
                pass
            killer.join()
            kinds[kind] += 1
            learner.page.close()
            if kind == "server":
                server.process.wait()
                server.close()
                server = self.start()
            text = learner.begin(server, place)
            with self.subTest(round=round_, killed=kind, kept=dict(learner.kept), begun=learner.number):
                self.assertGreaterEqual(number_in(text), learner.kept["typed"], "typed")
                self.check(server, place, learner)
        for number in learner.kept.values():
            self.assertGreater(number, 0, f"what is acknowledged is compared: {learner.kept}")
        self.assertTrue(any(self.opens(learner.page, each["name"]) for each in server.json("GET", f"/api/p/{place}")[1]["recordings"]))
        learner.page.close()
        print(f"killed {kinds}; acknowledged {learner.kept}")

    def opens(self, page, name):
        """Whether a recording can be opened. It is empty if the world was killed before its first tick."""
        what = "recording:" + name
        page.ask(request="open", what=what)
        return page.until(lambda message: message["message"] in ("error", "ended") or message.get("what") == what)["message"] == "hello"

    def test_a_world_that_hangs_ends_with_its_server(self):
        server = self.start()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway")
        mind = next(message for message in page.messages if message["message"] == "hello")["minds"][0]
        page.ask(request="console", agent=mind, line="run 100000000")
        page.until_message("busy")
        engine = server.engines()[0]
        server.kill()
        self.wait_for(lambda: not is_alive(engine), "the process of the world is gone")

    def check(self, server, place, learner):
        path = learner.file.removeprefix("/place/home/")
        status, _, saved = server.http("GET", f"/api/p/{place}/files/{path}")
        self.assertEqual(status, 200, path)
        saved = saved.decode()
        self.assertGreaterEqual(number_in(saved), learner.kept["saved"], "saved")
        if learner.kept["uploaded"]:
            notes = server.http("GET", f"/api/p/{place}/files/notes.txt")[2].decode()
            self.assertGreaterEqual(number_in(notes), learner.kept["uploaded"], "uploaded")
        lesson = learner.page.until_contents("mission", lambda mission: mission["lesson"])["lesson"]
        self.assertGreaterEqual(len(lesson["hints"]), learner.kept["hints"], "hints")
        self.assertGreaterEqual(int(lesson["is_passed"]), learner.kept["passed"], "passed")
        # The recording of the killed run can be opened.
        about = server.json("GET", f"/api/p/{place}")[1]
        self.assertTrue(about["recordings"])


if __name__ == "__main__":
    unittest.main()
