// SPDX-License-Identifier: BSD-2-Clause
import type { TeacherNote } from "../app/api";
import type { Contents } from "./contents";

/** Events of a run, for its views. */
export type RunMessage =
  | ({ message: "hello" } & Hello)
  | ({ message: "flow" } & Flow)
  | { message: "contents"; contents: Contents }
  | { message: "told"; text: string }
  | { message: "error"; id?: number; error: string; hint?: string }
  | { message: "busy" }
  | { message: "ready" }
  | { message: "ended"; text: string; can_open_again: boolean }
  | { message: "none" }
  | { message: "tabs"; may_type: boolean }
  | { message: "class"; is_hand_up: boolean; notes: readonly TeacherNote[] }
  | { message: "language"; content: unknown };

export interface Hello {
  version: string;
  what: string;
  title?: string;
  lesson?: string;
  scenario: string;
  seed: number;
  agents: readonly string[];
  minds: readonly string[];
  step_s: number;
  /** Ticks of a turn, in a game. */
  turn_ticks?: number;
  may_edit: boolean;
  is_recording: boolean;
  /** Read-only: its moments can be viewed, and nothing can be changed. */
  only_shows?: boolean;
  /** The run takes part in an exercise with other simulations. */
  has_exercise?: boolean;
}
/** `stopped`: a script is stopped in the middle of a tick. */
export interface Flow { paused: boolean; speed: number | "unlimited"; tick: number; time_s: number; stopped?: boolean }

/** A request of a page: an object with its name and fields (docs/workbench.md and docs/serve_protocol.md). */
export type Request = { readonly request: string; readonly id?: number } & Readonly<Record<string, unknown>>;

export type Connection = "connecting" | "open" | "lost" | "closed";

export interface Listener {
  message(message: RunMessage): void;
  block(bytes: Uint8Array): void;
  connection(state: Connection, retryAt?: number): void;
}

/** The source of a run: a server, a file, or an engine in the page. */
export interface RunSource {
  start(listener: Listener): void;
  /** Returns false if it cannot be sent now. It is not sent later. */
  send(request: Request): boolean;
  /** Connects again at once, if it waits for the next attempt. */
  retry(): void;
  close(): void;
}
