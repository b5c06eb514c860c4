# SPDX-License-Identifier: BSD-2-Clause
"""The Soar shell as a script: piped input, files, JSON, and nothing typed can bring it down."""
import json
import subprocess
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
                if "{" not in line:  # An open brace takes the next line with it.
                    self.assertIn("still here", done.stdout[-200:])


if __name__ == "__main__":
    unittest.main()
