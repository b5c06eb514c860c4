// SPDX-License-Identifier: BSD-2-Clause
import type { Listener, Request, RunMessage, RunSource } from "../run/source";
import { readMessage } from "../run/socket_source";
import type { ChangedFiles } from "../app/address";
import { Api, Refused } from "../app/api";
import { CHANGES_NOTHING, type EngineFiles, type Experiment, type FromWorker, type KeptFile, type ToWorker } from "./messages";
import type { UserFolders } from "./user_folders";

const BUSY_AFTER_MS = 200, HANGS_AFTER_MS = 60_000;
const NOT_LOADED = "The engine of this page cannot be loaded.";
const CRASHED = "The run has crashed. What was saved is kept.";
const ANOTHER_TAB = "Another tab shows your files already. What you change in this tab is not kept: close one of the two, and reload the other.";
const STORED_AGAIN = "The browser keeps your files again.";
const NOT_KEPT = "This browser keeps nothing for this page. Download your folder before you close it.";
const STORE_HINT = "Download your folder before you close this page. If the disk is full, make room.";
const notStored = (error: string): string => `The browser cannot keep your files: ${error}.`;

/** The parts of a Worker that are used; tests give their own. */
export interface Port {
  postMessage(message: ToWorker): void;
  onmessage: ((event: { data: FromWorker }) => void) | null;
  onerror: ((event: { message?: string }) => void) | null;
  terminate(): void;
}

/** A run in a worker of this page, with the place for its files. It replaces a server and its engine. */
export class LocalPlace implements RunSource {
  private port: Port | null = null;
  private listener: Listener | null = null;
  private what = "";
  private hasRun = false;
  private readonly waiting = new Map<number, { resolve: (response: Response) => void; reject: (error: unknown) => void }>();
  private readonly waitingForChanges = new Map<number, { resolve: (changes: ChangedFiles) => void; reject: (error: unknown) => void }>();
  private readonly waitingForFiles = new Map<number, { resolve: (files: readonly KeptFile[]) => void; reject: (error: unknown) => void }>();
  private readonly waitingForWrites = new Map<number, { resolve: (error: string) => void; reject: (error: unknown) => void }>();
  /** The number of workers until now. Each one begins with the files that the browser has stored. */
  private starts = 0;
  /** Called after a request that may have changed files of the place. */
  mayHaveChanged: () => void = () => undefined;
  private nextCall = 1;
  private isReady = false;
  private early: ToWorker[] = [];
  private busyTimer: ReturnType<typeof setTimeout> | null = null;
  private hangTimer: ReturnType<typeof setTimeout> | null = null;
  private isBusy = false;
  /** Another worker, while it grades. */
  private grader: Port | null = null;
  private isKept = true;

  /**
   * With an experiment, the place has only its files, and nothing is kept. `isOnly`: no other tab has this place, so this one may
   * store changed files.
   */
  constructor(private readonly makePort: () => Port, private readonly engine: EngineFiles, private readonly keep = true, private readonly experiment?: Experiment, readonly isOnly = true) {}

  start(listener: Listener): void {
    this.listener = listener;
    listener.connection("connecting");
    this.connect();
  }

  send(request: Request): boolean {
    if (request.request === "open") {
      this.post({ kind: "open", what: String(request["what"] ?? ""), ...(request.id === undefined ? {} : { id: request.id }) });
      this.awaitAnswer();
    } else if (request.request !== "take-over" && this.hasRun) {
      this.post({ kind: "request", text: JSON.stringify(request) });
      this.awaitAnswer();
      if (!CHANGES_NOTHING.has(request.request)) this.mayHaveChanged();
    }
    return true;
  }

  retry(): void {
    this.connect();
  }

  close(): void {
    this.stopGrading();
    this.noLongerBusy();
    this.port?.terminate();
    this.port = null;
    this.listener?.connection("closed");
  }

  /** The page is closed or hidden: saves changes now. */
  keepNow(): void {
    if (this.isReady) this.post({ kind: "keep" });
  }

  /** Answers requests to a server about a place: `path` begins after "/api/p/ID". */
  async answer(method: string, path: string, body: Uint8Array): Promise<Response> {
    return this.ask({ method, path, body }, true);
  }

  /** Writes a file of the user, or removes it (null), without a call of mayHaveChanged(). The answer is 409 if its text is no longer `was`. */
  async replace(path: string, bytes: Uint8Array | null, was: Uint8Array | null): Promise<Response> {
    return this.ask({ method: bytes === null ? "DELETE" : "PUT", path: `files/${path}`, body: bytes ?? new Uint8Array(), was }, false);
  }

  private async ask(what: { method: string; path: string; body: Uint8Array; was?: Uint8Array | null }, isReported: boolean): Promise<Response> {
    const call = this.nextCall++;
    return new Promise((resolve, reject) => {
      this.waiting.set(call, { resolve, reject });
      this.post({ kind: "answer", call, ...what });
      if (what.method !== "GET" && isReported) this.mayHaveChanged();
    });
  }

  /** All files below a folder of the place. */
  async files(folder: string): Promise<readonly KeptFile[]> {
    const call = this.nextCall++;
    return new Promise((resolve, reject) => {
      this.waitingForFiles.set(call, { resolve, reject });
      this.post({ kind: "files", call, folder });
    });
  }

  /** A number that differs after the engine has crashed: then the place has the files that the browser had stored. */
  get startCount(): number {
    return this.starts;
  }

  /**
   * Writes and removes files of the place that no run reads. `start`: the value of startCount when the caller read the place; files
   * for an earlier one are not written.
   */
  async write(files: readonly KeptFile[], removed: readonly string[], start: number): Promise<void> {
    if (start !== this.starts || this.port === null) throw new Refused(CRASHED, "", 500);
    const call = this.nextCall++;
    await new Promise<string>((resolve, reject) => {
      this.waitingForWrites.set(call, { resolve, reject });
      this.post({ kind: "write", call, files, removed });
    });
  }

  /** Stores all changes until now. Throws if the browser cannot. */
  async store(): Promise<void> {
    const call = this.nextCall++;
    const error = await new Promise<string>((resolve, reject) => {
      this.waitingForWrites.set(call, { resolve, reject });
      this.post({ kind: "keep", call });
    });
    if (error !== "") throw new Refused(notStored(error), STORE_HINT, 507);
  }

  /** The files of a lesson or world that differ from the program's. */
  async changes(what: string): Promise<ChangedFiles> {
    const call = this.nextCall++;
    return new Promise((resolve, reject) => {
      this.waitingForChanges.set(call, { resolve, reject });
      this.post({ kind: "changes", call, what });
    });
  }

  private connect(): void {
    if (this.port !== null) {
      if (this.isReady) this.open();
      return;
    }
    const port = this.makePort();
    this.port = port;
    ++this.starts;
    this.isReady = false;
    port.onmessage = ({ data }) => this.take(data);
    port.onerror = ({ message }) => this.crashed(message ?? CRASHED);
    port.postMessage({ kind: "begin", engine: this.engine, keep: this.keep && this.experiment === undefined, mayStore: this.isOnly, ...(this.experiment === undefined ? {} : { experiment: this.experiment }) });
  }

  private post(message: ToWorker): void {
    if (this.port === null) this.connect();
    if (this.isReady) this.port?.postMessage(message);
    else this.early.push(message);
  }

  private open(): void {
    this.listener?.connection("open");
    this.listener?.message({ message: "tabs", may_type: true });
    if (!this.hasRun) this.listener?.message({ message: "none" });
    if (!this.isKept || !this.isOnly) this.listener?.message({ message: "told", text: this.isOnly ? NOT_KEPT : ANOTHER_TAB });
  }

  private take(message: FromWorker): void {
    switch (message.kind) {
      case "ready": {
        this.isReady = true;
        this.isKept = message.isKept;
        if (this.listener !== null) this.open();
        const early = this.early;
        this.early = [];
        for (const one of early) this.post(one);
        return;
      }
      case "frame":
        return this.takeFrame(message.frame, message.bytes);
      case "begun":
        this.what = message.what;
        this.hasRun = true;
        return;
      case "refused":
        this.noLongerBusy();
        this.listener?.message({ message: "error", error: message.error, hint: message.hint, ...(message.id === undefined ? {} : { id: message.id }) });
        return;
      case "ended":
        this.hasRun = false;
        this.noLongerBusy();
        this.listener?.message({ message: "ended", text: message.text, can_open_again: true });
        return;
      case "failed":
        return this.crashed(message.text);
      case "answer":
        return this.answered(message.call, message.status, message.type, message.bytes);
      case "changes":
        this.waitingForChanges.get(message.call)?.resolve(message.changes);
        this.waitingForChanges.delete(message.call);
        return;
      case "files":
        this.waitingForFiles.get(message.call)?.resolve(message.files);
        this.waitingForFiles.delete(message.call);
        return;
      case "written":
        return this.wasWritten(message.call, "");
      case "kept":
        if (message.call !== undefined) return this.wasWritten(message.call, message.error);
        this.listener?.message({ message: "told", text: message.error === "" ? STORED_AGAIN : `${notStored(message.error)} ${STORE_HINT}` });
        return;
      case "grade":
        return this.grade({ ...message, kind: "grade-here" });
      case "stop-grading":
        return this.stopGrading();
      case "graded":
        return;  // Only workers that grade send this.
    }
  }

  private takeFrame(frame: string, bytes: Uint8Array): void {
    this.noLongerBusy();
    if (frame === "s" || frame === "f") {
      this.listener?.block(bytes);
      return;
    }
    if (frame === "b" || frame === "d") return;
    let text = new TextDecoder().decode(bytes);
    if (frame === "c") {
      const end = text.indexOf("\0");
      text = `{"message":"contents","contents":{${JSON.stringify(text.slice(0, end))}:${text.slice(end + 1)}}}`;
    }
    const message = readMessage(text);
    if (message !== null) this.listener?.message(frame === "h" ? ({ ...message, what: this.what } as RunMessage) : message);
  }

  private answered(call: number, status: number, type: string, bytes: Uint8Array): void {
    const waiting = this.waiting.get(call);
    this.waiting.delete(call);
    waiting?.resolve(new Response(bytes as BodyInit, { status, headers: { "Content-Type": type } }));
  }

  private wasWritten(call: number, error: string): void {
    this.waitingForWrites.get(call)?.resolve(error);
    this.waitingForWrites.delete(call);
  }

  /** Grades in a separate worker, so that the run continues and grading can be cancelled. */
  private grade(message: ToWorker): void {
    this.stopGrading();
    const grader = this.makePort();
    this.grader = grader;
    const failed = (text: string): void => {
      this.stopGrading();
      this.port?.postMessage({ kind: "graded", text: `Grading has crashed: ${text}\n`, isOver: true, files: [] });
    };
    grader.onmessage = ({ data }) => {
      if (grader !== this.grader) return;
      if (data.kind === "failed") failed(data.text);
      if (data.kind !== "graded") return;
      this.port?.postMessage(data);
      if (data.isOver) this.stopGrading();
    };
    grader.onerror = ({ message: text }) => failed(text ?? "");
    grader.postMessage(message);
  }

  private stopGrading(): void {
    this.grader?.terminate();
    this.grader = null;
  }

  /** The worker is unusable: the next request starts another one. */
  private crashed(text: string): void {
    const what = this.isReady ? CRASHED : NOT_LOADED;
    this.stopGrading();
    this.port?.terminate();
    this.port = null;
    this.hasRun = false;
    this.early = [];
    this.noLongerBusy();
    for (const { reject } of [...this.waiting.values(), ...this.waitingForChanges.values(), ...this.waitingForFiles.values(), ...this.waitingForWrites.values()]) reject(new Refused(what, text, 500));
    this.waiting.clear();
    this.waitingForChanges.clear();
    this.waitingForFiles.clear();
    this.waitingForWrites.clear();
    this.listener?.message({ message: "ended", text: `${what} (${text})`, can_open_again: true });
  }

  private awaitAnswer(): void {
    this.busyTimer ??= setTimeout(() => {
      this.isBusy = true;
      this.listener?.message({ message: "busy" });
    }, BUSY_AFTER_MS);
    this.hangTimer ??= setTimeout(() => this.crashed(`it has not answered for ${HANGS_AFTER_MS / 1000} s, and was ended`), HANGS_AFTER_MS);
  }

  private noLongerBusy(): void {
    if (this.busyTimer !== null) clearTimeout(this.busyTimer);
    if (this.hangTimer !== null) clearTimeout(this.hangTimer);
    this.busyTimer = this.hangTimer = null;
    if (this.isBusy) this.listener?.message({ message: "ready" });
    this.isBusy = false;
  }
}

const BEFORE = /^\/api\/p\/[^/]+\/?/;

/** Answers a page's requests to its server from the place in the worker. */
export class LocalApi extends Api {
  /** `folders`: folders of the user's disk; null: this browser or place has none. */
  constructor(private readonly place: LocalPlace, override readonly folders: UserFolders | null = null) {
    super("");
  }

  override source(): RunSource {
    return this.place;
  }

  override get hasServer(): boolean {
    return false;
  }

  override async changedFiles(what: string): Promise<ChangedFiles | null> {
    return this.place.changes(what);
  }

  /** The address of the page, which may be a file. */
  override get pageAddress(): string {
    return location.href.replace(/#.*$/, "");
  }

  override async fetch(path: string, options: RequestInit = {}): Promise<Response> {
    const body = options.body === undefined || options.body === null ? new Uint8Array() : new Uint8Array(await new Response(options.body).arrayBuffer());
    const response = await this.place.answer(options.method ?? "GET", decodeURIComponent(path.replace(BEFORE, "")), body);
    if (response.ok) return response;
    const told = (await response.json()) as { error?: string; hint?: string };
    throw new Refused(told.error ?? `The answer was ${response.status}.`, told.hint ?? "", response.status);
  }
}
