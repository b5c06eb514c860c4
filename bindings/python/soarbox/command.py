# SPDX-License-Identifier: BSD-2-Clause
"""Where the soarbox command is."""
from __future__ import annotations

import os
import pathlib
import shutil
import sys


class CommandError(RuntimeError):
    """The soarbox command is missing, failed, or printed something that this package does not understand."""


def find_command() -> str:
    """The command's path: $SOARBOX, the one that was built with this package or that is in its wheel, or the first on $PATH."""
    named = os.environ.get("SOARBOX")
    if named:
        if not os.access(named, os.X_OK):
            raise CommandError(f"$SOARBOX names {named}, which is not a program; set it to the path of soarbox")
        return named
    built = pathlib.Path(__file__).resolve().parents[2] / "bin" / "soarbox"
    if os.access(built, os.X_OK):
        return str(built)
    in_wheel = pathlib.Path(__file__).resolve().parent / "_program" / "bin" / "soarbox"
    if os.access(in_wheel, os.X_OK):
        return str(in_wheel)
    found = shutil.which("soarbox")
    if not found:
        raise CommandError("there is no soarbox on $PATH; install it, or set $SOARBOX to its path")
    return found


def main() -> None:
    """The command `soarbox` of the wheel."""
    command = find_command()
    if pathlib.Path(command).resolve() == pathlib.Path(sys.argv[0]).resolve():
        raise SystemExit("this wheel has no program; install it again")
    os.execv(command, [command, *sys.argv[1:]])
