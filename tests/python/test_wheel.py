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


def unpack(wheel, place):
    """Unpacks a wheel like pip, with the permission to execute programs."""
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(place)
        for entry in archive.infolist():
            (place / entry.filename).chmod(entry.external_attr >> 16 & 0o777)


class Wheel(unittest.TestCase):
    def test_its_modules_work_from_where_it_is_unpacked(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, TOOL, os.environ["SOARBOX_BUILD"], folder], check=True, stdout=subprocess.DEVNULL)
            [wheel] = pathlib.Path(folder).glob("soarbox-*.whl")
            self.assertRegex(wheel.name, rf"^soarbox-[\d.]+-cp3{sys.version_info.minor}-cp3\d+-linux_\w+\.whl$")
            place = pathlib.Path(folder) / "unpacked"
            unpack(wheel, place)
            [record] = place.glob("*.dist-info/RECORD")
            with open(record, encoding="utf-8") as rows:
                listed = {row[0] for row in csv.reader(rows)}
            held = {path.relative_to(place).as_posix() for path in place.rglob("*") if path.is_file()}
            self.assertEqual(listed, held)
            code = ("import soar_sml, soarbox\n"
                    "kernel = soar_sml.Kernel.CreateKernelInNewThread(0)\n"
                    "print(kernel.CreateAgent('scout').GetAgentName())\n"
                    "world = soarbox.World('soar_hallway', seed=3)\n"
                    "world.step(30)\n"
                    "print(world.tick, [agent.name for agent in world])\n"
                    "for who, process in (('python', 'self'), ('engine', world._engine._process.pid)):\n"
                    "    for line in open(f'/proc/{process}/maps'):\n"
                    "        if '.so' in line: print(who, line.split()[-1])\n")
            # Only the wheel: no command on the path, and no library of the build.
            done = subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": str(place), "PATH": "/usr/bin:/bin"},
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            said = done.stdout.splitlines()
            self.assertEqual(said[:2], ["scout", "30 ['anna', 'bert']"])
            self.assertIn(f"python {place / 'libsoarbox-sml.so.0'}", said)
            self.assertTrue(any(line.startswith(f"python {place}") and "libsqlite3" in line for line in said))
            loaded = {line.removeprefix("engine ") for line in said if line.startswith("engine ")}
            ours = {pathlib.Path(file).name.split(".so")[0] for file in loaded if file.startswith(str(place))}
            self.assertLessEqual({"libsqlite3", "libBulletDynamics", "libluajit-5.1"}, ours)
            system = {pathlib.Path(file).name.split(".so")[0] for file in loaded if not file.startswith(str(place))}
            self.assertFalse(system & ours, "a library comes from the system, too")

    def test_a_build_without_the_binding_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "CMakeCache.txt").write_text("CMAKE_PROJECT_VERSION:STATIC=1\n", encoding="utf-8")
            done = subprocess.run([sys.executable, TOOL, folder, folder], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 1)
            self.assertIn("has no binding for Python; install swig", done.stderr)


if __name__ == "__main__":
    unittest.main()
