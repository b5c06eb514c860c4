# SPDX-License-Identifier: BSD-2-Clause
"""An untrusted folder: each command of the program is combined with each kind of request in a file. A combination passes if
nothing is written, nothing outside of the folder is shown, nothing hangs, and the program ends with one of its exit codes."""
import os
import shutil
import socket
import threading

import strangers_folder
from soarbox_command import COMMAND, page_missing
from strangers_folder import SECRET, record, rules, run, write

MISSION = '[mission]\nseeds = "1..2"\nseconds = 0.3\n[[check]]\nname = "it walks"\nagent = "hero"\ncommand = "wander"\n'
LUA = "function Sandbox_Initialize(sandbox) %s end\n"


def rule_that_runs(command):
    return rules("sp {run*command (state <s> ^superstate nil) --> (<s> ^answer (cmd %s))}" % command)


def script(text):
    return {"Sandbox.lua": LUA % text}


def requests(outside):
    """The requests of folders, by name: the files, or a function that makes them."""
    leak, secret = outside / "leak", outside / "secret.soar"

    def links(folder):
        write(folder, rules("source link.soar\nsource folder/secret.soar"))
        (folder / "link.soar").symlink_to(secret)
        (folder / "folder").symlink_to(outside)
        (folder / "Link.lua").symlink_to(outside / "secret.lua")
        (folder / "scenario-link.toml").symlink_to(outside / "secret.toml")

    def devices(folder):
        write(folder, rules("source zero.soar\nsource /dev/zero\nsource /dev/random"))
        (folder / "zero.soar").symlink_to("/dev/zero")
        (folder / "Zero.lua").symlink_to("/dev/zero")

    def fifos(folder):
        write(folder, rules("source pipe.soar"))
        for name in ("pipe.soar", "Pipe.lua", "pipe.toml"):
            os.mkfifo(folder / name)

    def sockets(folder):
        write(folder, rules("source socket.soar"))
        with socket.socket(socket.AF_UNIX) as end:
            end.bind(str(folder / "socket.soar"))

    def cwd_settings(folder):
        write(folder, rules(""))
        write(folder, {"settings.soar": f"output log {leak}\nsave agent {leak}2\n"})

    chain = {f"f{i}.soar": f"source f{i + 1}.soar\n" * 3 for i in range(16)} | {"f16.soar": ""}
    return {
        "write a log": rules(f"output log {leak}"),
        "write by command-to-file": rules(f"output command-to-file {leak} echo x\ncommand-to-file {leak} echo x"),
        "save": rules(f"save agent {leak}\nsave percepts --open {leak}\nsave rete-network --save {leak}\nsave chunks {leak}"),
        "write in its own folder": rules("save agent more.soar\noutput log mine.log\nvisualize wm"),
        "write by an alias": rules(f"alias log2 output log\nlog2 {leak}\nalias print save agent {leak}"),
        "write by a rule": rule_that_runs(f"output log |{leak}|"),
        "save by a rule": rule_that_runs(f"save agent |{leak}|"),
        "open a database": rules(f"smem --set path {leak}\nsmem --enable\nsmem --init\nepmem --set path {leak}\nepmem --enable\n"
                                 f"smem --backup {leak}\nepmem --backup {leak}\nsmem --export {leak}"),
        "write by the settings of the working folder": cwd_settings,
        "read outside": rules(f"source {secret}\nload file {secret}\nload rete-network --load {secret}\nload percepts --open {secret}"),
        "read outside by cd": rules(f"cd {outside}\nsource secret.soar\npushd {outside}\nsource secret.soar\npopd\nls"),
        "read outside by Lua": script(f'Sandbox.CreateAgent(sandbox, "{outside}/secret.lua") Sandbox.CreateSoarAgent(sandbox, '
                                      f'"x.lua", "{secret}") print(pcall(dofile, "{outside}/secret.lua")) '
                                      f'print(pcall(require, "{outside}/secret"))'),
        "links": links,
        "devices": devices,
        "pipes": fifos,
        "sockets": sockets,
        "endless source": rules("source hero.soar\nsource hero.soar"),
        "ever more source": rules("source f0.soar") | chain,
        "run": rules("run\nrun 1000000"),
        "a shell by Lua": script(f'print(pcall(function() os.execute("touch {leak}") end)) '
                                 f'print(pcall(function() io.open("{leak}", "w") end)) '
                                 f'print(pcall(function() io.popen("touch {leak}") end)) '
                                 f'print(pcall(function() require("ffi").C.system("touch {leak}") end)) '
                                 f'print(pcall(function() package.loadlib("{leak}", "*") end))'),
        "a shell by rules": rules(f"system touch {leak}\nexec touch {leak}\ntcl exec touch {leak}\nload library touch"),
    }


class Doors(strangers_folder.StrangersFolder):
    def test_doors_that_take_a_folder(self):
        doors = {
            "run": ["run", self.folder, "--headless", "--seconds", "0.3"],
            "check of the folder": ["check", self.folder],
            "check of a file": ["check", self.folder / "hero.soar"],
            "why": ["why", self.folder, "--at", "0.2"],
            "inspect": ["inspect", self.folder, "--at", "0.2"],
        }
        for asked, files in requests(self.outside).items():
            self.lay(files)
            for door, arguments in doors.items():
                with self.subTest(door=door, asked=asked):
                    self.check(f"{door}, {asked}", [COMMAND, *arguments])

    def test_a_recording_carries_nothing_off_and_does_nothing(self):
        for asked, files in requests(self.outside).items():
            self.lay(files)
            recording, part, table = self.mine / "run.soarrec", self.mine / "part.soarrec", self.mine / "table"
            with self.subTest(door="record", asked=asked):
                self.check(f"record, {asked}", record(self.folder, recording))
                if not recording.exists():
                    continue
                for file in self.mine.iterdir():
                    self.assertNotIn(SECRET.encode(), file.read_bytes())
            # On another machine, only the stored data is available.
            doors = {
                "replay": ["replay", recording, "--headless"],
                "verify": ["verify", recording],
                "resume": ["resume", recording, "--at", "0.1", "--seconds", "0.2"],
                "why": ["why", recording, "--at", "0.2"],
                "inspect": ["inspect", recording, "--at", "0.2"],
                "export": ["export", recording, "--json", "-o", table],
                "export of a part": ["export", recording, "--recording", "--from", "0.1", "-o", part],
                "compare": ["compare", recording, recording],
            }
            for door, arguments in doors.items():
                with self.subTest(door=door, asked=asked):
                    self.check(f"{door}, {asked}", [COMMAND, *arguments])
            for file in self.mine.iterdir():
                self.assertNotIn(SECRET.encode(), file.read_bytes(), f"{file.name}, {asked}")
                file.unlink()

    def test_missions_sweeps_and_reports_do_no_more_than_runs(self):
        for asked, files in requests(self.outside).items():
            self.lay(files)
            scenario = self.folder / "scenario.toml"
            if scenario.exists():
                scenario.write_text(scenario.read_text() + MISSION, encoding="utf-8")
            with self.subTest(door="test", asked=asked):
                self.check(f"test, {asked}", [COMMAND, "test", self.folder, "--keep", self.mine], codes=(0, 1, 3, 4, 5))
            spec = self.mine / "sweep.toml"
            spec.write_text(f'scenario = "{self.folder}"\nseeds = "1..2"\nseconds = 0.2\nrecord = "all"\n', encoding="utf-8")
            with self.subTest(door="sweep", asked=asked):
                self.check(f"sweep, {asked}", [COMMAND, "sweep", spec, "--folder", self.mine / "results"])
            for recording in list(self.mine.rglob("*.soarrec"))[:1]:
                with self.subTest(door="report", asked=asked):
                    if page_missing():
                        self.skipTest(page_missing())
                    self.check(f"report, {asked}", [COMMAND, "report", recording, "-o", self.mine / "report.html"])
            for file in self.mine.rglob("*"):
                if file.is_file():
                    self.assertFalse(SECRET.encode() in file.read_bytes(), f"{file.name}, {asked}: holds what lies outside")
            shutil.rmtree(self.mine)
            self.mine.mkdir()

    def test_a_sweep_of_a_stranger_sets_nothing_up_that_writes(self):
        """The lines before the rules come from a file, too."""
        leak = self.outside / "leak"
        self.lay(rules(""))
        for line in (f"output log {leak}", f"command-to-file {leak} print s1", f"save agent {leak}", f"smem --set path {leak}",
                     f"source {self.outside / 'secret.soar'}"):
            spec = self.mine / "sweep.toml"
            spec.write_text(f'scenario = "{self.folder}"\nseeds = "1..1"\nseconds = 0.2\n[[variant]]\nname = "a"\nsetup = ["{line}"]\n',
                            encoding="utf-8")
            with self.subTest(line):
                self.check(f"sweep, {line}", [COMMAND, "sweep", spec, "--folder", self.mine / "results"])
            shutil.rmtree(self.mine)
            self.mine.mkdir()

    def test_what_was_typed_when_a_run_was_recorded_is_fenced(self):
        """A debugger's lines are recorded. Opening the recording does not execute their writes."""
        leak, secret = self.outside / "leak", self.outside / "secret.soar"
        typed = [f"output log {leak}", f"command-to-file {leak} print s1", f"save agent {leak}", f"source {secret}",
                 f"alias x save agent {leak}", f"x {leak}", f"cd {self.outside}", "ls", f"smem --set path {leak}",
                 f"load percepts --open {secret}", "visualize wm"]
        self.lay(rules(""))
        inputs = self.mine / "inputs.txt"
        inputs.write_text("".join(f'{number + 2} command "hero" "{line}"\n' for number, line in enumerate(typed)))
        recording = self.mine / "run.soarrec"
        done = self.check("a file of inputs", record(self.folder, recording, "--input", inputs, seconds="0.6"))
        for line in typed:
            if not line.startswith("alias"):
                self.assertIn(f"the command '{line}' failed", done.out)
        for door, arguments in {"verify": [], "resume": ["--at", "0.4"], "why": ["--at", "0.4"], "inspect": ["--at", "0.4"],
                                "replay": ["--headless"]}.items():
            with self.subTest(door):
                self.check(door, [COMMAND, door, recording, *arguments])

    def test_rule_files_cannot_hold_up_the_world(self):
        """Files cannot postpone the end of a decision or of a wait for output, and nothing depends on the clock."""
        endless = ("sp {begin (state <s> ^superstate nil) --> (<s> ^n 0)}\n"
                   "sp {count (state <s> ^n <n>) --> (<s> ^n (+ <n> 1))}\n")
        silent = ("sp {propose (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name again ^at (rand-float))}\n"
                  "sp {apply (state <s> ^operator <o>) (<o> ^name again) --> (<s> ^done <o>)}\n")
        for line, more in (("soar max-elaborations 2000000000", endless), ("soar max-nil-output-cycles 2000000000", silent),
                           ("max-elaborations 2000000000", endless), ("soar max-goal-depth 2000000000", ""), ("soar max-dc-time 1", ""),
                           ("soar max-gp 2000000000\ngp {g (state <s> ^a [1 2 3 4 5 6 7 8 9 10] ^b [1 2 3 4 5 6 7 8 9 10] ^c [1 2 3 4 5 6 7 8 9 10]"
                            " ^d [1 2 3 4 5 6 7 8 9 10] ^e [1 2 3 4 5 6 7 8 9 10] ^f [1 2 3 4 5 6 7 8 9 10]) --> (<s> ^x y)}", "")):
            self.lay({"scenario.toml": strangers_folder.WORLD, "hero.soar": line + "\n" + more})
            with self.subTest(line):
                done = self.check(line, [COMMAND, "run", self.folder, "--headless", "--seconds", "0.1"], codes=(1,))
                self.assertIn("at most", done.out)
            self.lay({"scenario.toml": strangers_folder.WORLD,
                      "hero.soar": "sp {set (state <s> ^superstate nil) --> (<s> ^answer (cmd %s))}\n" % line.split("\n", 1)[0] + more})
            with self.subTest("by a rule", line=line):
                self.check(line, [COMMAND, "run", self.folder, "--headless", "--seconds", "0.1"])

    def test_the_shell_reads_what_it_is_given_and_is_the_users_own_otherwise(self):
        self.lay(rules("source hero.soar\nsource hero.soar"))
        done = self.check("soar", [COMMAND, "soar", self.folder / "hero.soar"], "exit\n")
        self.assertIn("This file sources itself", done.out)

    def test_a_starter_scenario_is_no_door(self):
        self.lay({"settings.soar": f"output log {self.outside / 'leak'}"})
        run([COMMAND, "new", self.mine / "starter"], self.folder)
        self.check("new", [COMMAND, "run", self.mine / "starter", "--headless", "--seconds", "0.2"])

    def test_the_pipe_of_nobody_hangs_no_input(self):
        self.lay(rules(""))
        os.mkfifo(self.folder / "inputs")
        writer = threading.Thread(target=lambda: (self.folder / "inputs").write_text("", encoding="utf-8"))
        writer.start()
        done = run([COMMAND, "run", self.folder, "--headless", "--seconds", "0.1", "--input", self.folder / "inputs"], self.mine)
        writer.join()
        self.assertEqual(done.code, 0, done.out)
