# SPDX-License-Identifier: BSD-2-Clause
"""Each promise in docs/dev/promises.md is on its page of README or docs/, and has a test. The tests that are fast are here."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = os.environ["SOARBOX"]
PROMISES = (ROOT / "docs" / "dev" / "promises.md").read_text(encoding="utf-8")
LIMIT_S = 240

FLEE = """sp {scout*propose*flee
   (state <s> ^superstate nil ^io.input-link.self.health < 50)
-->
   (<s> ^operator <o> + =)
   (<o> ^name flee)
}
sp {scout*apply*flee
   (state <s> ^operator.name flee ^io.output-link <out>)
-->
   (<out> ^wander <command>)
}
"""

# Chooses a random direction to look whenever the time has changed.
CHOOSER = """sp {chooser*propose*go
   (state <s> ^superstate nil ^io.input-link <in>)
   (<in> ^time <t> ^waypoint.name <name>)
-->
   (<s> ^operator <o> + =)
   (<o> ^name go ^to <name> ^at <t>)
}
sp {chooser*apply*go
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name go ^to <name>)
-->
   (<out> ^face <command>)
   (<command> ^waypoint <name>)
   (write |choice: | <name> (crlf))
}
sp {chooser*apply*forget
   (state <s> ^superstate nil ^operator <o> ^io.output-link <out>)
   (<out> ^<name> <command>)
   (<command> ^status)
-->
   (<out> ^<name> <command> -)
}
"""


def rows(heading=None):
    """Page, words and the last cell of each row, before or below the second heading."""
    parts = PROMISES.split("## Promises without a test that starts them")
    text = parts[1] if heading else parts[0]
    return [tuple(cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:4]) for line in text.splitlines()
            if line.startswith("| ") and not line.startswith(("| page", "| ---"))]


def plain(text):
    return re.sub(r"\s+", " ", re.sub(r"<!--.*?-->|\]\([^)]*\)|[\[*`]", "", text))


def agent(number, position):
    return f'[[agent]]\nname = "{number}"\nrules = "chooser.soar"\nposition = {position}\nsenses = {{ only = ["time", "self", "waypoints"] }}\n'


class Promises(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) if hasattr(self, "enterContext") else self.make_folder()
        self.home = self.folder / "home"
        self.home.mkdir()
        self.environment = {**os.environ, "HOME": str(self.home)}
        for name in ("DISPLAY", "WAYLAND_DISPLAY", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"):
            self.environment.pop(name, None)

    def make_folder(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        return folder.name

    def run_command(self, *words, cwd=None):
        done = subprocess.run([COMMAND, *map(str, words)], cwd=cwd or self.folder, env=self.environment, check=False, capture_output=True,
                              text=True, timeout=LIMIT_S)
        self.assertIn(done.returncode, (0, 1), done.stdout + done.stderr)
        return done.stdout

    def test_each_promise_is_on_its_page_and_has_a_test(self):
        self.assertGreater(len(rows()), 30)
        for page, words, test in rows():
            self.assertIn(plain(words), plain((ROOT / page).read_text(encoding="utf-8")), page)
            self.assertTrue((ROOT / test).exists(), test)
        for page, words, why in rows("without"):
            self.assertIn(plain(words), plain((ROOT / page).read_text(encoding="utf-8")), page)
            self.assertTrue(why)

    def test_the_answer_on_the_first_page_is_what_a_run_prints(self):
        readme = (ROOT / "README.md").read_text(encoding="utf-8")
        shown = [line.strip() for line in re.findall(r"^ {6}(\S.*)$", readme, re.MULTILINE)]
        self.assertEqual(len(shown), 3)
        self.run_command("new", "scout")
        (self.folder / "scout" / "scout.soar").write_text(FLEE, encoding="utf-8")
        printed = self.run_command("run", "scout", "--headless", "--seconds", "2")
        for line in shown:
            self.assertIn(line, printed)

    def test_the_first_world_is_that_of_the_thesis(self):
        printed = self.run_command("run", "thesis", "--headless", "--seconds", "1")
        joins = re.findall(r"(\S+) +joins: (\w+)", printed)
        self.assertEqual([kind for _, kind in joins].count("lua"), 1)
        self.assertEqual([kind for _, kind in joins].count("soar"), 5)

    def test_minds_of_a_world_have_the_settings_that_the_page_names(self):
        for command, answer in (("soar wait-snc", "wait-snc is on"), ("soar max-goal-depth", "max-goal-depth is 23"),
                                ("soar max-nil-output-cycles", "max-nil-output-cycles is 15")):
            self.assertIn(answer, self.run_command("inspect", "soar_seek", "--at", "0.1", "--view", f"console {command}"))
        (self.folder / "settings.soar").write_text("soar max-goal-depth 7\n", encoding="utf-8")
        done = subprocess.run([COMMAND, "soar"], input="soar wait-snc\nsoar max-goal-depth\n", cwd=self.folder, env=self.environment, check=True,
                              capture_output=True, text=True, timeout=LIMIT_S)
        self.assertIn("wait-snc is off", done.stdout)
        self.assertIn("max-goal-depth is 23", done.stdout)

    def test_a_mind_decides_15_times_in_a_tick_at_most(self):
        decided = []
        for at in ("1", "2"):
            seen = json.loads(self.run_command("inspect", "soar_seek", "--at", at, "--json"))
            decided.append(seen[0]["decisions"])
        # Thirty ticks are between them.
        self.assertLessEqual(decided[1] - decided[0], 30 * 15)
        self.assertGreater(decided[1] - decided[0], 30 * 10)

    def test_the_choices_of_an_agent_do_not_depend_on_others(self):
        world = 'seconds = 10\n[[waypoint]]\nname = "a"\nposition = [50, 0]\n[[waypoint]]\nname = "b"\nposition = [-50, 0]\n' + agent("one", [0, 0])
        choices = []
        for name, text in (("alone", world), ("two", world + agent("two", [0, 40]))):
            folder = self.folder / name
            folder.mkdir()
            (folder / "chooser.soar").write_text(CHOOSER, encoding="utf-8")
            (folder / "scenario.toml").write_text(text, encoding="utf-8")
            printed = self.run_command("run", folder, "--headless")
            choices.append(re.findall(r" one +choice: (\w)", printed))
        self.assertGreater(len(choices[0]), 5)
        self.assertEqual(set(choices[0]), {"a", "b"})
        self.assertEqual(choices[0], choices[1])

    def test_looking_and_running_writes_nothing_that_was_not_named(self):
        cwd = self.folder / "empty"
        cwd.mkdir()
        for words in (("list",), ("check", "soar_seek"), ("run", "soar_seek", "--headless", "--seconds", "1"), ("why", "soar_seek", "--at", "1"),
                      ("inspect", "soar_seek", "--at", "1"), ("test", "soar_seek", "--seeds", "1..1"), ("learn",), ("help",)):
            self.run_command(*words, cwd=cwd)
            self.assertEqual([str(file) for file in cwd.rglob("*")], [], words)
            # Results of lessons and tests belong there.
            written = {file.relative_to(self.home).parts[:3] for file in self.home.rglob("*") if file.is_file()}
            self.assertLessEqual(written, {(".local", "state", "soarbox")}, words)
        self.run_command("learn", "1", "--headless", cwd=cwd)
        written = {file.relative_to(self.home).parts[0] for file in self.home.rglob("*") if file.is_file()}
        self.assertLessEqual(written, {".local", "soarbox-lessons"})
        self.assertEqual(list(cwd.rglob("*")), [])

    def sockets_of(self, process):
        """Local addresses, as /proc has them, of all sockets of the internet that this process has."""
        mine = set()
        for link in pathlib.Path(f"/proc/{process}/fd").iterdir():
            try:
                found = re.match(r"socket:\[(\d+)\]", os.readlink(link))
            except FileNotFoundError:
                continue
            if found:
                mine.add(found[1])
        addresses = []
        for kind in ("tcp", "tcp6", "udp", "udp6"):
            table = pathlib.Path(f"/proc/{process}/net/{kind}")
            for line in table.read_text().splitlines()[1:] if table.exists() else ():
                cells = line.split()
                if cells[9] in mine:
                    addresses.append(cells[1].split(":")[0])
        return addresses

    def while_it_runs(self, *words, until):
        """The sockets of a program after it has printed its ready message."""
        with subprocess.Popen([COMMAND, *words], cwd=self.folder, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as program:
            limit = threading.Timer(LIMIT_S, program.kill)
            limit.start()
            try:
                for line in program.stdout:
                    if until in line:
                        return self.sockets_of(program.pid)
            finally:
                limit.cancel()
                program.kill()
        self.fail(f"{words} never printed {until}")

    def test_a_run_has_no_socket_and_a_kernel_listens_to_this_machine_alone(self):
        self.assertEqual(self.while_it_runs("run", "soar_seek", "--headless", "--speed", "1", "--seconds", "60", until="joins"), [])
        listening = self.while_it_runs("kernel", "--port", "0", until="listens on")
        self.assertTrue(listening)
        self.assertLessEqual(set(listening), {"0100007F"})

    def test_what_the_service_starts_is_a_command_that_serves(self):
        unit = (ROOT / "cmake" / "soarbox-serve.service.in").read_text(encoding="utf-8")
        words = re.search(r"^ExecStart=\S+ (.*)$", unit, re.MULTILINE)[1].split()
        self.assertEqual((words[0], words[words.index("--listen") + 1]), ("serve", "127.0.0.1:8080"))
        words[words.index("--listen") + 1] = "127.0.0.1:0"
        words[words.index("--state") + 1] = str(self.folder / "state")
        (self.folder / "page").mkdir()
        (self.folder / "page" / "index.html").write_text("<title>page</title>", encoding="utf-8")
        listening = self.while_it_runs(*words, "--page", str(self.folder / "page"), until="Open http://")
        self.assertEqual(set(listening), {"0100007F"})

    @unittest.skipUnless(shutil.which("systemd-analyze"), "systemd-analyze is not installed")
    def test_the_service_is_one_that_systemd_can_read(self):
        unit = (ROOT / "cmake" / "soarbox-serve.service.in").read_text(encoding="utf-8")
        file = self.folder / "soarbox-serve.service"
        file.write_text(re.sub(r"^ExecStart=\S+", "ExecStart=/bin/true", unit, flags=re.MULTILINE), encoding="utf-8")
        done = subprocess.run(["systemd-analyze", "verify", file], capture_output=True, text=True, check=False, timeout=60)
        self.assertEqual([line for line in done.stderr.splitlines() if file.name in line and "Command 'man" not in line], [])


if __name__ == "__main__":
    unittest.main()
