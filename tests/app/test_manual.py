# SPDX-License-Identifier: BSD-2-Clause
"""Help and manual pages say the same, are well-formed, and their examples work."""
import os
import pathlib
import re
import shutil
import signal
import subprocess
import unittest

from soarbox_command import COMMAND, Run, ScenarioCase


def commands():
    text = Run("help").out
    return re.findall(r"^  ([a-z]+) ", text[text.index("Subcommands:"):text.index("Examples:")], re.MULTILINE)


def examples(command):
    return re.findall(r"^  (soarbox .*)$", Run(command, "--help").out.split("Examples:")[-1], re.MULTILINE)


class Manual(ScenarioCase):
    def pages(self):
        self.assertEqual(Run("help", "--pages", self.folder / "man").code, 0)
        return sorted((self.folder / "man").glob("*.1"))

    def test_help_is_what_the_sub_commands_say_themselves(self):
        self.assertEqual(Run("help").out, Run("--help").out)
        for command in commands():
            self.assertEqual(Run("help", command).out, Run(command, "--help").out)

    def test_help_names_the_sub_command_that_was_meant(self):
        run = Run("help", "inspct", code=2)
        self.assertIn("did you mean soarbox help inspect?", run.err)
        run = Run("help", "--pages", "/proc/nowhere", code=3)
        self.assertIn("this file cannot be written", run.err)

    def test_there_is_a_page_for_the_program_and_each_sub_command(self):
        names = {page.stem for page in self.pages()}
        self.assertEqual(names, {"soarbox"} | {f"soarbox-{command}" for command in commands()})
        for page in self.pages():
            text = page.read_text()
            for section in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS"):
                self.assertIn(f".SH {section}\n", text, page.name)

    @unittest.skipUnless(shutil.which("man"), "man is not installed")
    def test_a_page_holds_each_option_and_example_of_the_help(self):
        self.pages()
        for command in commands():
            done = subprocess.run(["man", "--warnings", "-l", self.folder / "man" / f"soarbox-{command}.1"], capture_output=True,
                                  text=True, check=False, env={**os.environ, "MANWIDTH": "400", "LC_ALL": "C.UTF-8",
                                                               "MAN_KEEP_FORMATTING": ""})
            self.assertEqual((done.returncode, done.stderr), (0, ""), command)
            said = re.sub(r"\s+", " ", re.sub(".\b", "", done.stdout)).replace("‐", "-").replace("−", "-")
            help_text = Run(command, "--help").out
            for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", help_text, re.MULTILINE):
                self.assertRegex(said, rf"{option}\b", command)
            for example in examples(command):
                self.assertIn(re.sub(r"\s+", " ", example), said)

    @unittest.skipUnless(shutil.which("mandoc"), "mandoc is not installed")
    def test_pages_are_well_formed(self):
        done = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", *self.pages()], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_the_examples_work_one_after_the_other(self):
        self.write("names.txt", "Ada\nGrace\n")
        environment = {**os.environ, "HOME": str(self.folder), "PATH": f"{pathlib.Path(COMMAND).parent}:{os.environ['PATH']}"}
        environment.pop("DISPLAY", None)
        environment.pop("WAYLAND_DISPLAY", None)
        made = set()
        tried = 0
        # The topic of the others comes first.
        for command in sorted(commands(), key=lambda name: (name != "new", name != "run")):
            for line in examples(command):
                if "| man" in line and not shutil.which("man"):
                    continue
                if command == "watch":  # test_watch.py starts a kernel for it.
                    continue
                if line in made:  # It would refuse to overwrite its own files.
                    continue
                made.add(line)
                tried += 1
                if command in ("kernel", "serve"):
                    self.serves(line, environment)
                    continue
                # There is no display, so all runs are headless. The starter of a lesson does not pass.
                done = subprocess.run(["bash", "-o", "pipefail", "-c", line], cwd=self.folder, env=environment, check=False,
                                      stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=200)
                self.assertEqual(done.returncode, 1 if line == "soarbox learn check 1" else 0, f"{line}: {done.stdout}{done.stderr}")
        self.assertGreater(tried, 25)

    def serves(self, line, environment):
        """Starts a server, waits until it prints its address, and ends it."""
        line = re.sub(r"--port \d+", "--port 0", re.sub(r"0\.0\.0\.0:\d+", "127.0.0.1:0", line))
        if line == "soarbox serve":
            line += " --listen 127.0.0.1:0"
        if "serve" in line:
            (self.folder / "page").mkdir(exist_ok=True)
            self.write("page/index.html", "<title>page</title>")
            line += " --page page"
        with subprocess.Popen(line.split(), cwd=self.folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, text=True) as server:
            said = next((words for words in server.stdout if re.search(r"\d", words)), "")
            server.send_signal(signal.SIGTERM)
            server.communicate(timeout=60)
        self.assertRegex(said, r"\d", line)


class Options(ScenarioCase):
    def test_the_page_of_options_is_what_the_program_prints(self):
        page = pathlib.Path(__file__).resolve().parents[2] / "docs" / "options.md"
        self.assertEqual(page.read_text(encoding="utf-8"), Run("help", "--markdown").out, "soarbox help --markdown > docs/options.md")

    def test_it_has_each_option_of_the_help(self):
        parts = re.split(r"^## soarbox ", Run("help", "--markdown").out, flags=re.MULTILINE)
        told = {part.split("\n")[0]: part for part in parts[1:]}
        self.assertEqual(set(told), set(commands()))
        for command, part in told.items():
            for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", Run(command, "--help").out, re.MULTILINE):
                if option != "--help":
                    self.assertRegex(part, rf"`{option}\b", command)
