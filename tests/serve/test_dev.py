# SPDX-License-Identifier: BSD-2-Clause
"""`./dev serve` starts a server from the existing build, and Ctrl+C ends it. `./dev soarbox` builds the page only for commands
that need it."""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]


class DevServe(unittest.TestCase):
    def test_serves_until_it_is_interrupted(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page"
            page.mkdir()
            (page / "index.html").write_text("<title>the page</title>", encoding="utf-8")
            command = [ROOT / "dev", "serve", "--listen", "127.0.0.1:0", "--state", f"{folder}/state", "--page", page]
            with subprocess.Popen(command, cwd=folder, env={**os.environ, "SOARBOX_BUILT": os.environ["SOARBOX_BUILT"]},
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as server:
                try:
                    said = ""
                    for line in server.stdout:
                        said += line
                        if re.search(r"http://\S+", line):
                            break
                    address = re.search(r"http://127\.0\.0\.1:\d+", said)
                    self.assertIsNotNone(address, said)
                    with urllib.request.urlopen(address[0] + "/", timeout=60) as answer:
                        self.assertIn("the page", answer.read().decode())
                finally:
                    server.send_signal(signal.SIGINT)
                    server.communicate(timeout=60)
            self.assertIn(server.returncode, (0, 130, -signal.SIGINT))
            with self.assertRaises(OSError):
                urllib.request.urlopen(address[0] + "/", timeout=10)


class DevSoarbox(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        shutil.copy(ROOT / "dev", self.folder / "dev")
        (self.folder / "web" / "src").mkdir(parents=True)
        for name in ("src/report.ts", "build.mjs", "package-lock.json"):
            (self.folder / "web" / name).touch()
        self.program("bin/node", "exit 0")
        self.program("bin/npm", 'echo "npm $*" >&2; [ "$1" = ci ] && exit ${NPM_FAILS:-0}; mkdir -p dist/page; touch dist/page/report.html')
        self.program("built/bin/soarbox", 'echo "soarbox $*"')

    def program(self, name, text):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("#!/bin/sh\n" + text + "\n", encoding="utf-8")
        file.chmod(0o755)

    def dev(self, *words, **more):
        path = f"{self.folder}/bin:{os.environ['PATH']}"
        return subprocess.run([self.folder / "dev", "soarbox", *words], capture_output=True, text=True, check=False,
                              env={**os.environ, "PATH": path, "SOARBOX_BUILT": str(self.folder / "built"), **more})

    def test_the_page_is_built_for_what_needs_it_where_it_is_old(self):
        for words in (("run", "thesis"), ("check", "report")):
            done = self.dev(*words)
            self.assertEqual((done.returncode, done.stdout), (0, f"soarbox {' '.join(words)}\n"), done.stderr)
            self.assertNotIn("npm", done.stderr)
        done = self.dev("report", "a.soarrec", NPM_FAILS="1")
        self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
        self.assertIn("the page cannot be built", done.stderr)
        done = self.dev("report", "a.soarrec")
        self.assertEqual((done.returncode, done.stdout), (0, "soarbox report a.soarrec\n"), done.stderr)
        self.assertIn("npm run", done.stderr)
        for words in (("report", "b.soarrec"), ("run", "thesis", "--browser"), ("serve",)):
            self.assertNotIn("npm", self.dev(*words).stderr, "it is there")
        later = time.time() + 10
        os.utime(self.folder / "web" / "src" / "report.ts", (later, later))
        self.assertIn("npm run", self.dev("replay", "a.soarrec", "--browser").stderr)

    @unittest.skipUnless(shutil.which("npm"), "npm is not installed")
    def test_npm_reports_why_it_cannot_install_packages_and_nothing_else(self):
        shutil.rmtree(self.folder / "bin")
        package = {"name": "page", "version": "1.0.0", "scripts": {"build": "mkdir -p dist/page && touch dist/page/report.html"}}
        lock = {"name": "page", "version": "1.0.0", "lockfileVersion": 3, "packages": {"": {"name": "page", "version": "1.0.0"}}}
        file = self.folder / "web" / "package.json"
        more = {"npm_config_registry": "http://127.0.0.1:9", "npm_config_fetch_retries": "0", "npm_config_cache": str(self.folder / "cache")}
        for depends in (True, False):
            if depends:
                package["dependencies"] = lock["packages"][""]["dependencies"] = {"uplot": "1.6.32"}
                lock["packages"]["node_modules/uplot"] = {"version": "1.6.32"}
            else:
                del package["dependencies"], lock["packages"][""]["dependencies"], lock["packages"]["node_modules/uplot"]
            file.write_text(json.dumps(package), encoding="utf-8")
            file.with_name("package-lock.json").write_text(json.dumps(lock), encoding="utf-8")
            done = self.dev("report", "a.soarrec", **more)
            if depends:
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("ECONNREFUSED", done.stderr)
                self.assertIn("the page cannot be built", done.stderr)
            else:
                self.assertEqual((done.returncode, done.stdout), (0, "soarbox report a.soarrec\n"), done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, "only: building the page\n" + done.stderr)


if __name__ == "__main__":
    unittest.main()
