// SPDX-License-Identifier: BSD-2-Clause
import type { ChangedFiles } from "../app/address";

/** The source of the engine for a worker: the address of a folder, or the contents of its files. */
export type EngineFiles = string | { wasm: ArrayBuffer; data: ArrayBuffer };
/** An engine that one worker has loaded, for another one. */
export interface LoadedEngine { module: WebAssembly.Module; data: ArrayBuffer }
/** A file of the place by its path, "/place/home/...". */
export interface KeptFile { path: string; bytes: Uint8Array }

/** The lesson or world of a link, and the files in the link. */
export interface Experiment { what: string; files: Readonly<Record<string, string>> }

/** Requests to a run that change no file. */
export const CHANGES_NOTHING: ReadonlySet<string> = new Set(["look", "flow", "overlays", "scene", "input", "language", "presence", "select"]);

/** Messages from the page to the worker that runs its engine. */
export type ToWorker =
  // With an experiment, the place contains only the experiment's files. `keep`: stored files are read. `mayStore`: changed files are
  // stored; without it, another tab stores them.
  | { kind: "begin"; engine: EngineFiles; keep: boolean; mayStore: boolean; experiment?: Experiment }
  | { kind: "open"; what: string; id?: number }
  | { kind: "request"; text: string }
  // `was`: if the file of the path has another text than this (null: if it exists), the answer is 409 and nothing is changed.
  | { kind: "answer"; call: number; method: string; path: string; body: Uint8Array; was?: Uint8Array | null }
  // With `call`, `kept` answers when all changes until now are stored.
  | { kind: "keep"; call?: number }
  | { kind: "changes"; call: number; what: string }
  // All files below a folder of the place, such as "/place/home/worlds/NAME".
  | { kind: "files"; call: number; folder: string }
  // Writes and removes files of the place, and answers `written`. The engine does not check them, and its run does not read them.
  | { kind: "write"; call: number; files: readonly KeptFile[]; removed: readonly string[] }
  // The only message to a worker that only grades; it answers with `graded`.
  | { kind: "grade-here"; engine: LoadedEngine; lesson: string; from: string; files: readonly KeptFile[] }
  /** The new output of that worker; `files`: its changed files, when it is done. */
  | { kind: "graded"; text: string; isOver: boolean; files: readonly KeptFile[] };

/** Messages from the worker. `frame` is a letter of the frames between engine and server (docs/serve_protocol.md). */
export type FromWorker =
  | { kind: "ready"; isKept: boolean }
  | { kind: "failed"; text: string }
  | { kind: "frame"; frame: string; bytes: Uint8Array }
  | { kind: "begun"; what: string }
  | { kind: "refused"; error: string; hint: string; id?: number }
  | { kind: "ended"; text: string }
  | { kind: "changes"; call: number; changes: ChangedFiles }
  | { kind: "files"; call: number; files: readonly KeptFile[] }
  | { kind: "written"; call: number }
  // The browser has stored the files, or could not (`error`). Without `call` it answers no request, and is sent only if storing begins or ceases to fail.
  | { kind: "kept"; error: string; call?: number }
  | { kind: "answer"; call: number; status: number; type: string; bytes: Uint8Array }
  | { kind: "grade"; engine: LoadedEngine; lesson: string; from: string; files: readonly KeptFile[] }
  | { kind: "stop-grading" }
  | { kind: "graded"; text: string; isOver: boolean; files: readonly KeptFile[] };
