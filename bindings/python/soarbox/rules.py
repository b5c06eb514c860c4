# SPDX-License-Identifier: BSD-2-Clause
"""Checks of rules, and the problems that they find."""
from __future__ import annotations

import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile
from typing import List, Optional, Sequence, Union

from .command import CommandError, find_command

PathLike = Union[str, "os.PathLike[str]"]


@dataclasses.dataclass(frozen=True)
class Diagnostic:
    """An error or a warning about rules or a scenario."""

    severity: str  #: "error" or "warning".
    message: str  #: Description of the problem.
    file: str = ""  #: The file; empty if it concerns no file.
    line: int = 0  #: Counted from 1; 0: no line.
    column: int = 0  #: Counted from 1; 0: no column.
    hint: str = ""  #: A suggestion; may be empty.
    excerpt: str = ""  #: The text of the line in the file.

    def __str__(self) -> str:
        where = ":".join([self.file] + [str(number) for number in (self.line, self.column) if number])
        text = f"{where}: {self.severity}: {self.message}" if where else f"{self.severity}: {self.message}"
        return text + (f"\n   note: {self.hint}" if self.hint else "")


class RuleError(ValueError):
    """Rules have errors. `diagnostics` has all of them; `file`, `line` and `hint` are those of the first error."""

    def __init__(self, diagnostics: Sequence[Diagnostic]):
        super().__init__("\n".join(str(each) for each in diagnostics))
        self.diagnostics = list(diagnostics)
        self.file = self.diagnostics[0].file
        self.line = self.diagnostics[0].line
        self.hint = self.diagnostics[0].hint


def check(*paths: PathLike) -> List[Diagnostic]:
    """Checks rules, scripts, scenario files or folders without running them. Returns the warnings.

    Raises RuleError if there are errors.
    """
    names = [os.fspath(path) for path in paths]
    if not names:
        raise ValueError("check needs a file or a folder")
    return _check(names, None)


def check_text(text: str, name: str = "rules.soar") -> List[Diagnostic]:
    """Same as check, for the text of rules. Diagnostics use `name` as the name of the file."""
    with tempfile.TemporaryDirectory(prefix="soarbox-") as folder:
        file = pathlib.Path(folder) / "rules.soar"
        file.write_text(text, encoding="utf-8")
        return _check([str(file)], name)


def _check(names: List[str], alias: Optional[str]) -> List[Diagnostic]:
    done = subprocess.run([find_command(), "check", "--json", "--", *names], capture_output=True, text=True,
                          errors="replace", check=False)
    found = []
    known = {field.name for field in dataclasses.fields(Diagnostic)}
    for line in done.stdout.splitlines():
        try:
            fields = json.loads(line)
            if "severity" not in fields:
                continue
            diagnostic = Diagnostic(**{name: value for name, value in fields.items() if name in known})
        except (ValueError, TypeError) as wrong:
            raise CommandError(f"soarbox check answered {line!r}") from wrong
        found.append(dataclasses.replace(diagnostic, file=alias) if alias and diagnostic.file else diagnostic)
    errors = [each for each in found if each.severity == "error"]
    if errors:
        raise RuleError(errors)
    if done.returncode != 0 and not found:
        raise CommandError(done.stderr.strip() or f"soarbox check ended with {done.returncode}")
    return found
