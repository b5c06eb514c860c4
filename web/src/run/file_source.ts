// SPDX-License-Identifier: BSD-2-Clause
import type { Span } from "../document/document";
import type { ContentName, Contents, DocumentContent, Ghosts, Imagery, Moment } from "./contents";
import type { Listener, Request, RunSource } from "./source";

/** A recorded run as `soarbox report` puts it into a page (app/scene_report.cpp). */
export interface RecordedRun {
  scenario: string;
  seed: number;
  agents: readonly string[];
  minds: readonly string[];
  step_s: number;
  turn_ticks?: number;
  first_tick: number;
  last_tick: number;
  /** In the order of ticks; the first is full. */
  scene: readonly { tick: number; full: boolean; block: string }[];
  /** In base 64, deflated: RecordedContent[]. */
  contents: string;
}
/** The contents of panels from this tick on, of one agent or of all (""). */
interface RecordedContent { tick: number; agent: string; name: ContentName; content: unknown }

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 8, 16] as const;
const FRAME_MS = 50;
/** Contents that also cover the time before their moment. */
const OF_A_WHILE: ReadonlySet<string> = new Set(["timeline", "trace"]);

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** The index of the last entry whose tick is not after `tick`; 0 if all are. */
export function lastUntil(entries: readonly { tick: number }[], tick: number): number {
  let low = 0, high = entries.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (entries[middle]!.tick <= tick) low = middle;
    else high = middle;
  }
  return low;
}

/** Shows a recorded run that is contained in the page: no server, no network. */
export class FileSource implements RunSource {
  private listener: Listener | null = null;
  private tick: number;
  /** The index of the block that was shown last; -1: none. */
  private block = -1;
  private agent: string;
  private paused = true;
  private speed = 1;
  private timer: ReturnType<typeof setInterval> | null = null;
  private contents: RecordedContent[] = [];
  /** The record of the selected answer about the imagined scene; "": none. */
  private record = "";
  private readonly told = new Map<string, unknown>();
  private readonly whiles = new Map<string, number>();
  /** The last complete trace, and its part up to the current moment. */
  private traced: { whole: DocumentContent; count: number; past: DocumentContent } | null = null;

  constructor(private readonly run: RecordedRun) {
    this.tick = run.first_tick;
    this.agent = run.minds[0] ?? run.agents[0] ?? "";
  }

  start(listener: Listener): void {
    this.listener = listener;
    const { scenario, seed, agents, minds, step_s, turn_ticks = 1 } = this.run;
    listener.connection("open");
    listener.message({ message: "hello", version: "", what: `recording:${scenario}`, title: scenario, scenario, seed, agents, minds, step_s, turn_ticks, may_edit: true, is_recording: true, only_shows: true });
    this.show();
    void this.unpackContents().then(() => this.show());
  }

  private async unpackContents(): Promise<void> {
    const plain = new Blob([bytesOf(this.run.contents)]).stream().pipeThrough(new DecompressionStream("deflate"));
    this.contents = JSON.parse(await new Response(plain).text()) as RecordedContent[];
  }

  send(request: Request): boolean {
    switch (request.request) {
      case "seek":
        this.moveTo(Number(request["tick"]));
        break;
      case "select":
        this.agent = String(request["agent"]);
        this.show();
        break;
      case "flow":
        this.obey(String(request["what"]));
        break;
      case "look": case "overlays": case "scene":
        break;
      case "ask":
        this.show();
        break;
      case "imagine":
        this.record = String(request["record"] ?? "");
        if (String(request["state"] ?? "") !== "") this.listener?.message({ message: "told", text: "This page contains only what the agent made up. A run, or its recording, can draw whole scenes." });
        this.show();
        break;
      default:
        this.listener?.message({ message: "told", text: "This page contains a recording: you can only look at it." });
    }
    return true;
  }

  retry(): void {}

  close(): void {
    this.pause(true);
    this.listener = null;
  }

  private obey(what: string): void {
    const { first_tick, last_tick } = this.run, at = SPEEDS.findIndex((speed) => speed >= this.speed);
    if (what === "go-on") {
      if (this.tick >= last_tick) this.moveTo(first_tick);
      this.pause(false);
    } else if (what === "pause") this.pause(true);
    else if (what === "step-tick" || what === "step-turn") {
      this.pause(true);
      const turn = what === "step-turn" ? (this.run.turn_ticks ?? 1) : 1, nextBlock = this.run.scene[lastUntil(this.run.scene, this.tick) + 1];
      this.moveTo(turn > 1 ? (Math.floor(this.tick / turn) + 1) * turn : (nextBlock ?? { tick: last_tick }).tick);
    } else if (what === "begin-again") this.moveTo(first_tick);
    else if (what === "faster") this.speed = SPEEDS[Math.min(at + 1, SPEEDS.length - 1)]!;
    else if (what === "slower") this.speed = SPEEDS[Math.max(at - 1, 0)]!;
    else this.listener?.message({ message: "told", text: "Only a run can do this; this is a recording of one." });
    this.tellFlow();
  }

  private pause(on: boolean): void {
    if (this.paused === on) return;
    this.paused = on;
    if (this.timer !== null) clearInterval(this.timer);
    this.timer = null;
    if (on) return;
    let last = performance.now(), exact = this.tick;
    this.timer = setInterval(() => {
      const now = performance.now();
      exact = Math.max(exact, this.tick) + ((now - last) / 1000) * (this.speed / this.run.step_s);
      last = now;
      if (Math.abs(exact - this.tick) > 10 / this.run.step_s) exact = this.tick;
      this.moveTo(Math.floor(exact));
      if (this.tick < this.run.last_tick) return;
      this.pause(true);
      this.tellFlow();
    }, FRAME_MS);
  }

  private moveTo(tick: number): void {
    this.tick = Math.min(Math.max(Math.round(tick), this.run.first_tick), this.run.last_tick);
    this.show();
  }

  private tellFlow(): void {
    this.listener?.message({ message: "flow", paused: this.paused, speed: this.speed, tick: this.tick, time_s: this.tick * this.run.step_s });
  }

  private show(): void {
    if (this.listener === null) return;
    this.showScene();
    this.tellFlow();
    this.tellContents();
  }

  /** Blocks contain differences. Decoding begins at the preceding full block, or continues from the current one. */
  private showScene(): void {
    const { scene } = this.run, wanted = lastUntil(scene, this.tick);
    if (wanted === this.block || scene.length === 0) return;
    let from = wanted;
    while (from > 0 && !scene[from]!.full) from -= 1;
    if (this.block >= from && this.block < wanted) from = this.block + 1;
    for (let i = from; i <= wanted; i += 1) this.listener?.block(bytesOf(scene[i]!.block));
    this.block = wanted;
  }

  /** The part of a trace up to a moment; the same object as long as it contains the same lines. */
  private pastOf(whole: DocumentContent): DocumentContent {
    const past = (whole.document ?? []).filter((node) => node.is !== "form").map((node) => node.is !== "table" ? node : { ...node, rows: node.rows.filter((row) => {
      const cell = row.c[0], spans = typeof cell === "object" && "s" in cell ? cell.s : cell, tick = Array.isArray(spans) ? (spans[0] as Span)[0] : undefined;
      return typeof tick !== "number" || tick <= this.tick;
    }) });
    const count = past.reduce((sum, node) => sum + (node.is === "table" ? node.rows.length : 0), 0), known = this.traced;
    if (known === null || known.whole !== whole || known.count !== count) this.traced = { whole, count, past: { document: past } };
    return this.traced!.past;
  }

  private showAnswer(now: Record<string, unknown>, { imagery }: Imagery, ghosts: Ghosts | undefined): void {
    const answers = imagery.scenes.flatMap((scene) => scene.extracts.flatMap((one) => one.values)), shown = answers.find((one) => one.record === this.record);
    now["ghosts"] = { ghosts: [], shapes: [], ...ghosts, answer: { text: shown?.value ?? "", lines: shown?.lines ?? [] } } satisfies Ghosts;
  }

  private tellContents(): void {
    const { first_tick, last_tick, step_s, turn_ticks = 1, minds } = this.run;
    const moment: Moment = {
      agent: this.agent, has_mind: minds.includes(this.agent), not_available: "", past_note: "", not_recorded: "",
      time: { first_tick, shown_tick: this.tick, last_tick, step_s, turn_ticks, is_recording: true, is_live: false, can_go_back: true, can_resume: false, resume_refusal: "", branch_tick: null, changed_tick: null, branches: 0 },
    };
    const now: Record<string, unknown> = { moment };
    for (const each of this.contents) {
      // Contents that cover an interval are stored at its end, so the next entry after this moment contains most of it.
      const isEnough = each.name in now && (OF_A_WHILE.has(each.name) ? this.whiles.get(each.name)! > this.tick : each.tick > this.tick);
      if (isEnough || (each.agent !== "" && each.agent !== this.agent)) continue;
      now[each.name] = each.content;
      this.whiles.set(each.name, each.tick);
    }
    if ("imagery" in now && (this.record !== "" || this.told.has("ghosts"))) this.showAnswer(now, now["imagery"] as Imagery, now["ghosts"] as Ghosts | undefined);
    if ("trace" in now) now["trace"] = this.pastOf(now["trace"] as DocumentContent);
    const changed: Record<string, unknown> = {};
    for (const [name, content] of Object.entries(now)) {
      if (name !== "moment" && this.told.get(name) === content) continue;
      this.told.set(name, content);
      changed[name] = content;
    }
    this.listener?.message({ message: "contents", contents: changed as Contents });
  }
}
