// SPDX-License-Identifier: BSD-2-Clause
import { SocketSource } from "../run/socket_source";
import type { ChangedFiles } from "./address";
import type { RunSource } from "../run/source";
import type { UserFolders } from "../local/user_folders";

/** The name of the place of a page without a server. */
export const LOCAL_PLACE = "local";

/** The server's description of a place (docs/serve_protocol.md). */
export interface PlaceInfo {
  place: string;
  learner: string;
  opens: string;
  lessons: readonly { name: string; title: string; course?: string; is_passed: boolean }[];
  scenarios: readonly { name: string; about: string }[];
  files: readonly { path: string; bytes: number }[];
  /** `when`: seconds since 1970; `world`: empty if the file cannot be read. */
  recordings: readonly { name: string; bytes: number; when: number; world?: string; seconds?: number }[];
  kept_days: number;
  has_run: boolean;
}
export interface ClassInfo {
  lessons: readonly { name: string; title: string; course?: string }[];
  learners: readonly Learner[];
  /** Scores for a learning platform, if the class is a course of one. */
  scores?: ScoreInfo;
}
export interface ScoreInfo {
  sent: number;
  waiting: number;
  refused: number;
  /** The reason why a score waits or was refused. */
  trouble: string;
}
export interface Learner {
  name: string;
  place: string;
  place_link: string;
  watch_link: string;
  is_here: boolean;
  doing?: string;
  last_hint?: string;
  /** "works", "mistake", "stuck" or "idle"; its duration and cause. */
  standing?: string;
  trouble?: string;
  lasts_s?: number;
  /** Seconds since the hand was raised; null: it is not raised. */
  hand_s?: number | null;
  notes?: readonly { text: string; file: string; line: number; when: number; is_read: boolean }[];
  done: Readonly<Record<string, { is_done: boolean; tries?: number; hints?: number; passed?: number; of?: number }>>;
}

/** A message of the teacher; `line`: 0 if it is about no line. */
export interface TeacherNote { id: number; text: string; file: string; line: number; when: number }

/** The games in which learners' rules compete. */
export interface ArenaInfo { games: readonly GameInfo[] }
export interface GameInfo {
  name: string;
  title: string;
  seconds: number;
  entries: readonly { learner: string; file: string; when: number }[];
  mine: { learner: string; file: string; when: number } | null;
  tournament: Tournament | null;
}
export interface Tournament {
  is_playing: boolean;
  played: number;
  seeds: number;
  ladder: readonly { learner: string; points: number; won: number; drawn: number; lost: number; scored: number; conceded: number }[];
  matches: readonly { learners: readonly [string, string]; seed: number; scores: readonly [number, number] | null; trouble: string; replay: string | null }[];
}

/** The server's answer to a refused request. */
export class Refused extends Error {
  constructor(message: string, readonly hint: string, readonly status: number) {
    super(message);
  }
}

const TOKEN_KEY = "soarbox.token";

/** Removes the token from the address, so that it is not seen or copied, and keeps it while the page is open. */
export function takeToken(location: Location, history: History, storage: Storage): string {
  const fragment = new URLSearchParams(location.hash.slice(1)), given = fragment.get("token");
  if (given !== null) {
    storage.setItem(TOKEN_KEY, given);
    fragment.delete("token");
    const rest = fragment.toString();
    history.replaceState(null, "", location.pathname + location.search + (rest === "" ? "" : `#${rest}`));
  }
  return storage.getItem(TOKEN_KEY) ?? "";
}

export class Api {
  /** Folders of the user's disk, in a page without a server. */
  readonly folders: UserFolders | null = null;

  constructor(private readonly token: string) {}

  async json<T>(path: string, options: RequestInit = {}): Promise<T> {
    return (await (await this.fetch(path, options)).json()) as T;
  }

  async fetch(path: string, options: RequestInit = {}): Promise<Response> {
    const headers = new Headers(options.headers);
    if (this.token !== "") headers.set("Authorization", `Bearer ${this.token}`);
    let response: Response;
    try {
      response = await fetch(path, { ...options, headers, cache: "no-store" });
    } catch {
      throw new Refused("The server cannot be reached.", "Look whether it still runs, and load the page again.", 0);
    }
    if (response.ok) return response;
    let told: { error?: string; hint?: string } = {};
    try {
      told = (await response.json()) as typeof told;
    } catch {
      // The answer of a proxy may not be JSON.
    }
    throw new Refused(told.error ?? `The server answered with ${response.status}.`, told.hint ?? "", response.status);
  }

  /** Downloads the contents of a path as a file. */
  async download(path: string, name: string): Promise<void> {
    const blob = await (await this.fetch(path)).blob(), url = URL.createObjectURL(blob), link = document.createElement("a");
    link.href = url;
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  }

  /** The source of a place's run: `path` is the path of its WebSocket. */
  source(path: string): RunSource {
    return new SocketSource(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}${path}`, this.token);
  }

  /** Whether there is a server. Without one, this browser has one place, which links cannot refer to. */
  get hasServer(): boolean {
    return true;
  }

  /** The files of a lesson or world that the user has changed; null: a server does not report them. */
  async changedFiles(_what: string): Promise<ChangedFiles | null> {
    return null;
  }

  /** The address of the page, without the fragment. */
  get pageAddress(): string {
    return `${location.origin}/`;
  }

  get hasToken(): boolean {
    return this.token !== "";
  }
}
