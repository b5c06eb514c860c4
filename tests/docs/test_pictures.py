# SPDX-License-Identifier: BSD-2-Clause
"""Each picture of the documents is used and taken by a script. The script reduces colours correctly."""
import pathlib
import re
import struct
import tempfile
import unittest
import zlib

import pictures

ROOT = pathlib.Path(__file__).resolve().parents[2]
IMAGES = ROOT / "docs" / "images"
BY_BROWSER = {"report", "side_by_side"}  # Scripts in web/ take these pictures.
SITE_SCRIPT = ROOT / "tests" / "docs" / "site_pictures.mjs"


def of_the_site():
    return set(re.findall(r'name: "(site_\w+)"', SITE_SCRIPT.read_text(encoding="utf-8")))


def there():
    return {file.stem for file in IMAGES.glob("*.png")}


def colours(file):
    """The pixels of a picture with a palette."""
    data, parts, at = file.read_bytes(), {}, 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        parts[kind] = data[at + 8:at + 8 + length]
        at += 12 + length
    width, height = struct.unpack(">II", parts[b"IHDR"][:8])
    raw, palette = zlib.decompress(parts[b"IDAT"]), parts[b"PLTE"]
    rows = [raw[y * (width + 1) + 1:(y + 1) * (width + 1)] for y in range(height)]
    return [[tuple(palette[3 * number:3 * number + 3]) for number in row] for row in rows]


class Pictures(unittest.TestCase):
    def test_a_script_takes_each_picture(self):
        self.assertEqual(there(), set(pictures.PICTURES) | BY_BROWSER | of_the_site())
        self.assertIn("docs/images/side_by_side.png", (ROOT / "web" / "side_by_side.mjs").read_text(encoding="utf-8"))
        self.assertIn("docs/images/report.png", (ROOT / "web" / "e2e" / "report.mjs").read_text(encoding="utf-8"))

    def test_a_page_shows_each_picture(self):
        text = "".join(page.read_text(encoding="utf-8") for page in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")])
        shown = set(re.findall(r"images/(\w+)\.png", text))
        self.assertEqual(shown, there())

    def test_each_world_of_a_picture_comes_with_the_program(self):
        for name, picture in pictures.PICTURES.items():
            self.assertTrue((ROOT / "scenarios" / picture["world"]).exists(), name)

    def test_fewer_colours_stay_near(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "picture.png"
            rows = [[(x * 2, y * 2, 200 if x == y else 20) for x in range(120)] for y in range(120)]
            raw = b"".join(b"\0" + bytes(part for pixel in row for part in pixel) for row in rows)
            file.write_bytes(b"\x89PNG\r\n\x1a\n" + pictures.chunk(b"IHDR", struct.pack(">IIBBBBB", 120, 120, 8, 2, 0, 0, 0))
                             + pictures.chunk(b"IDAT", zlib.compress(raw)) + pictures.chunk(b"IEND", b""))
            pictures.shrink(file)
            now = colours(file)
        self.assertLessEqual(len({pixel for row in now for pixel in row}), 256)
        far = max(max(abs(a - b) for a, b in zip(was, here)) for row, other in zip(rows, now) for was, here in zip(row, other))
        self.assertLessEqual(far, 24)

    def test_a_name_that_is_none_is_refused(self):
        self.assertEqual(pictures.main(["soarbox", "no-such-picture"]), 2)
        self.assertEqual(pictures.main([]), 2)


if __name__ == "__main__":
    unittest.main()
