// SPDX-License-Identifier: BSD-2-Clause

/** The contents of panels, as docs/workbench.md and docs/inspect.md have them. What the page does not show is left out. */

export interface Time {
  first_tick: number;
  shown_tick: number;
  last_tick: number;
  step_s: number;
  is_recording: boolean;
  is_live: boolean;
  can_go_back: boolean;
  can_resume: boolean;
  resume_refusal: string;
  branch_tick: number | null;
  branches: number;
}
export interface Moment { agent: string; has_mind: boolean; time: Time; not_available: string; past_note: string; not_recorded: string }

export interface AgentRow {
  name: string;
  kind: string;
  team: string;
  script: string;
  mind: boolean;
  alive: boolean;
  failed: boolean;
  health: number;
  state: string;
  operator: string;
  last_operator: string;
  command: string;
  decisions: number;
  errors: number;
  error?: string;
  file?: string;
  line?: number;
}
export interface Agents { agents: readonly AgentRow[]; activities: Readonly<Record<string, string>> }

export interface StackLevel { level: number; state: string; impasse: string; operator: string; name: string }
export interface Stack {
  note?: string;
  decisions: number;
  phase: string;
  halted: boolean;
  breakdown?: string;
  elaborations: number;
  firings: number;
  elements: number;
  rules: number;
  states: readonly StackLevel[];
}
export interface Element { timetag: number; id: string; attribute: string; value: string; acceptable?: boolean; object?: boolean }
export interface Maker { kind: "rule" | "input" | "architecture"; rule?: string; support?: "o" | "i"; level?: number; elements?: readonly Element[] }
export interface Preference { type: string; sign: string; referent?: string; maker: Maker }
export interface OperatorRow {
  id: string;
  name: string;
  about?: string;
  selected: boolean;
  verdict: string;
  value?: number;
  probability?: number;
  preferences: readonly Preference[];
}
export interface Operators { state: string; selected: string; impasse: string; why: string; note?: string; operators: readonly OperatorRow[] }
/** What an agent's script shows of its state (Agent.Show). */
export interface ShownRow { depth: number; name: string; value: string; active: boolean; since: number }
export interface Mind { stack: Stack; operators: Operators; shown?: { agent: string; rows: readonly ShownRow[] } }

export interface MemoryRow extends Element { about?: string; change?: "added" | "removed"; elements?: readonly MemoryRow[] }
export interface MemoryObject { id: string; about: string; exists: boolean; note?: string; elements: readonly MemoryRow[] }
export interface ElementStory extends Element {
  note?: string;
  made_by: readonly Maker[];
  tested_by: readonly { rule: string; condition: number; negated: boolean; matches: boolean }[];
}
export interface Memory { stack: Stack; objects: Readonly<Record<string, MemoryObject>>; element: ElementStory | null; found: readonly Element[] }

export interface RuleRow { name: string; type: string; file?: string; line?: number; documentation?: string; firings: number; matches: number; break?: boolean }
export interface Token { kind: string; text: string }
export interface RuleView extends RuleRow {
  source: string;
  tokens: readonly Token[];
  match: string;
  complete: boolean;
  failing?: number;
  conditions: readonly { text: string; negated: boolean; partial_matches: number }[];
  matches_now: readonly (readonly Element[])[];
  seen: readonly Element[];
}
export interface Coverage {
  rule: string;
  firings: number;
  matched: boolean;
  first_tick?: number;
  last_tick?: number;
  held?: number;
  conditions?: number;
  stops_at?: string;
}
export interface Rules {
  rules: readonly RuleRow[];
  rule: RuleView | null;
  rule_text: string;
  rule_file: string;
  rule_line: number;
  coverage: readonly Coverage[];
}

/** `time`: the moment that it is about, in seconds, if that is another one than now. */
export interface WhyNode { text: string; kind: string; link?: string; time?: number; below?: readonly WhyNode[] }
export interface Why { question: string; answer: WhyNode | null }

export interface Command { command: string; id?: string; timetag: number; parameters: string; status: string; reason?: string; progress?: number }
export interface Links { io: { input: MemoryObject; output: MemoryObject; commands: readonly Command[] } }

export interface Message { tick: number; time_s: number; from: string; to: string; about: string; text: string }
export interface Messages { messages: readonly Message[] }

export interface Span { kind: "state" | "operator"; level: number; id: string; text: string; first_tick: number; last_tick: number; open: boolean }
export interface Mark { tick: number; kind: string; text: string }
export interface Track { agent: string; spans: readonly Span[]; marks: readonly Mark[] }
export interface Timeline { timeline: readonly Track[] | null }

export interface TraceLine { tick: number; time_s: number; kind: string; level?: number; agent: string; text: string }
export interface Trace { lines: readonly TraceLine[] }

export interface Series { agent: string; what: string; minimum: number; maximum: number; points: readonly (readonly [number, number])[] }
export interface Plots { plots: readonly Series[]; plottable: readonly string[] }

export interface ConsoleLine { tick: number; kind: "input" | "output" | "error" | "hint"; text: string }
export interface Console {
  lines: readonly ConsoleLine[];
  completed_line: string;
  completion: { begin: number; words: readonly string[]; common: string };
  begun_line: string;
}

export interface Problem { severity: "note" | "warning" | "error"; file?: string; line?: number; column?: number; message: string; excerpt?: string; hint?: string; more?: number }
export interface OpenFile { file: string; is_changed: boolean; is_unsaved: boolean; failure: string }
export interface EditText {
  file: string;
  is_rules: boolean;
  version: number;
  text: string;
  problems: readonly Problem[];
  notice: string;
  is_changed: boolean;
  is_unsaved: boolean;
  go_to_line: number;
  go_to_count: number;
}
export interface Edit { files: readonly { agent: string; file: string; is_rules: boolean }[]; open_files: readonly OpenFile[]; edit: EditText }

export interface Breakpoints {
  breakpoints: readonly { number: number; kind: string; agent: string; what: string; enabled: boolean; hits: number }[];
  hits: readonly { number: number; agent: string; tick: number; why: string }[];
}
export interface Futures {
  futures: null | {
    branch_tick: number;
    now_tick: number;
    old_is_known: boolean;
    first_tick: number;
    last_tick: number;
    percepts: string | readonly string[];
    course: readonly {
      time_s: number; mean_distance_m: number; greatest_distance_m: number; farthest: string;
      health_old: number; health_new: number; alive_old: number; alive_new: number;
    }[];
  };
}
export interface Problems { problems: readonly (Problem & { agent: string; tick: number; time_s: number; cause: string })[] }
export interface Watch {
  agents: readonly string[];
  rows: readonly { what: string; cells: readonly { agent: string; text: string; is_new: boolean; is_error: boolean; tick: number }[] }[];
}
export interface Minds { minds: readonly { agent: string; note: string; stack: Stack; operators: Operators; command: string }[] }

export interface Check { name: string; expected: string; was: string; agent: string; is_marker: boolean; state: string; tick: number; time_s: number }
export interface Lesson {
  name: string;
  title: string;
  idea: string;
  task: string;
  panel: string;
  new_panels: readonly string[];
  hints: readonly string[];
  hint_count: number;
  is_passed: boolean;
  is_graded: boolean;
  grade: readonly string[];
  next: string;
}
export interface LessonOffer { name: string; title: string; is_passed: boolean }
export interface Mission { checks: readonly Check[]; lesson: Lesson | null; lessons: readonly LessonOffer[] }

export interface LongTerm {
  long_term: {
    semantic: boolean; episodic: boolean; objects: number; augmentations: number; episodes: number;
    known: readonly { number: number; activation: number; uses: number; text: string }[];
    note?: string;
  };
  known_search: string;
  episode: { episode: number; elements: readonly string[]; things: readonly { name: string; kind: string; x: number; z: number }[] };
  recalls: readonly { tick: number; level: number; memory: string; number: number; question: string; answer: string; reason: string }[];
}
export interface Learning {
  learning: {
    by_reward: boolean; last_reward: number; total_reward: number;
    numbers: readonly { rule: string; value: number; current: number; future: number; updates: number }[];
    rules: readonly { rule: string; firings: number; tick?: number; source?: string; purpose?: string; excised?: boolean }[];
    note?: string;
  };
  episodes: readonly { first_tick: number; last_tick: number; reward: number }[];
  rule: { rule: string; why: WhyNode; fired: readonly number[]; note?: string };
}
export interface ForeignEntity { id: string; agent: string; marking: string; team: string; body: string; type: string; silent_s: number }
/** The exercise of other simulations that the run takes part in. */
export interface Exercise {
  exercise: null | {
    number: number; address: string; this_machine_only: boolean; as: string; listens_only: boolean; takes_orders: boolean; is_frozen: boolean;
    sent: number; sent_per_s: number; not_sent: number; received: number; received_per_s: number;
    dropped: readonly { why: string; count: number }[];
    entity_count: number;
    entities: readonly ForeignEntity[];
  };
}
export interface SceneNode { name: string; parent: string; depth: number; shape: string; at: readonly number[]; tags: Readonly<Record<string, string>> }
export interface SceneLine { from: readonly [number, number, number]; to: readonly [number, number, number]; is_crossed: boolean }
export interface SceneAnswer { record: string; value: string; why: WhyNode; nodes: readonly string[]; lines: readonly SceneLine[] }
export interface SceneQuestion {
  id: string; command: string; rule: string; filter: string; status: string; problem?: string; hint?: string;
  count: number;
  values: readonly SceneAnswer[];
}
/** What the selected agent imagines. */
export interface Imagery {
  imagery: { note: string; scenes: readonly { state: string; nodes: readonly SceneNode[]; extracts: readonly SceneQuestion[] }[] };
  state: string;
  record: string;
}
/** A node of what it imagines as it is drawn: numbers of points count from 0. */
export interface ImaginedShape {
  name: string; state: string; kind: "made-up" | "sensed" | "remembered";
  points: readonly number[]; edges: readonly number[]; faces: readonly number[];
}
export interface Ghosts {
  shapes: readonly ImaginedShape[];
  answer: { text: string; lines: readonly SceneLine[] };
  ghosts: readonly {
    name: string; agent_id: number; kind: string; team: string; position: readonly [number, number, number];
    forward: readonly [number, number, number]; radius_m: number; height_m: number;
  }[];
}

/** All contents by name; what did not come yet is missing. */
export interface Contents {
  moment?: Moment;
  agents?: Agents;
  mind?: Mind;
  memory?: Memory;
  rules?: Rules;
  why?: Why;
  links?: Links;
  messages?: Messages;
  timeline?: Timeline;
  trace?: Trace;
  plots?: Plots;
  console?: Console;
  edit?: Edit;
  breakpoints?: Breakpoints;
  futures?: Futures;
  problems?: Problems;
  watch?: Watch;
  minds?: Minds;
  mission?: Mission;
  longterm?: LongTerm;
  learning?: Learning;
  exercise?: Exercise;
  imagery?: Imagery;
  ghosts?: Ghosts;
}
export type ContentName = keyof Contents;
