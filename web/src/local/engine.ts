// SPDX-License-Identifier: BSD-2-Clause
import { areEqual, changedFiles, filesBelow, writeExperiment, writeFiles } from "./experiment";
import { CHANGES_NOTHING, type EngineFiles, type FromWorker, type KeptFile, type LoadedEngine, type ToWorker } from "./messages";

/** The part of the engine's module (src/app/worker) that is used. */
export interface EngineModule {
  _soarbox_open(what: number): number;
  _soarbox_step(): number;
  _soarbox_take(text: number): void;
  _soarbox_answer(method: number, path: number, body: number, length: number): number;
  _soarbox_grade(lesson: number, from: number): number;
  _soarbox_graded(text: number, isOver: number): void;
  _malloc(bytes: number): number;
  _free(address: number): void;
  stringToNewUTF8(text: string): number;
  UTF8ToString(address: number): string;
  HEAPU8: Uint8Array;
  FS: {
    readFile(path: string): Uint8Array;
    writeFile(path: string, bytes: Uint8Array): void;
    unlink(path: string): void;
    readdir(path: string): string[];
    stat(path: string): { mode: number };
    isDir(mode: number): boolean;
    mkdirTree(path: string): void;
    analyzePath(path: string): { exists: boolean };
    filesystems: { IDBFS?: unknown };
    mount(type: unknown, options: object, path: string): void;
    syncfs(fromBrowser: boolean, done: (error: unknown) => void): void;
  };
}
export interface EngineSettings {
  soarboxFrame?(kind: string, bytes: Uint8Array): void;
  soarboxGrade?(lesson: string, from: string): void;
  soarboxStopGrading?(): void;
  print(line: string): void;
  printErr(line: string): void;
}
export type MakeEngine = (settings: EngineSettings) => Promise<EngineModule>;

/** The environment of an engine; tests replace it. */
export interface Surroundings {
  /** Loads the engine; `loaded` is for another worker, or null if grading is done in this one. */
  load(engine: EngineFiles | LoadedEngine): Promise<{ make: MakeEngine; loaded: LoadedEngine | null }>;
  say(message: FromWorker): void;
  /** Schedules a call; the returned function cancels it. */
  later(call: () => void, ms: number): () => void;
}

/** Changed files are stored in the browser this long after the request that may have changed them. */
const KEPT_AFTER_MS = 1000;
/** They are stored after this time at the latest, also if requests follow each other faster. */
const KEPT_WITHIN_MS = 5000;
/** Interval between saves of a growing recording. */
const KEPT_EVERY_MS = 60_000;
const ENDED = "The run has ended.";
/** The files that grading uses, and the file that records passed lessons. */
const PLACE = "/place", HOME = "/place/home", PROGRESS = "/place/state/soarbox/learn";

function withTexts<T>(engine: EngineModule, texts: readonly string[], call: (addresses: number[]) => T): T {
  const addresses = texts.map((text) => engine.stringToNewUTF8(text));
  try {
    return call(addresses);
  } finally {
    for (const address of addresses) engine._free(address);
  }
}

/** Runs the engine in a worker or in Node.js. It receives and sends messages, and never blocks. */
export class EngineWorker {
  private module: EngineModule | null = null;
  private stopWaiting: (() => void) | null = null;
  private stopKeeping: (() => void) | null = null;
  private isRunning = false;
  private isKept = false;
  private stopLatest: (() => void) | null = null;
  private isKeeping = false;
  /** Another change came while files were being stored. */
  private mustKeepAgain = false;
  /** Calls that `kept` will answer: of the current save, and of the next one. */
  private callsNow: number[] = [];
  private callsNext: number[] = [];
  private keepError = "";
  private reason = ENDED;
  private what = "";

  constructor(private readonly around: Surroundings) {}

  async take(message: ToWorker): Promise<void> {
    if (message.kind === "begin") return this.begin(message);
    if (message.kind === "grade-here") return this.gradeHere(message);
    if (this.module === null) return;
    switch (message.kind) {
      case "open":
        return this.guarded(() => this.open(message.what, message.id));
      case "request":
        return this.guarded(() => this.request(message.text));
      case "answer":
        return this.guarded(() => this.isAsExpected(message.path, message.was) ? this.answer(message.call, message.method, message.path, message.body) : this.say({ kind: "answer", call: message.call, status: 409, type: "application/json", bytes: new TextEncoder().encode('{"error":"the file has changed","hint":""}') }));
      case "keep":
        return this.guarded(() => this.keepNow(message.call));
      case "changes":
        return this.guarded(() => this.say({ kind: "changes", call: message.call, changes: changedFiles(this.engine.FS, message.what) }));
      case "files":
        return this.guarded(() => this.say({ kind: "files", call: message.call, files: filesBelow(this.engine.FS, message.folder) }));
      case "write":
        return this.guarded(() => this.write(message.call, message.files, message.removed));
      case "graded":
        return this.guarded(() => this.graded(message.text, message.isOver, message.files));
    }
  }

  private async begin({ engine, keep, mayStore, experiment }: Extract<ToWorker, { kind: "begin" }>): Promise<void> {
    try {
      const { make, loaded } = await this.around.load(engine);
      this.module = await make({
        soarboxFrame: (kind, bytes) => {
          // The engine does not know the name by which the world was opened.
          if (kind === "h") this.say({ kind: "begun", what: this.what });
          if (kind === "e") this.reason = new TextDecoder().decode(bytes);
          else this.say({ kind: "frame", frame: kind, bytes });
        },
        ...(loaded === null ? {} : { soarboxGrade: (lesson, from) => this.say({ kind: "grade", engine: loaded, lesson, from, files: this.filesOfLearner() }), soarboxStopGrading: () => this.say({ kind: "stop-grading" }) }),
        print: () => undefined,
        printErr: () => undefined,
      });
      const isFound = keep && (await this.findKept());
      this.isKept = isFound && mayStore;
      if (experiment !== undefined) writeExperiment(this.module.FS, experiment.what, experiment.files);
      this.say({ kind: "ready", isKept: isFound || !keep });
    } catch (error) {
      this.say({ kind: "failed", text: String(error) });
    }
  }

  /**
   * Reads the stored files of the place; returns false if the browser stores none, for example in a private window.
   */
  private async findKept(): Promise<boolean> {
    const { FS } = this.engine;
    try {
      FS.mount(FS.filesystems.IDBFS, {}, PLACE);
      await new Promise<void>((done, failed) => FS.syncfs(true, (error) => (error ? failed(error) : done())));
      return true;
    } catch {
      return false;
    }
  }

  /** Grades in this worker, which has no other task. */
  private async gradeHere({ engine, lesson, from, files }: Extract<ToWorker, { kind: "grade-here" }>): Promise<void> {
    const print = (line: string): void => this.say({ kind: "graded", text: `${line}\n`, isOver: false, files: [] });
    try {
      const { make } = await this.around.load(engine), module = await make({ print, printErr: print });
      writeFiles(module.FS, files);
      withTexts(module, [lesson, from], ([name, folder]) => module._soarbox_grade(name!, folder!));
      this.say({ kind: "graded", text: "", isOver: true, files: filesBelow(module.FS, PROGRESS) });
    } catch (error) {
      this.say({ kind: "failed", text: String(error) });
    }
  }

  private filesOfLearner(): KeptFile[] {
    const { FS } = this.engine;
    return [...filesBelow(FS, HOME), ...filesBelow(FS, PROGRESS)];
  }

  private graded(text: string, isOver: boolean, files: readonly KeptFile[]): void {
    writeFiles(this.engine.FS, files);
    withTexts(this.engine, [text], ([address]) => this.engine._soarbox_graded(address!, isOver ? 1 : 0));
    if (isOver) this.keepSoon();
  }

  private say(message: FromWorker): void {
    this.around.say(message);
  }

  private get engine(): EngineModule {
    if (this.module === null) throw new Error("there is no engine");
    return this.module;
  }

  private textAt(address: number): string {
    const text = this.engine.UTF8ToString(address);
    this.engine._free(address);
    return text;
  }

  /** A fault ends the engine; the page then starts another worker. */
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
    this.reason = ENDED;
    this.what = what;
    const told = withTexts(this.engine, [what], ([address]) => this.engine._soarbox_open(address!));
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
    withTexts(this.engine, [text], ([address]) => this.engine._soarbox_take(address!));
    if (!CHANGES_NOTHING.has((JSON.parse(text) as { request?: string }).request ?? "")) this.keepSoon();
    this.step();
  }

  private step(): void {
    this.stopWaiting?.();
    this.stopWaiting = null;
    const wait = this.engine._soarbox_step();
    if (wait < 0) return this.end();
    this.stopWaiting = this.around.later(() => this.guarded(() => this.step()), wait);
  }

  private end(): void {
    this.isRunning = false;
    this.say({ kind: "ended", text: this.reason });
    this.keepSoon();
  }

  /** Whether the file of an address "files/PATH" has this text; null: it does not exist. */
  private isAsExpected(address: string, was: Uint8Array | null | undefined): boolean {
    if (was === undefined) return true;
    const { FS } = this.engine, path = `${HOME}/${address.slice("files/".length)}`, exists = FS.analyzePath(path).exists && !FS.isDir(FS.stat(path).mode);
    return exists ? was !== null && areEqual(FS.readFile(path), was) : was === null;
  }

  private answer(call: number, method: string, path: string, body: Uint8Array): void {
    const { engine } = this, address = engine._malloc(body.length + 1);
    engine.HEAPU8.set(body, address);
    const told = JSON.parse(this.textAt(withTexts(engine, [method, path], ([name, place]) => engine._soarbox_answer(name!, place!, address, body.length)))) as { status: number; type: string; file: string };
    engine._free(address);
    const bytes = told.file === "" ? new Uint8Array() : engine.FS.readFile(told.file);
    this.say({ kind: "answer", call, status: told.status, type: told.type, bytes });
    // A request that was refused has changed nothing.
    if (method !== "GET" && told.status < 400) this.keepSoon();
  }

  private write(call: number, files: readonly KeptFile[], removed: readonly string[]): void {
    const { FS } = this.engine;
    for (const path of removed) if (FS.analyzePath(path).exists) FS.unlink(path);
    writeFiles(FS, files);
    this.say({ kind: "written", call });
    this.keepSoon();
  }

  private keepSoon(): void {
    if (!this.isKept) return;
    this.stopKeeping?.();
    this.stopKeeping = this.around.later(() => this.keep(), KEPT_AFTER_MS);
    this.stopLatest ??= this.around.later(() => this.keep(), KEPT_WITHIN_MS);
  }

  private keepNow(call?: number): void {
    if (call !== undefined && !this.isKept) return this.say({ kind: "kept", error: "", call });
    if (call !== undefined) this.callsNext.push(call);
    this.keep();
  }

  private keep(): void {
    if (!this.isKept || this.module === null) return;
    this.stopKeeping?.();
    this.stopLatest?.();
    this.stopKeeping = this.stopLatest = null;
    if (this.isKeeping) {
      this.mustKeepAgain = true;
      return;
    }
    this.isKeeping = true;
    this.callsNow = this.callsNext;
    this.callsNext = [];
    this.engine.FS.syncfs(false, (error) => this.kept(error ? (error as { message?: string }).message || String(error) : ""));
  }

  /** The browser has stored the files, or could not. */
  private kept(error: string): void {
    const calls = this.callsNow, isNew = (error === "") !== (this.keepError === "");
    this.callsNow = [];
    this.isKeeping = false;
    this.keepError = error;
    if (isNew) this.say({ kind: "kept", error });
    for (const call of calls) this.say({ kind: "kept", error, call });
    if (this.mustKeepAgain) {
      this.mustKeepAgain = false;
      this.keep();
    } else if ((this.isRunning || error !== "") && this.stopKeeping === null) {
      this.stopKeeping = this.around.later(() => this.keep(), KEPT_EVERY_MS);
    }
  }
}
