# SPDX-License-Identifier: BSD-2-Clause
"""A scenario can read only below its folder and cannot write, whatever its files contain."""
import os
import pathlib

from soarbox_command import WALKER, Run, ScenarioCase, new_folder, run_json
from test_bad_input import SANDBOX

SAY = """
sp {say
   (state <s> ^superstate nil ^io.output-link <out>)
-->
   (<out> ^walk <w>)
}
"""


class Fence(ScenarioCase):
    def setUp(self):
        super().setUp()
        self.outside = new_folder(self)
        (self.outside / "secret.soar").write_text("sp {secret (state <s> ^superstate nil) --> (<s> ^secret yes)}\n")
        self.write("Good.lua", WALKER)
        self.write("Sandbox.lua", SANDBOX % 'Sandbox.CreateSoarAgent(sandbox, "Good.lua", "own.soar");')

    def run_(self, rules):
        self.write("own.soar", rules + SAY)
        before = sorted(self.folder.rglob("*"))
        run = run_json(self.folder, "--seconds", 0.5, cwd=self.folder)
        self.assertEqual(sorted(self.folder.rglob("*")), before, "nothing was written")
        self.assertEqual(sorted(self.outside.iterdir()), [self.outside / "secret.soar"])
        self.assertTrue(run.of("command", command="walk"), "the rest of the file is loaded: " + run.out)
        return run

    def test_commands_that_write_or_start_something_are_told_with_their_place(self):
        out = self.outside / "written"
        for line in (f"output log {out}", f"output command-to-file {out} print s1", f"save agent {out}", "save agent own2.soar",
                     f"save rete-network --save {out}", f"save percepts --open {out}", f"save chunks {out}", "clog mylog", "log mylog",
                     "visualize wm", "ls", "run 5", "alias print save agent x", f"command-to-file {out} echo x",
                     f"soar init\noutput log {out}", f"time save agent {out}"):
            with self.subTest(line):
                run = self.run_("\n" + line + "\n")
                placed = [d for d in run.diagnostics() if d.get("file", "").endswith("own.soar") and d.get("line", 0) >= 2]
                self.assertTrue(placed, run.out)
                self.assertEqual(run.code, 1)

    def test_files_outside_are_not_read(self):
        (self.folder / "link.soar").symlink_to(self.outside / "secret.soar")
        (self.folder / "folder").symlink_to(self.outside)
        for name in (self.outside / "secret.soar", "link.soar", "folder/secret.soar", os.path.relpath(self.outside / "secret.soar", self.folder)):
            for line in (f"source {name}", f"load file {name}", f"load rete-network --load {name}", f"load percepts --open {name}",
                         f"pushd {pathlib.Path(name).parent}\nsource secret.soar\npopd" if "secret" in str(name) else f"source {name}"):
                with self.subTest(line):
                    run = self.run_(line + "\n")
                    self.assertEqual(run.code, 1, run.out)
                    self.assertTrue([d for d in run.diagnostics() if d.get("file", "").endswith("own.soar")], run.out)

    def test_files_inside_are(self):
        (self.folder / "more").mkdir()
        self.write("more/a.soar", "sp {a (state <s> ^superstate nil) --> (<s> ^a yes)}\nsource b.soar\n")
        self.write("more/b.soar", "sp {b (state <s> ^superstate nil) --> (<s> ^b yes)}\n")
        run = self.run_("pushd more\nsource a.soar\npopd\n")
        self.assertEqual(run.code, 0, run.out)

    def test_rules_that_carry_out_commands_are_fenced_too(self):
        out = self.outside / "written"
        self.run_("sp {write (state <s> ^superstate nil) --> (<s> ^answer (cmd output log |%s|)) (<s> ^other (cmd save agent |%s|))}\n" % (out, out))

    def test_rules_and_scripts_by_names_that_lead_outside_are_refused(self):
        (self.folder / "link.soar").symlink_to(self.outside / "secret.soar")
        (self.outside / "secret.lua").write_text("print('secret')")
        (self.folder / "Link.lua").symlink_to(self.outside / "secret.lua")
        self.addCleanup(lambda: (self.outside / "secret.lua").unlink())
        for rules in (self.outside / "secret.soar", "../" + self.outside.name + "/secret.soar", "link.soar"):
            self.write("Sandbox.lua", SANDBOX % f'Sandbox.CreateSoarAgent(sandbox, "Good.lua", "{rules}");')
            run = run_json(self.folder, "--seconds", 0.1, code=1)
            self.assertEqual(len(run.of("failed")), 1, run.out)
        for script in ("Link.lua", str(self.outside / "secret.lua"), "../" + self.outside.name + "/secret.lua"):
            self.write("Sandbox.lua", SANDBOX % f'Sandbox.CreateAgent(sandbox, "{script}");')
            run = run_json(self.folder, "--seconds", 0.1, code=1)
            self.assertNotIn('"secret"', run.out)

    def test_the_users_own_shell_keeps_all_commands(self):
        rules = self.write("mine.soar", f"output log {self.outside / 'log'}\nsave agent {self.outside / 'agent.soar'}\noutput log --close\n")
        run = Run("soar", rules, cwd=self.folder)
        self.assertTrue((self.outside / "log").exists(), run.out)
        self.assertTrue((self.outside / "agent.soar").exists())
