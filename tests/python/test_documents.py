# SPDX-License-Identifier: BSD-2-Clause
"""The Python code of the pages for Python runs unchanged, from top to bottom."""
import importlib.util
import pathlib
import re
import statistics
import unittest

DOCS = pathlib.Path(__file__).parents[2] / "docs"


class Documents(unittest.TestCase):
    def test_the_code_of_the_pages_runs(self):
        for page in ("python.md", "client_recordings.md"):
            self.run_page(DOCS / page)

    def run_page(self, page):
        text = page.read_text(encoding="utf-8")
        names = {"__name__": "page"}
        blocks = list(re.finditer(r"^```python\n(.*?)^```", text, re.M | re.S))
        self.assertGreaterEqual(len(blocks), 1)
        for block in blocks:
            line = text.count("\n", 0, block.start(1))
            with self.subTest(page=page.name, line=line + 1):
                exec(compile("\n" * line + block[1], str(page), "exec"), names)

    def test_the_tabular_learner_learns(self):
        path = DOCS / "examples" / "q_learning" / "q_learning.py"
        spec = importlib.util.spec_from_file_location("q_learning", path)
        example = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(example)
        returns = example.main(16)
        self.assertEqual(len(returns), 16)
        self.assertGreater(statistics.mean(returns[8:]), statistics.mean(returns[:8]))


if __name__ == "__main__":
    unittest.main()
