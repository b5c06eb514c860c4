// SPDX-License-Identifier: BSD-2-Clause
import type { Mark, Timeline } from "./contents";

export interface PrintedLine { tick: number; agent: string; text: string; isPrinted: boolean }

/** Events about agents begin with one of these words; all other events of a timeline were printed by rules and scripts. */
const NEWS = /^(?:shoots|dies|takes|drops|gives|leaves|says)\b/;
/** An agent that joins the world, and an agent with an idle mind. */
const ABOUT_RUN = /^(?:soar|lua)\b[^,]*,\s*\S+\.(?:soar|lua)$|^it has done nothing for /;

const MOST_LINES = 500;

function lineOf(agent: string, mark: Mark): PrintedLine | null {
  if (mark.kind !== "event" && mark.kind !== "message") return null;
  if (mark.text === "" || ABOUT_RUN.test(mark.text)) return null;
  return { tick: mark.tick, agent, text: mark.text, isPrinted: mark.kind === "event" && !NEWS.test(mark.text) };
}

/** Printed texts and events of agents, collected from the timeline, which has only the newest part. */
export class Printed {
  lines: readonly PrintedLine[] = [];
  private latest = -1;

  clear(): void {
    this.lines = [];
    this.latest = -1;
  }

  /** Adds new entries, and removes those of a future that was left by going back. Returns the texts printed since the last call. */
  note(timeline: Timeline | undefined, lastTick: number): PrintedLine[] {
    const told = (timeline?.timeline ?? []).flatMap((track) => track.marks.map((mark) => lineOf(track.agent, mark))).filter((one) => one !== null);
    const known = new Set(this.lines.map((one) => `${one.tick}/${one.agent}/${one.text}`)), fresh = told.filter((one) => !known.has(`${one.tick}/${one.agent}/${one.text}`) && one.tick <= lastTick);
    const kept = this.lines.filter((one) => one.tick <= lastTick);
    if (fresh.length === 0 && kept.length === this.lines.length) return [];
    this.lines = [...kept, ...fresh].sort((a, b) => a.tick - b.tick).slice(-MOST_LINES);
    const since = fresh.filter((one) => one.isPrinted && one.tick > this.latest);
    this.latest = Math.max(-1, ...this.lines.map((one) => one.tick));
    return since;
  }
}
