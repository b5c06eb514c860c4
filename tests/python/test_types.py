# SPDX-License-Identifier: BSD-2-Clause
"""A type checker accepts the package soarbox, and a program that uses soar_sml."""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = '''
import soar_sml as sml


def phrase(event: int, data: str, agent: sml.Agent, function: str, argument: str) -> str:
    return data + argument


def main() -> None:
    kernel = sml.Kernel.CreateKernelInNewThread(sml.Kernel.kSuppressListener)
    kernel.record("run.soarrec")
    agent = kernel.CreateAgent("scout")
    kernel.AddRhsFunction("phrase", phrase, "Good morning, ")
    wme = agent.GetInputLink().CreateIntWME("x", 1)
    wme.Update(3)
    agent.RunSelf(2)
    print(agent.ExecuteCommandLine("print s1"))
    kernel.Shutdown()
'''


@unittest.skipUnless(importlib.util.find_spec("mypy"), "needs mypy (python3-mypy)")
class Types(unittest.TestCase):
    def mypy(self, *arguments, stubs=""):
        with tempfile.TemporaryDirectory() as cache:
            return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", cache, *map(str, arguments)],
                                  capture_output=True, text=True, env=os.environ | {"MYPYPATH": str(stubs)})

    def test_the_package_is_strictly_typed(self):
        package = pathlib.Path(importlib.util.find_spec("soarbox").origin).parent
        self.assertTrue((package / "py.typed").exists())
        checked = self.mypy(package)
        self.assertEqual(checked.returncode, 0, checked.stdout)

    def test_the_client_interface_has_types(self):
        modules = pathlib.Path(importlib.util.find_spec("soar_sml").origin).parent
        with tempfile.TemporaryDirectory() as folder:
            # For installed packages, the checker finds the stubs itself.
            for name in ("soar_sml", "Python_sml_ClientInterface"):
                shutil.copy(modules / f"{name}-stubs" / "__init__.pyi", pathlib.Path(folder) / f"{name}.pyi")
            program = pathlib.Path(folder) / "program.py"
            program.write_text(PROGRAM, encoding="utf-8")
            checked = self.mypy(program, stubs=folder)
            self.assertEqual(checked.returncode, 0, checked.stdout)
            program.write_text(PROGRAM.replace('"x", 1', '"x", "one"').replace("Shutdown", "ShutDown"), encoding="utf-8")
            checked = self.mypy(program, stubs=folder)
            self.assertEqual(checked.stdout.count("error:"), 2, checked.stdout)


if __name__ == "__main__":
    unittest.main()
