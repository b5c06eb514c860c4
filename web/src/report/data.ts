// SPDX-License-Identifier: BSD-2-Clause

/** What `soarbox report` puts into a page (src/report): one or more runs, or a sweep. */
export type Report = RunReport | SweepReport;

interface Head {
  title: string;
  verdict: string;
  /** The command that shows the run. */
  command: string;
  build: string;
  /** The origin of the runs: files, program, machine. Runs of earlier versions have none. */
  manifest?: Readonly<Record<string, unknown>>;
  passed?: boolean | null;
}

/** The data of one agent. Series contain differences: centimetres, points of health, and tenths of metres per second. */
export interface AgentReport {
  name: string;
  team: string;
  distance: number;
  health: number;
  alive: boolean;
  rounds: number;
  damage: number;
  /** The index of the time at which its series begin. */
  from?: number;
  x?: readonly number[];
  z?: readonly number[];
  hp?: readonly number[];
  v?: readonly number[];
  rules: readonly { name: string; firings: number; type: string; file?: string; stops?: string }[];
}
export interface CheckReport { name: string; state: string; mark: "passed" | "failed" | "moment" | "over seeds"; time: number; time_text: string; text: string; reasons: readonly string[] }
export interface MomentReport { time: number; time_text: string; agent: string; text: string; reasons: readonly string[] }
export interface PlaceReport { name: string; x: number; z: number; r: number; hx: number; hz: number }
export interface ThingReport { x: number; z: number; w: number; d: number; turn: number; round: boolean }
export interface EventReport { t: number; a: string; k: string; text: string }
/** Agent's index, from, to, name. */
export type SpanReport = readonly [number, number, number, string];

export interface RunReport extends Head {
  kind: "run";
  /** Whether a second simulation reached the recorded state. */
  same: boolean;
  scenario: string;
  seed: number;
  seconds: number;
  things: readonly ThingReport[];
  warnings: readonly string[];
  times: readonly number[];
  agents: readonly AgentReport[];
  spans: readonly SpanReport[];
  events: readonly EventReport[];
  /** What was left out, in sentences. */
  thinned: readonly string[];
  checks: readonly CheckReport[];
  moments: readonly MomentReport[];
  waypoints: readonly PlaceReport[];
  regions: readonly PlaceReport[];
  files: readonly { name: string; text: string }[];
}

export interface Statistics { mean: number; low: number; high: number; median: number; sd: number; values: readonly number[] }
export interface Metric {
  name: string;
  /** Of each variant; without values it has no numbers. */
  variants: readonly (Partial<Statistics> & { values: readonly number[] })[];
  /** From the first variant, on equal seeds. Without `d`: all differences are equal. */
  differences: readonly (Statistics & { variant: string; pairs: number; probability: number; holm: number; d?: number; delta: number })[];
}
export interface Standing { agent: string; rating: number; low: number; high: number; games: number; won: number; drawn: number; lost: number; place: number; points: number }
export type Cell = string | number | boolean;

export interface SweepReport extends Head {
  kind: "sweep";
  standings?: readonly Standing[];
  variants: readonly { name: string; runs: number; broken: number; judged: number; passed: number; low: number; high: number; checks: readonly { true: number; of: number; low: number; high: number }[] }[];
  check_names: readonly string[];
  metrics: readonly Metric[];
  outliers: readonly { variant: string; seed: number; what: string; value: number; median: number; command: string }[];
  columns: readonly string[];
  rows: readonly (readonly Cell[])[];
  failed: readonly { variant: string; seed: number; outcome: string; error: string }[];
}

/** Position, health and speed of an agent, at the times from index `from` on. */
export interface Way { from: number; x: readonly number[]; z: readonly number[]; health: readonly number[]; speed: readonly number[] }

function summed(differences: readonly number[] | undefined, of: number): number[] {
  let sum = 0;
  return (differences ?? []).map((difference) => (sum += difference) / of);
}

/** Metres, points and metres per second; null for agents without a body. */
export function wayOf(agent: AgentReport): Way | null {
  if (agent.x === undefined || agent.x.length === 0) return null;
  return { from: agent.from ?? 0, x: summed(agent.x, 100), z: summed(agent.z, 100), health: summed(agent.hp, 1), speed: summed(agent.v, 10) };
}

/** The index of the last time that is not after `seconds`. */
export function indexAt(times: readonly number[], seconds: number): number {
  let low = 0, high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle]! <= seconds + 1e-6) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The position at a time, interpolated between two moments. */
export function positionAt(way: Way, times: readonly number[], seconds: number): { x: number; z: number; isAlive: boolean } {
  const last = way.x.length - 1, at = Math.max(0, Math.min(last, indexAt(times, seconds) - way.from)), next = Math.min(last, at + 1);
  const before = times[at + way.from] ?? 0, after = times[next + way.from] ?? 0, share = after > before ? Math.min(1, Math.max(0, (seconds - before) / (after - before))) : 0;
  const between = (of: readonly number[]): number => of[at]! + share * (of[next]! - of[at]!);
  return { x: between(way.x), z: between(way.z), isAlive: (way.health[at] ?? 1) > 0 };
}
