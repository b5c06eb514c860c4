// SPDX-License-Identifier: BSD-2-Clause
import type { Document } from "../document/document";

/** The contents of panels, as docs/workbench.md describes them. Panels with a document have nothing else. */

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
  /** The tick at which the user last changed rules of the running world. */
  changed_tick?: number | null;
}
export interface Moment { agent: string; has_mind: boolean; time: Time; not_available: string; past_note: string; not_recorded: string }

export interface Span { kind: "state" | "operator"; level: number; id: string; text: string; first_tick: number; last_tick: number; open: boolean }
export interface Mark { tick: number; kind: string; text: string }
export interface Track { agent: string; spans: readonly Span[]; marks: readonly Mark[] }
export interface Timeline { timeline: readonly Track[] | null }

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
  /** It is a script that can stop at lines: at these lines, and it is stopped at this one (0: it is not). */
  can_stop?: boolean;
  stops?: readonly number[];
  stop_conditions?: readonly string[];
  stopped_line?: number;
}
/** The script that is stopped in the middle of a tick. */
export interface StoppedScript { script: string; reason: string; error: string; file?: string; line?: number; count: number }
export interface Edit { files: readonly { agent: string; file: string; is_rules: boolean }[]; open_files: readonly OpenFile[]; edit: EditText; stopped?: StoppedScript | null }

export interface Check { name: string; expected: string; was: string; agent: string; is_marker: boolean; state: string; tick: number; time_s: number }
export interface Lesson {
  name: string;
  title: string;
  panel: string;
  is_graded: boolean;
}
export interface LessonOffer { name: string; title: string; is_passed: boolean }
export interface Mission extends DocumentContent { checks: readonly Check[]; lesson: Lesson | null; lessons: readonly LessonOffer[] }

/** The agent's imagined scenes in a report: the lines with which answers are drawn. */
export interface Imagery {
  imagery: { scenes: readonly { extracts: readonly { values: readonly { record: string; value: string; lines: readonly SceneLine[] }[] }[] }[] };
}
export interface SceneLine { from: readonly [number, number, number]; to: readonly [number, number, number]; is_crossed: boolean }
/** A node of an imagined scene, as it is drawn. Edges and faces contain indices of points, from 0. */
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

/** The contents of a panel that is described by a document, and the number on its tab. */
export interface DocumentContent { document?: Document; badge?: string }

/** All contents by name. Those that have not arrived yet are missing. */
export interface Contents extends Partial<Record<DocumentName, DocumentContent>> {
  moment?: Moment;
  timeline?: Timeline;
  edit?: Edit;
  mission?: Mission;
  ghosts?: Ghosts;
}
type DocumentName = "agents" | "mind" | "memory" | "rules" | "why" | "links" | "messages" | "plots" | "trace" | "breakpoints" | "futures" | "watch" | "minds" |
  "longterm" | "learning" | "exercise" | "imagery" | "script" | "problems" | "console";
export type ContentName = keyof Contents;
