# SPDX-License-Identifier: BSD-2-Clause
"""Pictures, animations and plots that are drawn without a display."""
import os
import shutil
import struct
import subprocess
import unittest
import xml.etree.ElementTree

from mission_case import SWEEP, MissionCase
from png_picture import Picture
from soarbox_command import COMMAND, Run

SVG = "{http://www.w3.org/2000/svg}"


def frames_of_gif(path):
    """Width, height and the number of pictures; walks through all blocks."""
    data = path.read_bytes()
    assert data[:6] == b"GIF89a", data[:6]
    at, count = 13, 0
    while data[at:at + 1] != b";":
        if data[at] == 0x21:
            at += 2
        else:
            assert data[at] == 0x2c, data[at]
            count += 1
            at += 10 + 256 * 3 + 1
        while data[at]:
            at += data[at] + 1
        at += 1
    assert at == len(data) - 1
    return (*struct.unpack("<HH", data[6:10]), count)


class Drawings(MissionCase):
    def setUp(self):
        super().setUp()
        self.mission("")
        self.file = self.folder / "run.soarrec"
        Run("run", self.folder / "scenario.toml", "--headless", "--seconds", 3, "--record", self.file, code=0)

    def draw(self, *words, code=0, **environment):
        kept = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
        done = subprocess.run([COMMAND, "replay", self.file, *map(str, words)], env={**kept, **environment}, capture_output=True, text=True,
                              timeout=300, check=False)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def test_pictures_of_moments_without_a_display(self):
        folder = self.folder / "pictures"
        out = self.draw("--pictures", folder, "--every", 1, "--width", 320, "--height", 180).stdout
        self.assertIn("4 pictures of 320 by 180 pixels, one every 1 s", out)
        names = sorted(path.name for path in folder.iterdir())
        self.assertEqual(names, ["tick-000000.png", "tick-000030.png", "tick-000060.png", "tick-000090.png"])
        pictures = [(folder / name).read_bytes() for name in names]
        self.assertEqual(len(set(pictures)), 4, "the scout walks")
        picture = Picture(folder / names[0])
        self.assertEqual((picture.width, picture.height), (320, 180))
        again = self.folder / "again"
        self.draw("--pictures", again, "--every", 1, "--width", 320, "--height", 180)
        self.assertEqual([(again / name).read_bytes() for name in names], pictures)

    def test_a_part_from_above_that_follows_an_agent(self):
        folder = self.folder / "pictures"
        self.draw("--pictures", folder, "--every", 0.5, "--from", 1, "--to", 2, "--plan", "--select", "scout", "--width", 160, "--height", 120)
        self.assertEqual(len(list(folder.iterdir())), 3)
        self.assertIn("there is no agent 'nobody' in these moments",
                      self.draw("--pictures", folder, "--select", "nobody", "--width", 160, "--height", 120, code=3).stderr)

    def test_an_animation_needs_nothing_else(self):
        clip = self.folder / "clip.gif"
        self.draw("--video", clip, "--width", 160, "--height", 120, PATH="")
        self.assertEqual(frames_of_gif(clip), (160, 120, 31))

    def test_a_video_needs_ffmpeg_and_says_so(self):
        clip = self.folder / "it's a clip.mp4"
        err = self.draw("--video", clip, PATH="", code=3).stderr
        self.assertIn("ffmpeg, which makes videos of this kind, is not installed", err)
        self.assertIn("or name a .gif", err)
        self.assertFalse(clip.exists())
        self.assertIn("the name of a video ends with its kind", self.draw("--video", self.folder / "clip", code=3).stderr)

    def test_a_program_that_makes_videos_gets_all_pixels(self):
        # Instead of ffmpeg, a program that counts.
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "ffmpeg").write_text(f"#!/bin/sh\necho \"$@\" > {self.folder}/words\nwc -c > {self.folder}/count\n", encoding="utf-8")
        (tools / "ffmpeg").chmod(0o755)
        clip = self.folder / "it's a clip.mp4"
        self.draw("--video", clip, "--width", 160, "--height", 120, PATH=f"{tools}:{os.environ['PATH']}")
        self.assertEqual(int((self.folder / "count").read_text()), 31 * 160 * 120 * 3)
        words = (self.folder / "words").read_text()
        self.assertIn("-f rawvideo -pix_fmt rgb24 -s 160x120 -r 10 -i -", words)
        self.assertIn(str(clip), words)
        (tools / "ffmpeg").write_text("#!/bin/sh\nexit 1\n", encoding="utf-8")
        err = self.draw("--video", clip, "--width", 160, "--height", 120, code=3, PATH=f"{tools}:{os.environ['PATH']}").stderr
        self.assertIn("ffmpeg made no video", err)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_ffmpeg_makes_a_video(self):
        clip = self.folder / "clip.mp4"
        self.draw("--video", clip, "--width", 160, "--height", 120)
        self.assertEqual(clip.read_bytes()[4:8], b"ftyp")


class Plots(MissionCase):
    def plots(self, source):
        folder = self.folder / "plots"
        out = Run("report", source, "--plots", folder, code=0).out
        drawn = {path.stem: xml.etree.ElementTree.parse(path).getroot() for path in sorted(folder.glob("*.svg"))}
        self.assertIn(f"{len(drawn)} plots, each as SVG and PNG", out)
        for name, root in drawn.items():
            picture = Picture(folder / f"{name}.png")
            self.assertEqual((picture.width, picture.height), (2 * int(root.get("width")), 2 * int(root.get("height"))), name)
            self.assertTrue(root.find(SVG + "title").text)
            for shape in root.iter():
                for key in ("x", "y", "cx", "cy"):
                    self.assertTrue(-1 <= float(shape.get(key, 0)) <= 2000, (name, shape.attrib))
        return drawn

    def test_of_a_sweep(self):
        self.mission("")
        Run("sweep", self.write("study.toml", SWEEP), code=0)
        plots = self.plots(self.folder / "study.toml")
        self.assertLessEqual({"rate-passed", "distribution-distance", "histogram-distance", "difference-distance"}, set(plots))
        texts = [text.text for text in plots["distribution-distance"].iter(SVG + "text")]
        self.assertLessEqual({"slow", "fast"}, set(texts))
        # A dot for each of 12 runs and one for each mean.
        self.assertEqual(len(list(plots["distribution-distance"].iter(SVG + "circle"))), 14)
        # Each run is in one bar: the bars of six runs each.
        self.assertEqual(len(list(plots["difference-distance"].iter(SVG + "circle"))), 1)
        self.assertTrue(any("after Holm" in text.text for text in plots["difference-distance"].iter(SVG + "text")))
        self.assertEqual(set(self.plots(self.folder / "study.sweep")), set(plots))

    def test_of_a_run(self):
        self.mission("")
        file = self.folder / "run.soarrec"
        Run("run", self.folder / "scenario.toml", "--headless", "--seconds", 3, "--record", file, code=0)
        plots = self.plots(file)
        self.assertEqual(set(plots), {"map", "speed", "health"})
        self.assertIn("scout", [text.text for text in plots["map"].iter(SVG + "text")])
        points = max(len(path.get("points").split()) for path in plots["speed"].iter(SVG + "polyline"))
        self.assertGreater(points, 10)

    def test_what_has_no_plots(self):
        self.assertIn("there is nothing here to make plots of", Run("report", self.folder, "--plots", self.folder / "plots", code=3).err)
