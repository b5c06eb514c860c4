# SPDX-License-Identifier: BSD-2-Clause
"""Virtual displays for tests of the window. One of each size is started at its first use, and runs until the tests end."""
import atexit
import functools
import os
import shutil
import subprocess


def can_draw():
    return shutil.which("Xvfb") is not None


@functools.lru_cache(maxsize=None)
def display(width, height):
    """Starts a virtual display with a free number and returns its name, such as ":99"."""
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp",
                               "-noreset"], pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write)

    def end():
        server.terminate()
        server.wait()

    atexit.register(end)
    with os.fdopen(read) as said:
        number = said.readline().strip()
    if not number:
        raise RuntimeError("the virtual display did not start")
    return f":{number}"


def environment(width, height):
    """Environment variables with which a program opens its window on a virtual display of this size."""
    changed = {name: value for name, value in os.environ.items() if name not in ("WAYLAND_DISPLAY", "XAUTHORITY")}
    changed["DISPLAY"] = display(width, height)
    return changed
