// SPDX-License-Identifier: BSD-2-Clause
import type { TeacherNote } from "../app/api";
import { isFull, SceneReader, unpack } from "../format/scene_reader";
import type { Scene } from "../format/scene";
import type { ContentName, Contents } from "./contents";
import { browserStore, KeptText } from "./kept_text";
import { Printed, type PrintedLine } from "./printed";
import type { Connection, Flow, Hello, Request, RunMessage, RunSource } from "./source";

export interface Remark { text: string; hint: string; isError: boolean }

/** Callbacks for views of a run. Each may be left out. */
export interface RunEvents {
  hello: Hello;
  flow: Flow;
  contents: readonly ContentName[];
  scene: Scene;
  remark: Remark;
  state: RunState;
  connection: { state: Connection; retryAt: number };
  language: unknown;
  printed: readonly PrintedLine[];
  /** Another tab has started to edit texts, or this one edits again. */
  tabs: boolean;
  /** The learner's hand or the teacher's messages have changed. */
  class: ClassNews;
}
/** The class data of a learner: whether their hand is up, and unread messages. */
export interface ClassNews { is_hand_up: boolean; notes: readonly TeacherNote[] }
export type RunState = "joining" | "running" | "busy" | "ended" | "none";

type Handlers = { [K in keyof RunEvents]: Set<(event: RunEvents[K]) => void> };

/** The run that is shown: its current contents, and requests to it. */
export class Run {
  hello: Hello | null = null;
  flow: Flow = { paused: false, speed: 1, tick: 0, time_s: 0 };
  contents: Contents = {};
  scene: Scene | null = null;
  state: RunState = "joining";
  connection: Connection = "connecting";
  retryAt = 0;
  endedText = "";
  canOpenAgain = true;
  /** What agents printed in this run. */
  readonly printed = new Printed();
  /** Whether this tab may change texts: one tab of a place at a time. */
  mayType = true;
  readonly kept: KeptText;

  private readonly handlers: Handlers = {
    hello: new Set(), flow: new Set(), contents: new Set(), scene: new Set(), remark: new Set(), state: new Set(),
    connection: new Set(), language: new Set(), printed: new Set(), tabs: new Set(), class: new Set(),
  };
  private reader = new SceneReader();
  /** Blocks are unpacked one after another, so that they stay in order. */
  private queue: Promise<void> = Promise.resolve();
  private waiting = 0;
  private looked: string[] = [];
  private overlays: string[] = [];
  private opened: string | null = null;

  /** `place` distinguishes texts typed in different places. */
  constructor(private readonly source: RunSource, place = "") {
    this.kept = new KeptText(place, place === "" ? null : browserStore());
  }

  /** Lets this tab change texts; the others can read them. */
  takeOver(): void {
    this.ask("take-over");
  }

  start(): void {
    this.source.start({
      message: (message) => this.take(message),
      block: (bytes) => this.takeBlock(bytes),
      connection: (state, retryAt) => {
        this.connection = state;
        this.retryAt = retryAt ?? 0;
        if (state === "open") this.greet();
        this.tell("connection", { state, retryAt: this.retryAt });
      },
    });
  }

  close(): void {
    this.source.close();
  }

  retry(): void {
    this.source.retry();
  }

  on<K extends keyof RunEvents>(event: K, call: (event: RunEvents[K]) => void): () => void {
    this.handlers[event].add(call);
    return () => this.handlers[event].delete(call);
  }

  /** Shows a message to the user. */
  remark(text: string, hint: string, isError = true): void {
    this.tell("remark", { text, hint, isError });
  }

  /** Sends a request; shows a message if there is no connection. */
  ask(request: string, fields: Readonly<Record<string, unknown>> = {}): boolean {
    if (this.isWatching) {
      this.tell("remark", { text: "You watch this run: only the learner whose run it is can do this.", hint: "", isError: false });
      return false;
    }
    const sent = this.source.send({ request, ...fields } as Request);
    if (!sent) this.tell("remark", { text: "The server cannot be reached now. Try again when the page is connected.", hint: "", isError: true });
    return sent;
  }

  /** Somebody else's run, which this page cannot change. */
  get isWatching(): boolean {
    return this.hello?.may_edit === false;
  }

  /** "lesson:NAME", "scenario:NAME" or "recording:NAME". */
  open(what: string): void {
    this.opened = what;
    this.canOpenAgain = true;
    this.setState("joining");
    if (this.connection === "open") this.ask("open", { what });
  }

  /** The visible panels; sent again whenever a run begins. */
  look(panels: readonly string[]): void {
    const sorted = [...new Set(panels)].sort();
    if (sorted.join() === this.looked.join()) return;
    this.looked = sorted;
    if (this.hello !== null && this.connection === "open") this.source.send({ request: "look", panels: this.looked });
  }

  wantOverlays(on: readonly string[]): void {
    if (on.join() === this.overlays.join()) return;
    this.overlays = [...on];
    if (this.hello?.may_edit === true && this.connection === "open") this.source.send({ request: "overlays", on: this.overlays });
  }

  private greet(): void {
    if (this.opened !== null && this.hello === null) this.source.send({ request: "open", what: this.opened });
  }

  private take(message: RunMessage): void {
    switch (message.message) {
      case "hello":
        this.forget();
        this.hello = message;
        this.opened = null;
        this.setState("running");
        this.tell("hello", message);
        this.source.send({ request: "look", panels: this.looked });
        if (message.may_edit && this.overlays.length > 0) this.source.send({ request: "overlays", on: this.overlays });
        break;
      case "flow":
        this.flow = message;
        this.tell("flow", message);
        break;
      case "contents": {
        const names = Object.keys(message.contents) as ContentName[];
        this.contents = { ...this.contents, ...message.contents };
        if (names.includes("timeline")) this.notePrinted();
        this.tell("contents", names);
        break;
      }
      case "told":
        this.tell("remark", { text: message.text, hint: "", isError: false });
        break;
      case "error":
        // The request to open something was refused: the current run continues.
        if (this.opened !== null) {
          this.opened = null;
          this.setState(this.hello === null ? "none" : "running");
        }
        this.tell("remark", { text: message.error, hint: message.hint ?? "", isError: true });
        break;
      case "busy":
        if (this.state === "running") this.setState("busy");
        break;
      case "ready":
        if (this.state === "busy") this.setState("running");
        break;
      case "ended":
        this.endedText = message.text;
        this.canOpenAgain = message.can_open_again;
        this.setState("ended");
        break;
      case "none":
        if (this.opened !== null) break;
        this.forget();
        this.setState("none");
        break;
      case "tabs":
        if (this.mayType === message.may_type) break;
        this.mayType = message.may_type;
        this.tell("tabs", this.mayType);
        break;
      case "class":
        this.tell("class", message);
        break;
      case "language":
        this.tell("language", message.content);
        break;
      default:
        break;
    }
  }

  private notePrinted(): void {
    const fresh = this.printed.note(this.contents.timeline, Math.max(this.contents.moment?.time.last_tick ?? 0, this.flow.tick));
    if (fresh.length > 0) this.tell("printed", fresh);
  }

  /** Drops all data of the previous run. */
  private forget(): void {
    this.hello = null;
    this.contents = {};
    this.printed.clear();
    this.scene = null;
    this.endedText = "";
    this.reader = new SceneReader();
    this.flow = { paused: false, speed: 1, tick: 0, time_s: 0 };
  }

  private setState(state: RunState): void {
    if (this.state === state) return;
    this.state = state;
    this.tell("state", state);
  }

  private takeBlock(bytes: Uint8Array): void {
    const reader = this.reader;
    this.waiting += 1;
    this.queue = this.queue.then(async () => {
      this.waiting -= 1;
      if (reader !== this.reader) return;
      try {
        const scene = reader.read(await unpack(bytes), isFull(bytes));
        if (scene === null || reader !== this.reader) return;
        this.scene = scene;
        this.tell("scene", scene);
      } catch (error) {
        this.tell("remark", { text: error instanceof Error ? error.message : String(error), hint: "", isError: true });
      }
    });
  }

  private tell<K extends keyof RunEvents>(event: K, value: RunEvents[K]): void {
    for (const call of [...this.handlers[event]]) call(value);
  }
}
