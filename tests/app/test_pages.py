# SPDX-License-Identifier: BSD-2-Clause
"""Each command line in the README and in docs/ works as it is printed there, beside the files that its page speaks of."""
import pathlib
import re
import shlex
import shutil

from soarbox_command import Run, ScenarioCase, page_missing

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted(page for page in (ROOT / "docs").rglob("*.md") if "spec" not in page.parts)]
# What waits for somebody, needs a display or a cluster, or leaves the machine; these have tests of their own.
ELSEWHERE = re.compile(r"^(serve|kernel|lsp|dap|mcp|help)\b|--on slurm|--screenshot|--dis 239|^learn$|my-lessons")
FORM = re.compile(r"[A-Z]{2,}|\[|\||\b[NX]\b|, [a-z]+ |\.\.\.")
MINE = """sp {mine*propose*look (state <s> ^type state -^looked) --> (<s> ^operator <o> +) (<o> ^name look)}
sp {mine*apply*look (state <s> ^operator.name look) --> (<s> ^looked yes)}
"""
SWEEP = 'scenario = "thesis"\nseeds = "1..2"\nseconds = 1\nrecord = "all"\n[[variant]]\nname = "one"\n'
MISSION = 'scenario = "thesis"\nseconds = 1\n[[check]]\nname = "it is there"\nagent = "follower-1"\ndistance = { min = 0 }\nby = 1\n'


def printed_lines():
    """(place, words) of each `soarbox` line, without its comment."""
    for page in PAGES:
        for number, text in enumerate(page.read_text().splitlines(), 1):
            found = re.match(r"^(?:    )?(?:\./dev )?(?:soarbox (?=[a-z])|(?=run\b))(.+)$", text) if re.match(r" *(\./dev|soarbox) ", text) else None
            if found:
                yield f"{page.relative_to(ROOT)}:{number}", re.split(r"\s{3,}| # ", found[1])[0].strip()


def is_form(words):
    """Whether there is something to fill in; `RULE` stands for the name of a rule that was learned."""
    return FORM.search(words.replace("RULE", "")) is not None


class Pages(ScenarioCase):
    def test_the_options_of_a_form_are_those_of_the_sub_command(self):
        seen = 0
        for place, words in printed_lines():
            for form in words.split(", ") if is_form(words) else ():
                text = Run(form.split()[0], "--help").out
                for option in re.findall(r"--[a-z][a-z-]*", form):
                    seen += 1
                    self.assertIn(option, text, f"{place}: soarbox {form}")
        self.assertGreater(seen, 30)

    def test_each_option_is_described_on_a_page(self):
        text = "".join(page.read_text() for page in PAGES)
        commands = re.findall(r"^  ([a-z]+) ", Run("help").out.split("Subcommands:")[1].split("Examples:")[0], re.MULTILINE)
        missing = [f"{command} {option}" for command in commands
                   for option in re.findall(r"^ +(?:-\w,)? *(--[a-z][a-z-]*)", Run(command, "--help").out, re.MULTILINE)
                   if not re.search(re.escape(option) + r"\b(?!-)", text)]
        self.assertEqual(missing, [])

    def prepare(self):
        """The files that the pages speak of, in a folder that looks like a checkout."""
        folder = self.folder / "here"
        for tree in ("scenarios/soar_skirmish", "scenarios/soar_reward", "docs/lessons"):
            shutil.copytree(ROOT / tree, folder / tree)
        for name in ("mine.soar", "a.soar", "b.soar", "simple.soar", "move-to-food.soar", "agent.soar"):
            (folder / name).write_text(MINE)
        for name in ("variants.toml", "bold.toml", "sweep.toml"):
            (folder / name).write_text(SWEEP)
        (folder / "my.toml").write_text(MISSION)
        (folder / "look.txt").write_text("30 command watchman print s1\n")
        for words in ("run soar_skirmish --headless --seconds 8 --record run.soarrec", "datamap agent.soar -o agent.vsa.json", "sweep sweep.toml"):
            Run(*words.split(), cwd=folder, code=0)
        for name in "AB":
            shutil.copy(folder / "run.soarrec", folder / name)
        return folder

    def learned_rule(self, folder):
        return re.search(r"[\w*-]*chunk[\w*-]*", Run("inspect", "soar_town", "--agent", "learner", "--at", "200", "--view", "learning", cwd=folder).out)[0]

    def test_a_command_line_does_what_its_page_says(self):
        folder = self.prepare()
        rule, done = self.learned_rule(folder), set()
        for place, words in printed_lines():
            if is_form(words) or ELSEWHERE.search(words) or words in done:
                continue
            done.add(words)
            if words.startswith("report ") and page_missing():
                continue
            words = shlex.split(words.replace("RULE", rule))
            if words[0] in ("run", "replay"):
                words += ["--headless"] if "--headless" not in words else []
                words += ["--seconds", "2"] if words[0] == "run" and "--seconds" not in words else []
            if words[0] == "test":
                words = [word for word in words if not re.match(r"1\.\.|--seeds", word)] + ["--seeds", "1..2"]
            run = Run(*words, cwd=folder)
            with self.subTest(place, words=words):
                self.assertEqual((run.code, "error" in run.err), (int("eater=mine.soar" in words and "test" in words), False), run.err + run.out)
        self.assertGreater(len(done), 50)
