#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Tests the npm package as a user gets it: installed from its tarball into an empty folder, compared with the native command.

usage: run_npm.py --package build/npm/soarbox-VERSION.tgz --native SOARBOX [TEST...]

`./dev npm test` builds both and calls this. Nothing is skipped: a missing package or program is an error.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
import urllib.error
import urllib.request

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
GIVEN = argparse.Namespace()
LIMIT_S = 600
# The second condition needs a closing parenthesis.
BROKEN = "sp {greet*propose\n   (state <s> ^name greet\n   -->\n   (<s> ^done yes)}\n"
UNTIDY = "sp {hello\n(state <s> ^type state)\n-->\n      (write |hello|)\n   (halt)}\n"
AGENT = """sp {begin*propose
   (state <s> ^superstate nil -^n)
-->
   (<s> ^operator <o> +)
   (<o> ^name begin)}
sp {begin*apply
   (state <s> ^operator.name begin)
-->
   (<s> ^n 0)}
sp {count*propose
   (state <s> ^n < 3)
-->
   (<s> ^operator <o> + =)
   (<o> ^name count)}
sp {count*apply
   (state <s> ^operator.name count ^n <n>)
-->
   (<s> ^n <n> - (+ <n> 1))
   (write |now | (+ <n> 1) (crlf))}
"""


class Package(unittest.TestCase):
    """Each test has a separate folder, in which `npm` and `native` run the two programs."""

    maxDiff = 4000

    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(tempfile.mkdtemp(prefix="soarbox-npm-"))
        cls.addClassCleanup(shutil.rmtree, cls.root, ignore_errors=True)
        cls.installed = cls.root / "empty"
        cls.installed.mkdir()
        # The native program must not be on the path. Both programs use the same worlds.
        node = pathlib.Path(shutil.which("node") or sys.exit("run_npm.py: there is no node on the path")).parent
        cls.environment = {"PATH": f"{node}:/usr/bin:/bin", "HOME": str(cls.root), "LANG": "C.UTF-8"}
        done = subprocess.run(["npm", "install", "--offline", "--no-audit", "--no-fund", str(GIVEN.package)], cwd=cls.installed,
                              env=cls.environment, capture_output=True, text=True, check=False, timeout=LIMIT_S)
        if done.returncode != 0:
            raise AssertionError(f"npm install failed:\n{done.stdout}{done.stderr}")
        cls.module = cls.installed / "node_modules" / "soarbox"
        cls.program = cls.installed / "node_modules" / ".bin" / "soarbox"

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=self.root))

    def run_one(self, program, words, given=None, cwd=None):
        variables = {"SOARBOX_DATA": str(self.module / "share" / "soarbox")} if program == GIVEN.native else {}
        return subprocess.run([str(program), *map(str, words)], input=given, cwd=cwd or self.folder, env=self.environment | variables,
                              capture_output=True, text=True, check=False, timeout=LIMIT_S)

    def npm(self, *words, given=None, code=0):
        done = self.run_one(self.program, words, given)
        self.assertEqual(done.returncode, code, done.stdout[-2000:] + done.stderr[-2000:])
        return done

    def native(self, *words, given=None):
        return self.run_one(GIVEN.native, words, given)

    def assert_same(self, *words, given=None, code=0, has=""):
        """Both programs print the same and end in the same way. `has`: a text that the output contains."""
        ours, theirs = self.npm(*words, given=given, code=code), self.native(*words, given=given)
        self.assertEqual((ours.stdout, ours.stderr, ours.returncode), (theirs.stdout, theirs.stderr, theirs.returncode))
        self.assertIn(has, ours.stdout + ours.stderr)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def end_of(self, done):
        return next(json.loads(line) for line in reversed(done.stdout.splitlines()) if line.startswith('{"event":"end"'))


class Commands(Package):
    def test_version_and_a_wrong_command_line(self):
        self.assertEqual(self.npm("--version").stdout.split("\n")[0], self.native("--version").stdout.split("\n")[0])
        self.assert_same("chek", code=2, has="check")

    def test_it_says_that_it_has_no_sockets(self):
        for words in (("kernel",), ("kernel", "--port", 0), ("run", "soar_flee", "--headless", "--port", 4000)):
            with self.subTest(words=words):
                told = self.npm(*words, code=3).stderr
                self.assertIn("this build has no sockets", told)
                self.assertIn("use the native soarbox", told)
                self.assertNotIn("another program", told)

    def test_npx_runs_it(self):
        done = subprocess.run(["npx", "--offline", "soarbox", "list"], cwd=self.installed, env=self.environment, capture_output=True,
                              text=True, check=False, timeout=LIMIT_S)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("soar_flee", done.stdout)

    def test_soar_answers_lines(self):
        self.assert_same("soar", self.write("count.soar", AGENT), given="run 6\nprint --depth 2 s1\nprint count*apply\nexit\n", has="now 3")

    def test_check(self):
        self.assert_same("check", self.write("broken.soar", BROKEN), code=1, has="broken.soar:")
        self.assert_same("check", self.write("count.soar", AGENT))

    def test_format(self):
        name = self.write("untidy.soar", UNTIDY)
        self.assert_same("format", "--check", name, code=1, has=name)
        self.npm("format", name)
        ours = (self.folder / name).read_text(encoding="utf-8")
        self.write(name, UNTIDY)
        self.native("format", name)
        self.assertEqual(ours, (self.folder / name).read_text(encoding="utf-8"))
        self.assertNotEqual(ours, UNTIDY)

    def test_worlds_end_in_the_same_state(self):
        for world in ("soar_flee", "thesis", "soar_hallway"):
            with self.subTest(world=world):
                words = ("run", world, "--headless", "--json", "--seconds", 10, "--threads", 1)
                ours, theirs = self.end_of(self.npm(*words)), self.end_of(self.native(*words))
                self.assertEqual((ours["state"], ours["ticks"]), (theirs["state"], theirs["ticks"]))

    def test_why(self):
        self.assert_same("why", "soar_flee", "flee", "--agent", "rabbit", has="flee")

    def test_a_recording_is_replayed_verified_and_reported(self):
        self.npm("run", "soar_flee", "--headless", "--seconds", 5, "--record", "flee.soarrec")
        self.assert_same("replay", "flee.soarrec", "--headless", has="rabbit")
        verified = self.native("verify", "flee.soarrec")
        self.assertEqual(verified.returncode, 0, verified.stdout + verified.stderr)
        self.assertIn("equal: ", verified.stdout)
        pages = []
        for program in (self.npm, self.native):
            self.assertEqual(program("report", "flee.soarrec", "-o", "flee.html").returncode, 0)
            pages.append((self.folder / "flee.html").read_text(encoding="utf-8"))
        self.assertIn("rabbit", pages[0])
        self.assertEqual(*pages)

    def test_a_lesson_is_listed_begun_and_graded(self):
        self.assert_same("learn", "--folder", "lessons", has="learn")
        self.npm("learn", "1", "--headless", "--folder", "lessons")
        self.assert_same("learn", "check", "1", "--folder", "lessons", code=1, has="anna")
        solution = REPOSITORY / "lessons" / "01-a-rule" / "solution" / "porter.soar"
        shutil.copy(solution, self.folder / "lessons" / "01-a-rule" / "porter.soar")
        self.assert_same("learn", "check", "1", "--folder", "lessons", has="Passed with all of 10 seeds")

    def test_missions(self):
        self.npm("new", "scout")
        results = []
        for program in (self.npm, self.native):
            lines = [json.loads(line) for line in program("test", "scout", "--seeds", "1..2", "--json", "--no-keep").stdout.splitlines()]
            # The duration is not compared.
            results.append([{key: value for key, value in line.items() if key not in ("cpu_s", "wall_s")} for line in lines])
        self.assertEqual(*results)
        self.assertTrue(results[0][-1]["passed"])

    def test_an_editor_gets_problems(self):
        file = (self.folder / "broken.soar").as_uri()
        messages = [
            {"id": 1, "method": "initialize", "params": {"processId": None, "rootUri": self.folder.as_uri(), "capabilities": {}}},
            {"method": "initialized", "params": {}},
            {"method": "textDocument/didOpen", "params": {"textDocument": {"uri": file, "languageId": "soar", "version": 1, "text": BROKEN}}},
            {"id": 2, "method": "shutdown"}, {"method": "exit"}]
        texts = [json.dumps({"jsonrpc": "2.0", **message}) for message in messages]
        given = "".join(f"Content-Length: {len(text)}\r\n\r\n{text}" for text in texts)
        answers = []
        for program in (self.npm, self.native):
            printed = program("lsp", given=given).stdout
            answers.append([json.loads(part) for part in re.split(r"Content-Length: \d+\s+", printed)[1:]])
        self.assertEqual(*answers)
        problems = [answer for answer in answers[0] if answer.get("method") == "textDocument/publishDiagnostics"]
        self.assertTrue(any(each["params"]["uri"] == file and each["params"]["diagnostics"] for each in problems), answers[0])


class Api(Package):
    """Programs in JavaScript: a client of kernels, worlds, commands."""

    def run_script(self, name, *words):
        shutil.copy(REPOSITORY / "tests" / "wasm" / name, self.installed / name)
        done = subprocess.run(["node", name, *map(str, words)], cwd=self.installed, env=self.environment, capture_output=True, text=True,
                              check=False, timeout=LIMIT_S)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout[-3000:])
        return done.stdout

    def test_a_client_of_a_kernel(self):
        kernel = subprocess.Popen([str(GIVEN.native), "kernel", "--port", "0"], env=self.environment, cwd=self.folder,
                                  stdout=subprocess.PIPE, text=True)
        self.addCleanup(kernel.stdout.close)
        self.addCleanup(kernel.wait)
        self.addCleanup(kernel.kill)
        port = re.search(r":(\d+)", kernel.stdout.readline()).group(1)
        self.assertEqual(self.run_script("npm_client.js", port), "all checks passed\n")

    def test_worlds_and_commands(self):
        self.assertEqual(self.run_script("npm_worlds.js"), "all checks passed\n")

    def test_the_types(self):
        """A program that uses them compiles; one that uses them wrongly does not."""
        compiler = REPOSITORY / "web" / "node_modules" / ".bin" / "tsc"
        self.assertTrue(compiler.exists(), f"{compiler} is missing; npm ci in web/ installs it")
        right = """import {Agent, Kernel, runWorld} from "soarbox";
async function main(): Promise<number> {
  const kernel = await Kernel.CreateRemoteConnection("127.0.0.1", 12121), agent: Agent = await kernel.CreateAgent("a");
  const link = await agent.GetInputLink();
  link.CreateIdWME("pair").CreateIntWME("a", 3).Update(4);
  await agent.RegisterForPrintEvent((_, text) => console.log(text));
  const command = agent.GetCommand(0);
  command?.AddStatusComplete();
  for await (const event of runWorld("soar_flee", {seconds: 3})) if (event.event === "end") return 0;
  return (await agent.RunSelf(3, "phase")).length;
}
void main();
"""
        for text, code in ((right, 0), (right.replace('CreateIntWME("a", 3)', 'CreateIntWME("a", "3")'), 1)):
            (self.installed / "program.ts").write_text(text, encoding="utf-8")
            done = subprocess.run([str(compiler), "--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", "--lib", "es2022,dom",
                                   "--types", "", "program.ts"], cwd=self.installed, env=self.environment, capture_output=True, text=True,
                                  check=False, timeout=LIMIT_S)
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
            self.assertEqual("program.ts(5" in done.stdout, code != 0, done.stdout)


class Serving(Package):
    """The site on this machine."""

    def fetch(self, path, method="GET"):
        try:
            with urllib.request.urlopen(urllib.request.Request(self.address + path, method=method), timeout=60) as answer:
                return answer.status, answer.headers.get("Content-Type"), answer.read()
        except urllib.error.HTTPError as problem:
            return problem.code, problem.headers.get("Content-Type"), problem.read()

    def start(self):
        server = subprocess.Popen([str(self.program), "serve", "--listen", "127.0.0.1:0"], env=self.environment, cwd=self.folder,
                                  stdout=subprocess.PIPE, text=True)
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)
        self.address = re.search(r"http://\S+/", server.stdout.readline()).group()
        return server

    def test_it_sends_the_site_and_nothing_else(self):
        server = self.start()
        status, kind, page = self.fetch("")
        self.assertEqual((status, kind), (200, "text/html; charset=utf-8"))
        self.assertIn(b"soarbox-engine", page)
        status, kind, engine = self.fetch("engine/soarbox-engine.wasm")
        self.assertEqual((status, kind, engine[:4]), (200, "application/wasm", b"\0asm"))
        self.assertEqual(engine, (self.module / "site" / "engine" / "soarbox-engine.wasm").read_bytes())
        for path in ("nothing", "assets", "..%2fpackage.json", "assets/..%2f..%2f..%2fpackage.json", "%00", "%zz"):
            self.assertEqual(self.fetch(path)[0], 404, path)
        self.assertEqual(self.fetch("", method="POST")[0], 405)
        taken = self.npm("serve", "--listen", self.address.removeprefix("http://").rstrip("/"), code=3)
        self.assertIn("EADDRINUSE", taken.stderr)
        server.send_signal(signal.SIGTERM)
        server.wait(LIMIT_S)

    def test_what_it_does_not_take(self):
        self.assertIn("--listen", self.npm("serve", "--help").stdout)
        self.assertIn("--class", self.npm("serve", "--class", "names.txt", code=2).stderr)
        self.assertIn("expected an address of this machine", self.npm("serve", "--listen", "0.0.0.0:8080", code=2).stderr)


class Contents(Package):
    def test_no_dependency_and_all_licences(self):
        described = json.loads((self.module / "package.json").read_text(encoding="utf-8"))
        self.assertNotIn("dependencies", described)
        self.assertEqual([entry.name for entry in (self.installed / "node_modules").iterdir() if not entry.name.startswith(".")], ["soarbox"])
        notices = (self.module / "licences.txt").read_text(encoding="utf-8")
        for name in ("the Soarbox authors", "Bullet", "Recast", "Lua", "zstd", "zlib", "musl", "fmt", "toml++", "CLI11"):
            self.assertIn(name, notices)

    def test_a_damaged_package_says_so(self):
        copy = self.folder / "soarbox"
        shutil.copytree(self.module, copy, ignore=shutil.ignore_patterns("engine", "site"))
        for word in ("list", "serve"):
            done = subprocess.run(["node", str(copy / "soarbox.js"), word], env=self.environment, capture_output=True, text=True,
                                  check=False, timeout=LIMIT_S)
            self.assertEqual(done.returncode, 3)
            self.assertIn("install the package again", done.stderr)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--package", required=True, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--native", required=True, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("tests", nargs="*")
    parser.parse_args(namespace=GIVEN)
    if not GIVEN.package.is_file():
        sys.exit(f"run_npm.py: error: {GIVEN.package} is not there; ./dev npm makes it")
    if not os.access(GIVEN.native, os.X_OK):
        sys.exit(f"run_npm.py: error: {GIVEN.native} is not a program; ./dev build release makes it")
    unittest.main(argv=[sys.argv[0], "-v", *GIVEN.tests])


if __name__ == "__main__":
    main()
