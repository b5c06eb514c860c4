# SPDX-License-Identifier: BSD-2-Clause
"""Runs of the real command in exercises with other programs, with real datagrams over the network of this machine."""
import json
import math
import os
import pathlib
import random
import shutil
import signal
import subprocess
import tempfile
import unittest

import exercise

COMMAND = os.environ["SOARBOX"]
SKIRMISH = pathlib.Path(__file__).resolve().parents[2] / "scenarios" / "soar_skirmish"
NODE_MODULES = os.environ.get("SOARBOX_DIS_NODE_MODULES", "")
GUARD = """
description = "A guard that stands"
seconds = 60
[dis]
address = "239.1.2.3"
application = 1
%s
[[agent]]
name = "guard"
rules = "guard.soar"
body = "soldier"
team = "blue"
position = [0, 0]
"""
# It prints what it perceives of foreign agents, and sends it to its team.
GUARD_RULES = """
sp {guard*propose*wait
   (state <s> ^superstate nil)
-->
   (<s> ^operator <o> +)
   (<o> ^name wait)}
sp {guard*note*foreign
   (state <s> ^superstate nil ^io.input-link.agent <a>)
   (<a> ^foreign yes ^name <n> ^kind <k> ^team <t> ^relation <r>)
-->
   (write (crlf) |sees | <n> | | <k> | | <t> | | <r>)}
sp {guard*note*hit
   (state <s> ^superstate nil ^io.input-link.event <e>)
   (<e> ^type hit ^by <by>)
-->
   (write (crlf) |hit by | <by>)}
"""


def free_port():
    import socket
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Running:
    """A run of the command in the background."""

    def __init__(self, *arguments):
        environment = dict(os.environ)
        environment.pop("DISPLAY", None)
        self.process = subprocess.Popen([COMMAND, "run", *map(str, arguments), "--headless", "--json"],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)

    def events_until(self, wanted):
        """Reads its events up to the first one for which `wanted` is true; ends with None if there is none."""
        events = []
        for line in self.process.stdout:
            if line.startswith("{"):
                events.append(json.loads(line))
                if wanted(events[-1]):
                    return events
        return events + [None]

    def finish(self):
        self.process.send_signal(signal.SIGINT)
        out, self.err = self.process.communicate(timeout=120)
        return [json.loads(line) for line in out.splitlines() if line.startswith("{")]


def is_news(event, news, agent=None):
    return event["event"] == "news" and event["news"] == news and agent in (None, event["agent"])


class Exercise(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.port = free_port()
        self.member = exercise.Member(self.port)
        self.addCleanup(self.member.close)

    def start(self, *arguments, port=None, application=None):
        place = f"239.1.2.3:{port or self.port}" + (f",1,{application}" if application else "")
        run = Running(*arguments, "--dis", place)
        self.addCleanup(lambda: (run.process.kill(), run.process.wait(), run.process.stdout.close(),
                                 run.process.stderr.close()))
        return run

    def guard(self, options="", **more):
        (self.folder / "guard.toml").write_text(GUARD % f"port = {self.port}\n{options}", encoding="utf-8")
        (self.folder / "guard.soar").write_text(GUARD_RULES, encoding="utf-8")
        run = self.start(self.folder / "guard.toml", "--record", self.folder / "guard.soarrec", **more)
        heard = self.member.hear_until(lambda datagram: exercise.kind_of(datagram) == 1)
        self.assertIsNotNone(heard[-1], "the guard is told of")
        return run, heard[-1]

    def keep_saying(self, datagrams, run, wanted):
        """Sends these repeatedly, as a real simulation does, until the run reports the wanted event."""
        import threading
        over = threading.Event()

        def say():
            while not over.is_set():
                for datagram in datagrams:
                    self.member.say(datagram)
                over.wait(0.05)
        speaker = threading.Thread(target=say)
        speaker.start()
        try:
            return run.events_until(wanted)
        finally:
            over.set()
            speaker.join()

    def test_an_agent_is_where_the_standard_says_it_is(self):
        run, state = self.guard()
        self.assertEqual(exercise.entity_of(state), (1, 1, 1))
        expected = exercise.on_earth(0, 0, 0)
        self.assertLess(math.dist(exercise.place_of(state), expected), 0.05)
        self.assertEqual(state[129:140].rstrip(b"\0"), b"guard")
        run.finish()

    def test_a_foreign_entity_is_perceived_hits_and_leaves(self):
        run, _ = self.guard()
        visitor = exercise.entity_state((7, 8, 9), exercise.on_earth(0, 0, 8))
        events = self.keep_saying([visitor], run, lambda e: e["event"] == "log" and "sees" in e["text"])
        self.assertIn("sees visitor soldier red enemy", events[-1]["text"])
        shot = exercise.detonation((7, 8, 9), (1, 1, 1), exercise.on_earth(0, 1, 0))
        self.member.say(visitor)
        self.member.say(shot)
        events = self.keep_saying([visitor], run, lambda e: e["event"] == "log" and "hit by" in e["text"])
        self.assertIn("hit by visitor", events[-1]["text"])
        # The run announces that it leaves.
        self.member.say(exercise.entity_state((7, 8, 9), exercise.on_earth(0, 0, 8), appearance=1 << 23 | 1 << 16))
        events = run.events_until(lambda e: is_news(e, "leaves"))
        self.assertIsNotNone(events[-1])
        run.finish()
        # The recording contains the received PDUs: the run can be repeated without a network, bit for bit.
        verified = subprocess.run([COMMAND, "verify", self.folder / "guard.soarrec"], capture_output=True, text=True,
                                  check=False)
        self.assertEqual(verified.returncode, 0, verified.stderr)
        self.assertIn("equal", verified.stdout)

    def test_shots_at_ours_in_numbers_kill(self):
        run, _ = self.guard()
        visitor = exercise.entity_state((7, 8, 9), exercise.on_earth(0, 0, 8))
        shot = exercise.detonation((7, 8, 9), (1, 1, 1), exercise.on_earth(0, 1, 0))
        events = self.keep_saying([visitor, shot], run, lambda e: is_news(e, "dies", "guard"))
        self.assertIn("shot by visitor", events[-1]["text"])
        # The other members are informed.
        heard = self.member.hear_until(
            lambda d: exercise.kind_of(d) == 1 and exercise.entity_of(d) == (1, 1, 1) and exercise.damage_of(d) == 3)
        self.assertIsNotNone(heard[-1])
        run.finish()

    def test_who_is_silent_leaves(self):
        run, _ = self.guard("timeout = 0.3")
        self.keep_saying([exercise.entity_state((7, 8, 9), exercise.on_earth(0, 0, 8))], run,
                         lambda e: e["event"] == "log" and "sees" in e["text"])
        events = run.events_until(lambda e: is_news(e, "leaves"))
        self.assertEqual(events[-1]["agent"], "visitor")
        run.finish()

    def test_orders_are_obeyed_only_where_the_scenario_says_so(self):
        run, _ = self.guard("takes_orders = true")
        self.member.say(exercise.order(14, (1, 1, 0)))
        heard = self.member.hear_until(lambda d: exercise.kind_of(d) == 15)
        self.assertIsNotNone(heard[-1], "it acknowledges")
        self.assertEqual(heard[-1][24:26], b"\0\4")
        # The entity does not move, and its PDUs contain this.
        heard = self.member.hear_until(lambda d: exercise.kind_of(d) == 1 and d[85] & 0x20)
        self.assertIsNotNone(heard[-1])
        self.member.say(exercise.order(13, (65535, 65535, 0)))
        heard = self.member.hear_until(lambda d: exercise.kind_of(d) == 15)
        self.assertEqual(heard[-1][24:26], b"\0\3")
        # Other programs cannot add or remove entities of its world: it answers that it is unable to comply.
        for kind, flag in ((11, 1), (12, 2)):
            self.member.say(exercise.order(kind, (1, 1, 1)))
            heard = self.member.hear_until(lambda d: exercise.kind_of(d) == 15)
            self.assertIsNotNone(heard[-1])
            self.assertEqual(heard[-1][24:28], bytes([0, flag, 0, 2]))
        run.finish()

    def test_damaged_and_strange_datagrams_are_counted_and_dropped(self):
        run, _ = self.guard()
        good = exercise.entity_state((7, 8, 9), exercise.on_earth(0, 0, 8))
        chance = random.Random(3)
        for _ in range(300):
            damaged = bytearray(good)
            for _ in range(chance.randint(1, 12)):
                damaged[chance.randrange(len(damaged))] = chance.randrange(256)
            self.member.say(bytes(damaged[:chance.randint(1, len(damaged))]))
            self.member.say(chance.randbytes(chance.randint(1, 300)))
        self.member.say(exercise.entity_state((7, 8, 9), exercise.on_earth(0, 0, 8), version=4))
        self.member.say(exercise.entity_state((7, 8, 9), exercise.on_earth(0, 0, 8), exercise=200))
        self.keep_saying([good], run, lambda e: e["event"] == "log" and "sees visitor" in e["text"])
        run.finish()
        self.assertRegex(run.err, r"dropped: .*\d+ too short")
        self.assertRegex(run.err, r"\d+ another version")
        self.assertRegex(run.err, r"\d+ of other exercises")

    def test_no_more_entities_than_allowed(self):
        run, _ = self.guard("most_entities = 5")
        many = [exercise.entity_state((7, 8, n), exercise.on_earth(n % 20, 0, 10 + n // 20), marking=f"m{n}")
                for n in range(1, 60)]
        self.keep_saying(many, run, lambda e: e["event"] == "log" and "sees" in e["text"])
        run.finish()
        self.assertIn(" 5 foreign entities", run.err)
        self.assertRegex(run.err, r"\d+ of too many entities")

    def test_two_soarboxes_fight_and_a_third_watches(self):
        def falls(event):
            return is_news(event, "dies") and "shot by red" in event["text"]

        # Fights between processes are not deterministic: sometimes no soldier of the blue team falls.
        for fight in range(5):
            port = free_port()
            watcher = exercise.Member(port)
            self.addCleanup(watcher.close)
            recording = self.folder / f"red-{fight}.soarrec"
            runs = {"blue": self.start(SKIRMISH / "joint_blue.toml", port=port),
                    "red": self.start(SKIRMISH / "joint_red.toml", "--record", recording, port=port)}
            watch = self.start(SKIRMISH / "joint_watch.toml", port=port)
            # A soldier of one team is killed by the other.
            events = runs["blue"].events_until(lambda e: falls(e) or e.get("time", 0) > 45)
            if events[-1] is not None and falls(events[-1]):
                break
            for run in (*runs.values(), watch):
                run.process.kill()
        else:
            self.fail("no soldier of the blue team was ever hit")
        victim = events[-1]["agent"]
        # Its owner informs all others.
        heard = watcher.hear_until(lambda d: exercise.kind_of(d) == 1 and exercise.damage_of(d) == 3
                                   and d[129:140].rstrip(b"\0").decode() == victim[:11])
        self.assertIsNotNone(heard[-1])
        self.assertEqual(exercise.entity_of(heard[-1])[:2], (1, 1))
        # One process is killed: the others continue, and its soldiers disappear from them.
        runs["blue"].process.kill()
        events = runs["red"].events_until(lambda e: is_news(e, "leaves"))
        self.assertTrue(events[-1]["agent"].startswith("blue"), events[-1])
        runs["red"].finish()
        watch.finish()
        self.assertRegex(watch.err, r" 0 PDUs sent, [1-9]\d\d+ received, [1-8] foreign entities")
        verified = subprocess.run([COMMAND, "verify", recording], capture_output=True, text=True,
                                  check=False)
        self.assertIn("equal", verified.stdout, verified.stderr)
        told = subprocess.run([COMMAND, "replay", recording, "--headless"], capture_output=True,
                              text=True, check=True)
        self.assertIn("check the red team meets the enemy true", told.stdout)

    def test_a_mission_is_tested_without_others_and_says_so(self):
        (self.folder / "guard.toml").write_text(GUARD % f"port = {self.port}", encoding="utf-8")
        (self.folder / "guard.soar").write_text(GUARD_RULES, encoding="utf-8")
        (self.folder / "mission.toml").write_text(
            'scenario = "guard.toml"\nseconds = 1\nseeds = "1..2"\n[[check]]\nname = "it lives"\nagent = "guard"\n'
            'operator = "wait"\n', encoding="utf-8")
        done = subprocess.run([COMMAND, "test", self.folder / "mission.toml"], capture_output=True, text=True, check=False)
        self.assertIn("a test joins no exercise", done.stderr, done.stdout)
        self.assertIsNone(self.member.hear(0.5))

    def test_wrong_options_are_told(self):
        for option, part in (("nowhere", "a port is missing"), ("1.2.3.4:0", "not a port"),
                             ("localhost:3000", "not an IPv4 address"), ("239.1.2.3:3000,0", "not a valid site")):
            done = subprocess.run([COMMAND, "run", "soar_wander", "--headless", "--seconds", "1", "--dis", option],
                                  capture_output=True, text=True, check=False)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(part, done.stderr)
        (self.folder / "guard.toml").write_text(GUARD % 'anchr = [1, 2, 3]', encoding="utf-8")
        (self.folder / "guard.soar").write_text(GUARD_RULES, encoding="utf-8")
        done = subprocess.run([COMMAND, "run", self.folder / "guard.toml", "--headless"], capture_output=True, text=True,
                              check=False)
        self.assertIn("guard.toml:7", done.stderr)
        self.assertIn("did you mean 'anchor'?", done.stderr)

    @unittest.skipUnless(shutil.which("tshark"), "tshark is not installed")
    def test_another_program_reads_all_that_is_sent(self):
        run = self.start(SKIRMISH, application=5)
        heard = self.member.hear_until(lambda d: exercise.kind_of(d) == 22)
        self.assertIsNotNone(heard[-1], "they talk to each other")
        heard += self.member.hear_until(lambda d: exercise.kind_of(d) == 3)
        run.finish()
        while (rest := self.member.hear(0.2)) is not None:
            heard.append(rest)
        capture = self.folder / "heard.pcap"
        exercise.write_capture(capture, [d for d in heard if d], 3000)
        read = subprocess.run(["tshark", "-r", capture, "-d", "udp.port==3000,dis", "-T", "json"],
                              capture_output=True, text=True, check=True)
        packets = [packet["_source"]["layers"] for packet in json.loads(read.stdout)]
        self.assertEqual(len(packets), len([d for d in heard if d]))
        for packet in packets:
            self.assertIn("dis", packet)
            self.assertNotIn("_ws.malformed", json.dumps(packet))
            self.assertNotIn("_ws.expert", json.dumps(packet["dis"]))
        text = read.stdout
        for part in ('"dis.pdu_type": "1"', '"dis.pdu_type": "2"', '"dis.pdu_type": "3"', '"dis.pdu_type": "22"',
                     "blue-leader", '"dis.entity_id_application": "5"'):
            self.assertIn(part, text)

    @unittest.skipUnless(NODE_MODULES and shutil.which("node"), "open-dis is not installed (npm)")
    def test_what_open_dis_encodes_moves_bodies_and_it_decodes_ours(self):
        run, state = self.guard()
        script = pathlib.Path(__file__).with_name("open_dis.js")
        place = exercise.on_earth(0, 0, 8)
        made = subprocess.run(["node", script, "encode", *map(str, place)], capture_output=True, text=True, check=True,
                              env={**os.environ, "NODE_PATH": NODE_MODULES})
        events = self.keep_saying([bytes.fromhex(made.stdout.strip())], run,
                                  lambda e: e["event"] == "log" and "sees" in e["text"])
        self.assertIn("sees open-dis soldier red enemy", events[-1]["text"])
        run.finish()
        read = subprocess.run(["node", script, "decode", state.hex()], capture_output=True, text=True, check=True,
                              env={**os.environ, "NODE_PATH": NODE_MODULES})
        fields = json.loads(read.stdout)
        self.assertEqual(fields["entityID"], [1, 1, 1])
        self.assertEqual(fields["forceId"], 1)
        self.assertEqual(fields["marking"], "guard")
        self.assertLess(math.dist(fields["location"], exercise.on_earth(0, 0, 0)), 0.05)
