# SPDX-License-Identifier: BSD-2-Clause
"""The Soar shell as a script: piped input, files, JSON, and robustness against any input."""
import json
import pathlib
import socket
import subprocess
import tempfile
import threading
import unittest

from soarbox_command import COMMAND, ScenarioCase

RULE = "sp {elaborate*x\n   (state <s> ^superstate nil)\n-->\n   (<s> ^x 1)\n}\n"


def shell(text, *arguments):
    return subprocess.run([COMMAND, "soar", *map(str, arguments)], input=text, capture_output=True, text=True, timeout=60,
                          errors="replace", check=False)


class SoarShell(ScenarioCase):
    def test_piped_input_is_a_script_and_rules_may_span_lines(self):
        done = shell(RULE + "run 1\nprint s1\n")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("1 rule fired", done.stdout)
        self.assertIn("^x 1)", done.stdout)

    def test_near_miss_is_suggested_and_the_failure_shows_in_the_exit_code(self):
        done = shell("pirnt s1\nprint s1\n")
        self.assertEqual(done.returncode, 1)
        self.assertIn("did you mean 'print'?", done.stdout)
        self.assertIn("(S1 ", done.stdout, "the next command runs")

    def test_files_are_sourced_first(self):
        done = shell("print\n", self.write("rules.soar", RULE))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("Total: 1 production sourced.", done.stdout)
        self.assertIn("elaborate*x", done.stdout)

    def test_json_gives_one_object_per_command(self):
        done = shell("print s1\npirnt\n", "--json")
        first, second = (json.loads(line) for line in done.stdout.splitlines())
        self.assertTrue(first["ok"])
        self.assertIn("epmem", json.dumps(first["result"]))
        self.assertFalse(second["ok"])
        self.assertEqual(second["diagnostics"][0]["severity"], "error")

    def test_exit_ends_it(self):
        self.assertNotIn("(S1 ", shell("exit\nprint s1\n").stdout)

    def test_nothing_typed_brings_it_down(self):
        junk = ["sp {", "sp }", "sp {a", "print {", '"', "|", "[", "]", "gp {x [", "sp {x (state <s> ^a [1 2]) --> }", "\0", "é\xff",
                "source /no/such/file", "source .", "cd", "cd /no/such", "popd", "alias a", "alias a a", "a", "run -x", "run -1",
                "run 99999999999999999999", "print -d 99999999999999", "print (", "matches", "preferences x y z", "excise", "wm add",
                "wm add s1 ^x", "wm remove x", "chunk singleton state", "load library", "help " * 50, "trace 99", "soar max-elaborations x",
                "decide srand x", "production find", "x" * 100000, "{" * 5000, "(" * 5000, "output command-to-file", "echo " + "|" * 999]
        for line in junk:
            with self.subTest(line=line[:40]):
                done = shell(line + "\necho still here\n")
                self.assertIn(done.returncode, (0, 1), done.stderr[-500:])
                if "{" not in line:  # After an open brace, the next line belongs to the same command.
                    self.assertIn("still here", done.stdout[-200:])


class Viewer:
    """A viewer of scenes: it accepts one connection and stores the received data, or closes it after the first line."""

    def __init__(self, family, address, leaves=False):
        self.server = socket.socket(family)
        self.server.bind(address)
        self.server.listen(1)
        self.text = ""
        self.leaves = leaves
        self.thread = threading.Thread(target=self.read, daemon=True)
        self.thread.start()

    def read(self):
        connection, _ = self.server.accept()
        with connection, connection.makefile(encoding="utf-8") as lines:
            for line in lines:
                self.text += line
                if self.leaves:
                    return

    def lines(self):
        self.thread.join(20)
        assert not self.thread.is_alive(), "the connection ends with the shell"
        self.server.close()
        return self.text.splitlines()


class SceneViewers(unittest.TestCase):
    SCENE = ("run 1\nsvs S1.scene.sgel add ball world b 0.5 p 1 2 3\nsvs S1.scene.sgel add post world v 0 0 0 0 1 0 p 4 0 0 s 1 2 1\n"
             "svs S1.scene.sgel change ball p 1 5 3\nsvs S1.scene.sgel tag add ball colour red\nsvs S1.scene.sgel delete post\n")
    SHOWN = ["-S1", "+S1 +ball b 0.5 p 1 2 3 r 0 0 0 1 s 1 1 1", "+S1 +post v 0 0 0 0 1 0 p 4 0 0 r 0 0 0 1 s 1 2 1",
             "+S1 +ball p 1 5 3 r 0 0 0 1 s 1 1 1", "S1 -post"]

    def test_a_viewer_that_listens_on_a_port_is_told_what_changes(self):
        viewer = Viewer(socket.AF_INET, ("127.0.0.1", 0))
        port = viewer.server.getsockname()[1]
        done = shell(f"svs --enable\nsvs connect_viewer {port}\n{self.SCENE}svs disconnect_viewer\n")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(viewer.lines(), [*self.SHOWN, "-S1"])

    def test_a_viewer_at_a_socket_of_the_file_system_is_told_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            path = str(pathlib.Path(folder) / "viewer")
            viewer = Viewer(socket.AF_UNIX, path)
            done = shell(f"svs --enable\nsvs connect_viewer {path}\n{self.SCENE}svs S1.scene.draw off\nsvs S1.scene.draw on\n")
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertEqual(viewer.lines()[:len(self.SHOWN) + 3],
                             [*self.SHOWN, "-S1", "-S1", "+S1 +ball b 0.5 p 1 5 3 r 0 0 0 1 s 1 1 1"])

    def test_a_viewer_that_leaves_stops_nothing(self):
        viewer = Viewer(socket.AF_INET, ("127.0.0.1", 0), leaves=True)
        port = viewer.server.getsockname()[1]
        done = shell(f"svs --enable\nsvs connect_viewer {port}\n{self.SCENE * 3}svs S1.scene\necho still here\n")
        self.assertEqual(viewer.lines()[0], "-S1")
        self.assertIn("still here", done.stdout)

    def test_where_nobody_listens_is_told(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))  # The port is in use, but no program listens.
            nobody = free.getsockname()[1]
            for where, told in ((nobody, "Start the viewer first"), (0, "a port is a number from 1 to 65535"),
                                (70000, "a port is a number from 1 to 65535"), ("/no/such/socket", "Start the viewer first"),
                                ("/" + "x" * 200, "the name of the socket is too long")):
                with self.subTest(where=where):
                    done = shell(f"svs --enable\nsvs connect_viewer {where}\necho still here\n")
                    self.assertIn(told, done.stdout)
                    self.assertIn("still here", done.stdout)
