# SPDX-License-Identifier: BSD-2-Clause
"""`./dev serve` starts a server that answers, and Ctrl+C ends it; it takes the build that there is."""
import os
import pathlib
import re
import signal
import subprocess
import tempfile
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


if __name__ == "__main__":
    unittest.main()
