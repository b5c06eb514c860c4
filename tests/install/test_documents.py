# SPDX-License-Identifier: BSD-2-Clause
"""Links of installed documents work, and the documents contain what a user without the source needs."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

BUILD = os.environ["SOARBOX_BUILD"]
LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        for component in ("documentation", "licence"):
            subprocess.run(["cmake", "--install", BUILD, "--prefix", folder.name, "--component", component], check=True, stdout=subprocess.DEVNULL)
        cls.pages = pathlib.Path(folder.name) / "share" / "doc" / "soarbox"

    def links(self):
        for page in sorted(self.pages.rglob("*.md")):
            for link in LINK.findall(CODE.sub("", page.read_text(encoding="utf-8"))):
                if "://" not in link and not link.startswith("#"):
                    yield page, link

    def test_every_link_leads_to_an_installed_file(self):
        links = list(self.links())
        self.assertGreater(len(links), 400)
        broken = [f"{page.relative_to(self.pages)}: {link}" for page, link in links if not (page.parent / link.split("#")[0]).exists()]
        self.assertEqual(broken, [])

    def test_a_link_that_cannot_be_followed_keeps_its_words(self):
        text = (self.pages / "README.md").read_text(encoding="utf-8")
        self.assertIn("[Soar in one evening](docs/soar_in_one_evening.md)", text)
        self.assertIn("CONTRIBUTING (in the source)", text)

    def test_users_find_the_reference_of_the_client_interface(self):
        for name in ("docs/README.md", "docs/spec/sml_client_api.md", "docs/spec/imagery.md", "docs/spec/teaching_worlds.md", "LICENSE", "SECURITY.md", "CITATION.cff"):
            self.assertTrue((self.pages / name).is_file(), name)
        self.assertFalse((self.pages / "docs" / "dev").exists(), "maintainers' pages stay with the source")


if __name__ == "__main__":
    unittest.main()
