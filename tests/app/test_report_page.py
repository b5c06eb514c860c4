# SPDX-License-Identifier: BSD-2-Clause
"""Pages of soarbox report in a real browser. SOARBOX_PICTURES=FOLDER keeps pictures of them to look at."""
import os
import pathlib
import tempfile
import unittest

import headless_browser
from soarbox_command import Run
from mission_case import RULES, SWEEP, WORLD

TAB, ENTER, RIGHT = "\ue004", "\ue007", "\ue014"
EVIL = "x</script><script>window.hurt=1</script>\" onload='window.hurt=1' ]]> \u202e"
PICTURES = os.environ.get("SOARBOX_PICTURES")


@unittest.skipIf(headless_browser.missing(), headless_browser.missing())
class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        os.environ["XDG_STATE_HOME"] = str(cls.folder / "state")
        cls.addClassCleanup(os.environ.pop, "XDG_STATE_HOME")
        checks = ('[[check]]\nname = "to the gate"\nagent = "scout"\nat = "gate"\nby = 10\n'
                  '[[check]]\nname = "%s"\nagent = "scout"\nat = "mill"\nby = 5\n' % EVIL.replace('"', '\\"'))
        say = ('sp {scout*say (state <s> ^superstate nil ^io.input-link.self) --> '
               '(write |<img src=x onerror="window.hurt=1"> {{data}}| (crlf))}')
        (cls.folder / "scenario.toml").write_text(WORLD + checks, encoding="utf-8")
        (cls.folder / "scout.soar").write_text(RULES + say, encoding="utf-8")
        recording = cls.folder / "run.soarrec"
        cls.make("run", cls.folder, "--headless", "--seconds", "8", "--record", recording)
        cls.page = cls.folder / "run.html"
        cls.make("report", recording, "-o", cls.page)
        spec = cls.folder / "sweep.toml"
        spec.write_text(SWEEP, encoding="utf-8")
        cls.make("sweep", spec)
        cls.sweep_page = cls.folder / "sweep.html"
        cls.make("report", spec, "-o", cls.sweep_page)
        browser = headless_browser.Browser(cls.folder)
        cls.addClassCleanup(browser.close)
        cls.browser = browser

    @classmethod
    def make(cls, *words):
        run = Run(*words)
        if run.code != 0:
            raise AssertionError(run.out + run.err)

    def show(self, page, width=1280, height=900, phone=False):
        self.browser.size(width, height, phone)
        self.browser.open(page)

    def keep(self, name):
        if PICTURES:
            self.browser.picture(pathlib.Path(PICTURES) / (name + ".png"))

    def tearDown(self):
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual(self.browser.fetched(), [], "a page needs no network")
        self.assertIsNone(self.browser.run("return window.hurt === undefined ? null : window.hurt"))

    def text(self, selector="body"):
        return self.browser.run("return document.querySelector(arguments[0]).innerText", selector)

    def test_a_run_tells_checks_ways_rules_and_texts(self):
        self.show(self.page)
        for head in ("Checks", "Key moments", "Map", "Timeline", "Numbers", "Messages", "Rules", "Files", "About"):
            self.assertIn(head, self.text())
        self.assertIn(EVIL.split("\u202e")[0].strip(), self.text("#checks"), "a name stays text")
        self.assertIn("window.hurt=1", self.text("#messages"), "what is printed stays text")
        self.assertIn("scout*apply*go", self.text("#rules"))
        self.assertIn("soarbox replay", self.text("header"))
        self.assertEqual(self.browser.run("return document.querySelectorAll('h1').length"), 1)
        self.keep("run-desktop")

    def test_the_slider_moves_the_map_and_a_check_moves_the_slider(self):
        self.show(self.page)
        where = "return document.querySelector('#ways g[transform]').getAttribute('transform')"
        before = self.browser.run(where)
        self.browser.run("const s = document.getElementById('slider'); s.value = 4; s.dispatchEvent(new Event('input'))")
        self.assertNotEqual(self.browser.run(where), before)
        self.assertIn("4.0 s", self.text(".bar output"))
        self.browser.run("document.querySelectorAll('#checks li button')[1].click()")
        self.assertIn("5.0 s", self.text(".bar output"), "the moment at which the second check failed")

    def test_all_goes_by_the_keyboard(self):
        self.show(self.page)
        self.browser.run("document.getElementById('slider').focus()")
        self.browser.press(RIGHT, RIGHT)
        self.assertIn("0.2 s", self.text(".bar output"))
        self.browser.run("document.querySelector('#rules th:nth-child(3) button').focus()")
        self.browser.press(ENTER)
        fired = "return [...document.querySelectorAll('#rules td:nth-child(3)')].map(cell => +cell.textContent)"
        rising = self.browser.run(fired)
        self.assertEqual(rising, sorted(rising))
        self.assertEqual(self.browser.run("return document.querySelector('#rules th:nth-child(3)').getAttribute('aria-sort')"), "ascending")
        self.browser.press(ENTER)
        self.assertEqual(self.browser.run(fired), sorted(rising, reverse=True))
        self.browser.run("document.activeElement.blur(); window.scrollTo(0, 0)")
        seen = set()
        for _ in range(12):
            self.browser.press(TAB)
            seen.add(self.browser.run("return document.activeElement.tagName"))
        self.assertTrue({"BUTTON", "INPUT"} <= seen, seen)

    def test_times_sort_as_numbers_and_texts_can_be_selected(self):
        self.show(self.page)
        self.browser.run("document.querySelector('#messages th button').click()")
        times = self.browser.run("return [...document.querySelectorAll('#messages td:first-child')].map(cell => parseFloat(cell.textContent))")
        self.assertEqual(times, sorted(times))
        selected = self.browser.run("getSelection().selectAllChildren(document.querySelector('#ways')); return getSelection().toString()")
        self.assertIn("gate", selected)

    def test_a_phone_shows_it_without_scrolling_sideways(self):
        for page, name in ((self.page, "run-phone"), (self.sweep_page, "sweep-phone")):
            self.show(page, 390, 844, phone=True)
            self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 390)
            small = self.browser.run("return [...document.querySelectorAll('header button, .bar button, ul.plain button')]"
                                     ".filter(b => b.getBoundingClientRect().height < 43.9)"
                                     ".map(b => b.textContent + ' ' + b.getBoundingClientRect().height)")
            self.assertEqual(small, [], "buttons are large enough for fingers")
            self.keep(name)

    def test_light_and_dark_have_contrast(self):
        # Relative luminance and contrast as WCAG defines them.
        contrast = """
            const light = c => { const [r, g, b] = c.match(/[\\d.]+/g).slice(0, 3).map(v => { v /= 255;
              return v <= 0.03928 ? v / 12.92 : Math.pow((v + 0.055) / 1.055, 2.4); }); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
            const card = light(getComputedStyle(document.querySelector('section')).backgroundColor);
            return [...document.querySelectorAll('h2, .quiet, .good, .bad, .moment')].filter(e => e.closest('section')).map(e => {
              const text = light(getComputedStyle(e).color); return (Math.max(card, text) + 0.05) / (Math.min(card, text) + 0.05); });"""
        self.addCleanup(self.browser.scheme, "light")
        grounds = set()
        for scheme in ("light", "dark"):
            self.browser.scheme(scheme)
            self.show(self.page)
            grounds.add(self.browser.run("return getComputedStyle(document.body).backgroundColor"))
            self.assertGreater(min(self.browser.run(contrast)), 4.5, scheme)
            self.keep("run-" + scheme)
        self.assertEqual(len(grounds), 2)
        self.browser.run("document.getElementById('theme').click()")
        self.assertIn(self.browser.run("return getComputedStyle(document.body).backgroundColor"), grounds)

    def test_a_sweep_tells_variants_differences_and_seeds(self):
        self.show(self.sweep_page)
        for head in ("Variants", "Checks", "Distributions", "Differences from slow", "All runs"):
            self.assertIn(head, self.text())
        self.assertEqual(self.browser.run("return document.querySelectorAll('#rows tbody tr').length"), 12)
        self.assertGreater(self.browser.run("return document.querySelectorAll('#distributions svg').length"), 1)
        self.keep("sweep-desktop")

    def test_without_scripts_the_page_tells_the_most_important(self):
        with headless_browser.Browser(self.folder / "plain", script=False) as plain:
            plain.open(self.page)
            source = plain._ask("GET", plain.session + "/source")
        self.assertIn("to the gate", source.split('<script type="application/json"')[0])


if __name__ == "__main__":
    unittest.main()
