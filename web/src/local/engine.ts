// SPDX-License-Identifier: BSD-2-Clause
import type { FromWorker, ToWorker } from "./messages";

/** The part of the engine's module (src/app/worker) that is used. */
export interface EngineModule {
  _soarbox_open(what: number): number;
  _soarbox_step(): number;
  _soarbox_take(text: number): void;
  _soarbox_answer(method: number, path: number, body: number, length: number): number;
  _malloc(bytes: number): number;
  _free(address: number): void;
  stringToNewUTF8(text: string): number;
  UTF8ToString(address: number): string;
  HEAPU8: Uint8Array;
  FS: {
    readFile(path: string): Uint8Array;
    filesystems: { IDBFS?: unknown };
    mount(type: unknown, options: object, path: string): void;
    syncfs(fromBrowser: boolean, done: (error: unknown) => void): void;
  };
}
export type MakeEngine = (settings: {
  soarboxFrame(kind: string, bytes: Uint8Array): void;
  print(line: string): void;
  printErr(line: string): void;
  /** Where a file of the engine is; not needed if it is beside the program. */
  locateFile?(name: string): string;
}) => Promise<EngineModule>;

/** How the engine's loop waits; tests give their own. */
export interface Clock {
  later(call: () => void, ms: number): () => void;
}

/** Changed files are kept this long after the request that may have changed them. */
const KEPT_AFTER_MS = 1000;
/** Recordings grow all the time; what they hold is kept this often. */
const KEPT_EVERY_MS = 60_000;
/** Requests that change no file. */
const CHANGES_NOTHING = new Set(["look", "flow", "overlays", "scene", "input", "language", "presence", "select"]);

/** Runs the engine in a worker, or in Node.js: messages in, messages out. Nothing in it waits. */
export class EngineWorker {
  private module: EngineModule | null = null;
  private stopWaiting: (() => void) | null = null;
  private stopKeeping: (() => void) | null = null;
  private isRunning = false;
  private isKept = false;
  private isKeeping = false;
  private words: string[] = [];
  private what = "";

  constructor(private readonly makeEngine: () => Promise<MakeEngine>, private readonly say: (message: FromWorker) => void, private readonly clock: Clock) {}

  async take(message: ToWorker): Promise<void> {
    if (message.kind === "begin") return this.begin(message.keep);
    if (this.module === null) return;
    switch (message.kind) {
      case "open":
        return this.guarded(() => this.open(message.what, message.id));
      case "request":
        return this.guarded(() => this.request(message.text));
      case "answer":
        return this.guarded(() => this.answer(message.call, message.method, message.path, message.body));
      case "keep":
        return this.keep();
    }
  }

  private async begin(keep: boolean): Promise<void> {
    try {
      const make = await this.makeEngine();
      this.module = await make({
        soarboxFrame: (kind, bytes) => {
          // The engine does not know by what name it was asked for.
          if (kind === "h") this.say({ kind: "begun", what: this.what });
          this.say({ kind: "frame", frame: kind, bytes });
        },
        print: () => undefined,
        printErr: (line) => {
          this.words = [...this.words.slice(-40), line];
        },
      });
      this.isKept = keep && (await this.findKept());
      this.say({ kind: "ready" });
    } catch (error) {
      this.say({ kind: "failed", text: String(error) });
    }
  }

  /** Reads what the browser has kept of the place; false if it keeps nothing, as in a private window. */
  private async findKept(): Promise<boolean> {
    const { FS } = this.engine;
    try {
      FS.mount(FS.filesystems.IDBFS, {}, "/place");
      await new Promise<void>((done, failed) => FS.syncfs(true, (error) => (error ? failed(error) : done())));
      return true;
    } catch {
      return false;
    }
  }

  private get engine(): EngineModule {
    if (this.module === null) throw new Error("there is no engine");
    return this.module;
  }

  private withText<T>(text: string, call: (address: number) => T): T {
    const address = this.engine.stringToNewUTF8(text);
    try {
      return call(address);
    } finally {
      this.engine._free(address);
    }
  }

  private textAt(address: number): string {
    const text = this.engine.UTF8ToString(address);
    this.engine._free(address);
    return text;
  }

  /** A fault of the engine ends it: the page starts another worker. */
  private guarded(call: () => void): void {
    try {
      call();
    } catch (error) {
      this.module = null;
      this.stopWaiting?.();
      this.say({ kind: "failed", text: String(error) });
    }
  }

  private open(what: string, id?: number): void {
    const before = this.what;
    this.words = [];
    this.what = what;
    const told = this.withText(what, (address) => this.engine._soarbox_open(address));
    if (told !== 0) {
      const { error, hint } = JSON.parse(this.textAt(told)) as { error: string; hint: string };
      if (error !== "") this.what = before;
      if (error !== "") return this.say({ kind: "refused", error, hint, ...(id === undefined ? {} : { id }) });
      return this.end();
    }
    this.isRunning = true;
    this.keepSoon();
    this.step();
  }

  private request(text: string): void {
    if (!this.isRunning) return;
    this.withText(text, (address) => this.engine._soarbox_take(address));
    if (!CHANGES_NOTHING.has((JSON.parse(text) as { request?: string }).request ?? "")) this.keepSoon();
    this.step();
  }

  private step(): void {
    this.stopWaiting?.();
    this.stopWaiting = null;
    const wait = this.engine._soarbox_step();
    if (wait < 0) return this.end();
    this.stopWaiting = this.clock.later(() => this.guarded(() => this.step()), wait);
  }

  private end(): void {
    this.isRunning = false;
    const line = this.words.filter((one) => one.includes("error: ")).at(-1);
    this.say({ kind: "ended", text: line === undefined ? "The run has ended." : line.slice(line.indexOf("error: ") + 7) });
    this.keepSoon();
  }

  private answer(call: number, method: string, path: string, body: Uint8Array): void {
    const address = this.engine._malloc(body.length + 1);
    this.engine.HEAPU8.set(body, address);
    const told = JSON.parse(this.textAt(this.withText(method, (name) => this.withText(path, (place) => this.engine._soarbox_answer(name, place, address, body.length))))) as { status: number; type: string; file: string };
    this.engine._free(address);
    const bytes = told.file === "" ? new Uint8Array() : this.engine.FS.readFile(told.file);
    this.say({ kind: "answer", call, status: told.status, type: told.type, bytes });
    if (method !== "GET") this.keepSoon();
  }

  private keepSoon(): void {
    if (!this.isKept) return;
    this.stopKeeping?.();
    this.stopKeeping = this.clock.later(() => this.keep(), KEPT_AFTER_MS);
  }

  private keep(): void {
    if (!this.isKept || this.isKeeping || this.module === null) return;
    this.stopKeeping?.();
    this.isKeeping = true;
    this.engine.FS.syncfs(false, () => {
      this.isKeeping = false;
      if (this.isRunning && this.stopKeeping === null) this.stopKeeping = this.clock.later(() => this.keep(), KEPT_EVERY_MS);
    });
    this.stopKeeping = null;
  }
}
