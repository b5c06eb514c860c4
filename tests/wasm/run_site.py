#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-2-Clause
"""Tries a site that `./dev site` has written in a browser.

usage: run_site.py [--site FOLDER] [TEST...]

The site is served by Python's server of files, below a path, as on any static host. TEST: files of tests instead of site.mjs, for
example web/e2e/lessons.mjs. Needs Chromium (SOARBOX_BROWSER) and the page's packages (npm ci in web/).
"""
import argparse
import functools
import http.server
import os
import pathlib
import subprocess
import sys
import tempfile
import threading

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--site", type=pathlib.Path, default=REPOSITORY / "build" / "site")
    parser.add_argument("tests", nargs="*", default=[REPOSITORY / "tests" / "wasm" / "site.mjs"])
    arguments = parser.parse_args()
    if not (arguments.site / "engine").is_dir():
        sys.exit(f"there is no site in {arguments.site}: ./dev site writes it")
    with tempfile.TemporaryDirectory() as root:
        (pathlib.Path(root) / "some").mkdir()
        (pathlib.Path(root) / "some" / "place").symlink_to(arguments.site.resolve())
        with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=root)) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            address = f"http://127.0.0.1:{server.server_address[1]}/some/place"
            done = subprocess.run(["node", "--test", "--test-concurrency=1", *map(str, arguments.tests)], check=False,
                                  env={**os.environ, "SOARBOX_PAGE": address})
            server.shutdown()
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
