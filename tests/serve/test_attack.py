# SPDX-License-Identifier: BSD-2-Clause
"""Attacks of one hostile learner on a server, and their effects on others. The tests check its answers and limit its
processor time and memory. They do not check the time of an answer, because it depends on the load of the machine (combined.py measures it)."""
import io
import json
import os
import pathlib
import signal
import socket
import stat
import subprocess
import threading
import time
import unittest
import zipfile

from combined import Combined, cpu_s, memory_mb, most_memory_mb
from web_client import COMMAND, ServeCase

# Maximum processor seconds of one attack, with a margin for slow machines and checked builds: before there were limits, one message took 50.
MOST_WORK_S = 5


class Attack(ServeCase):
    def assert_others_are_served(self, server, before_s):
        """Another page gets an answer, and the server has used little processor time since the given value."""
        for _ in range(10):
            self.assertLess(server.http("GET", "/")[0], 500)
        self.assertLess(cpu_s(server.process.pid) - before_s, MOST_WORK_S)

    def when_allowed(self, server, method, path, body=None):
        """The answer to a request, which is sent again while the server asks to wait (429)."""
        answer = server.http(method, path, body)
        while answer[0] == 429:
            time.sleep(0.5)
            answer = server.http(method, path, body)
        return answer


class Messages(Attack):
    def test_a_message_with_many_keys_is_refused_at_once(self):
        server = self.serve()
        page = self.page(server, server.new_place())
        page.until_message("none")
        before_s = cpu_s(server.process.pid)
        page.send_frame(1, json.dumps({f"{i:05}": 0 for i in range(80_000)}).encode())
        self.assert_others_are_served(server, before_s)
        self.assertIn("at most 256 fields", page.until_message("error")["hint"])

    def test_deep_and_long_messages_are_refused(self):
        server = self.serve()
        page = self.page(server, server.new_place())
        page.until_message("none")
        for text in ('{"request":"x","a":' + "[" * 70 + "]" * 70 + "}", json.dumps({"request": "x", "a": [0] * 30_000}), "[" * 500_000):
            page.send_frame(1, text.encode())
            self.assertIn("not a request", page.until_message("error")["error"])
        # Input below the limits is accepted after such messages.
        page.send_frame(1, json.dumps({"a": {"request": "y", "id": 1}, "request": "x", "id": "mine", "b": [["id"]]}).encode())
        answer = page.until_message("error")
        self.assertEqual((answer["id"], answer["error"]), ("mine", "there is no run"))

    def test_bytes_are_charged_as_well_as_messages(self):
        server = self.serve()
        page = self.page(server, server.new_place())
        page.until_message("none")
        # Each costs 16 points. A page has 1,000 points and gets 100 per second.
        frame, is_refused = page.frame(1, json.dumps({"request": "x", "a": "b" * 1_000_000}).encode()), threading.Event()

        def flood():
            while not is_refused.is_set():
                page.socket.sendall(frame)
        flooding = threading.Thread(target=flood)
        flooding.start()
        try:
            page.until(lambda message: message["message"] == "error" and "more than this server allows" in message["error"])
            # From now on the server reads its messages once per second.
            self.assert_others_are_served(server, cpu_s(server.process.pid))
        finally:
            is_refused.set()
            flooding.join()


class Processes(Attack):
    def test_a_place_has_one_process_however_often_it_opens(self):
        server = self.serve()
        page = self.page(server, server.new_place())
        page.until_message("none")
        for i in range(100):
            page.ask(request="open", what="scenario:soar_hallway" if i % 2 else "scenario:thesis")
        counts, is_over = [], threading.Event()

        def count():
            while not is_over.is_set():
                counts.append(len(server.engines()))
                time.sleep(0.02)
        counting = threading.Thread(target=count)
        counting.start()
        try:
            page.until(lambda message: message["message"] == "hello" and message["what"] == "scenario:soar_hallway")
        finally:
            is_over.set()
            counting.join()
        self.assertEqual(max(counts), 1)
        self.assertEqual(len(server.engines()), 1)
        page.ask(request="flow", what="pause")
        page.until(lambda message: message["message"] == "flow" and message["paused"])
        self.assertEqual([message["what"] for message in page.messages if message["message"] == "hello"][-1], "scenario:soar_hallway", "the last one counts")

    def test_runs_are_limited_by_address_and_pages_without_a_run_hold_no_room(self):
        server = self.serve("--sessions", "2", "--each", "1")
        idle = [self.page(server, server.new_place()) for _ in range(4)]
        for page in idle:
            page.until_message("none")
        self.opened(server, server.new_place(), "scenario:soar_hallway")
        idle[0].ask(request="open", what="scenario:soar_hallway")
        self.assertIn("your address already runs", idle[0].until_message("error")["error"])

    def test_a_run_that_hangs_is_told_unasked_and_ended(self):
        server = self.serve("--hang", "20")
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "agents")
        page.until(lambda message: message["message"] == "flow" and message["tick"] > 3)
        engine = server.engines()[0]
        os.kill(engine, signal.SIGSTOP)
        told = page.until(lambda message: message["message"] in ("busy", "ended"))
        self.assertEqual(told["message"], "busy", "it is told, unasked, before the run is ended")
        self.assertIn("has not answered for 20 s", page.until_message("ended")["text"])
        self.wait_for(lambda: not server.engines(), "the process is gone")
        page.ask(request="open", what="scenario:soar_hallway")
        page.until_message("hello")


class Disk(Attack):
    def test_folders_count_and_go_when_empty(self):
        server = self.serve()
        place = server.new_place()
        home = self.folder / "state" / "places" / place / "home"
        self.assertEqual(server.json("PUT", f"/api/p/{place}/files/a/b/c/x", b"1")[0], 200)
        self.assertEqual(server.json("DELETE", f"/api/p/{place}/files/a/b/c/x")[0], 200)
        self.assertEqual(list(home.iterdir()), [])
        statuses = []
        for i in range(60):
            statuses.append(self.when_allowed(server, "PUT", f"/api/p/{place}/files/{i}/a/b/c/d/e/f/x", b"1")[0])
        self.assertIn(400, statuses)
        self.assertLessEqual(sum(1 for path in home.rglob("*") if path.is_dir()), 256)

    def test_a_file_called_part_is_a_file_like_others(self):
        server = self.serve()
        place = server.new_place()
        for name, text in (("a.soar.part", b"mine"), ("a.soar", b"other")):
            self.assertEqual(server.http("PUT", f"/api/p/{place}/files/{name}", text)[0], 200)
        self.assertEqual(server.http("GET", f"/api/p/{place}/files/a.soar.part")[2], b"mine")
        self.assertEqual(list((self.folder / "state" / "places" / place / "parts").iterdir()), [])

    def test_requests_over_http_are_charged(self):
        server = self.serve()
        place, other = server.new_place(), server.new_place()
        archive = io.BytesIO()
        with zipfile.ZipFile(archive, "w") as writing:
            for i in range(256):
                writing.writestr(str(i), os.urandom(10_000))
        self.assertEqual(server.http("POST", f"/api/p/{place}/zip", archive.getvalue())[0], 200)
        statuses = [server.http("GET", f"/api/p/{place}/zip")[0] for _ in range(20)]
        self.assertIn(429, statuses)
        self.assertEqual(server.http("GET", f"/api/p/{other}")[0], 200, "another place is served")

    def test_downloads_are_not_held_in_memory(self):
        server = self.serve()
        place = server.new_place()
        recordings = self.folder / "state" / "places" / place / "state" / "soarbox" / "recordings"
        recordings.mkdir(parents=True)
        (recordings / "big.soarrec").write_bytes(os.urandom(1 << 20) * 16)
        sleepers, before_s = [], cpu_s(server.process.pid)
        for _ in range(40):
            sleeper = socket.create_connection(("127.0.0.1", server.port), timeout=60)
            self.addCleanup(sleeper.close)
            sleeper.sendall(f"GET /api/p/{place}/recordings/big.soarrec HTTP/1.1\r\nHost: {server.host}\r\n\r\n".encode())
            sleepers.append(sleeper)
        self.assert_others_are_served(server, before_s)
        self.assertLess(memory_mb(server.process.pid), most_memory_mb(server.process.pid))
        # The requests of the sleepers may still wait in the queue of the place.
        status, _, got = self.when_allowed(server, "GET", f"/api/p/{place}/recordings/big.soarrec")
        self.assertEqual((status, len(got)), (200, 16 << 20))


class Secrets(Attack):
    def test_the_right_token_works_whatever_others_have_tried(self):
        server = self.serve("--token", "sesame")
        for _ in range(12):
            server.http("POST", "/api/places", b"", Authorization="Bearer wrong")
        self.assertEqual(server.http("POST", "/api/places", b"", Authorization="Bearer wrong")[0], 429)
        self.assertEqual(server.http("POST", "/api/places", b"", Authorization="Bearer sesame")[0], 200)

    def test_a_token_comes_from_a_file(self):
        (self.folder / "token").write_text("from-a-file\n", encoding="utf-8")
        server = self.serve("--token-file", self.folder / "token")
        self.assertEqual(server.http("POST", "/api/places", b"", Authorization="Bearer from-a-file")[0], 200)
        self.assertEqual(server.http("POST", "/api/places", b"")[0], 401)
        self.assertNotIn(b"from-a-file", pathlib.Path(f"/proc/{server.process.pid}/cmdline").read_bytes())

    def test_a_token_that_browsers_cannot_send_is_refused_at_the_start(self):
        with self.assertRaisesRegex(AssertionError, "this token cannot be used"):
            self.serve("--token", "a, b")

    def test_places_are_seen_by_their_owner_alone(self):
        server = self.serve()
        place = server.new_place()
        for folder in (self.folder / "state", self.folder / "state" / "places"):
            self.assertEqual(stat.S_IMODE(folder.stat().st_mode), 0o700)
        page = self.opened(server, place, "lesson:01-a-rule", "mission", "edit", "console")
        edit = page.until_contents("edit", lambda edit: edit["files"])
        page.ask(request="edit", file=edit["files"][0]["file"])
        page.until_contents("edit", lambda edit: edit["edit"]["text"])
        page.ask(request="edit-text", what="save", text="sp {broken (state <s> --> }")
        page.until_contents("edit", lambda edit: edit["edit"]["notice"] == "Saved.")
        page.ask(request="lesson", what="grade")
        page.until_contents("mission", lambda mission: mission["lesson"]["grade"])
        page.ask(request="console", agent=next(m for m in page.messages if m["message"] == "hello")["minds"][0], line="pwd")
        page.ask(request="flow", what="pause")
        page.until(lambda message: message["message"] == "flow" and message["paused"])
        for engine in server.engines():
            self.assertNotIn(place.encode(), pathlib.Path(f"/proc/{engine}/cmdline").read_bytes())
        self.assertNotIn(place, json.dumps(page.messages))
        self.assertIn("/place/", edit["files"][0]["file"])


class Wall(Attack):
    def rights(self, pid):
        """The restrictions of a process: its network, whether it may gain privileges, and filtered system calls."""
        lines = dict(line.split(":", 1) for line in pathlib.Path(f"/proc/{pid}/status").read_text(encoding="utf-8").splitlines())
        return os.readlink(f"/proc/{pid}/ns/net"), lines["NoNewPrivs"].strip(), lines["Seccomp"].strip(), lines.get("Seccomp_filters", "").strip()

    def begin(self, *options):
        server = self.serve(*options)
        self.opened(server, server.new_place(), "lesson:01-a-rule")
        return self.rights(server.process.pid), self.rights(server.engines()[0]), (self.folder / "server.err").read_text(encoding="utf-8")

    def test_a_world_has_the_wall_that_the_server_does_not_call_missing(self):
        own, engine, notes = self.begin()
        self.assertEqual(engine[1], "1", "no new privileges")
        self.assertEqual(engine[0] == own[0], "user namespaces" in notes, notes)
        if "seccomp" not in notes:
            self.assertEqual(engine[2], "2")
            self.assertTrue(engine[3] == "" or int(engine[3]) > int(own[3]))

    def test_the_wall_can_be_left_out(self):
        own, engine, notes = self.begin("--no-wall")
        self.assertEqual(engine, own)
        self.assertIn("--no-wall", notes)

    def test_a_world_beside_an_exercise_keeps_the_network(self):
        own, engine, _ = self.begin("--dis")
        self.assertEqual((engine[0], engine[1]), (own[0], "1"))


class Tabs(Attack):
    def test_one_tab_edits_and_another_may_take_over(self):
        server = self.serve()
        place = server.new_place()
        one = self.opened(server, place, "lesson:01-a-rule", "edit")
        one.ask(request="edit", file=one.until_contents("edit", lambda edit: edit["files"])["files"][0]["file"])
        one.until_contents("edit", lambda edit: edit["edit"]["text"])
        two = self.page(server, place)
        self.assertFalse(two.until_message("tabs")["may_type"])
        two.until_message("hello")
        two.ask(request="edit-text", what="type", text="# two")
        self.assertIn("another tab", two.until_message("error")["error"])
        two.ask(request="take-over")
        self.assertTrue(two.until_message("tabs")["may_type"])
        one.until(lambda message: message["message"] == "tabs" and not message["may_type"])
        one.ask(request="edit-text", what="save", text="# one, over it")
        self.assertIn("another tab", one.until_message("error")["error"])
        two.ask(request="edit-text", what="type", text="# two")
        two.until_contents("edit", lambda edit: edit["edit"]["text"] == "# two" or edit["edit"]["is_unsaved"])
        two.close()
        one.until(lambda message: message["message"] == "tabs" and message["may_type"])

    def test_a_tab_that_connects_again_is_the_same(self):
        server = self.serve()
        place = server.new_place()
        from web_client import WebSocket
        pages = [WebSocket(server, f"/api/p/{place}/run?tab=x{i}") for i in (1, 2, 1)]
        for page in pages:
            self.addCleanup(page.close)
        self.assertTrue(pages[2].until_message("tabs")["may_type"])

    def test_what_is_typed_survives_a_kill_soon_after(self):
        server = self.serve()
        place = server.new_place()
        page = self.opened(server, place, "lesson:01-a-rule", "edit")
        page.ask(request="edit", file=page.until_contents("edit", lambda edit: edit["files"])["files"][0]["file"])
        page.until_contents("edit", lambda edit: edit["edit"]["text"])
        for i in range(5):
            page.ask(request="edit-text", what="type", text=f"# thought {i}\n")
            # The draft is on the disk before the engine confirms the text.
            page.until_contents("edit", lambda edit, i=i: f"thought {i}" in edit["edit"]["text"])
            os.kill(server.engines()[0], signal.SIGKILL)
            page.until_message("ended")
            page.contents.clear()
            page.ask(request="open", what="lesson:01-a-rule")
            page.until_message("hello")
            page.ask(request="look", panels=["edit"])
            page.ask(request="edit", file=page.until_contents("edit", lambda edit: edit["files"])["files"][0]["file"])
            page.until_contents("edit", lambda edit, i=i: f"thought {i}" in edit["edit"]["text"])


class Together(ServeCase):
    def test_a_class_goes_on_while_all_attacks_run_at_once(self):
        combined = Combined(self.folder, 3)
        self.addCleanup(lambda: combined.server.process.poll() is None and combined.server.kill())
        combined.run(10, least_answers=5)
        self.assertEqual(len(combined.rounds), 11, combined.rounds)
        self.assertEqual({status for _, status in combined.waits}, {200})
        self.assertLess(combined.memory_mb, combined.most_memory_mb)
        for learner in combined.learners:
            self.assertEqual((learner.fault, learner.refusals), (None, []))
            self.assertGreaterEqual(len(learner.answers), 5)
            self.assertGreater(learner.tick, 0)


class Rules(Attack):
    def test_a_refusal_names_the_command_and_no_folder_of_the_server(self):
        server = self.serve()
        page = self.opened(server, server.new_place(), "scenario:soar_hallway", "console")
        agent = next(message for message in page.messages if message["message"] == "hello")["minds"][0]
        for line in ("ls", "pwd", "source /etc/passwd"):
            page.ask(request="console", agent=agent, line=line)
        page.ask(request="console", agent=agent, line="echo the end")
        lines = page.until_printed("the end")
        self.assertIn("'ls'", lines)
        self.assertNotIn("Type it yourself", lines)
        self.assertNotIn(str(self.folder), lines)


class Exercises(ServeCase):
    def test_a_world_of_somebody_else_joins_no_network_unasked(self):
        world = self.folder / "world"
        world.mkdir()
        (world / "scenario.toml").write_text('[dis]\naddress = "127.255.255.255"\nport = 23290\nsite = 1\napplication = 2\n[[agent]]\nname = "a"\n', encoding="utf-8")

        def run(address, *options):
            text = (world / "scenario.toml").read_text(encoding="utf-8")
            (world / "scenario.toml").write_text(text.replace("127.255.255.255", address).replace("192.0.2.255", address), encoding="utf-8")
            done = subprocess.run([COMMAND, "run", world, "--headless", "--seconds", "0.2", *options], capture_output=True, text=True, check=False)
            return done.stdout + done.stderr
        self.assertNotIn("--dis", run("127.255.255.255"))
        self.assertIn("joins no exercise", run("192.0.2.255"))


if __name__ == "__main__":
    unittest.main()
