# SPDX-License-Identifier: BSD-2-Clause
"""The bill of materials names what the page and the programs contain."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "packaging" / "bill_of_materials.py"


class Bill(unittest.TestCase):
    def test_it_names_packages_of_the_page_and_libraries_of_the_programs(self):
        done = subprocess.run([sys.executable, SCRIPT, os.environ["SOARBOX_BUILD"]], capture_output=True, text=True, check=True)
        bill = json.loads(done.stdout)
        self.assertEqual((bill["bomFormat"], bill["metadata"]["component"]["name"]), ("CycloneDX", "soarbox"))
        parts = {part["name"]: part for part in bill["components"]}
        wanted = json.loads((ROOT / "web" / "package.json").read_text(encoding="utf-8"))
        for name, version in wanted["dependencies"].items():
            self.assertEqual(parts[name]["version"], version)
        for name in wanted["devDependencies"]:
            self.assertNotIn(name, parts, "what only builds or tests is not in the product")
        if (pathlib.Path("/var/lib/dpkg/status")).exists():
            self.assertIn("libluajit-5.1-2", parts, "a library that the program is linked with")
            self.assertIn("nlohmann-json3-dev", parts, "headers that are compiled in")
        for part in bill["components"]:
            self.assertTrue(part["version"] and part["purl"].startswith("pkg:"), part)

    def test_without_a_build_it_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("no soarbox was built here", done.stderr)


if __name__ == "__main__":
    unittest.main()
