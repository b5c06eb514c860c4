# SPDX-License-Identifier: BSD-2-Clause
"""Pages for users follow docs/dev/words.md: they contain none of the replaced words that have only one meaning."""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
REPLACED = {"tells": "reports", "anew": "again", "remedy": "hint", "at hand": "current", "take over": "reload"}
# Their text is generated from tables in the source.
GENERATED = {"workbench.md", "soar_commands.md", "percepts.md", "commands.md"}


def pages():
    return [ROOT / "README.md", *(page for page in sorted((ROOT / "docs").glob("*.md")) if page.name not in GENERATED)]


def prose(text):
    """The text without blocks of code and quoted words, in the same lines."""
    text = re.sub(r"```.*?```", lambda block: "\n" * block[0].count("\n"), text, flags=re.DOTALL)
    return re.sub(r"`[^`\n]*`|^ {4}.*$|^ {6}.*$", "", text, flags=re.MULTILINE)


class Words(unittest.TestCase):
    def test_no_page_has_a_word_that_is_replaced(self):
        found = []
        for page in pages():
            for number, line in enumerate(prose(page.read_text(encoding="utf-8")).splitlines(), 1):
                for word, better in REPLACED.items():
                    if re.search(rf"\b{word}\b", line, re.IGNORECASE):
                        found.append(f"{page.relative_to(ROOT)}:{number}: write {better} instead of {word}: {line.strip()[:90]}")
        self.assertEqual(found, [])

    def test_code_is_left_out(self):
        self.assertEqual(prose("a `told` b\n```\ntold\n```\n    told\n").split(), ["a", "b"])


if __name__ == "__main__":
    unittest.main()
