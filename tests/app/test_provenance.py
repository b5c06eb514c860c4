# SPDX-License-Identifier: BSD-2-Clause
"""The provenance of a table: its manifest, and repetition of its runs."""
import csv
import hashlib
import json
import re
import shutil
import socket
import sqlite3
import subprocess

from mission_case import REPOSITORY, RULES, SWEEP, MissionCase
from soarbox_command import Run


class Provenance(MissionCase):
    def sweep(self, *words, code=0):
        self.mission("")
        return Run("sweep", self.write("study.toml", SWEEP), *words, code=code)

    def manifest(self):
        return json.loads((self.folder / "study.sweep" / "manifest.json").read_text(encoding="utf-8"))

    def test_version_names_commit_and_build(self):
        out = Run("--version", code=0).out
        self.assertRegex(out, r"\A\d+\.\d+\.\d+\n(commit [0-9a-f]{40}( with changes)?\n)?build [0-9a-f]+\n\Z")
        git = subprocess.run(["git", "-C", REPOSITORY, "rev-parse", "HEAD"], capture_output=True, text=True, check=False)
        if git.returncode == 0:
            self.assertIn("\ncommit ", out)

    def test_a_manifest_names_all_that_the_tables_were_made_from(self):
        self.sweep("--jobs", "2")
        manifest = self.manifest()
        self.assertIn(manifest["build"].split()[1], Run("--version").out)
        self.assertEqual(manifest["command"][1:], ["sweep", str(self.folder / "study.toml"), "--jobs", "2"])
        self.assertEqual((manifest["runs"], manifest["seeds"]), (12, [1, 2, 3, 4, 5, 6]))
        self.assertRegex(manifest["written"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertEqual(manifest["sweep_sha256"], hashlib.sha256((self.folder / "study.toml").read_bytes()).hexdigest())
        self.assertEqual([variant["name"] for variant in manifest["variants"]], ["slow", "fast"])
        for variant in manifest["variants"]:
            folder = self.folder / "study.sweep" / "variants" / variant["name"]
            files = sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())
            self.assertEqual(sorted(variant["sha256"]), files)
            for name, digest in variant["sha256"].items():
                self.assertEqual(digest, hashlib.sha256((folder / name).read_bytes()).hexdigest())
        with sqlite3.connect(self.folder / "study.sweep" / "results.sqlite") as database:
            kept = dict(database.execute("SELECT name, value FROM metadata"))
        self.assertEqual(kept["build"], manifest["build"])
        self.assertEqual(json.loads(kept["variants"]), manifest["variants"])

    def test_only_the_manifest_says_when_and_where(self):
        self.sweep()
        tables = {name: (self.folder / "study.sweep" / name).read_bytes() for name in ("results.csv", "numbers.csv")}
        self.sweep()
        for name, content in tables.items():
            self.assertEqual((self.folder / "study.sweep" / name).read_bytes(), content)

    def test_numbers_in_long_form_are_those_of_the_table(self):
        self.sweep()
        folder = self.folder / "study.sweep"
        with open(folder / "results.csv", newline="", encoding="utf-8") as file:
            wide = {(row["variant"], row["seed"]): row for row in csv.DictReader(file)}
        with open(folder / "numbers.csv", newline="", encoding="utf-8") as file:
            tidy = list(csv.DictReader(file))
        columns = list(tidy[0])
        self.assertEqual(columns[:2] + columns[-2:], ["variant", "seed", "name", "value"])
        self.assertEqual(set(columns[2:-2]), {"agent.scout.speed", "agent.scout.senses.noise"})
        for row in tidy:
            cell = wide[row["variant"], row["seed"]][row["name"]]
            expected = {"true": 1.0, "false": 0.0, "untested": 0.0}.get(cell)
            self.assertEqual(float(row["value"]), float(cell) if expected is None else expected)
        names = {row["name"] for row in tidy}
        self.assertLessEqual({"check: there", "distance", "decisions", "passed"}, names)
        arrivals = [row for row in tidy if row["name"] == "arrival"]
        self.assertEqual(len(arrivals), sum(row["arrival"] != "" for row in wide.values()))
        with sqlite3.connect(folder / "results.sqlite") as database:
            self.assertEqual(database.execute("SELECT count(*) FROM numbers").fetchone()[0], len(tidy))

    def test_lines_of_json_are_the_rows_of_the_table(self):
        run = self.sweep("--json")
        with open(self.folder / "study.sweep" / "results.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        lines = run.of("run")
        self.assertEqual(len(lines), 12)
        for line, row in zip(lines, rows, strict=True):
            self.assertEqual((line["variant"], line["seed"], line["state_hash"]), (row["variant"], int(row["seed"]), row["state_hash"]))
            self.assertAlmostEqual(line["distance"], float(row["distance"]), places=6)
        self.assertEqual(run.of("sweep")[0]["runs"], 12)
        self.assertEqual(run.of("sweep")[0]["missing"], 0)

    def test_runs_made_again_are_equal_and_what_was_changed_is_found(self):
        self.sweep()
        folder = self.folder / "study.sweep"
        self.assertIn("12 of 12 runs made again, 0 differ", Run("sweep", "--verify", folder, code=0).out)
        self.assertIn("5 of 12 runs made again, 0 differ", Run("sweep", "--verify", folder, "--sample", "5", code=0).out)
        moved = self.folder / "elsewhere"
        shutil.copytree(folder, moved)
        self.assertIn("12 of 12 runs made again, 0 differ", Run("sweep", "--verify", moved, "--sample", "0", code=0).out)
        # Rules that were changed afterwards.
        rules = folder / "variants" / "fast" / "scout.soar"
        rules.write_text(rules.read_text(encoding="utf-8").replace("gate", "mill"), encoding="utf-8")
        run = Run("sweep", "--verify", folder, code=1)
        self.assertIn("6 rows belong to no variant that the folder holds", run.out)
        self.assertIn("this is not a folder of a sweep", Run("sweep", "--verify", self.folder, code=3).err)

    def test_a_row_that_says_something_else_is_found(self):
        self.sweep()
        parts = self.folder / "study.sweep" / "parts"
        part = next(parts.glob("*.rows"))
        lines = part.read_text(encoding="utf-8").splitlines()
        def checksum(text):
            value = 0xcbf29ce484222325
            for byte in text.encode():
                value = (value ^ byte) * 0x100000001b3 % 2**64
            return f"{value:016x} "
        body = lines[3][17:]
        forged = re.sub(r'(state_hash\\":\\")\d+', r"\g<1>12345", body)
        self.assertNotEqual(body, forged)
        lines[3] = checksum(forged) + forged
        part.write_text("\n".join(lines) + "\n", encoding="utf-8")
        run = Run("sweep", "--verify", self.folder / "study.sweep", code=1)
        self.assertRegex(run.out, r"variant '(slow|fast)', seed \d: its state is [0-9a-f]{16} now, and 0000000000003039 in its row")
        self.assertIn("12 of 12 runs made again, 1 differ", run.out)


class OfRecordings(MissionCase):
    def record(self, name, *words, rules=None):
        self.mission("", **({} if rules is None else {"rules": rules}))
        file = self.folder / name
        Run("run", self.folder / "scenario.toml", "--headless", "--seconds", 3, "--seed", 3, "--record", file, *words, code=0)
        return file

    def info(self, file):
        return json.loads(Run("replay", file, "--info", "--json", code=0).out)

    def test_a_recording_says_what_it_was_made_from_when_and_where(self):
        file = self.record("run.soarrec")
        info = self.info(file)
        manifest = info["manifest"]
        version = Run("--version").out.splitlines()
        self.assertEqual(manifest["program"], "soarbox " + version[0])
        self.assertEqual(manifest["build"], info["build"])
        if version[1].startswith("commit "):
            self.assertEqual(manifest["commit"], version[1].removeprefix("commit "))
        self.assertEqual(manifest["command"][1:3], ["run", str(self.folder / "scenario.toml")])
        self.assertEqual(manifest["host"], socket.gethostname())
        self.assertRegex(manifest["began"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertEqual((manifest["seed"], info["seed"], info["last_tick"]), (3, 3, 90))
        files = {name: hashlib.sha256((self.folder / name).read_bytes()).hexdigest() for name in ("scenario.toml", "scout.soar")}
        self.assertEqual(manifest["sha256"], files)
        self.assertTrue(all(re.fullmatch("[0-9a-f]{64}", digest) for digest in manifest["library_sha256"].values()))
        text = Run("replay", file, "--info", code=0).out
        for words in (manifest["host"], manifest["began"], f"  {files['scout.soar']}  scout.soar", "soarbox", "seed            3"):
            self.assertIn(words, text)

    def test_nothing_that_is_compared_depends_on_when_and_where(self):
        a = self.record("a.soarrec")
        b = self.record("b.soarrec", "--threads", "1")
        self.assertNotEqual(self.info(a)["manifest"]["command"], self.info(b)["manifest"]["command"])
        self.assertRegex(Run("compare", a, b, code=0).out, r"\Aequal: ticks 0 to 90\n\Z")
        Run("verify", a, code=0)
        self.assertEqual(Run("export", a, "--json", code=0).out, Run("export", b, "--json", code=0).out)

    def test_rules_given_on_the_command_line_are_among_the_digests(self):
        other = self.write("other.soar", RULES.replace("off I go", "here I go"))
        digests = self.info(self.record("run.soarrec", "--rules", f"scout={other}"))["manifest"]["sha256"]
        self.assertEqual(digests["other.soar"], hashlib.sha256(other.read_bytes()).hexdigest())

    def test_a_part_keeps_the_manifest_and_a_run_that_continues_has_its_own(self):
        file = self.record("run.soarrec")
        whole = self.info(file)["manifest"]
        Run("export", file, "--recording", "--from", "1", "--to", "2", "-o", self.folder / "part.soarrec", code=0)
        self.assertEqual(self.info(self.folder / "part.soarrec")["manifest"], whole)
        Run("resume", file, "--at", "1", "--record", self.folder / "on.soarrec", code=0)
        on = self.info(self.folder / "on.soarrec")
        self.assertEqual(on["manifest"]["command"][1], "resume")
        self.assertEqual((on["manifest"]["sha256"], on["branch_tick"]), (whole["sha256"], 30))

    def test_a_bounded_recording_keeps_it(self):
        self.mission("")
        file = self.folder / "long.soarrec"
        Run("run", self.folder / "scenario.toml", "--headless", "--seconds", 120, "--record", file, "--record-level", "all", "--record-limit", 1, code=0)
        info = self.info(file)
        self.assertEqual(info["manifest"]["command"][1], "run")

    def test_recordings_of_failed_missions_have_one(self):
        self.mission('[[check]]\nagent = "scout"\nat = "mill"\nby = 2\n')
        Run("test", self.folder / "scenario.toml", "--keep", self.folder / "kept", code=1)
        manifest = self.info(next((self.folder / "kept").rglob("*.soarrec")))["manifest"]
        self.assertEqual(manifest["command"][1], "test")
        self.assertIn("scout.soar", manifest["sha256"])
