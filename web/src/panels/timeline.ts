// SPDX-License-Identifier: BSD-2-Clause
import { h } from "../dom/view";
import type { Contents, Span, Track } from "../run/contents";
import { EMPTY } from "./panel_table";
import { infoOf, type MakePanel } from "./panel";
import { clock, empty } from "./parts";

const NAMES_PX = 92, LINE_PX = 16, GAP_PX = 6, MARKS_PX = 14, SCALE_PX = 22, MOST_TICKS = 900;
const MARK_COLORS: Readonly<Record<string, string>> = { command: "#e0a30b", outcome: "#2fa37a", message: "#3a8fd6", event: "#9a6fd0", error: "#d9412b", edit: "#d67a3a", learned: "#c04fa0" };
const MARK_NAMES: Readonly<Record<string, string>> = { command: "command", outcome: "answer", message: "message", event: "event", error: "error", edit: "changed rule", learned: "learned rule" };

export interface Placement { first: number; last: number; perTick: number; rows: readonly { track: Track; top: number; lines: number }[]; height: number }

/** The vertical layout. Each level has two lines: one for the state and one for the operator. */
export function placeTracks(tracks: readonly Track[], shownTick: number, widthPx: number): Placement {
  const last = Math.max(shownTick, 60), first = Math.max(0, last - MOST_TICKS);
  let top = SCALE_PX;
  const rows = tracks.map((track) => {
    const deepest = track.spans.reduce((most, span) => Math.max(most, span.level), 1), lines = deepest * 2 - 1, row = { track, top, lines };
    top += lines * LINE_PX + MARKS_PX + GAP_PX;
    return row;
  });
  return { first, last, perTick: Math.max(1, widthPx - NAMES_PX - 8) / (last - first), rows, height: top };
}

export function lineOf(span: Pick<Span, "kind" | "level">): number {
  return span.kind === "operator" ? 2 * span.level - 2 : 2 * span.level - 3;
}

/** A name that is drawn over the bars of one or more spans. */
export interface BarName { text: string; kind: Span["kind"]; level: number; left: number; right: number }

/** Minimum width of a bar with its own name, and maximum gap between bars that share one. */
const LEAST_NAMED_PX = 26, MOST_GAP_PX = 2;

/** Names of bars. Bars that are too narrow for a name share one if they follow each other and mean the same. */
export function namesOf(bars: readonly BarName[]): BarName[] {
  const shown: BarName[] = [], narrow = new Map<number, BarName>();
  for (const bar of bars) {
    const line = lineOf(bar), before = narrow.get(line);
    if (bar.right - bar.left >= LEAST_NAMED_PX) {
      shown.push(bar);
      narrow.delete(line);
    } else if (before !== undefined && before.text === bar.text && bar.left - before.right <= MOST_GAP_PX) {
      before.right = bar.right;
    } else {
      const group = { ...bar };
      shown.push(group);
      narrow.set(line, group);
    }
  }
  return shown.filter((one) => one.right - one.left >= LEAST_NAMED_PX);
}

const hue = (text: string): number => [...text].reduce((sum, c) => (sum * 31 + (c.codePointAt(0) ?? 0)) % 360, 7);

export const timelinePanel: MakePanel = (context) => {
  let canvas: HTMLCanvasElement | null = null, latest: Contents = {}, hint = "";

  const paint = (): void => {
    if (canvas === null) return;
    const tracks = latest.timeline?.timeline ?? [], step = latest.moment?.time.step_s ?? 1 / 30, shownTick = latest.moment?.time.shown_tick ?? 0;
    const width = canvas.parentElement?.clientWidth ?? 0;
    if (width === 0) return;
    const placed = placeTracks(tracks, shownTick, width), ratio = devicePixelRatio, style = getComputedStyle(canvas), inkColor = style.color;
    canvas.width = width * ratio;
    canvas.height = placed.height * ratio;
    canvas.style.height = `${placed.height}px`;
    const out = canvas.getContext("2d");
    if (out === null) return;
    out.scale(ratio, ratio);
    out.font = "12px system-ui, sans-serif";
    out.textBaseline = "middle";
    const x = (tick: number): number => NAMES_PX + (tick - placed.first) * placed.perTick;
    out.fillStyle = out.strokeStyle = inkColor;
    const everyS = (placed.last - placed.first) * step > 16 ? 5 : (placed.last - placed.first) * step > 6 ? 2 : 1;
    for (let second = Math.ceil((placed.first * step) / everyS) * everyS; second <= placed.last * step; second += everyS) {
      out.globalAlpha = 0.6;
      out.fillText(`${second} s`, x(second / step) + 3, 9);
      out.globalAlpha = 0.18;
      out.fillRect(x(second / step), 0, 1, placed.height);
    }
    for (const { track, top, lines } of placed.rows) {
      out.globalAlpha = 1;
      out.fillStyle = inkColor;
      out.fillText(track.agent === "" ? "world" : track.agent, 2, top + LINE_PX / 2, NAMES_PX - 8);
      const bars: BarName[] = [];
      for (const span of track.spans) {
        const left = Math.max(x(span.first_tick), NAMES_PX), right = Math.max(x(span.open ? placed.last : span.last_tick), left + 2), y = top + lineOf(span) * LINE_PX;
        if (right < NAMES_PX || lineOf(span) < 0) continue;
        out.globalAlpha = 1;
        out.fillStyle = span.kind === "state" ? "hsl(32 75% 45%)" : `hsl(${hue(span.text)} 48% 45%)`;
        out.fillRect(left, y + 1, right - left - 0.5, LINE_PX - 2);
        bars.push({ text: span.text, kind: span.kind, level: span.level, left, right });
      }
      for (const name of namesOf(bars)) {
        const y = top + lineOf(name) * LINE_PX, room = name.right - name.left - 8, wide = out.measureText(name.text).width;
        const next = Math.min(width, ...bars.filter((bar) => lineOf(bar) === lineOf(name) && bar.left >= name.right).map((bar) => bar.left));
        // A name that is too long for its bar is written after it, if there is room.
        const isAfter = wide > room && next - name.right > wide + 8;
        out.save();
        out.beginPath();
        out.rect(isAfter ? name.right : name.left, y, isAfter ? wide + 8 : name.right - name.left - 2, LINE_PX);
        out.clip();
        out.fillStyle = isAfter ? inkColor : "#fff";
        out.fillText(name.text, (isAfter ? name.right : name.left) + 4, y + LINE_PX / 2 + 0.5);
        out.restore();
      }
      for (const mark of track.marks) {
        if (mark.tick < placed.first) continue;
        out.fillStyle = MARK_COLORS[mark.kind] ?? inkColor;
        out.globalAlpha = 0.9;
        out.beginPath();
        out.arc(x(mark.tick), top + lines * LINE_PX + MARKS_PX / 2, 3.4, 0, 7);
        out.fill();
      }
      out.globalAlpha = 0.15;
      out.fillStyle = inkColor;
      out.fillRect(0, top + lines * LINE_PX + MARKS_PX + GAP_PX / 2, width, 1);
    }
  };

  const at = (event: MouseEvent): { tick: number; text: string } => {
    const box = canvas!.getBoundingClientRect(), placed = placeTracks(latest.timeline?.timeline ?? [], latest.moment?.time.shown_tick ?? 0, box.width), step = latest.moment?.time.step_s ?? 1 / 30;
    const tick = Math.round(placed.first + (event.clientX - box.left - NAMES_PX) / placed.perTick), y = event.clientY - box.top;
    const row = placed.rows.find((one) => y >= one.top && y < one.top + one.lines * LINE_PX + MARKS_PX + GAP_PX);
    const told = [clock(tick * step)];
    if (row !== undefined) {
      const line = Math.floor((y - row.top) / LINE_PX), near = 5 / placed.perTick;
      if (line < row.lines) for (const span of row.track.spans) if (lineOf(span) === line && span.first_tick <= tick && (span.open || span.last_tick >= tick)) told.push(`${span.text} (${span.id})`);
      if (line >= row.lines) for (const mark of row.track.marks) if (Math.abs(mark.tick - tick) <= near) told.push(`${mark.kind}: ${mark.text}`);
    }
    return { tick, text: told.slice(0, 5).join(" · ") };
  };

  return {
    ...infoOf("timeline"), uses: ["timeline", "moment"],
    view: (contents) => {
      latest = contents;
      const tracks = contents.timeline?.timeline ?? [];
      if (tracks.length === 0) {
        canvas = null;
        return empty(EMPTY.timeline);
      }
      return [
        h("p.quiet.told", { attributes: { "aria-live": "off" } }, hint === "" ? "Click a moment to go there. A state of the stack is orange, an operator has its own colour." : hint),
        h("ul.mark-kinds", { attributes: { "aria-label": "Meaning of the dots" } }, Object.entries(MARK_NAMES).filter(([kind]) => tracks.some((track) => track.marks.some((mark) => mark.kind === kind)))
          .map(([kind, name]) => h("li", { key: kind }, h("i", { style: { background: MARK_COLORS[kind]! } }), name))),
        h("canvas.timeline", {
          foreign: true, attributes: { role: "img", "aria-label": "Operators and events over time; the trace has the same as text" },
          mounted: (element) => {
            canvas = element as HTMLCanvasElement;
            paint();
            new ResizeObserver(paint).observe(element.parentElement!);
          },
          patched: paint,
          on: {
            click: (event) => context.run.ask("seek", { tick: Math.max(0, at(event).tick) }),
            mousemove: (event) => {
              hint = at(event).text;
              context.redraw("timeline");
            },
            mouseleave: () => {
              hint = "";
              context.redraw("timeline");
            },
          },
        }),
        h("ul.hidden", null, tracks.map((track) => h("li", null, `${track.agent === "" ? "world" : track.agent}: ${track.spans.filter((span) => span.open).map((span) => span.text).join(", ")}`))),
      ];
    },
  };
};
