# SPDX-License-Identifier: BSD-2-Clause
"""The report page of a run (docs/report.md), as a file and in a notebook."""
from __future__ import annotations

import html
import os
import pathlib
import tempfile
import time
from typing import Optional

from .command import CommandError
from .tables import PathLike, Table, record_into, recording, run_command


def report(recording_file: PathLike, file: PathLike) -> None:
    """Writes the report page of a recording. Raises CommandError if it cannot be read or written."""
    run_command(["report", os.fspath(recording_file), "-o", os.fspath(file)])


def report_of_live_run(recording_file: PathLike, file: PathLike) -> None:
    """The same during the run. Waits up to 10 s, because the first ticks may not be in the file yet."""
    for patience in range(100, -1, -1):
        try:
            return report(recording_file, file)
        except CommandError as error:
            if "holds no ticks" not in str(error) or patience == 0:
                raise
        time.sleep(0.1)


def page_in_notebook(recording_file: PathLike, is_live: bool = False) -> str:
    """The report page as HTML for a notebook: a frame with scripts that cannot access the notebook."""
    with tempfile.TemporaryDirectory(prefix="soarbox-") as folder:
        page = pathlib.Path(folder) / "report.html"
        (report_of_live_run if is_live else report)(recording_file, page)
        text = page.read_text(encoding="utf-8", errors="replace")
    return (f'<iframe srcdoc="{html.escape(text)}" sandbox="allow-scripts" '
            'style="width: 100%; height: 720px; border: 0"></iframe>')


class Run:
    """A recorded run. A notebook shows it as its report page."""

    def __init__(self, file: PathLike):
        self.file = os.fspath(file)  #: The recording.

    def table(self, start: Optional[float] = None, end: Optional[float] = None) -> Table:
        """Returns soarbox.recording of its file."""
        return recording(self.file, start, end)

    def report(self, file: PathLike) -> None:
        """Writes the report page."""
        report(self.file, file)

    def _repr_html_(self) -> str:
        return page_in_notebook(self.file)

    def __repr__(self) -> str:
        return f"<soarbox.Run {self.file}>"


def record(scenario: PathLike, file: PathLike, seconds: float, seed: Optional[int] = None, *,
           level: str = "decisions") -> Run:
    """Runs a scenario for this many simulated seconds and records it into a file.

    `level` is "world", "decisions" or "all" (docs/recording.md). Raises CommandError if it cannot be run.
    """
    record_into(scenario, file, seconds, seed, level)
    return Run(file)
