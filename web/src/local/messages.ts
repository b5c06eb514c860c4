// SPDX-License-Identifier: BSD-2-Clause

/** What the page says to the worker that runs its engine. */
export type ToWorker =
  | { kind: "begin"; engine: string; keep: boolean }
  | { kind: "open"; what: string; id?: number }
  | { kind: "request"; text: string }
  | { kind: "answer"; call: number; method: string; path: string; body: Uint8Array }
  | { kind: "keep" };

/** What the worker says: `frame` is a letter of the frames between engine and server (docs/serve.md). */
export type FromWorker =
  | { kind: "ready" }
  | { kind: "failed"; text: string }
  | { kind: "frame"; frame: string; bytes: Uint8Array }
  | { kind: "begun"; what: string }
  | { kind: "refused"; error: string; hint: string; id?: number }
  | { kind: "ended"; text: string }
  | { kind: "answer"; call: number; status: number; type: string; bytes: Uint8Array };
