# SPDX-License-Identifier: BSD-2-Clause
"""Recordings as tables in long form: a row per agent and tick, per event, and per change of a percept."""
import csv
import json
import sqlite3

from mission_case import MissionCase
from soarbox_command import Run

TABLES = ("agents", "events", "percepts")


class Tidy(MissionCase):
    def setUp(self):
        super().setUp()
        self.mission("")
        self.file = self.folder / "run.soarrec"
        Run("run", self.folder / "scenario.toml", "--headless", "--seconds", 4, "--seed", 3, "--record", self.file, "--record-level", "all",
            code=0)

    def tables(self, *arguments):
        """Each table as a list of rows, from files of comma-separated values."""
        folder = self.folder / "tables"
        Run("export", self.file, "--tidy", "-o", folder, *arguments, code=0)
        tables = {}
        for name in TABLES:
            with open(folder / f"{name}.csv", newline="", encoding="utf-8") as file:
                tables[name] = list(csv.DictReader(file))
        return tables

    def wide(self):
        return list(csv.DictReader(Run("export", self.file, "--csv", code=0).out.splitlines()))

    def test_each_agent_has_a_row_per_tick_with_the_values_of_the_wide_table(self):
        tidy, wide = self.tables()["agents"], self.wide()
        self.assertEqual(len(tidy), 121)
        self.assertEqual(len(tidy), len(wide))
        for row, other in zip(tidy, wide):
            for name in ("tick", "agent", "command"):
                self.assertEqual(row[name], other[name])
            for name in ("time_s", "x_m", "y_m", "z_m", "speed_mps", "heading_deg", "health"):
                self.assertAlmostEqual(float(row[name]), float(other[name]), delta=1e-4)
        # At the gate all tasks are done.
        self.assertEqual({row["operator"] for row in tidy[2:110]}, {"go"})
        self.assertEqual(tidy[-1]["operator"], "")
        self.assertEqual({row["alive"] for row in tidy}, {"1"})
        self.assertTrue(all(int(row["depth"]) >= 1 for row in tidy[1:]))

    def test_changes_of_percepts_applied_in_order_give_the_columns_of_the_wide_table(self):
        changes, values = self.tables()["percepts"], {}
        at = 0
        for row in self.wide():
            while at < len(changes) and int(changes[at]["tick"]) <= int(row["tick"]):
                change = changes[at]
                path = change["percept"]
                if change["change"] == "set":
                    values[path] = change["word"] or float(change["value"])
                else:
                    for gone in [key for key in values if key == path or key.startswith(path + ".")]:
                        del values[gone]
                at += 1
            columns = {name: text for name, text in row.items() if "." in name and text != ""}
            self.assertEqual(set(columns), {path for path in values if "." in path}, row["tick"])
            for name, text in columns.items():
                expected = values[name]
                self.assertAlmostEqual(float(text), expected, delta=1e-4 * max(1, abs(expected))) if isinstance(expected, float) \
                    else self.assertEqual(text, expected)
        self.assertEqual(at, len(changes))

    def test_events_are_those_of_the_recording(self):
        events = self.tables()["events"]
        lines = [json.loads(line) for line in Run("export", self.file, "--json", code=0).out.splitlines()][1:]
        decisions = [text for line in lines for mind in line.get("minds", []) for text in mind.get("decisions", [])]
        selected = [row for row in events if row["event"] == "operator"]
        self.assertEqual(len(selected), sum(text.strip().startswith("O:") for text in decisions))
        self.assertTrue(selected)
        commands = [text for line in lines for mind in line.get("minds", []) for text in mind.get("commands", [])]
        self.assertEqual([row["text"] for row in events if row["source"] == "mind" and row["event"].startswith("command")
                          and row["event"] == "command"], [text for text in commands if text.startswith("move-to")])
        world = [event for line in lines for event in line.get("events", [])]
        self.assertEqual([row["event"] for row in events if row["source"] == "world"], [event["kind"] for event in world])
        self.assertIn("scout*propose*go", {row["name"] for row in events if row["event"] == "rule fired"})
        self.assertIn("off I go", {row["text"] for row in events if row["event"] == "log"})

    def test_a_database_has_the_same_rows(self):
        tables = self.tables()
        database = self.folder / "run.sqlite"
        out = Run("export", self.file, "--tidy", "-o", database, code=0).out
        self.assertIn(f"{len(tables['agents'])} rows of agents, {len(tables['events'])} of events, {len(tables['percepts'])} of percepts", out)
        with sqlite3.connect(database) as opened:
            opened.row_factory = sqlite3.Row
            for name in TABLES:
                rows = [dict(row) for row in opened.execute(f"SELECT * FROM {name}")]
                self.assertEqual(len(rows), len(tables[name]))
                for row, text in zip(rows, tables[name]):
                    self.assertEqual(list(row), list(text))
                    for key, value in row.items():
                        if isinstance(value, float):
                            self.assertAlmostEqual(value, float(text[key]), delta=1e-8 * max(1, abs(value)))
                        else:
                            self.assertEqual("" if value is None else str(value), text[key])
            kept = dict(opened.execute("SELECT name, value FROM metadata"))
        self.assertEqual((kept["seed"], kept["level"], kept["recording"]), ("3", "all", "run.soarrec"))
        self.assertIn(kept["build"].split()[1], Run("--version").out)
        self.assertIn("scout.soar", json.loads(kept["sha256"]))
        manifest = json.loads((self.folder / "tables" / "manifest.json").read_text(encoding="utf-8"))
        self.assertEqual(manifest["sha256"], json.loads(kept["sha256"]))

    def test_a_part_has_its_ticks_and_knows_what_the_minds_did_before(self):
        whole = self.tables()["agents"]
        part = self.tables("--from", 2, "--to", 3)["agents"]
        self.assertEqual(part, [row for row in whole if 60 <= int(row["tick"]) <= 90])

    def test_other_forms_are_refused(self):
        run = Run("export", self.file, "--tidy", "-o", self.folder / "run.parquet", code=3)
        self.assertIn("run.parquet: error: tables are not written in this form", run.err)
        self.assertIn(".sqlite file, or a folder", run.err)
        self.assertIn("--output", Run("export", self.file, "--tidy", code=2).err)
        self.write("taken", "")
        self.assertIn("this folder cannot be made", Run("export", self.file, "--tidy", "-o", self.folder / "taken", code=3).err)
