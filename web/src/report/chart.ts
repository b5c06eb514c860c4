// SPDX-License-Identifier: BSD-2-Clause
import { h, patch, type Child, type View } from "../dom/view";
import type { Time } from "./time";

/** Shared by the charts of reports: scales, ticks, colours, and an area that is drawn at its full width. */

const COLOR_COUNT = 8;
const DASHES = ["", "6 3", "2 3", "8 3 2 3"] as const;
/** Colours by name, for teams that are named after a colour. */
const NAMED: ReadonlyMap<string, number> = new Map([["blue", 0], ["red", 1], ["green", 2], ["purple", 3], ["orange", 4]]);

export interface Paint { color: string; dash: string }

/** Colours of the style: light ones in dark mode. */
export function color(index: number): string {
  return `var(--c${index % COLOR_COUNT})`;
}

export function dash(index: number): string {
  return DASHES[Math.floor(index / COLOR_COUNT) % DASHES.length]!;
}

/** Agents of a team share its colour, taken from its name if possible, and differ in their dashes. Without teams each agent has its own colour. */
export function paints(agents: readonly { team: string }[]): Paint[] {
  const teams = [...new Set(agents.map((agent) => agent.team))];
  if (teams.length < 2 || teams.length > COLOR_COUNT) return agents.map((_, i) => ({ color: color(i), dash: dash(i) }));
  const taken = new Set(teams.map((team) => NAMED.get(team))), free = Array.from({ length: COLOR_COUNT }, (_, i) => i).filter((i) => !taken.has(i));
  const colors = new Map(teams.map((team) => [team, NAMED.get(team) ?? free.shift() ?? 0])), members = new Map<string, number>();
  return agents.map(({ team }) => {
    const member = members.get(team) ?? 0;
    members.set(team, member + 1);
    return { color: color(colors.get(team)!), dash: DASHES[member % DASHES.length]! };
  });
}

export function scale(low: number, high: number, from: number, to: number): (value: number) => number {
  const span = high - low || 1;
  return (value) => from + ((to - from) * (value - low)) / span;
}

/** About this many round numbers within a range. */
export function ticks(low: number, high: number, count: number): number[] {
  const raw = (high - low || 1) / count, power = 10 ** Math.floor(Math.log10(raw)), step = [1, 2, 5, 10].map((one) => one * power).find((one) => one >= raw * 0.999) ?? raw, list: number[] = [];
  for (let at = Math.ceil(low / step - 1e-9); at * step <= high + step * 1e-9; at += 1) list.push(Number((at * step).toFixed(9)));
  return list;
}

/** The approximate number of round numbers that fit on an axis. */
export function tickCount(width: number, most: number): number {
  return Math.max(3, Math.min(most, Math.round(width / 110)));
}

/** A number on an axis, with enough digits to differ from its neighbours. */
export function labelOf(value: number, list: readonly number[]): string {
  const step = list.length > 1 ? Math.abs(list[1]! - list[0]!) : 1;
  return String(Number(value.toFixed(Math.max(0, Math.min(9, 1 - Math.floor(Math.log10(step)))))));
}

/** Four digits are enough to compare by. */
export function digits(value: number): string {
  return Number.isFinite(value) ? String(Number(value.toPrecision(4))) : "";
}

export function seconds(time: number): string {
  return `${time.toFixed(1)} s`;
}

/** The text, shortened if it does not fit. */
export function cut(text: string, most: number): string {
  const letters = [...text];
  return letters.length > most ? `${letters.slice(0, most - 1).join("")}…` : text;
}

export function line(x1: number, y1: number, x2: number, y2: number, stroke: string, width = 1): View {
  return h("line", { attributes: { x1: x1.toFixed(1), y1: y1.toFixed(1), x2: x2.toFixed(1), y2: y2.toFixed(1), stroke, "stroke-width": width } });
}

export function text(x: number, y: number, words: string, anchor: "start" | "middle" | "end" = "start", what = "text"): View {
  return h(what, { attributes: { x: x.toFixed(1), y: y.toFixed(1), "text-anchor": anchor } }, words);
}

/** Vertical lines with their numbers below. */
export function axis(low: number, high: number, count: number, x: (value: number) => number, height: number, unit = ""): Child {
  const marks = ticks(low, high, count);
  return marks.map((mark) => [line(x(mark), 0, x(mark), height - 18, "var(--line)"), text(x(mark), height - 4, labelOf(mark, marks) + unit, "middle", "text.quiet")]);
}

export interface Drawing {
  height: number;
  children: Child;
  /** Marks at the current moment, drawn over the rest. */
  at?: (seconds: number) => Child;
  /** Called on a click at this position of the picture. */
  click?: (x: number, y: number) => void;
}

export interface ChartProps {
  /** The text alternative of the picture. */
  label: string;
  caption: string;
  id?: string;
  /** Minimum width; narrower areas scroll. */
  least?: number;
  most?: number;
  time?: Time;
}

const LEAST_PX = 240;

/** A chart that is redrawn when its width changes, so that its text keeps its size. */
export function chart({ label, caption, id, least = LEAST_PX, most = 4000, time }: ChartProps, draw: (width: number) => Drawing): View {
  return h("figure", null, h("figcaption", null, caption), h("div.chart", {
    foreign: true,
    attributes: { tabindex: least > LEAST_PX ? 0 : undefined, role: least > LEAST_PX ? "group" : undefined, "aria-label": least > LEAST_PX ? label : undefined },
    mounted: (place) => {
      let width = 0, drawing: Drawing | null = null;
      const move = (): void => {
        const over = place.querySelector("g.now");
        if (over !== null && drawing?.at !== undefined && time !== undefined) patch(over, [drawing.at(time.now)]);
      };
      const redraw = (): void => {
        const wanted = Math.round(Math.min(most, Math.max(least, place.clientWidth)));
        if (wanted === width || place.clientWidth === 0) return;
        width = wanted;
        const made = draw(width);
        drawing = made;
        patch(place, [h(`svg${made.click === undefined ? "" : ".click"}`, {
          attributes: { viewBox: `0 0 ${width} ${made.height}`, width, height: made.height, role: "img", "aria-label": label, id },
          on: { click: (event) => {
            const box = (event.currentTarget as Element | null ?? place.firstElementChild!).getBoundingClientRect();
            made.click?.(((event.clientX - box.left) / box.width) * width, ((event.clientY - box.top) / box.height) * made.height);
          } },
        }, made.children, h("g.now", { foreign: true }))]);
        move();
      };
      time?.on(move);
      redraw();
      new ResizeObserver(redraw).observe(place);
    },
  }));
}
