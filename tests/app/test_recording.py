# SPDX-License-Identifier: BSD-2-Clause
"""Recordings contain what happened in the run, they can be simulated again, and damage to the file is reported."""
import csv
import io
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import tempfile
import time
import unittest

from soarbox_command import COMMAND, Run, end_with, new_folder, wait_until

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]

SECONDS = 12


class Recorded(unittest.TestCase):
    """One recorded run of the thesis' world, shared by the tests."""

    @classmethod
    def setUpClass(cls):
        cls.folder = new_folder(cls)
        cls.file = cls.folder / "run.soarrec"
        cls.live = Run("run", "thesis/mixed.lua", "--headless", "--json", "--report", 1, "--seconds", SECONDS, "--seed", 5,
                       "--record", cls.file, "--record-level", "all")

    def exported(self, file, *arguments):
        done = Run("export", file, "--json", *arguments, code=0)
        lines = [json.loads(line) for line in done.out.splitlines()]
        return lines[0], lines[1:]

    def copy(self, name, content):
        path = self.folder / name
        path.write_bytes(content)
        return path


class Replay(Recorded):
    def test_recording_changes_nothing_and_holds_the_live_run(self):
        self.assertEqual(self.live.code, 0, self.live.err)
        bare = Run("run", "thesis/mixed.lua", "--headless", "--json", "--report", 1, "--seconds", SECONDS, "--seed", 5)
        self.assertEqual(self.live.out, bare.out)
        head, ticks = self.exported(self.file)
        self.assertEqual(head["seed"], 5)
        self.assertEqual([tick["tick"] for tick in ticks], list(range(SECONDS * 30 + 1)))
        self.assertEqual(ticks[-1]["state"], self.live.of("end")[0]["state"])
        by_tick = {tick["tick"]: tick for tick in ticks}
        states = self.live.of("state")
        self.assertGreater(len(states), 5)
        for state in states:
            for agent, recorded in zip(state["agents"], by_tick[state["tick"]]["agents"], strict=True):
                self.assertEqual(agent["name"], recorded["name"])
                self.assertEqual(agent["position"], recorded["position"])

    def test_minds_are_told(self):
        _, ticks = self.exported(self.file)
        minds = [mind for tick in ticks for mind in tick.get("minds", [])]
        self.assertTrue(any("O: " in line for mind in minds for line in mind.get("decisions", [])))
        self.assertTrue(any(line.startswith("distance ") for mind in minds for line in mind.get("percepts", [])))
        self.assertTrue(any("fire " in line for mind in minds for line in mind.get("details", [])))
        self.assertTrue(any(mind.get("commands") for mind in minds))

    def test_reasons_are_told_with_decisions_and_commands(self):
        _, ticks = self.exported(self.file)
        reasons, rules = set(), set()
        for mind in (mind for tick in ticks for mind in tick.get("minds", [])):
            self.assertEqual(len(mind.get("reasons", [])), len(mind.get("decisions", [])))
            self.assertEqual(len(mind.get("command_rules", [])), len(mind.get("commands", [])))
            reasons.update(mind.get("reasons", []))
            rules.update(mind.get("command_rules", []))
        self.assertTrue(any("by rule " in reason for reason in reasons), reasons)
        # Each command was made by a rule that fired.
        fired = {line.split("fire ", 1)[1] for tick in ticks for mind in tick.get("minds", [])
                 for line in mind.get("details", []) if "fire " in line}
        self.assertTrue(rules - {""})
        self.assertLessEqual(rules - {""}, fired)

    def test_text_tells_a_range(self):
        done = Run("replay", self.file, "--headless", "--from", 2, "--to", 2.1, code=0)
        self.assertEqual([line.split()[3] for line in done.out.splitlines() if " tick " in line], ["60", "61", "62", "63"])

    def test_a_table_for_spreadsheets(self):
        Run("export", self.file, "--csv", "-o", self.folder / "run.csv", code=0)
        rows = list(csv.DictReader(io.StringIO((self.folder / "run.csv").read_text(encoding="utf-8"))))
        agents = {row["agent"] for row in rows}
        self.assertEqual(len(rows), (SECONDS * 30 + 1) * len(agents))
        self.assertTrue(all(float(row["time_s"]) >= 0 and float(row["x_m"]) == float(row["x_m"]) for row in rows))
        self.assertIn("distance", rows[0])
        self.assertTrue(any(row["distance"] for row in rows[len(agents) * 5:]))


class Part(Recorded):
    def test_a_part_is_a_recording_that_is_verified_and_resumed_like_the_whole(self):
        part = self.folder / "part.soarrec"
        done = Run("export", self.file, "--recording", "--from", 4, "--to", 6, "-o", part, code=0)
        whole = {tick["tick"]: tick for tick in self.exported(self.file)[1]}
        ticks = self.exported(part)[1]
        self.assertEqual([tick["tick"] for tick in ticks], list(range(120, 181)))
        self.assertEqual(ticks, [whole[tick["tick"]] for tick in ticks])
        done = Run("verify", part, code=0)
        self.assertIn("equal: ticks 120 to 180", done.out)
        done = Run("resume", part, "--at", 5, "--seconds", 1, "--json")
        self.assertEqual(done.of("end")[0]["state"], whole[180]["state"])

    def test_what_cannot_be_is_told(self):
        part = self.folder / "none.soarrec"
        done = Run("export", self.file, "--recording", "--from", 1000, "-o", part, code=3)
        self.assertIn("is not in the recording", done.err)
        done = Run("export", self.file, "--recording", "-o", self.file, code=3)
        self.assertIn("name another file", done.err)
        self.assertEqual(Run("export", self.file, "--recording").code, 2)
        self.assertEqual(Run("verify", self.file).code, 0)


class Verify(Recorded):
    def test_the_run_is_equal(self):
        done = Run("verify", self.file, code=0)
        self.assertIn(f"equal: ticks 0 to {SECONDS * 30}", done.out)

    def test_another_seed_is_found(self):
        other = self.folder / "other.soarrec"
        Run("run", "thesis/mixed.lua", "--headless", "--seconds", 2, "--seed", 6, "--record", other, "--record-level", "all")
        done = Run("compare", self.file, other, code=1)
        self.assertIn("first difference: tick ", done.out)

    def test_a_changed_rule_is_found_and_named(self):
        world = self.folder / "world"
        world.mkdir()
        (world / "scout.soar").write_text(RULES.format(speed=2), encoding="utf-8")
        file = self.folder / "scout.soarrec"
        done = Run("run", world / "scout.soar", "--headless", "--seconds", 3, "--record", file, code=0)
        self.assertEqual(Run("verify", file).code, 0)
        (world / "scout.soar").write_text(RULES.format(speed=3), encoding="utf-8")
        done = Run("verify", file, code=1)
        self.assertIn("files of the scenario have changed", done.err)
        self.assertRegex(done.out, r"tick \d+ .* differs: .*command")
        # The recording contains the files of the run: verify and resume use them.
        done = Run("verify", file, "--as-recorded", code=0)
        self.assertIn("made from them as they were then", done.err)
        again = self.folder / "again.soarrec"
        done = Run("resume", file, "--at", 1, "--record", again)
        self.assertIn("tick 30 reached", done.out, done.err)
        self.assertEqual(Run("compare", file, again).code, 0)
        head = self.exported(again)[0]
        self.assertEqual((head["branched_from"], head["branch_tick"]), (str(file), 30))
        (world / "scout.soar").unlink()
        gone = self.folder / "gone.soarrec"
        done = Run("resume", file, "--at", 1, "--record", gone)
        self.assertIn("tick 30 reached", done.out, done.err)
        self.assertEqual(Run("compare", file, gone).code, 0)


class EveryScenario(unittest.TestCase):
    def test_each_one_is_replayed_as_it_ran_and_verified(self):
        if os.environ.get("SOARBOX_SANITIZE"):
            self.skipTest("too slow with sanitizers")
        listed = Run("list")
        names = [line.split()[0] for line in listed.out.splitlines()]
        self.assertGreater(len(names), 15)
        with tempfile.TemporaryDirectory() as folder:
            for name in names:
                with self.subTest(name):
                    file = pathlib.Path(folder) / f"{name}.soarrec"
                    live = Run("run", name, "--headless", "--json", "--report", 0.1, "--seconds", 0.4, "--record",
                               file, code=0)
                    told = Run("replay", file, "--json")
                    ticks = {tick["tick"]: tick for tick in map(json.loads, told.out.splitlines()[1:])}
                    end = live.of("end")[0]
                    self.assertEqual(ticks[end["ticks"]]["state"], end["state"])
                    for state in live.of("state"):
                        positions = [agent["position"] for agent in ticks[state["tick"]]["agents"]]
                        self.assertEqual([agent["position"] for agent in state["agents"]], positions)
                    self.assertEqual(Run("verify", file).code, 0)


RULES = """
sp {{scout*propose*walk
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <o> + =)
   (<o> ^name walk)
}}
sp {{scout*apply*walk
   (state <s> ^operator.name walk ^io.output-link <out>)
-->
   (<out> ^set-speed <c>)
   (<c> ^speed {speed})
}}
"""


class Usual(unittest.TestCase):
    """Runs in a window are recorded automatically."""

    def test_the_last_five_are_kept(self):
        if not os.environ.get("DISPLAY"):
            self.skipTest("needs a display")
        with tempfile.TemporaryDirectory() as state:
            folder = pathlib.Path(state) / "soarbox" / "recordings"
            folder.mkdir(parents=True)
            for number in 3, 4, 5, 8, 12:
                (folder / f"run-{number:04}.soarrec").write_bytes(b"old")
            (folder / "mine.soarrec").write_bytes(b"the user's own")
            done = subprocess.run([COMMAND, "run", "thesis", "--seconds", "0.5", "--port", "0"], capture_output=True,
                                  env=dict(os.environ, XDG_STATE_HOME=state), text=True, timeout=200, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            names = sorted(path.name for path in folder.iterdir())
            self.assertEqual(names, ["mine.soarrec", *(f"run-{n:04}.soarrec" for n in (4, 5, 8, 12, 13))])
            self.assertIn(f"recording to {folder / 'run-0013.soarrec'}", done.stderr)
            self.assertEqual(Run("verify", folder / "run-0013.soarrec").code, 0)


class Abandoned(unittest.TestCase):
    def test_a_run_whose_reader_goes_away_ends_in_good_order_with_its_recording(self):
        with tempfile.TemporaryDirectory() as folder:
            kept = pathlib.Path(folder) / "run.soarrec"
            process = subprocess.Popen([COMMAND, "run", "thesis", "--headless", "--json", "--every-command", "--seconds", "3600", "--record", kept],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.assertIn(b'"begin"', process.stdout.readline())
            process.stdout.close()
            self.assertEqual((process.wait(timeout=240), process.stderr.read()), (128 + signal.SIGPIPE, b""))
            process.stderr.close()
            run = Run("verify", kept, code=0)
            self.assertTrue(run.out.startswith("equal: ticks 0 to "), run.out)


class Damage(Recorded):
    def test_any_end_of_the_file_is_told_and_the_rest_used(self):
        content = self.file.read_bytes()
        random.seed(1)
        used = 0
        for _ in range(20):
            cut = self.copy("cut.soarrec", content[:random.randrange(len(content))])
            done = Run("export", cut, "--csv")
            self.assertIn(done.code, (0, 3))
            if done.code == 3:
                self.assertIn("error", done.err)
            else:
                used += 1
        self.assertGreater(used, 5)

    def test_what_is_no_recording(self):
        for name, content in (("empty", b""), ("text", b"sp {a\n}"), ("magic", b"SOARBOX\x1a" + bytes(200))):
            for command in ("replay", "verify", "export"):
                done = Run(command, self.copy(name, content), code=3)
                self.assertIn("error", done.err)
        done = Run("verify", self.folder / "absent", code=3)
        self.assertIn("no such file", done.err)

    def test_killed_at_any_moment_the_complete_blocks_are_there(self):
        if os.environ.get("SOARBOX_SANITIZE"):
            self.skipTest("too slow with sanitizers")
        random.seed(2)
        used = 0
        for i in range(10):
            file = self.folder / f"killed{i}.soarrec"
            process = subprocess.Popen([COMMAND, "run", "thesis/mixed.lua", "--headless", "--seconds", "3600", "--record",
                                        str(file)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            wait_until(lambda: file.exists() and file.stat().st_size > 20000 + 4000 * (i + 1))
            time.sleep(random.random() * 0.05)
            process.send_signal(signal.SIGKILL)
            process.wait()
            done = Run("export", file, "--csv", "--to", 1, code=0)
            used += len(done.out.splitlines()) > 30
            if i == 0:
                self.assertEqual(Run("verify", file).code, 0)
        self.assertEqual(used, 10)


class Why(Recorded):
    def test_reasons_at_a_moment_of_a_recording_are_those_of_the_run(self):
        agent = self.exported(self.file, "--to", 0)[1][0]["agents"]
        names = [a["name"] for a in agent if a["kind"].startswith("soar")]
        moment = ("--agent", names[0], "--at", 4)
        recorded = Run("why", self.file, *moment)
        live = Run("why", "thesis/mixed.lua", "--seed", 5, *moment)
        self.assertEqual(recorded.code, 0, recorded.err)
        self.assertEqual(recorded.out, live.out)
        self.assertIn("operator", recorded.out)

    def test_without_a_moment_a_short_recording_is_explained_at_its_end(self):
        short = self.folder / "short.soarrec"
        Run("run", "thesis/mixed.lua", "--headless", "--seconds", 2, "--seed", 5, "--record", short)
        self.assertEqual(Run("why", short, code=0).out, Run("why", short, "--at", 2, code=0).out)
        Run("why", short, "--at", 3, code=3)

    def test_a_moment_or_an_agent_that_is_not_there(self):
        done = Run("why", self.file, "--at", 1000, code=3)
        self.assertIn("is not in the recording", done.err)
        done = Run("why", self.file, "--at", 1, "--agent", "nobody", code=3)
        self.assertIn("no agent 'nobody'", done.err)


class Resume(Recorded):
    def test_without_a_change_the_future_is_the_same(self):
        for threads in 1, 4:
            again = self.folder / f"again{threads}.soarrec"
            done = Run("resume", self.file, "--at", 5, "--record", again, "--json", "--threads", threads, code=0)
            self.assertEqual(done.of("end")[0]["state"], self.live.of("end")[0]["state"])
            Run("compare", self.file, again, code=0)

    def test_with_a_changed_rule_it_is_told_where_they_part(self):
        rules = self.folder / "halt.soar"
        rules.write_text("sp {stop*here (state <s> ^superstate nil) --> (halt)}\n", encoding="utf-8")
        again = self.folder / "stopped.soarrec"
        done = Run("resume", self.file, "--at", 5, "--rules", rules, "--record", again, "--seconds", 2)
        self.assertIn("tick 150 reached", done.out, done.err)
        compared = Run("compare", self.file, again, code=1)
        self.assertRegex(compared.out, r"first difference: tick 15\d")
        Run("verify", again, code=0)

    def test_a_moment_that_is_not_there(self):
        done = Run("resume", self.file, "--at", 1000, code=3)
        self.assertIn("is not in the recording", done.err)


class OfAMatch(unittest.TestCase):
    """The process that plays a match of a tournament for a server."""

    def reason(self, state):
        """Why it ended: the text that it sends to the server."""
        match = REPOSITORY / "scenarios" / "soar_skirmish"
        ours, theirs = socket.socketpair()
        with ours:
            with theirs:
                engine = end_with(self, subprocess.Popen(
                    ["sh", "-c", 'exec "$@" 3<&0 </dev/null', "sh", COMMAND, "engine", "--match", match, "--seconds", "1",
                     "--home", state.parent],
                    stdin=theirs.fileno(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                    env={**os.environ, "XDG_STATE_HOME": str(state)}))
            ours.settimeout(120)
            sent = b""
            while got := ours.recv(65536):
                sent += got
        self.assertEqual(engine.wait(120), 3)
        self.assertEqual((sent[:1], int.from_bytes(sent[1:5], "little")), (b"e", len(sent) - 5))
        return sent[5:].decode()

    def test_that_cannot_be_written_is_the_reason_of_the_end(self):
        folder = new_folder(self)
        self.assertIn("this recording cannot be written: No such file", self.reason(folder / "missing"))
        (folder / "full").mkdir()
        (folder / "full" / "match.soarrec").symlink_to("/dev/full")
        self.assertIn("No space left on device", self.reason(folder / "full"))
