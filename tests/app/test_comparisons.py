# SPDX-License-Identifier: BSD-2-Clause
"""The statements of sweeps, tournaments and `compare` about differences are true, and include their uncertainty."""
import csv
import math
import re
import statistics

from mission_case import RULES, SWEEP, WORLD, MissionCase
from soarbox_command import Run

# Chooses at random between two kinds of steps.
CHANCE = """
sp {scout*propose*step
   (state <s> ^superstate nil ^io.input-link.waypoint <w>)
   (<w> ^name <name>)
-->
   (<s> ^operator <o> + =)
   (<o> ^name step ^to <name>)
}
sp {scout*apply*step
   (state <s> ^operator <o> ^io.output-link <out>)
   (<o> ^name step ^to <name>)
-->
   (<out> ^move-to <command>)
   (<command> ^waypoint <name>)
}
"""
NOISY = """
scenario = "scenario.toml"
seeds = "1..%d"
seconds = 6
[[check]]
name = "near"
agent = "scout"
near = "gate"
range = { max = 3 }
[[variant]]
name = "base"
parameters = { "agent.scout.speed" = 2, "agent.scout.senses.noise" = 0.5 }
[[variant]]
name = "fast"
parameters = { "agent.scout.speed" = 3, "agent.scout.senses.noise" = 0.5 }
[[variant]]
name = "fast too"
parameters = { "agent.scout.speed" = 3, "agent.scout.senses.noise" = 0.5 }
[[metric]]
name = "way"
at_end = "distance"
agent = "scout"
"""
DIFFERENCE = re.compile(r"^  (?P<what>[^:]+): (?P<variant>.+) has (?P<mean>\S+) (?P<word>more|less) than base \(95 %: (?P<low>\S+) to (?P<high>\S+)\), "
                        r"more in \d+ % of (?P<pairs>\d+) equal seeds; d (?P<d>\S+), Cliff's delta (?P<delta>\S+); "
                        r"by chance with probability (?P<p>[^,;]+)(, (?P<holm>[^;]+) after Holm)?", re.MULTILINE)


def student_two_sided(t, freedom):
    """The probability that |t| of Student's t distribution is at least this large, by Simpson's rule over the density."""
    scale = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)) / math.sqrt(freedom * math.pi)
    density = lambda x: scale * (1 + x * x / freedom) ** (-(freedom + 1) / 2)
    steps, width = 20000, abs(t) / 20000
    inside = sum((1 if i in (0, steps) else 4 if i % 2 else 2) * density(i * width) for i in range(steps + 1)) * width / 3
    return max(0, 1 - 2 * inside)


def holm(probabilities):
    order = sorted(range(len(probabilities)), key=lambda i: probabilities[i])
    corrected, most = [0.0] * len(order), 0.0
    for rank, i in enumerate(order):
        most = max(most, min(1, (len(order) - rank) * probabilities[i]))
        corrected[i] = most
    return corrected


class Sweeps(MissionCase):
    def rows(self, name="noisy.sweep"):
        with open(self.folder / name / "results.csv", newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def noisy(self, seeds, rules=CHANCE):
        self.mission("", rules=rules)
        return Run("sweep", self.write("noisy.toml", NOISY % seeds), code=0).out

    def of(self, what, variant):
        return {int(row["seed"]): float(row[what]) for row in self.rows() if row["variant"] == variant}

    def test_differences_are_those_of_the_table_corrected_for_how_many_they_are(self):
        out = self.noisy(12)
        found = [each.groupdict() for each in DIFFERENCE.finditer(out)]
        self.assertGreaterEqual(len(found), 4, out)
        told = int(re.search(r"\((\d+) comparisons, corrected after Holm", out)[1])
        lines = re.findall(r"by chance with probability (\S+?), (\S+?) after Holm", out)
        self.assertEqual(told, len(lines), out)
        for (_, shown), corrected in zip(lines, holm([float(p) for p, _ in lines])):
            self.assertAlmostEqual(float(shown), corrected, delta=0.02 * corrected + 1e-12)
        checked = 0
        for each in found:
            what = each["what"]
            if what not in self.rows()[0]:
                continue
            checked += 1
            base, other = self.of(what, "base"), self.of(what, each["variant"])
            differences = [other[seed] - base[seed] for seed in base]
            n, mean, sd = len(differences), statistics.mean(differences), statistics.stdev(differences)
            self.assertEqual(int(each["pairs"]), n)
            self.assertEqual(each["word"], "less" if mean < 0 else "more")
            if each["word"] == "less":  # "2.4 less than base (95 %: 1.3 to 3.6)"
                each.update(mean=-float(each["mean"]), low=-float(each["high"]), high=-float(each["low"]))
            for shown, expected in (("mean", mean), ("d", mean / sd),
                                    ("p", student_two_sided(mean / sd * math.sqrt(n), n - 1)),
                                    ("low", mean - 2.200985 * sd / math.sqrt(n)), ("high", mean + 2.200985 * sd / math.sqrt(n)),
                                    ("delta", sum((b > a) - (b < a) for a in base.values() for b in other.values()) / n / n)):
                self.assertAlmostEqual(float(each[shown]), expected, delta=0.006 * abs(expected) + 1e-4, msg=f"{what} {shown}")
        self.assertGreaterEqual(checked, 2)

    def test_few_seeds_equal_variants_and_constant_numbers_are_said(self):
        out = self.noisy(3)
        self.assertIn("these are few seeds", out)
        self.assertRegex(out, r"the same in all runs: .*alive 1")
        self.assertIn("fast and fast too have the same numbers on each seed", out)
        self.assertNotIn("these are few seeds", self.noisy(12))

    def test_what_may_be_chance_says_how_many_seeds_would_show_it(self):
        self.mission("", rules=CHANCE)
        spec = (NOISY % 5).replace('"agent.scout.speed" = 3', '"agent.scout.speed" = 2.02')
        out = Run("sweep", self.write("noisy.toml", spec), code=0).out
        self.assertRegex(out, r"that may be chance \(\d+ seeds would show this d, if it is one\)")

    def test_numbers_that_differ_by_rounding_do_not_differ(self):
        self.mission("")
        spec = SWEEP.replace('"agent.scout.speed" = 2 }', '"agent.scout.speed" = 5 }').replace(', "agent.scout.senses.noise" = 0.5', '')
        out = Run("sweep", self.write("noisy.toml", spec), code=0).out
        self.assertNotRegex(out, r"e-\d\d (more|less) than")
        self.assertIn("fast never differs from slow", out)

    def test_differences_that_are_all_equal_have_no_d(self):
        self.mission("")
        spec = (NOISY % 4).replace(', "agent.scout.senses.noise" = 0.5', '')
        out = Run("sweep", self.write("noisy.toml", spec), code=0).out
        self.assertRegex(out, r"way: fast has \S+ more than base .* 4 equal seeds; no d, because all differences are equal, Cliff's delta 1;")
        self.assertNotRegex(out, r"; d (0|\S+e[-+]\d+),")

    def test_a_variant_rests_on_the_files_that_it_uses(self):
        self.mission("")
        self.write("bold.soar", RULES)
        one = SWEEP + '[[variant]]\nname = "bold"\nrules = { "scout" = "bold.soar" }\n'
        spec = self.write("noisy.toml", one.replace('"scenario.toml"', '"."'))
        Run("sweep", spec, code=0)
        before = {(row["variant"], row["seed"]): row["state_hash"] for row in self.rows()}
        # A file that no variant uses; then a variant that uses it.
        self.write("bolder.soar", RULES.replace("off I go", "here I go"))
        self.assertIn("0 runs made, 18 were there", Run("sweep", spec, code=0).err)
        spec.write_text(spec.read_text() + '[[variant]]\nname = "bolder"\nrules = { "scout" = "bolder.soar" }\n', encoding="utf-8")
        self.assertIn("6 runs made, 18 were there", Run("sweep", spec, code=0).err)
        after = {(row["variant"], row["seed"]): row["state_hash"] for row in self.rows()}
        self.assertEqual(before, {key: after[key] for key in before})
        # The files of a variant that has runs must not change.
        self.write("bold.soar", RULES.replace("off I go", "there I go"))
        self.assertIn("variant 'bold' has changed since this sweep began", Run("sweep", spec, code=3).err)
        self.write("bold.soar", RULES)
        self.write("scout.soar", RULES.replace("off I go", "there I go"))
        self.assertRegex(Run("sweep", spec, code=3).err, r"variant '(slow|fast)' has changed since this sweep began")


class Compare(MissionCase):
    def record(self, name, seed, rules=CHANCE, world=WORLD):
        self.mission("", rules=rules, world=world)
        file = self.folder / name
        Run("run", self.folder / "scenario.toml", "--headless", "--seconds", 4, "--seed", seed, "--record", file, "--record-level", "all",
            code=0)
        return file

    def test_other_seeds_are_named_and_that_chance_selected(self):
        a, b = self.record("a.soarrec", 1), None
        for seed in range(2, 20):
            b = self.record("b.soarrec", seed)
            out = Run("compare", a, b, code=1).out
            self.assertIn(f"seeds differ: A 1, B {seed}", out)
            if "first other decision" in out:
                break
        self.assertRegex(out, r"  A: .*chance.*\n  B: .*chance")
        self.assertIn("chance selected, and other random numbers gave another result", out)
        self.assertNotIn("its rules or its memory differ", out)
        # Two operators with the same name are distinguished by their elements.
        contents = re.findall(r"^  ([AB]): O\d+ \^to (gate|mill) \^name step$", out, re.MULTILINE)
        self.assertEqual([side for side, _ in contents], ["A", "B"], out)
        self.assertNotEqual(contents[0][1], contents[1][1])

    def test_other_rules_are_named_with_their_line(self):
        a = self.record("a.soarrec", 1, RULES)
        b = self.record("b.soarrec", 1, RULES.replace("^waypoint gate)", "^waypoint mill)"))
        out = Run("compare", a, b, code=1).out
        line = RULES[:RULES.index("^waypoint gate)")].count("\n") + 1
        self.assertIn(f"files differ from scout.soar:{line} on", out)
        self.assertNotIn("seeds differ", out)
        self.assertNotIn("by chance", out)

    def test_equal_runs_name_nothing(self):
        out = Run("compare", self.record("a.soarrec", 1), self.record("b.soarrec", 1), code=0).out
        self.assertRegex(out, r"\Aequal: ticks 0 to \d+\n\Z")
