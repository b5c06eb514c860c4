# SPDX-License-Identifier: BSD-2-Clause
"""Recordings and sweeps as tables."""
from __future__ import annotations

import csv
import os
import pathlib
import subprocess
import sys
import tempfile
from typing import Any, Dict, List, Optional, Union

from .command import CommandError, find_command
from .values import value_of

PathLike = Union[str, "os.PathLike[str]"]
Cell = Union[int, float, str, None]


class Table(List[Dict[str, Cell]]):
    """A list of rows; each row maps columns to cells. Numbers are int or float; an empty cell is None."""

    def column(self, name: str) -> List[Cell]:
        """All cells of a column."""
        return [row[name] for row in self]

    def frame(self) -> Any:
        """The table as a pandas.DataFrame. Raises ImportError if there is no pandas."""
        try:
            import pandas  # type: ignore
        except ImportError:
            raise ImportError("frame() needs pandas: install python3-pandas; the table itself needs nothing") from None
        return pandas.DataFrame(list(self))

    def columns(self) -> Dict[str, List[Cell]]:
        """All columns by name: what `polars.DataFrame` and `pyarrow.table` are made from."""
        return {name: self.column(name) for name in self[0]} if self else {}


def record_into(scenario: PathLike, file: PathLike, seconds: float, seed: Optional[int], level: str) -> None:
    """Runs and records a scenario, for soarbox.record."""
    arguments = ["run", os.fspath(scenario), "--headless", "--seconds", str(seconds), "--record", os.fspath(file),
                 "--record-level", level]
    if seed is not None:
        arguments += ["--seed", str(seed)]
    run_command(arguments)


def recording(file: PathLike, start: Optional[float] = None, end: Optional[float] = None) -> Table:
    """A recording as a table: a row for each agent and tick from `start` to `end`, in simulated seconds."""
    with tempfile.TemporaryDirectory(prefix="soarbox-") as folder:
        table = pathlib.Path(folder) / "table.csv"
        arguments = ["export", os.fspath(file), "--csv", "-o", str(table)]
        for option, value in (("--from", start), ("--to", end)):
            if value is not None:
                arguments += [option, str(value)]
        run_command(arguments)
        return _read(table)


def tables(file: PathLike, start: Optional[float] = None, end: Optional[float] = None) -> Dict[str, Table]:
    """A recording as tidy tables by name, from `start` to `end`, in simulated seconds.

    "agents": a row for each agent and tick. "events": what happened, and what minds decided. "percepts": what agents perceived,
    a row for each change. docs/recording.md describes the columns.
    """
    with tempfile.TemporaryDirectory(prefix="soarbox-") as folder:
        arguments = ["export", os.fspath(file), "--tidy", "-o", folder]
        for option, value in (("--from", start), ("--to", end)):
            if value is not None:
                arguments += [option, str(value)]
        run_command(arguments)
        return {each.stem: _read(each) for each in sorted(pathlib.Path(folder).glob("*.csv"))}


def sweep(spec: PathLike, folder: Optional[PathLike] = None, jobs: int = 0) -> Table:
    """Makes the missing runs of a sweep (docs/sweeps.md), and returns its table: a row for each run.

    Rows and tables go into `folder`; by default this is a folder next to the spec, with its name. `jobs` is the number of
    runs at the same time; 0 means one per processor. Raises CommandError if the sweep fails.
    """
    spec = pathlib.Path(os.fspath(spec))
    results = pathlib.Path(os.fspath(folder)) if folder is not None else spec.with_suffix(".sweep")
    run_command(["sweep", str(spec), "--folder", str(results), "--jobs", str(jobs)])
    return _read(results / "results.csv")


def run_command(arguments: List[str]) -> None:
    """Runs `soarbox` with these arguments. If it fails, raises CommandError with its error output."""
    done = subprocess.run([find_command(), *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True, errors="replace", check=False)
    if done.returncode != 0:
        raise CommandError(done.stderr.strip() or f"soarbox {arguments[0]} ended with {done.returncode}")


def _read(file: pathlib.Path) -> Table:
    csv.field_size_limit(sys.maxsize)
    with open(file, encoding="utf-8", errors="replace", newline="") as lines:
        return Table({name: value_of(cell) if cell else None for name, cell in row.items() if name is not None}
                     for row in csv.DictReader(lines))
