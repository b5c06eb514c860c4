# SPDX-License-Identifier: BSD-2-Clause
"""A world in a separate process. It accepts requests and returns contents (docs/workbench.md)."""
from __future__ import annotations

import itertools
import json
import os
import pathlib
import shutil
import socket
import struct
import subprocess
import tempfile
from typing import Any, Dict, List, Optional

from .command import find_command


class EngineGone(Exception):
    """The process has ended. The text is its last message."""


class Engine:
    """Starts `soarbox engine`. The world waits at tick 0 until a request steps it."""

    def __init__(self, run: str, seed: Optional[int]):
        self.contents: Dict[str, Any] = {}  #: The newest contents, by their names.
        self.hello: Dict[str, Any] = {}
        self.remarks: List[str] = []
        self._bytes = bytearray()
        self._marks = itertools.count(1)
        command = find_command()
        self._folder = tempfile.mkdtemp(prefix="soarbox-world-")
        self._errors = open(pathlib.Path(self._folder) / "errors", "w+b")  # Closed by Close.
        ours, theirs = socket.socketpair()
        self._socket = ours
        arguments = [command, "engine", "--home", self._folder, "--run", run]
        if seed is not None:
            arguments += ["--seed", str(seed)]
        # The engine reads its requests from descriptor 3. Its recordings are removed together with the world.
        environment = dict(os.environ, XDG_STATE_HOME=self._folder)
        self._process = subprocess.Popen(["sh", "-c", 'exec "$@" 3<&0 </dev/null', "sh", *arguments], stdin=theirs.fileno(),
                                         stdout=subprocess.DEVNULL, stderr=self._errors, env=environment)
        theirs.close()
        # The engine reads these requests before its first tick, so no tick is missed. Nothing here draws scenes.
        self.ask({"request": "presence", "draws": False}, {"request": "flow", "what": "pause"})

    def ask(self, *requests: Dict[str, Any]) -> None:
        """Sends requests; synchronize() waits until they are carried out."""
        frames = bytearray()
        for request in requests:
            text = json.dumps(request).encode()
            frames += b"j" + struct.pack("<I", len(text)) + text
        try:
            self._socket.sendall(frames)
        except OSError:
            raise EngineGone(self._last_words()) from None

    def synchronize(self) -> List[str]:
        """Waits until all requests are carried out. Returns the errors of refused requests, as sentences.

        The engine reports the end of a batch of requests, but not of which batch. Therefore this sends a request that the
        engine refuses. The refusal has an id and is sent in order: the end of its batch is the end of all earlier requests.
        """
        mark = f"mark-{next(self._marks)}"
        self.ask({"request": "flow", "what": "mark", "id": mark}, {"request": "live"})
        refused: List[str] = []
        seen = False
        while True:
            kind, content = self._frame()
            if kind == b"d" and seen:
                return refused
            if kind == b"c":
                name, _, text = content.partition(b"\0")
                self.contents[name.decode()] = json.loads(text)
            elif kind == b"h":
                self.hello = json.loads(content)
            elif kind == b"j":
                message = json.loads(content)
                if message.get("message") == "error" and message.get("id") == mark:
                    seen = True
                elif message.get("message") == "error":
                    refused.append(": ".join(part for part in (message.get("error"), message.get("hint")) if part))

    def recording(self) -> Optional[pathlib.Path]:
        """The recording of the newest run; None if there is none."""
        files = list(pathlib.Path(self._folder).glob("soarbox/recordings/*.soarrec"))
        return max(files, key=lambda file: file.stat().st_mtime) if files else None

    def close(self) -> None:
        """Ends the process and removes its files."""
        self._socket.close()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._errors.close()
        shutil.rmtree(self._folder, ignore_errors=True)

    def _frame(self) -> "tuple[bytes, bytes]":
        while True:
            if len(self._bytes) >= 5:
                (length,) = struct.unpack_from("<I", self._bytes, 1)
                if len(self._bytes) >= 5 + length:
                    frame = bytes(self._bytes[:1]), bytes(self._bytes[5:5 + length])
                    del self._bytes[:5 + length]
                    return frame
            try:
                more = self._socket.recv(1 << 16)
            except OSError:
                more = b""
            if not more:
                raise EngineGone(self._last_words())
            self._bytes += more

    def _last_words(self) -> str:
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            return "it does not answer any more"
        self._errors.seek(0)
        return self._errors.read().decode("utf-8", "replace").strip() or f"it ended with {self._process.returncode}"
