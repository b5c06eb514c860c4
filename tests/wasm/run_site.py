#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Tests a site that `./dev site` has written, in a browser.

usage: run_site.py [--site FOLDER|NAME.html] [--firefox] [--or-skip] [TEST...]

Python's file server serves a folder below a path, as on any static host. A single file is opened from the disk. TEST: files with tests to
run instead of site.mjs, for example web/e2e/lessons.mjs. Needs Chromium (SOARBOX_BROWSER) and the page's packages (npm ci in web/).
--firefox: runs firefox.mjs in Firefox (SOARBOX_FIREFOX), on a display of its own (xvfb-run).
--or-skip: if there is no site, or if it is older than the sources, prints the reason and exits with 77.
"""
import argparse
import functools
import http.server
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "tests" / "serve"))
from once_more import run_files  # noqa: E402

SKIPPED = 77


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def newest_source():
    """The newest file from which a site is built."""
    listed = subprocess.run(["git", "ls-files", "src", "web/src", "lessons", "scenarios", "media", "cmake/wasm"], cwd=REPOSITORY,
                            capture_output=True, text=True, check=True).stdout.split("\n")
    files = [REPOSITORY / name for name in listed if name and not name.endswith(("_test.cpp", ".test.ts"))]
    return max((file for file in files if file.is_file()), key=lambda file: file.stat().st_mtime)


def what_is_missing(site, is_old_good, is_firefox):
    """The reason why nothing can be tested; empty: there is none."""
    proof = site if site.suffix == ".html" else site / "index.html"
    if not proof.is_file():
        return f"there is no site in {site}: ./dev site writes it (it needs emscripten, docs/dev/wasm.md)"
    if not is_old_good and (newest := newest_source()).stat().st_mtime > proof.stat().st_mtime:
        return f"the site in {site} is older than {newest.relative_to(REPOSITORY)}: ./dev site writes it again"
    if not all((REPOSITORY / "web" / "node_modules" / name).is_dir() for name in ("playwright-core", "puppeteer-core")):
        return "the page's packages are not there: npm ci in web/"
    if is_firefox and not os.environ.get("DISPLAY") and not shutil.which("xvfb-run"):
        return "there is no display for Firefox: install xvfb and xauth"
    variable, program = ("SOARBOX_FIREFOX", "/usr/bin/firefox-esr") if is_firefox else ("SOARBOX_BROWSER", "/usr/bin/chromium")
    if not shutil.which(os.environ.get(variable, program)):
        return f"there is no {program}: install it, or name a browser in {variable}"
    return ""


def run(tests, address, with_display):
    """Runs files of tests. Returns the exit status. with_display: on a display of its own if there is a program for that."""
    virtual = ["xvfb-run", "--auto-servernum", "--server-args=-screen 0 1400x1000x24"] if with_display and shutil.which("xvfb-run") else []

    def passes(test):
        return subprocess.run([*virtual, "node", "--test", str(test)], check=False, env={**os.environ, "SOARBOX_PAGE": address}).returncode == 0

    return run_files(tests, passes)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--site", type=pathlib.Path, default=REPOSITORY / "build" / "site")
    parser.add_argument("--firefox", action="store_true")
    parser.add_argument("--or-skip", action="store_true")
    parser.add_argument("tests", nargs="*")
    arguments = parser.parse_args()
    site = arguments.site.resolve()
    tests = arguments.tests or [REPOSITORY / "tests" / "wasm" / ("firefox.mjs" if arguments.firefox else "site.mjs")]
    if missing := what_is_missing(site, not arguments.or_skip, arguments.firefox):
        print(f"{'skipped: ' if arguments.or_skip else 'error: '}{missing}", file=sys.stderr)
        return SKIPPED if arguments.or_skip else 1
    if site.suffix == ".html":
        return run(tests, site.as_uri(), arguments.firefox)
    with tempfile.TemporaryDirectory() as root:
        (pathlib.Path(root) / "some").mkdir()
        (pathlib.Path(root) / "some" / "place").symlink_to(site)
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=root)) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            code = run(tests, f"http://127.0.0.1:{server.server_address[1]}/some/place/", arguments.firefox)
            server.shutdown()
    return code


if __name__ == "__main__":
    sys.exit(main())
