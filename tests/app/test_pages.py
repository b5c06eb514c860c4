# SPDX-License-Identifier: BSD-2-Clause
"""The options in README and docs/ exist in the command. tests/docs runs the examples of the pages."""
import pathlib
import re

from soarbox_command import Run, ScenarioCase

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted(page for page in (ROOT / "docs").rglob("*.md") if "spec" not in page.parts)]
FORM = re.compile(r"[A-Z]{2,}|\[|\||\b[NX]\b|, [a-z]+ |\.\.\.")


def printed_lines():
    """(page:line, command line without its comment) of each `soarbox` line."""
    for page in PAGES:
        for number, text in enumerate(page.read_text().splitlines(), 1):
            found = re.match(r"^(?:    )?(?:\./dev )?(?:soarbox (?=[a-z])|(?=run\b))(.+)$", text) if re.match(r" *(\./dev|soarbox) ", text) else None
            if found:
                yield f"{page.relative_to(ROOT)}:{number}", re.split(r"\s{3,}| # ", found[1])[0].strip()


def is_form(words):
    """Whether a command line contains a placeholder."""
    return FORM.search(words) is not None


class Pages(ScenarioCase):
    def test_the_options_of_a_form_are_those_of_the_sub_command(self):
        seen = 0
        for place, words in printed_lines():
            for form in words.split(", ") if is_form(words) else ():
                text = Run(form.split()[0], "--help").out
                for option in re.findall(r"--[a-z][a-z-]*", form):
                    seen += 1
                    self.assertIn(option, text, f"{place}: soarbox {form}")
        self.assertGreater(seen, 20)

    def test_each_option_is_described_on_a_page(self):
        text = "".join(page.read_text() for page in PAGES)
        commands = re.findall(r"^  ([a-z]+) ", Run("help").out.split("Subcommands:")[1].split("Examples:")[0], re.MULTILINE)
        missing = [f"{command} {option}" for command in commands
                   for option in re.findall(r"^ +(?:-\w,)? *(--[a-z][a-z-]*)", Run(command, "--help").out, re.MULTILINE)
                   if not re.search(re.escape(option) + r"\b(?!-)", text)]
        self.assertEqual(missing, [])
