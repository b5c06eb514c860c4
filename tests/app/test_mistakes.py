# SPDX-License-Identifier: BSD-2-Clause
"""Mistakes of beginners and their messages. mistakes/NAME.soar contains the mistake. mistakes/NAME.txt contains the output
of `soarbox check`, the console output of a run, and the contents of the panel Problems.

    WRITE_EXPECTED=1 python3 -m unittest test_mistakes      writes the .txt files; check each line before you commit them
"""
import os
import pathlib
import re

from soarbox_command import Run, ScenarioCase, run_json

MISTAKES = pathlib.Path(__file__).resolve().parent / "mistakes"

WORLD = """
[[agent]]
name = "hero"
rules = "hero.soar"
position = [0, 0]

[[waypoint]]
name = "gate"
position = [3, 0]

[[waypoint]]
name = "tower"
position = [0, -12]
"""


def one_line(diagnostic):
    place = ":".join(str(part) for part in (pathlib.Path(diagnostic.get("file", "")).name, diagnostic.get("line"),
                                            diagnostic.get("column")) if part)
    hint = f" | {diagnostic['hint']}" if diagnostic.get("hint") else ""
    return f"{place}: {diagnostic['severity']}: {diagnostic['message']}{hint}".lstrip(": ")


class Mistakes(ScenarioCase):
    maxDiff = None

    def told(self, name):
        """All output for this mistake."""
        folder = self.folder / name
        folder.mkdir()
        (folder / "hero.soar").write_text((MISTAKES / f"{name}.soar").read_text(encoding="utf-8"), encoding="utf-8")
        (folder / "scenario.toml").write_text(WORLD, encoding="utf-8")
        check = Run("check", folder / "hero.soar").out
        console = Run("run", folder, "--headless", "--seconds", 6)
        events = run_json(folder, "--seconds", 6)
        problems = [one_line(event["diagnostic"]) for event in events.events if "diagnostic" in event]
        for event in events.of("gap"):
            problems += [f"{event['agent']}: {event['text']}"] + [f"  {reason}" for reason in event.get("reasons", [])
                                                                   if not reason.startswith("it perceives")]
        text = f"== check\n{check}== console\n{console.err}== problems\n" + "".join(line + "\n" for line in problems)
        text = text.replace(str(folder) + "/", "")
        return re.sub(r"^it perceives .*\n", "", text, flags=re.M)

    def test_each_gets_its_sentence_with_line_and_remedy(self):
        names = sorted(file.stem for file in MISTAKES.glob("*.soar"))
        self.assertGreaterEqual(len(names), 20)
        for name in names:
            with self.subTest(name):
                told = self.told(name)
                expected = MISTAKES / f"{name}.txt"
                if os.environ.get("WRITE_EXPECTED"):
                    expected.write_text(told, encoding="utf-8")
                self.assertEqual(told, expected.read_text(encoding="utf-8"))
