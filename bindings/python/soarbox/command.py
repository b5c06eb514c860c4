# SPDX-License-Identifier: BSD-2-Clause
"""Where the soarbox command is."""
from __future__ import annotations

import os
import pathlib
import shutil


class CommandError(RuntimeError):
    """The soarbox command is missing, failed, or printed something that this package does not understand."""


def find_command() -> str:
    """The command's path: $SOARBOX, the one that was built with this package, or the first on $PATH."""
    named = os.environ.get("SOARBOX")
    if named:
        if not os.access(named, os.X_OK):
            raise CommandError(f"$SOARBOX names {named}, which is no program; set it to the path of soarbox")
        return named
    built = pathlib.Path(__file__).resolve().parents[2] / "bin" / "soarbox"
    if os.access(built, os.X_OK):
        return str(built)
    found = shutil.which("soarbox")
    if not found:
        raise CommandError("there is no soarbox on $PATH; install it, or set $SOARBOX to its path")
    return found
