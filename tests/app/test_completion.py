# SPDX-License-Identifier: BSD-2-Clause
"""Completion of `soarbox` command lines in real bash and zsh shells."""
import os
import pathlib
import shutil
import subprocess
import unittest

from soarbox_command import COMMAND, Run, ScenarioCase

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "packaging" / "completion"
BASH_COMPLETION = pathlib.Path("/usr/share/bash-completion/bash_completion")

# Completes a line as if a user pressed Tab at its end: readline passes these variables to the function.
IN_BASH = r"""
source "$BASH_COMPLETION" && source "$COMPLETION" || exit 1
open=
compopt() { [[ $* != *nospace* ]] || open=open; }
COMP_LINE=$1 COMP_POINT=${#1} COMP_TYPE=9 COMP_KEY=9
COMP_WORDS=()
rest=$1
while [[ $rest =~ ^[[:space:]]*(=+|:+|[^[:space:]=:]+)(.*)$ ]]; do
  COMP_WORDS+=("${BASH_REMATCH[1]}")
  rest=${BASH_REMATCH[2]}
done
[[ $1 == *[[:space:]] ]] && COMP_WORDS+=("")
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
complete -p soarbox
_soarbox soarbox "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\n' "${COMPREPLY[@]}" $open
"""

# A shell on a separate terminal, in which Tab is pressed.
IN_ZSH = r"""
zmodload zsh/zpty || exit 1
zpty shell zsh -f -i
ask() { zpty -w shell "$1"; }
ask "PS1= PS2= RPS1=; unset zle_bracketed_paste; stty cols 400 rows 900"
ask "fpath=($COMPLETION \$fpath); autoload -Uz compinit; compinit -D -u; LISTMAX=0; setopt no_auto_menu"
ask "zstyle ':completion:*' menu no; zle -C listed .list-choices _main_complete; bindkey '^L' listed"
# The terminal would process text typed before the shell shows its prompt.
ask "path=(${COMMAND:h} \$path); cd $PLACE; PS1='REA''DY'"
zpty -r shell text "*READY*"
zpty -w -n shell "$1"$'\t'$'\x0c'
zpty -w -n shell $'\x15print -r -- DO\'\'NE\n'
text=""
while zpty -r shell part; do
  text+=$part
  [[ $text == *DONE* ]] && break
done
print -r -- "$text"
zpty -d shell
"""


@unittest.skipUnless(BASH_COMPLETION.exists(), "the package bash-completion is not installed")
class InBash(ScenarioCase):
    def offered(self, line):
        done = subprocess.run(["bash", "-c", IN_BASH, "bash", line], capture_output=True, text=True, timeout=60, check=False,
                              cwd=self.folder, env={**os.environ, "BASH_COMPLETION": str(BASH_COMPLETION),
                                                    "COMPLETION": str(FOLDER / "soarbox.bash"),
                                                    "PATH": f"{pathlib.Path(COMMAND).parent}:{os.environ['PATH']}"})
        lines = done.stdout.splitlines()
        self.assertEqual(lines[:1], ["complete -F _soarbox soarbox"], done.stderr)
        return [each for each in lines[1:] if each]

    def test_offers_sub_commands_and_options(self):
        self.assertEqual(self.offered("soarbox re"), ["replay", "resume", "report"])
        self.assertIn("--headless", self.offered("soarbox run thesis --"))
        self.assertEqual(self.offered("soarbox run thesis --render"), ["--render-scale"])
        self.assertEqual(self.offered("soarbox run --headless --headl"), [])

    def test_offers_scenarios_lessons_and_words(self):
        self.assertIn("soar_hallway", self.offered("soarbox run soar_ha"))
        self.assertEqual(self.offered("soarbox learn check 12"), ["12-reward"])
        self.assertEqual(self.offered("soarbox run --detail "), ["auto", "low", "full"])
        self.assertEqual(self.offered("soarbox run --show labels,tr"), ["labels,trails", "open"])
        self.assertEqual(self.offered("soarbox help insp"), ["inspect"])

    def test_offers_files_of_the_kind_that_is_wanted(self):
        (self.folder / "rules here").mkdir()
        for name in ("scout.soar", "scout.txt", "run.soarrec", "rules here/a.soar"):
            self.write(name, "")
        self.assertEqual(sorted(self.offered("soarbox replay ")), ["rules here", "run.soarrec"])
        self.assertIn("scout.soar", self.offered("soarbox run sco"))
        self.assertNotIn("scout.txt", self.offered("soarbox run sco"))
        self.assertIn("scout.soar", self.offered("soarbox run thesis --rules scout=sc"))
        self.assertIn("scout.soar", self.offered("soarbox run thesis --rules=scout=sc"))
        self.assertEqual(self.offered("soarbox test --keep "), ["rules here"])

    def test_does_not_repeat_what_stands_before_a_sign(self):
        self.assertEqual(self.offered("soarbox run --detail=a"), ["auto"])


@unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
class InZsh(ScenarioCase):
    def offered(self, line):
        done = subprocess.run(["zsh", "-f", "-c", IN_ZSH, "zsh", line], capture_output=True, text=True, timeout=60, check=False,
                              env={**os.environ, "COMPLETION": str(FOLDER), "COMMAND": COMMAND, "PLACE": str(self.folder),
                                   "TERM": "dumb"})
        return done.stdout

    def test_offers_sub_commands_with_what_they_do(self):
        said = self.offered("soarbox re")
        self.assertRegex(said, r"resume +-- Go back to a moment of a recording")
        self.assertNotIn("inspect", said)

    def test_completes_scenarios_files_and_words(self):
        self.write("run.soarrec", "")
        self.write("other.txt", "")
        self.assertIn("soarbox run soar_hallway ", self.offered("soarbox run soar_ha"))
        self.assertIn("soarbox replay run.soarrec ", self.offered("soarbox replay "))
        self.assertIn("--render-scale ", self.offered("soarbox run --render"))
        self.assertIn("labels,trails", self.offered("soarbox run --show labels,tr"))
        self.write("scout.soar", "")
        self.assertIn("--rules=scout=scout.soar", self.offered("soarbox run --rules=scout=sc"))


class WithoutAShell(unittest.TestCase):
    def offered(self, *words):
        run = Run("complete", *words)
        self.assertEqual((run.code, run.err), (0, ""))
        return run.out.splitlines()

    def test_bears_words_that_cannot_be(self):
        for words in ((), ("",), ("xyzzy", ""), ("run", "--xyzzy", ""), ("run", "--show=="), ("learn", "check", "1", ""),
                      ("run", "thesis", "another", "x"), ("lsp", "x")):
            self.offered(*words)
        self.assertEqual(self.offered("run", "--xyzzy="), [])

    def test_every_value_has_a_name_of_its_own_in_the_help(self):
        for command in (line.split("\t")[0] for line in self.offered("")):
            self.assertNotRegex(Run(command, "--help").out, r"^  \S+ (TEXT|INT|FLOAT)[ :=.]", command)
