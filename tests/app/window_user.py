# SPDX-License-Identifier: BSD-2-Clause
"""Shared by tests that play a user of the window, with real mouse and keyboard events."""
import subprocess
import unittest

from soarbox_command import COMMAND, Run, new_folder
from virtual_display import environment

WORLD = """
seconds = 60

[[agent]]
name = "walker"
rules = "walker.soar"
body = "runner"

[[agent]]
name = "idler"
rules = "idler.soar"
body = "runner"
position = [6, 0]

[[waypoint]]
name = "east"
position = [18, 0]

[[waypoint]]
name = "north"
position = [0, -18]
"""

WALKER = """
sp {walker*propose*seek
   (state <s> ^superstate nil ^io.input-link.waypoint <w>)
   (<w> ^name <name> ^here no)
-->
   (<s> ^operator <o> +)
   (<o> ^name seek ^waypoint <name>)
}

sp {walker*prefer*north
   (state <s> ^superstate nil ^operator <a> + ^operator <b> +)
   (<a> ^waypoint north)
   (<b> ^waypoint east)
-->
   (<s> ^operator <a> > <b>)
}

sp {walker*apply*seek
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name seek ^waypoint <name>)
-->
   (<out> ^seek <command>)
   (<command> ^waypoint <name> ^within 0.8)
}

sp {walker*apply*forget-answered-command
   (state <s> ^superstate nil ^operator <o> ^io.output-link <out>)
   (<out> ^<name> <command>)
   (<command> ^status)
-->
   (<out> ^<name> <command> -)
}
"""

IDLER = """
sp {idler*propose*first
   (state <s> ^superstate nil)
-->
   (<s> ^operator <o> +)
   (<o> ^name first)
}

sp {idler*propose*second
   (state <s> ^superstate nil)
-->
   (<s> ^operator <o> +)
   (<o> ^name second)
}

sp {idler*propose*flee
   (state <s> ^superstate nil ^io.input-link.self.health < 10)
-->
   (<s> ^operator <o> +)
   (<o> ^name flee)
}

sp {idler*apply*first
   (state <s> ^operator.name first)
-->
   (<s> ^done first)
}

sp {idler*apply*second
   (state <s> ^operator.name second)
-->
   (<s> ^done second)
}

sp {idler*apply*flee
   (state <s> ^operator.name flee)
-->
   (<s> ^done flee)
}
"""


class WindowUser(unittest.TestCase):
    """Plays a user of the window. The window stores its state between runs in a folder of the test."""

    def setUp(self):
        self.folder = new_folder(self)
        for name, text in (("scenario.toml", WORLD), ("walker.soar", WALKER), ("idler.soar", IDLER)):
            (self.folder / name).write_text(text, encoding="utf-8")
        self.home = self.folder / "home"

    def surroundings(self, size):
        return environment(*size) | {"XDG_STATE_HOME": str(self.home / "state"),
                                     "XDG_CONFIG_HOME": str(self.home / "config")}

    def window(self, script, *command, size=(1280, 720)):
        """The command line that opens a window and plays a user in it."""
        file = self.folder / "user.txt"
        file.write_text(script, encoding="utf-8")
        return [COMMAND, *command, "--width", str(size[0]), "--height", str(size[1]), "--ui-script", str(file),
                "--detail", "low"]

    def play(self, script, *arguments, size=(1280, 720), code=0, record="--no-record"):
        """Plays a user and expects this exit code. 0: success; 1: the run reported a problem."""
        return self.played(script, "run", str(self.folder), record, "--port", "0", *arguments, size=size, code=code)

    def played(self, script, *command, size=(1280, 720), code=0):
        done = subprocess.run(self.window(script, *command, size=size), capture_output=True, text=True, timeout=280,
                              check=False, cwd=self.folder, env=self.surroundings(size))
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def record(self, level):
        """Records three seconds of the run and returns the file."""
        file = self.folder / f"{level}.soarrec"
        Run("run", self.folder, "--headless", "--seconds", 3, "--record", file, "--record-level", level, code=0)
        return file

    def replay(self, file, script):
        self.played(script, "replay", str(file))
