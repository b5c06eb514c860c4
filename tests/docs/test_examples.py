# SPDX-License-Identifier: BSD-2-Clause
"""Every shell example of README, docs and lessons works unchanged, in an empty folder, with the program on the path."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import unittest.mock

import examples

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = pathlib.Path(os.environ["SOARBOX"])
LIMIT_S = 600


def pages():
    found = [ROOT / "README.md", *(page for page in sorted((ROOT / "docs").rglob("*.md")) if "spec" not in page.parts)]
    wanted = os.environ.get("PAGES", "")
    return [page for page in found if re.search(wanted, str(page))]


class Reader:
    """Types the examples of a page, one after the other, beginning in an empty folder."""

    def __init__(self, folder):
        self.folder, self.home = folder, folder
        self.environment = {**os.environ, "HOME": str(folder / "home"), "PATH": f"{COMMAND.parent}:{os.environ['PATH']}",
                            "SOURCE": str(ROOT)}
        for name in ("DISPLAY", "WAYLAND_DISPLAY", "XDG_STATE_HOME", "XDG_CONFIG_HOME"):
            self.environment.pop(name, None)
        (folder / "home").mkdir()

    def type(self, command):
        """Exit status and all that the command prints."""
        moved = re.match(r"cd (\S+)", command)
        if moved:
            self.folder = (self.folder / moved[1]).resolve()
            return (0 if self.folder.is_dir() else 1), ""
        # A run in a window ends when the window is closed; a headless run ends by itself.
        done = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=self.folder, env=self.environment, check=False,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=LIMIT_S)
        return done.returncode, done.stdout


def says(expected, printed):
    """Whether the lines are printed, in order and without others between them; `...` matches any lines."""
    pattern = "".join(r"(?:.*\n)*?" if line.strip() == "..." else re.escape(line.rstrip()) + r"[ ]*\n" for line in expected if line.strip())
    return re.search("^" + pattern, re.sub(r"\n\s*\n", "\n", printed.rstrip("\n") + "\n"), re.MULTILINE) is not None


class Examples(unittest.TestCase):
    maxDiff = None

    def check(self, page):
        with tempfile.TemporaryDirectory() as folder:
            reader = Reader(pathlib.Path(folder))
            if "lessons" in page.parts:  # Their worlds come with the pages, and these are read where they are.
                shutil.copytree(ROOT / "docs" / "lessons", reader.folder / "docs" / "lessons")
            wrong = []
            for one in examples.examples(page.read_text(encoding="utf-8")):
                for name, text in one.files.items():
                    (reader.folder / name).parent.mkdir(parents=True, exist_ok=True)
                    (reader.folder / name).write_text(text, encoding="utf-8")
                for command in one.before:
                    reader.type(command)
                code, printed = reader.type(one.command)
                where = f"{page.relative_to(ROOT)}:{one.line}: {one.command}"
                if code != one.code:
                    wrong.append(f"{where}\nended with {code} instead of {one.code}:\n{printed[-1500:]}")
                elif one.compares and not says(one.expected, printed):
                    wrong.append(f"{where}\nprinted\n{printed[-3000:]}\nand not\n" + "\n".join(one.expected))
            self.assertEqual("\n\n".join(wrong), "")


def add_tests():
    for page in pages():
        name = "test_" + re.sub(r"\W+", "_", str(page.relative_to(ROOT).with_suffix("")))
        setattr(Examples, name, lambda case, page=page: case.check(page))


add_tests()


class Reading(unittest.TestCase):
    """The test itself detects errors."""

    def test_blocks_and_comments(self):
        text = ("<!-- before: soarbox new scout -->\n\n    soarbox check scout   # mistakes\n    soarbox run SCENARIO [--json]\n\ntext\n"
                "<!-- not run: needs a window -->\n```\nsoarbox replay x\n```\n<!-- output -->\n```\n$ soarbox list\na\n...\nz\n```\n"
                "<!-- exit 3 -->\n\n    soarbox run \\\n      nowhere\n")
        found = list(examples.examples(text))
        self.assertEqual([one.command.split("#")[0].split() for one in found],
                         [["soarbox", "check", "scout"], ["soarbox", "list"], ["soarbox", "run", "nowhere"]])
        self.assertEqual(found[0].before, ["soarbox new scout"])
        self.assertEqual((found[1].expected, found[1].compares, found[2].code), (["a", "...", "z"], True, 3))

    def test_a_block_that_is_not_run_says_why(self):
        with self.assertRaises(ValueError):
            list(examples.examples("<!-- not run: -->\n\n    soarbox list\n"))

    def test_output_is_compared_in_order(self):
        self.assertTrue(says(["b", "...", "d"], "a\nb\nc\nd\n"))
        self.assertFalse(says(["b", "d"], "a\nb\nc\nd\n"))
        self.assertFalse(says(["b", "...", "e"], "a\nb\nc\nd\n"))

    def test_a_broken_example_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text("\n    soarbox run no-such-world\n")
            broken = Examples()
            with self.assertRaises(AssertionError), unittest.mock.patch(f"{__name__}.ROOT", pathlib.Path(folder)):
                broken.check(page)

    def test_there_are_examples_to_run(self):
        count = sum(len(list(examples.examples(page.read_text(encoding="utf-8")))) for page in pages())
        self.assertGreater(count, 60 if "PAGES" not in os.environ else 0)


if __name__ == "__main__":
    unittest.main()
