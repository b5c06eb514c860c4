# SPDX-License-Identifier: BSD-2-Clause
"""Pages about runs and sweeps, through the real command."""
import base64
import csv
import json
import os
import re
import shutil
import unittest
import zlib
from unittest import mock

from mission_case import REPOSITORY, RULES, SWEEP, MissionCase
from soarbox_command import Run, page_missing


def data_of(page):
    """The data in a page: its runs, or its sweep."""
    return json.loads(re.search(r'<script type="application/json" id="data"[^>]*>(.*?)</script>', page.read_text(encoding="utf-8"), re.S)[1])


@unittest.skipIf(page_missing(), page_missing())
class Reports(MissionCase):
    def test_what_is_meant_over_seeds_is_no_failure_of_one_run(self):
        self.mission('[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\nby = 10\n'
                     '[[check]]\nname = "now and then"\nagent = "scout"\nat = "mill"\nby = 1\npass = 0\n')
        recording, page = self.folder / "run.soarrec", self.folder / "report.html"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "12", "--record", recording).code, 0)
        self.assertEqual(Run("report", recording, "-o", page).code, 0)
        data = data_of(page)[0]
        self.assertEqual(data["verdict"], "passed: all of 1 checks")
        self.assertEqual([check["mark"] for check in data["checks"]], ["passed", "over seeds"])
        self.assertIn("not in this run; it is to be true in 0 runs", data["checks"][1]["text"])

    def test_a_page_stands_alone_and_texts_stay_texts(self):
        evil = "x</script><script>alert(1)</script>\" onload='alert(2)'"
        self.mission('[[check]]\nname = "%s"\nagent = "scout"\nat = "mill"\nby = 5\n' % evil.replace('"', '\\"'),
                     rules=RULES + 'sp {scout*say (state <s> ^superstate nil ^io.input-link.self) --> (write |<script>alert(3)</script> {{data}} {{script}}| (crlf))}')
        recording = self.folder / "run.soarrec"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "6", "--record", recording).code, 0)
        page = self.folder / "report.html"
        Run("report", recording, "-o", page, code=0)
        text = page.read_text(encoding="utf-8")
        self.assertEqual(text.count("<script"), 4, "the data, the recorded run, and what shows each of them")
        self.assertEqual(text.count("</script>"), 4)
        self.assertNotRegex(text, r"(src|href)=[\"']?http")
        data = data_of(page)[0]
        self.assertEqual(data["checks"][0]["name"], evil)
        self.assertEqual(data["checks"][0]["state"], "false")
        self.assertTrue(data["same"], "simulated again it comes to the recorded state")
        self.assertEqual(data["spans"][0][3], "go")
        fired = {rule["name"]: rule["firings"] for rule in data["agents"][0]["rules"]}
        self.assertEqual(fired["scout*apply*go"], 1)

    def test_a_page_carries_the_notices_of_what_it_contains(self):
        self.mission('[[check]]\nname = "there"\nagent = "scout"\nat = "gate"\nby = 10\n')
        recording, page = self.folder / "run.soarrec", self.folder / "report.html"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "1", "--record", recording).code, 0)
        self.assertEqual(Run("report", recording, "-o", page).code, 0)
        text = page.read_text(encoding="utf-8")
        notices = re.search(r'<footer class="licences">.*?</footer>', text, re.S)[0]
        # Recognises the libraries by texts in the scripts of the page.
        self.assertIn("THREE.", text)
        for words in ("the Soarbox authors", "three.js authors", "Leon Sorokin", "Permission is hereby granted", "uplot "):
            self.assertIn(words, notices)
        self.assertNotIn("{{", notices)

    def test_panels_of_the_run_in_3d_hold_what_was_until_their_moment(self):
        self.mission("")
        recording, page = self.folder / "run.soarrec", self.folder / "report.html"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "6", "--record", recording).code, 0)
        self.assertEqual(Run("report", recording, "-o", page).code, 0)
        recorded = json.loads(re.search(r'id="recorded"[^>]*>(.*?)</script>', page.read_text(encoding="utf-8"), re.S)[1])
        told = {each["name"]: each["content"] for each in json.loads(zlib.decompress(base64.b64decode(recorded["contents"])))
                if each["tick"] == recorded["last_tick"]}
        track = next(track for track in told["timeline"]["timeline"] if track["agent"] == "scout")
        self.assertIn("go", " ".join(span["text"] for span in track["spans"]))
        self.assertIn("off I go", json.dumps(told["trace"]["document"]))

    def test_an_hour_of_ten_busy_agents_is_at_most_10_mb(self):
        self.write("Walker.lua", """
local ticks = 0
function Agent_Initialize(agent) end
function Agent_Update(agent, deltaTimeInMillis, command)
    ticks = ticks + 1
    agent:SetTarget(Vector.new(60 * math.sin(ticks / 140), 0, 60 * math.cos(ticks / 177)))
    agent:ApplyForce(agent:ForceToPosition(agent:GetTarget()) * 50)
    if ticks % 10 == 0 then
        print("I have walked for " .. ticks .. " ticks, and there is nothing to be seen of the <gate> yet")
    end
end
""")
        self.write("teller.soar", """
sp {teller*propose*tell
   (state <s> ^superstate nil ^io.input-link.time <t>)
-->
   (<s> ^operator <o> +)
   (<o> ^name tell ^time <t>)
}
sp {teller*apply*tell
   (state <s> ^operator <o>)
   (<o> ^name tell ^time <t>)
-->
   (<s> ^told <t>)
   (write |second | <t> (crlf))
}
""")
        self.write("Sandbox.lua", """
require "SandboxUtilities"
function Sandbox_Initialize(sandbox)
    Sandbox.CreatePlane(sandbox, 4000, 4000)
    for i = 1, 9 do
        local agent = Sandbox.CreateAgent(sandbox, "Walker.lua")
        agent:SetPosition(Vector.new(4 * i, 0, 0))
    end
    Sandbox.CreateSoarAgent(sandbox, { name = "teller", rules = "teller.soar", position = Vector.new(0, 0, 10) })
end
function Sandbox_Update(sandbox, deltaTimeInMillis) end
""")
        recording, page = self.folder / "hour.soarrec", self.folder / "hour.html"
        Run("run", self.folder, "--headless", "--seconds", 3600, "--record", recording, "--record-level", "world", code=0)
        run = Run("report", recording, "-o", page, code=0)
        self.assertLessEqual(page.stat().st_size, 10_000_000, run.out)
        text = page.read_text(encoding="utf-8")
        data = data_of(page)[0]
        self.assertTrue(data["same"])
        self.assertEqual(len(data["agents"]), 10)
        # Only events that could not be seen are omitted. The page reports this, and the remaining events cover the entire hour.
        told = next(line for line in data["thinned"] if "events, commands and prints" in line)
        said = int(re.search(r"Of (\d+) events", told)[1])
        self.assertGreater(said, 9 * 3600 * 3)
        self.assertGreater(said * 110, 10_000_000, "all of them would be too much")
        prints = [event for event in data["events"] if event["k"] == "print"]
        self.assertGreater(len(prints), 5000)
        for begin in range(0, 3600, 300):
            self.assertGreater(sum(begin <= event["t"] < begin + 300 for event in prints), len(prints) / 24)
        # Paths are complete and as exact as before.
        csv_file = self.folder / "end.csv"
        self.assertEqual(Run("export", recording, "--csv", "--from", "3599.99", "-o", csv_file).code, 0)
        with open(csv_file, newline="", encoding="utf-8") as file:
            ends = {row["agent"]: row for row in csv.DictReader(file)}
        self.assertEqual(len(data["times"]), 18001)
        for agent in data["agents"]:
            self.assertEqual(len(agent["x"]), len(data["times"]) - agent["from"])
            if agent["name"] in ends:
                self.assertGreater(agent["distance"], 100)
                self.assertAlmostEqual(sum(agent["x"]) / 100, float(ends[agent["name"]]["x_m"]), delta=0.006)
        self.assertEqual(data["agents"][9]["name"], "teller")

    def test_many_rules_and_prints_leave_a_page_of_10_mb(self):
        say = ('sp {teller*propose*tell (state <s> ^superstate nil ^io.input-link.time <t>) --> (<s> ^operator <o> +) (<o> ^name tell ^time <t>)}\n'
               'sp {teller*apply*tell (state <s> ^operator <o>) (<o> ^name tell ^time <t>) --> (<s> ^told <t>) (write |%s | <t> (crlf))}\n' % ("x" * 220))
        never = "".join('sp {teller*%s*%d (state <s> ^superstate nil ^%s-%d <x>) --> (<s> ^y <x>)}\n' % ("name-" * 11, i, "attribute-" * 20, i) for i in range(3500))
        self.write("teller.soar", say + never)
        agents = "".join('[[agent]]\nname = "teller-%d"\nrules = "teller.soar"\nposition = [%d, 0]\n' % (i, 4 * i) for i in range(4))
        self.write("scenario.toml", "seconds = 100\n" + agents)
        recording, page = self.folder / "busy.soarrec", self.folder / "busy.html"
        made = Run("run", self.folder, "--headless", "--seconds", "99", "--record", recording)
        self.assertEqual(made.code, 0, made.err)
        run = Run("report", recording, "-o", page)
        self.assertEqual(run.code, 0, run.err)
        self.assertLessEqual(page.stat().st_size, 10_000_000, run.out)
        data = data_of(page)[0]
        told = " ".join(data["thinned"])
        self.assertIn("events, commands and prints", told)
        self.assertIn("rules are left out", told)
        self.assertGreater(sum(len(agent["rules"]) for agent in data["agents"]), 2000)

    def test_a_sweep_becomes_a_page(self):
        self.mission("")
        spec = self.write("sweep.toml", SWEEP)
        self.assertEqual(Run("sweep", spec).code, 0)
        page = self.folder / "sweep.html"
        self.assertEqual(Run("report", spec, "-o", page).code, 0)
        data = data_of(page)[0]
        self.assertEqual([variant["runs"] for variant in data["variants"]], [6, 6])
        self.assertEqual(len(data["rows"]), 12)

    def test_what_cannot_be_read_or_written_is_told(self):
        self.assertEqual(Run("report", self.folder / "nothing").code, 3)
        self.assertEqual(Run("report", self.folder).code, 3)
        self.mission("")
        recording = self.folder / "run.soarrec"
        self.assertEqual(Run("run", self.folder, "--headless", "--seconds", "1", "--record", recording).code, 0)
        run = Run("report", recording, "-o", self.write("file", "") / "page.html", code=3)
        self.assertIn("page.html", run.err)
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        run = Run("report", recording, "-o", pipe, code=3)
        self.assertIn("not a plain file", run.err)
        self.assertTrue(pipe.is_fifo(), "it is still what it was")

    def test_the_page_reads_nothing_as_markup(self):
        sources = sorted((REPOSITORY / "web" / "src").rglob("*.ts"))
        self.assertGreater(len(sources), 50)
        for source in sources:
            script = source.read_text(encoding="utf-8")
            for word in ("innerHTML", "outerHTML", "insertAdjacentHTML", "document.write", "eval(", "Function("):
                self.assertNotIn(word, script, source)


class NotBuilt(MissionCase):
    def test_where_the_page_is_not_built_one_is_told_who_builds_it(self):
        for folder in ("scenarios", "media"):
            shutil.copytree(REPOSITORY / folder, self.folder / "data" / folder, ignore=shutil.ignore_patterns("*.mesh", "*.png"))
        with mock.patch.dict(os.environ, {"SOARBOX_DATA": str(self.folder / "data")}):
            run = Run("report", self.folder / "run.soarrec", "-o", self.folder / "page.html")
        self.assertEqual(run.code, 3, run.out)
        self.assertIn("the page that reports are shown in is not built", run.err)
        self.assertIn("./dev soarbox report builds it", run.err)
        self.assertFalse((self.folder / "page.html").exists())
