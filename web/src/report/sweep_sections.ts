// SPDX-License-Identifier: BSD-2-Clause
import { h, type Child, type View } from "../dom/view";
import { axis, chart, color, cut, digits, line, scale, text, tickCount } from "./chart";
import type { Metric, Standing, SweepReport } from "./data";
import { manifestOf, section } from "./section";
import { table, type TableCell } from "./table";

const LETTER_PX = 7, MOST_METRICS = 24, MOST_DOTS = 200;

const percent = (share: number): string => `${Math.round(100 * share)} %`;
/** Maximum width of names next to a picture, and the number of letters that fit. */
function namesOf(names: readonly string[], width: number): { left: number; fits: number } {
  const left = Math.min(Math.max(70, width * 0.3), 16 + LETTER_PX * Math.max(...names.map((name) => name.length), 4));
  return { left, fits: Math.max(4, Math.floor((left - 10) / LETTER_PX)) };
}
const named = (name: string, y: number, fits: number): View => h("g", null, h("title", null, name), text(4, y, cut(name, fits)));
const whole = (name: string, least: number, most: number): string => `${name} (95 %: ${digits(least)} to ${digits(most)})`;

/** Each run of each variant, with the mean and its interval below. Many runs are a box from the first quarter to the third, and a line from 5 % to 95 %. */
function distribution(metric: Metric, names: readonly string[]): View {
  const all = metric.variants.flatMap((one) => one.values), low = all.reduce((a, b) => Math.min(a, b), Infinity), high = all.reduce((a, b) => Math.max(a, b), -Infinity), ROW = 38;
  return chart({ label: `Distribution of ${metric.name}`, caption: metric.name }, (width) => {
    const { left, fits } = namesOf(names, width), x = scale(low, high, left + 8, width - 28), height = names.length * ROW + 26;
    const row = (one: Metric["variants"][number], i: number): Child => {
      const y = i * ROW, own = color(i), sorted = [...one.values].sort((a, b) => a - b), at = (share: number): number => x(sorted[Math.floor(share * (sorted.length - 1))]!);
      return [
        named(names[i]!, y + 22, fits),
        sorted.length > 0 && (sorted.length <= MOST_DOTS
          ? one.values.map((value, k) => h("circle", { attributes: { cx: x(value).toFixed(1), cy: y + 16 + ((k * 7) % 11) - 5, r: 2.5, fill: own, "fill-opacity": 0.5 } }))
          : [line(at(0.05), y + 16, at(0.95), y + 16, own), h("rect", { attributes: { x: at(0.25), y: y + 8, width: Math.max(1, at(0.75) - at(0.25)), height: 16, fill: own, "fill-opacity": 0.3, stroke: own } })]),
        one.mean !== undefined && h("g", null, h("title", null, whole(`mean ${digits(one.mean)}`, one.low!, one.high!)), line(x(one.low!), y + 30, x(one.high!), y + 30, own, 3), h("circle", { attributes: { cx: x(one.mean), cy: y + 30, r: 4, fill: own } })),
      ];
    };
    return { height, children: [axis(low, high, tickCount(width, 8), x, height), metric.variants.map(row)] };
  });
}

/** The agents of a tournament: their results, and the confidence intervals of their ratings. */
function standings(agents: readonly Standing[]): View {
  const low = Math.min(...agents.map((one) => one.low)), high = Math.max(...agents.map((one) => one.high)), ROW = 26;
  const rows = agents.map((one) => [one.agent, one.rating, `${one.low} to ${one.high}`, one.games, one.won, one.drawn, one.lost, one.place, one.points]);
  return section("standings", "Standings", table(["agent", "rating", "95 %", "games", "won", "drawn", "lost", "place", "points per game"], rows, "Best first"),
    chart({ label: "Ratings with their 95 % intervals", caption: "Ratings on Elo’s scale, with 95 % intervals from resampling the games", most: 1100 }, (width) => {
      const { left, fits } = namesOf(agents.map((one) => one.agent), width), x = scale(low, high, left + 8, width - 28), height = ROW * agents.length + 30;
      return {
        height,
        children: [axis(low, high, tickCount(width, 8), x, height), agents.map((one, i): Child => {
          const y = i * ROW + 14;
          return [named(one.agent, y + 4, fits), h("g", null, h("title", null, whole(`${one.agent}: ${one.rating}`, one.low, one.high)), line(x(one.low), y, x(one.high), y, color(i), 3), h("circle", { attributes: { cx: x(one.rating), cy: y, r: 4.5, fill: color(i) } }))];
        })],
      };
    }));
}

/** The sections about a sweep. */
export function sweepSections(sweep: SweepReport): Child {
  const names = sweep.variants.map((one) => one.name);
  const variants = sweep.variants.map((one) => [one.name, one.runs, one.broken, one.runs - one.judged, one.passed, one.judged > 0 ? percent(one.passed / one.judged) : "", `${percent(one.low)} to ${percent(one.high)}`]);
  const checks = sweep.check_names.map((name, i): TableCell[] => [name, ...sweep.variants.map((one) => {
    const share = one.checks[i];
    return share === undefined ? "" : `${share.true} of ${share.of} (${percent(share.low)} to ${percent(share.high)})`;
  })]);
  const differences = sweep.metrics.flatMap((metric) => metric.differences.map((one) => [metric.name, one.variant, one.mean, one.low, one.high, one.pairs, one.d ?? "", one.delta, one.probability, one.holm, one.holm < 0.05 ? "differs" : "may be chance"]));
  const few = Math.min(...sweep.metrics.flatMap((metric) => metric.differences.map((one) => one.pairs)));
  const outliers = sweep.outliers.map((one): TableCell[] => [one.variant, one.seed, one.what, one.value, one.median, h("code", null, one.command)]);
  return [
    sweep.standings !== undefined && sweep.standings.length > 0 && standings(sweep.standings),
    section("variants", "Variants", table(["variant", "runs", "crashed or hung", "undecided", "passed", "share", "95 %"], variants, "Runs of each variant")),
    checks.length > 0 && section("checks", "Checks", table(["check", ...names], checks, "How often each check was true, with 95 % intervals")),
    sweep.metrics.length > 0 && section("distributions", "Distributions", h("p.quiet", null, "Each run, with the mean and its 95 % interval below."), h("div.even", null, sweep.metrics.slice(0, MOST_METRICS).map((metric) => distribution(metric, names)))),
    differences.length > 0 && section("differences", `Differences from ${names[0] ?? ""}, on equal seeds`,
      h("p.quiet", null, `${differences.length} comparisons. The intervals (95 %, Student's t) and p are those of each alone; "after Holm" corrects for all ${differences.length}. d: the mean difference in standard deviations of the differences, empty if all differences are equal; Cliff's delta: how much likelier a larger value is than a smaller one.${few < 10 ? ` ${few} pairs are few: small differences do not show, and the intervals hold only if the numbers are spread like a normal distribution.` : ""}`),
      table(["number", "variant", "mean difference", "low", "high", "pairs", "d", "Cliff's delta", "p", "after Holm", "in all"], differences, "Paired differences with 95 % intervals")),
    outliers.length > 0 && section("outliers", "Seeds that stand out", table(["variant", "seed", "what", "value", "median", "see it"], outliers, "Furthest from the median of their variant")),
    sweep.failed.length > 0 && section("failed", "Runs that broke", table(["variant", "seed", "outcome", "why"], sweep.failed.map((one) => [one.variant, one.seed, one.outcome, one.error]), "Crashed and hung runs")),
    section("rows", "All runs", table(sweep.columns, sweep.rows.map((row) => row.map((cell) => (typeof cell === "boolean" ? (cell ? "yes" : "no") : cell))), "All runs")),
    section("about", "About", h("p.quiet", null, `Build ${sweep.build}. Intervals of means: Student's t; of rates: Wilson; of ratings: resampling.`),
      manifestOf(sweep)),
  ];
}
