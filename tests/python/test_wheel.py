# SPDX-License-Identifier: BSD-2-Clause
"""The wheel of a build contains everything that its modules need, and correct metadata."""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

TOOL = pathlib.Path(__file__).parents[2] / "bindings/python/wheel.py"


class Wheel(unittest.TestCase):
    def test_its_modules_work_from_where_it_is_unpacked(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, TOOL, os.environ["SOARBOX_BUILD"], folder], check=True, stdout=subprocess.DEVNULL)
            [wheel] = pathlib.Path(folder).glob("soarbox-*.whl")
            self.assertRegex(wheel.name, rf"^soarbox-[\d.]+-cp3{sys.version_info.minor}-cp3\d+-linux_\w+\.whl$")
            place = pathlib.Path(folder) / "unpacked"
            with zipfile.ZipFile(wheel) as archive:
                archive.extractall(place)
            [record] = place.glob("*.dist-info/RECORD")
            with open(record, encoding="utf-8") as rows:
                listed = {row[0] for row in csv.reader(rows)}
            held = {path.relative_to(place).as_posix() for path in place.rglob("*") if path.is_file()}
            self.assertEqual(listed, held)
            code = ("import soar_sml, soarbox\n"
                    "kernel = soar_sml.Kernel.CreateKernelInNewThread(0)\n"
                    "print(kernel.CreateAgent('scout').GetAgentName())\n"
                    "print(next(line.split()[-1] for line in open('/proc/self/maps') if 'libsoarbox-sml' in line))\n")
            said = subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": str(place)}, capture_output=True,
                                  text=True, check=True).stdout.splitlines()
            self.assertEqual(said, ["scout", str(place / "libsoarbox-sml.so.0")])

    def test_a_build_without_the_binding_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "CMakeCache.txt").write_text("CMAKE_PROJECT_VERSION:STATIC=1\n", encoding="utf-8")
            done = subprocess.run([sys.executable, TOOL, folder, folder], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertIn("has no binding for Python; install swig", done.stderr)


if __name__ == "__main__":
    unittest.main()
