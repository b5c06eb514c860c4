# SPDX-License-Identifier: BSD-2-Clause
"""An untrusted sweep: its file, its results folder and its variants cannot access anything outside of the folder."""
import hashlib
import os
import socket
import threading

import strangers_folder
from soarbox_command import COMMAND, page_missing
from strangers_folder import SECRET, rules, run

TOP = 'scenario = "folder"\nseeds = "1..2"\nseconds = 0.2\n'


def checksum(text):
    """A row with its checksum before it."""
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = ((value ^ byte) * 0x100000001B3) & (1 << 64) - 1
    return f"{value:016x} {text}\n"


class Sweeps(strangers_folder.StrangersFolder):
    """Here the sweep is next to the untrusted scenario. Only `mine` and the results may change."""

    def setUp(self):
        super().setUp()
        self.pack = self.top / "pack"
        self.pack.mkdir()
        self.folder, self.results = self.pack / "folder", self.pack / "sweep.sweep"
        (self.outside / "agent.soar").write_text("# somebody's rules\n")
        (self.outside / ".profile").write_text("# somebody's shell\n")
        (self.outside / ".keys").mkdir()
        (self.outside / ".keys" / "key").write_text("precious\n")

    def state(self):
        """All files outside of the user's folder, with checksums of their contents."""
        return [(path, hashlib.md5(path.read_bytes()).hexdigest() if path.is_file() and not path.is_symlink() else "", path.is_symlink())
                for root in (self.outside, self.folder) for path in sorted(root.rglob("*"))]

    def sweep(self, text, *arguments, codes=(0, 1, 3)):
        spec = self.pack / "sweep.toml"
        spec.write_text(text, encoding="utf-8")
        done = self.check(text, [COMMAND, "sweep", spec, *arguments], codes=codes)
        kept = [path for path in self.results.rglob("*") if path.is_file() and not path.is_symlink()]
        for path in kept:
            self.assertFalse(SECRET.encode() in path.read_bytes(), f"{path} holds what lies outside")
        return done

    def test_variants_write_into_their_own_copies(self):
        self.lay(rules(""))
        (self.pack / "other.soar").write_text("# other rules\n")
        victims = [f"{self.outside}/agent.soar", "../../../../outside/agent.soar", "../../../../../outside/agent.soar", "../hero.soar",
                   "../../../folder/hero.soar"]
        for victim in victims:
            with self.subTest("rules", victim=victim):
                done = self.sweep(TOP + f'[[variant]]\nname = "a"\nrules = {{ "{victim}" = "other.soar" }}\n')
                self.assertEqual(done.code, 3, done.out)
                self.assertIn("the scenario has no rules", done.out)

    def test_setup_writes_into_the_copy_of_the_rules_only(self):
        for victim in (f"{self.outside}/.profile", "../../../../outside/.profile", "../../../../outside/agent.soar", "../hero.soar"):
            self.lay({"scenario.toml": strangers_folder.WORLD.replace("hero.soar", victim), "hero.soar": strangers_folder.GOOD})
            with self.subTest(victim):
                done = self.sweep(TOP + '[[variant]]\nname = "a"\nsetup = ["echo touched"]\n')
                self.assertEqual(done.code, 3, done.out)
                self.assertIn("not in the scenario's folder", done.out)
            self.lay(rules(""))
            with self.subTest("by a parameter", victim=victim):
                self.sweep(TOP + f'[[variant]]\nname = "a"\nsetup = ["echo touched"]\nparameters = {{ "agent.hero.rules" = "{victim}" }}\n')

    def test_nothing_outside_is_read(self):
        self.lay(rules(""))
        secret = self.outside / "secret.soar"
        (self.pack / "link.soar").symlink_to(secret)
        (self.pack / "link.toml").symlink_to(self.outside / "secret.toml")
        for name in (secret, "link.soar"):
            for who in ("hero", "hero.soar"):
                with self.subTest(name=name, who=who):
                    done = self.sweep(TOP + f'[[variant]]\nname = "a"\nrules = {{ "{who}" = "{name}" }}\n')
                    self.assertIn("beside this sweep", done.out)
        for name in (self.outside / "secret.toml", "link.toml"):
            with self.subTest(mission=name):
                done = self.sweep(f'mission = "{name}"\nseeds = "1..2"\nseconds = 0.2\n')
                self.assertIn("there is no mission", done.out)

    def test_a_results_folder_that_came_along_leads_nowhere(self):
        self.lay(rules(""))
        text = TOP + 'record = "all"\n[[variant]]\nname = "keys"\n'

        def make(name, target):
            for path in sorted(self.results.rglob("*"), reverse=True):
                path.rmdir() if path.is_dir() and not path.is_symlink() else path.unlink()
            place = self.results / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.symlink_to(target)

        for name in ("variants", "parts", "recordings", "slurm", "variants/keys", "variants/.keys", "parts/a.rows", "sweep.id",
                     "results.csv", ".results.csv", "results.sqlite", ".results.sqlite", "recordings/keys-1.soarrec"):
            for target in (self.outside, self.outside / "agent.soar", self.outside / "new", "/dev/zero"):
                make(name, target)
                with self.subTest(name=name, target=target):
                    done = self.sweep(text)
                    self.assertEqual(done.code, 3, done.out)
                    self.assertRegex(done.out, "only plain files|cannot be made")
                with self.subTest("report", name=name, target=target):
                    self.check("report", [COMMAND, "report", self.pack / "sweep.toml", "-o", self.mine / "page.html"])

    def test_pipes_and_sockets_in_a_results_folder_hang_nothing(self):
        self.lay(rules(""))
        (self.results / "parts").mkdir(parents=True)
        os.mkfifo(self.results / "parts" / "a.rows")
        self.assertEqual(self.sweep(TOP).code, 3)

    def test_rows_that_somebody_else_wrote_are_read_with_care(self):
        self.lay(rules(""))
        (self.results / "parts").mkdir(parents=True)
        rows = ['{"key": 5}', '{"key": "a", "variant": -1}', '{"key": "b", "variant": 99999999999, "seed": "x"}', "[]", "5", '{"metrics": 5}',
                '{"metrics": {"a": 1}, "result": {}}', "[" * 100_000, '{"key": "c", "result": "{\\"checks\\": 5}"}', '{"tries": 1e400}',
                '{"key": "d", "result": "{\\"idle_checks\\": [9999999], \\"state_hash\\": \\"x\\"}"}']
        (self.results / "parts" / "a.rows").write_text("".join(map(checksum, rows)) + "x" * 100_000 + "\0\n")
        done = self.sweep(TOP, codes=(0,))
        self.assertIn("2 runs made", done.out)
        if page_missing():
            self.skipTest(page_missing())
        self.check("report", [COMMAND, "report", self.pack / "sweep.toml", "-o", self.mine / "page.html"], codes=(0,))

    def test_a_job_that_is_none_is_not_handed_to_slurm(self):
        self.lay(rules(""))
        programs = self.top / "programs"
        programs.mkdir()
        for name in ("sbatch", "squeue", "scancel"):
            (programs / name).write_text(f'#!/bin/sh\necho "$@" >>{self.top}/asked\n')
            (programs / name).chmod(0o755)
        (self.results / "slurm").mkdir(parents=True)
        (self.results / "slurm" / "job").write_text("--user=somebody\n")
        (self.pack / "sweep.toml").write_text(TOP)
        command = [COMMAND, "sweep", self.pack / "sweep.toml", "--cancel"]
        done = run(["env", f"PATH={programs}:{os.environ['PATH']}", *command], self.folder)
        self.assertIn("this sweep was not given to Slurm", done.out)
        self.assertFalse((self.top / "asked").exists())

    def test_names_of_variants_are_names(self):
        self.lay(rules(""))
        for name in ("../x", ".x", "a/b", "..", "a\\u0000b", "\\u0000", "a\\nb", "x" * 300):
            with self.subTest(name):
                done = self.sweep(TOP + f'[[variant]]\nname = "{name}"\n')
                self.assertEqual(done.code, 3)
                self.assertIn("not a name for a variant", done.out)

    def test_kernels_of_other_machines_are_not_reached(self):
        self.lay(rules(""))
        for kernel in ("192.0.2.1:12121", "example.org:80", "[::1]:12121", "127.0.0.1", "127.0.0.1:0", "127.0.0.1:99999", "localhost:x"):
            with self.subTest(kernel):
                done = self.sweep(TOP + f'[[variant]]\nname = "a"\nkernel = "{kernel}"\n')
                self.assertEqual(done.code, 3)
                self.assertIn("is not a kernel of this machine", done.out)

    def test_a_server_that_never_answers_ends_the_sweep_or_its_runs(self):
        self.lay(rules(""))
        with socket.create_server(("127.0.0.1", 0)) as server:
            thread = threading.Thread(target=self.swallow, args=(server,), daemon=True)
            thread.start()
            done = self.sweep(TOP + f'[[variant]]\nname = "a"\nkernel = "127.0.0.1:{server.getsockname()[1]}"\n')
        self.assertNotEqual(done.code, 0)

    @staticmethod
    def swallow(server):
        held = []
        try:
            while True:
                held.append(server.accept()[0])
        except OSError:
            pass
