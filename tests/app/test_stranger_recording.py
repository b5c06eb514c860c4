# SPDX-License-Identifier: BSD-2-Clause
"""Recordings that were written by hand, and scenarios with minds in the kernel of another process."""
import contextlib
import os
import pathlib
import re
import subprocess
import tempfile

import forged_recording as forged
import strangers_folder
from soarbox_command import COMMAND
from strangers_folder import SECRET, record, rules, run


class Recordings(strangers_folder.StrangersFolder):
    def setUp(self):
        super().setUp()
        self.recording = self.mine / "run.soarrec"
        self.lay(rules(""))

    def doors(self, codes=(0, 1, 3)):
        outputs = []
        for door, arguments in {"verify": [], "verify as recorded": ["--as-recorded"], "resume": ["--at", "0.2", "--record", self.mine / "more.soarrec"],
                                "why": ["--at", "0.2"], "inspect": ["--at", "0.2"], "replay": ["--headless"],
                                "export": ["--json"], "report": ["-o", self.mine / "page.html"]}.items():
            with self.subTest(door):
                outputs.append(self.check(door, [COMMAND, door.split()[0], self.recording, *arguments], codes=codes).out)
        for file in self.mine.iterdir():
            self.assertFalse(SECRET.encode() in file.read_bytes(), f"{file.name} holds what lies outside")
        return outputs

    def record_commands(self, *lines):
        inputs = self.mine / "inputs.txt"
        inputs.write_text("".join(f'{i + 1} command "hero" "{line}"\n' for i, line in enumerate(lines)))
        self.check("record", record(self.folder, self.recording, "--input", inputs, seconds="0.5"))
        inputs.unlink()

    def test_further_folders_that_it_names_are_not_read(self):
        secret = self.outside / "secret.soar"
        self.record_commands(f"source {secret}", f"cd {self.outside}", "source secret.soar", f"load percepts --open {secret}")
        for scenario in (str(self.folder), str(self.folder / "scenario.toml")):
            for further in (["/"], [str(self.outside)], [str(self.outside), "/etc", "/proc/self"], ["/", str(self.folder)]):
                for files in ([], [(1, "some.soar", "# nothing\n")], [(1, str(secret).lstrip("/"), "# nothing\n")]):
                    with self.subTest(scenario=scenario, further=further, files=files):
                        self.recording.write_bytes(forged.with_header(self.recording, forged.header(scenario, "/", further, files)))
                        self.doors()

    def test_files_that_it_keeps_stay_in_a_folder_that_goes(self):
        self.record_commands("print s1")
        names = ["../leak", f"../{self.outside.name}/leak", str(self.outside / "leak"), "a/../../leak", "..", ".", "", "a/", "\0", "a\0/b",
                 "/".join("a" * 2000), "x" * 5000]
        for name in names:
            with self.subTest(name[:60]):
                self.recording.write_bytes(forged.with_header(self.recording, forged.header(
                    "gone", "/nowhere", (), [(0, name, SECRET), (0, "scenario.toml", strangers_folder.WORLD)])))
                temporary = self.top / "temporary"
                temporary.mkdir(exist_ok=True)
                for door in ("verify", "why", "inspect"):
                    done = run(["env", f"TMPDIR={temporary}", COMMAND, door, self.recording], self.folder)
                    self.assertIn(done.code, (0, 1, 3), done.out)
                self.assertEqual(list(temporary.iterdir()), [])
                self.assertFalse((self.outside / "leak").exists() or (self.top / "leak").exists())

    def test_a_header_that_asks_for_too_much_is_refused(self):
        self.record_commands("print s1")
        for header in (forged.header("x", "/", ["/x"] * 100_000, [(0, "a.soar", "")] * 50_000), forged.header("x", "/", (), [(2**31, "a.soar", "")]),
                       forged.header("x" * (1 << 20), "/" * (1 << 20)), forged.header(str(self.folder), memory_mb=2**63),
                       forged.header(str(self.folder), memory_mb=0), forged.header(str(self.folder), seed=2**64 - 1),
                       forged.header("/proc/self/mem"), forged.header("/dev/zero"), forged.header("/proc/self/root" * 100)):
            self.recording.write_bytes(forged.with_header(self.recording, header))
            self.doors()

    def test_a_pipe_is_no_recording(self):
        os.mkfifo(self.mine / "pipe.soarrec")
        for door in ("replay", "verify", "why", "inspect", "export", "report"):
            done = run([COMMAND, door, self.mine / "pipe.soarrec"], self.folder)
            self.assertIn(done.code, (2, 3), f"{door}: {done.out}")
        (self.mine / "pipe.soarrec").unlink()


class OtherKernels(strangers_folder.StrangersFolder):
    """The restrictions of a run also apply in the kernel that `--kernel` names."""

    @contextlib.contextmanager
    def kernel(self):
        with tempfile.TemporaryDirectory() as here, subprocess.Popen(
                [COMMAND, "kernel", "--port", "0"], cwd=here, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
            line = process.stdout.readline()
            try:
                yield int(re.search(r"127\.0\.0\.1:(\d+)", line).group(1)), pathlib.Path(here)
            finally:
                process.terminate()

    def test_what_rule_files_and_rules_ask_for_is_refused_there(self):
        leak, secret = self.outside / "leak", self.outside / "secret.soar"
        asked = {
            "log": f"output log {leak}", "save": f"save agent {leak}", "to a file": f"command-to-file {leak} print s1",
            "database": f"smem --set path {leak}\nsmem --set database file\nsmem --enable\nsmem --init", "read": f"source {secret}",
            "by a rule": "sp {leak (state <s> ^superstate nil) --> (<s> ^x (cmd output log |%s|))}" % leak,
            "saved by a rule": "sp {leak (state <s> ^superstate nil) --> (<s> ^x (cmd save agent |%s|))}" % leak,
        }
        with self.kernel() as (port, here):
            for name, text in asked.items():
                self.lay(rules(text))
                for folder in (self.folder, "."):
                    with self.subTest(name, folder=folder):
                        done = self.check(name, [COMMAND, "run", folder, "--headless", "--seconds", "0.3", "--kernel", f"127.0.0.1:{port}"])
                        if not name.endswith("rule"):
                            self.assertIn("may", done.out)
                        self.assertIn("wander", done.out, "the rest of the file is loaded")
                        self.assertEqual(list(here.iterdir()), [])
