// SPDX-License-Identifier: BSD-2-Clause
import { h, type Child, type View } from "../dom/view";
import { axis, chart, color, cut, dash, digits, line, paints, scale, seconds, text, tickCount, ticks } from "./chart";
import type { EventReport, RunReport, Way } from "./data";
import type { Time } from "./time";

const LETTER_PX = 7, ROW_PX = 30, RIGHT_PX = 24;
const SHORTEST_PX = 680;

/** How an event's triangle is painted. */
function markColor(kind: string): string {
  return kind === "problem" || kind === "gap" || kind === "impasse" ? "var(--bad)" : kind === "message" ? "var(--mark)" : "var(--ink)";
}

/** Events drawn as triangles: no frequent ones, and only one of several equal triangles at the same position. */
export function marksOf(events: readonly EventReport[], places: ReadonlyMap<string, number>, x: (seconds: number) => number): EventReport[] {
  const drawn = new Set<string>();
  return events.filter((event) => {
    const spot = `${event.a}/${event.k}/${Math.round(x(event.t))}`;
    if (!places.has(event.a) || event.k === "command" || event.k === "print" || drawn.has(spot)) return false;
    drawn.add(spot);
    return true;
  });
}

/** Operators and events of all agents over the entire run. */
export function timelineFigure(run: RunReport, time: Time): View {
  const names = new Map<string, number>(), places = new Map(run.agents.map((agent, i) => [agent.name, i]));
  for (const [, , , name] of run.spans) if (!names.has(name)) names.set(name, names.size);
  return chart({ label: "Operators and events of each agent over time; the tables below have the same as text", caption: "Bars are selected operators; triangles are impasses, messages and other events. A click moves the slider.", id: "spans", least: SHORTEST_PX, time }, (width) => {
    const left = Math.min(150, 14 + LETTER_PX * Math.max(...run.agents.map((agent) => agent.name.length), 4)), fits = Math.floor((left - 10) / LETTER_PX), height = run.agents.length * ROW_PX + 24;
    const end = run.seconds || 1, x = scale(0, end, left, width - RIGHT_PX);
    return {
      height,
      children: [
        axis(0, end, tickCount(width, 16), x, height, " s"),
        run.agents.map((agent, i) => h("g", null, h("title", null, agent.name), text(4, i * ROW_PX + 18, cut(agent.name, fits)))),
        run.spans.map(([agent, from, to, name]): Child => {
          const number = names.get(name)!, wide = Math.max(1, x(to) - x(from));
          return h("g", null, h("title", null, `${run.agents[agent]!.name}: ${name}, ${seconds(from)} to ${seconds(to)}`),
            h("rect", { attributes: { x: x(from).toFixed(1), y: agent * ROW_PX + 5, width: wide.toFixed(1), height: 18, fill: color(number), "fill-opacity": 0.3, stroke: color(number), "stroke-dasharray": dash(number) } }),
            wide > LETTER_PX * name.length + 6 && text(x(from) + 4, agent * ROW_PX + 18, name));
        }),
        marksOf(run.events, places, x).map((event): Child => {
          const at = x(event.t), y = places.get(event.a)! * ROW_PX + 27;
          return h("path", { attributes: { d: `M${(at - 4).toFixed(1)} ${y}h8l-4 -6Z`, fill: markColor(event.k) } }, h("title", null, `${seconds(event.t)} ${event.k}: ${event.text}`));
        }),
      ],
      at: (now) => line(x(now), 0, x(now), height - 18, "var(--accent)", 2),
      click: (at) => time.go(((at - left) / (width - RIGHT_PX - left)) * end),
    };
  });
}

const PLOT_PX = 190, MOST_POINTS = 900;

/** One number of all agents over time. */
export function plotFigure(run: RunReport, ways: readonly (Way | null)[], what: "speed" | "health", title: string, time: Time): View {
  const high = ways.reduce((most, way) => (way === null ? most : way[what].reduce((a, b) => Math.max(a, b), most)), 0) || 1, paint = paints(run.agents);
  return chart({ label: `${title} over time`, caption: title, time }, (width) => {
    const left = 44, end = run.seconds || 1, x = scale(0, end, left, width - RIGHT_PX), y = scale(0, high, PLOT_PX - 24, 10);
    return {
      height: PLOT_PX,
      children: [
        ticks(0, high, 4).map((value) => [line(left, y(value), width - RIGHT_PX, y(value), "var(--line)"), text(left - 6, y(value) + 4, digits(value), "end", "text.quiet")]),
        ticks(0, end, tickCount(width, Infinity)).map((value) => text(x(value), PLOT_PX - 6, `${value} s`, "middle", "text.quiet")),
        ways.map((way, i): Child => {
          if (way === null) return null;
          const every = Math.max(1, Math.floor(way[what].length / MOST_POINTS)), last = way[what].length - 1;
          const d = way[what].map((value, k) => (k % every === 0 || k === last ? `${x(run.times[k + way.from] ?? 0).toFixed(1)} ${y(value).toFixed(1)}` : "")).filter((point) => point !== "").join("L");
          return h("path", { attributes: { d: `M${d}`, fill: "none", stroke: paint[i]!.color, "stroke-width": 1.5, "stroke-dasharray": paint[i]!.dash } }, h("title", null, run.agents[i]!.name));
        }),
      ],
      at: (now) => line(x(now), 8, x(now), PLOT_PX - 24, "var(--accent)"),
      click: (at) => time.go(((at - left) / (width - RIGHT_PX - left)) * end),
    };
  });
}

/** Legend of colours and dashes. */
export function legend(run: RunReport): View {
  const paint = paints(run.agents);
  return h("ul.legend", { attributes: { "aria-label": "Colours of agents" } }, run.agents.map((agent, i) => h("li", null,
    h("svg", { attributes: { viewBox: "0 0 28 8", width: 28, height: 8, "aria-hidden": "true" } }, h("line", { attributes: { x1: 0, y1: 4, x2: 28, y2: 4, stroke: paint[i]!.color, "stroke-width": 2.5, "stroke-dasharray": paint[i]!.dash } })), agent.name)));
}
