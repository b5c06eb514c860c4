# SPDX-License-Identifier: BSD-2-Clause
"""Runs the page's end-to-end tests (web/e2e) in a real browser, against a real server and reports that the command has created.

usage: in_browser.py [TEST...]

Needs the page built (./dev serve), its packages (npm ci in web/) and Chromium; SOARBOX names the command.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

import report_samples
from once_more import run_files
from web_client import COMMAND, Server

WEB = pathlib.Path(__file__).resolve().parents[2] / "web"


class PageServer(Server):
    def start(self, words):
        at = words.index("--page")
        super().start(words[:at] + words[at + 2:])


def main():
    if not (WEB / "dist" / "page" / "index.html").exists():
        sys.exit("the page is not built: npm run build in web/")
    with tempfile.TemporaryDirectory() as folder:
        reports = pathlib.Path(folder) / "reports"
        tests = sys.argv[1:] or sorted(str(path.relative_to(WEB)) for path in (WEB / "e2e").glob("*.mjs"))
        if any(test.endswith("report.mjs") for test in tests):
            report_samples.make(reports)
        server = PageServer(folder)
        try:
            environment = {**os.environ, "SOARBOX_PAGE": server.origin, "SOARBOX_REPORTS": str(reports), "SOARBOX_COMMAND": COMMAND}

            def passes(test):
                done = subprocess.run(["node", "--test", test], cwd=WEB, check=False, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                print(done.stdout, end="", flush=True)
                return done.returncode == 0

            return run_files(tests, passes, at_a_time=2)
        finally:
            server.kill()


if __name__ == "__main__":
    sys.exit(main())
