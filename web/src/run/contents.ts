// SPDX-License-Identifier: BSD-2-Clause
// Written by reference_pages from src/workbench/contents_fields.h, contents_json.cpp and src/debugger/fields.h.
import type { Document } from "../document/document";

/** The tick that the picture and the panels show, and the ticks that they can show. */
export interface Time {
  /** the oldest tick that can be shown */
  readonly first_tick: number;
  /** the tick that is shown */
  readonly shown_tick: number;
  /** the newest tick */
  readonly last_tick: number;
  /** length of a tick in seconds */
  readonly step_s: number;
  /** ticks in a turn of a game */
  readonly turn_ticks: number;
  /** whether the run is a recording */
  readonly is_recording: boolean;
  /** whether the newest tick is shown, and new ones are followed */
  readonly is_live: boolean;
  /** whether the run has a history */
  readonly can_go_back: boolean;
  /** whether the run can continue from a past tick */
  readonly can_resume: boolean;
  /** why it cannot; empty if it can */
  readonly resume_refusal: string;
  /** the tick at which the run last left its old future */
  readonly branch_tick: number | null;
  /** how often it went back and continued from there */
  readonly branches: number;
  /** the tick at which the user last changed rules; null: never */
  readonly changed_tick: number | null;
}

/** What an agent did in some ticks. */
export interface Track {
  /** empty: the world */
  readonly agent: string;
  /** in the order in which they began */
  readonly spans: readonly Span[];
  /** in the order of their ticks */
  readonly marks: readonly Mark[];
}

/** The time during which a state exists or an operator is selected. */
export interface Span {
  /** what it is */
  readonly kind: "operator" | "state";
  /** of the goal stack, from 1 */
  readonly level: number;
  /** "O3", "S2" */
  readonly id: string;
  /** the operator's name, or the impasse */
  readonly text: string;
  /** when it began */
  readonly first_tick: number;
  /** when it ended, or the newest tick */
  readonly last_tick: number;
  /** whether it has not ended */
  readonly open: boolean;
}

/** An event in one tick. */
export interface Mark {
  /** when it happened */
  readonly tick: number;
  /** `command`, `outcome`, `message`, `event`, `error`, `edit` or `learned` */
  readonly kind: string;
  /** what happened */
  readonly text: string;
}

/** A file that an agent was made from. */
export interface AgentFile {
  /** empty: the world */
  readonly agent: string;
  /** the file */
  readonly file: string;
  /** whether it has rules; otherwise it is a script */
  readonly is_rules: boolean;
}

/** A file that was opened to be edited. */
export interface OpenFile {
  /** the file */
  readonly file: string;
  /** whether it differs from what runs */
  readonly is_changed: boolean;
  /** whether it differs from the file on the disk */
  readonly is_unsaved: boolean;
  /** why it could not be saved; empty if it could */
  readonly failure: string;
}

/** The file that the editor shows. */
export interface EditText {
  /** empty: none */
  readonly file: string;
  /** whether it has rules; otherwise it is a script */
  readonly is_rules: boolean;
  /** grows when the text comes from elsewhere than the editor */
  readonly version: number;
  /** its text */
  readonly text: string;
  /** of the text that was last checked or applied */
  readonly problems: readonly Problem[];
  /** the result of the last request */
  readonly notice: string;
  /** grows when the run has reloaded the text */
  readonly reload_count: number;
  /** whether it differs from what runs */
  readonly is_changed: boolean;
  /** whether it differs from the file on the disk */
  readonly is_unsaved: boolean;
  /** the line to scroll to; 0: none */
  readonly go_to_line: number;
  /** grows with each request to scroll */
  readonly go_to_count: number;
  /** whether it is a script that can stop at lines */
  readonly can_stop: boolean;
  /** the lines at which it stops */
  readonly stops: readonly number[];
  /** the condition of each of them; empty: always */
  readonly stop_conditions: readonly string[];
  /** the line at which it is stopped; 0: it is not */
  readonly stopped_line: number;
}

/** An error or a warning that the user should correct. */
export interface Problem {
  /** how bad it is */
  readonly severity: "note" | "warning" | "error";
  /** the file that it is in */
  readonly file?: string;
  /** from 1 */
  readonly line?: number;
  /** from 1 */
  readonly column?: number;
  /** what is wrong */
  readonly message: string;
  /** that line of the file */
  readonly excerpt?: string;
  /** what to do */
  readonly hint?: string;
  /** number of further places with the same error */
  readonly more?: number;
}

/** The script that is stopped in the middle of a tick. */
export interface StoppedScript {
  /** the agent that it belongs to; `sandbox` */
  readonly script: string;
  /** `breakpoint`, `step` or `error` */
  readonly reason: string;
  /** the error, or why the condition of the stop has no value */
  readonly error: string;
  /** where it is stopped */
  readonly file?: string;
  /** the line in that file */
  readonly line?: number;
  /** how often a script has stopped so far */
  readonly count: number;
}

/** A check of the run's mission. */
export interface Check {
  /** its name */
  readonly name: string;
  /** "scout should be at gate by 30 s" */
  readonly expected: string;
  /** the value found instead; empty if there is none to report */
  readonly was: string;
  /** the agent whose behaviour decided it; empty if there is none */
  readonly agent: string;
  /** whether it marks a moment instead of being required */
  readonly is_marker: boolean;
  /** `open`, `true`, `false`, `untested` or `undecided` */
  readonly state: string;
  /** when it was decided */
  readonly tick: number;
  /** the same in seconds */
  readonly time_s: number;
}

/** The lesson that the world belongs to. */
export interface Lesson {
  /** the name that opens it */
  readonly name: string;
  /** its title */
  readonly title: string;
  /** what it teaches */
  readonly idea: string;
  /** what to do */
  readonly task: string;
  /** the panel to look at */
  readonly panel: string;
  /** the panels that it is about */
  readonly new_panels: readonly string[];
  /** hints that were asked for */
  readonly hints: readonly string[];
  /** number of all hints */
  readonly hint_count: number;
  /** whether the learner has changed something, or had it graded */
  readonly is_tried: boolean;
  /** whether it is solved */
  readonly is_passed: boolean;
  /** whether it is being graded */
  readonly is_graded: boolean;
  /** the result, line by line */
  readonly grade: readonly string[];
  /** the next lesson; empty if this is the last */
  readonly next: string;
}

/** A lesson that can be opened. */
export interface LessonOffer {
  /** the name that opens it */
  readonly name: string;
  /** its title */
  readonly title: string;
  /** whether it is solved */
  readonly is_passed: boolean;
}

/** The scenes of a mind, from the top state down. */
export interface Scenes {
  /** why there is none; empty if there is one */
  readonly note: string;
  /** one for each state */
  readonly scenes: readonly ImaginedScene[];
}

/** The scene of a state. */
export interface ImaginedScene {
  /** "S1" */
  readonly state: string;
  /** each before its children */
  readonly nodes: readonly SceneNode[];
  /** what rules ask, and the answers */
  readonly extracts: readonly SceneExtract[];
}

/** A node of an imagined scene. */
export interface SceneNode {
  /** its name */
  readonly name: string;
  /** empty for the root */
  readonly parent: string;
  /** number of nodes above it */
  readonly depth: number;
  /** `group`, `hull` or `ball` */
  readonly shape: string;
  /** its origin in the world, in metres */
  readonly at: readonly [number, number, number];
  /** x, y, z, w */
  readonly turn: readonly [number, number, number, number];
  /** in its own coordinates */
  readonly scale: readonly [number, number, number];
  /** of a ball, before scaling */
  readonly radius?: number;
  /** corners of a hull, in its own coordinates */
  readonly points?: readonly (readonly [number, number, number])[];
  /** its tags */
  readonly tags: Readonly<Record<string, string>>;
}

/** A command to a scene, and its answer. */
export interface SceneExtract {
  /** the identifier of the command */
  readonly id: string;
  /** its name */
  readonly command: string;
  /** the rule that gave it */
  readonly rule: string;
  /** empty if it changes the scene */
  readonly filter: string;
  /** of the command */
  readonly status: string;
  /** what is wrong with it */
  readonly problem?: string;
  /** and what to do */
  readonly hint?: string;
  /** number of all values */
  readonly count: number;
  /** the first 40 of them */
  readonly values: readonly SceneValue[];
}

/** A value that an extract found. */
export interface SceneValue {
  /** its identifier in working memory */
  readonly record: string;
  /** as text */
  readonly value: string;
  /** from what it was computed */
  readonly why: Reason;
  /** the nodes that it is about */
  readonly nodes: readonly string[];
  /** lines that show why it is so */
  readonly lines: readonly SceneLine[];
}

/** A step of an answer to why. */
export interface Reason {
  /** a sentence */
  readonly text: string;
  /** what it is about */
  readonly kind: string;
  /** the name of the agent, operator or rule, or the time tag of the element */
  readonly link?: string;
  /** in seconds, of a moment that has passed */
  readonly time?: number;
  /** the steps that it depends on */
  readonly below?: readonly Reason[];
}

/** A line that shows why a value of a scene is what it is. */
export interface SceneLine {
  /** in metres */
  readonly from: readonly [number, number, number];
  /** in metres */
  readonly to: readonly [number, number, number];
  /** whether it is a sight line that an object blocks */
  readonly is_crossed: boolean;
}

/** A world that can be opened. */
export interface ScenarioOffer {
  /** the name or path that opens it */
  readonly name: string;
  /** its description */
  readonly about: string;
}

/** A match of the text that is searched everywhere. */
export interface FoundPlace {
  /** what it is */
  readonly kind: "rule" | "file" | "memory" | "trace" | "message";
  /** the matching line */
  readonly title: string;
  /** where it is: "fighter.soar:12", "0:03.20" */
  readonly detail: string;
  /** the agent that it belongs to */
  readonly agent: string;
  /** the file */
  readonly file: string;
  /** the line in that file */
  readonly line: number;
  /** when it happened */
  readonly tick: number;
  /** the identifier in working memory */
  readonly id: string;
}

/** A figure without a body: an agent in another future, or an object that an agent remembers. */
export interface GhostBody {
  /** the agent, or the object */
  readonly name: string;
  /** the agent whose figure is drawn; 0: none */
  readonly agent_id: number;
  /** of that agent */
  readonly kind: string;
  /** of that agent */
  readonly team: string;
  /** of its centre, in metres */
  readonly position: readonly [number, number, number];
  /** where it looks */
  readonly forward: readonly [number, number, number];
  /** its radius */
  readonly radius_m: number;
  /** its height */
  readonly height_m: number;
}

/** A node of an imagined scene, as it is drawn. */
export interface ImaginedShape {
  /** its name */
  readonly name: string;
  /** the state of its scene */
  readonly state: string;
  /** where it comes from */
  readonly kind: "made-up" | "sensed" | "remembered";
  /** x, y and z of each, in metres of the world */
  readonly points: readonly number[];
  /** two numbers of points each, from 0 */
  readonly edges: readonly number[];
  /** three numbers of points each, from 0 */
  readonly faces: readonly number[];
}

/** What shows the reason of the selected answer. */
export interface AnswerLines {
  /** the answer */
  readonly text: string;
  /** lines in the picture */
  readonly lines: readonly SceneLine[];
}

export interface Moment {
  /** the agent that most contents are about; empty: none is selected */
  readonly agent: string;
  /** whether it has a Soar mind */
  readonly has_mind: boolean;
  /** the tick that is shown */
  readonly time: Time;
  /** why the mind's contents are not shown; empty: they are shown */
  readonly not_available: string;
  /** the progress of simulating a recorded moment again, or why this is impossible */
  readonly past_note: string;
  /** not empty: contents come from a recording, which does not hold the mind's memory */
  readonly not_recorded: string;
}

export interface Timeline {
  /** operators, impasses, commands and events of the last 900 ticks */
  readonly timeline: readonly Track[] | null;
}

export interface Edit {
  /** what the selected agent was made from */
  readonly files: readonly AgentFile[];
  /** files that were opened to be edited */
  readonly open_files: readonly OpenFile[];
  /** the file that is shown */
  readonly edit: EditText;
  /** the script that is stopped */
  readonly stopped: StoppedScript | null;
}

export interface Mission {
  /** checks of the run */
  readonly checks: readonly Check[];
  /** the lesson that the world belongs to; null: none */
  readonly lesson: Lesson | null;
  /** all lessons */
  readonly lessons: readonly LessonOffer[];
}

export interface Imagery {
  /** the scene of each state, what its rules ask, and the answers */
  readonly imagery: Scenes;
  /** the state with the scene that is drawn over the world; empty: what the agent made up in any state */
  readonly state: string;
  /** the answer that is drawn; empty: none */
  readonly record: string;
}

export interface Offers {
  /** worlds that can be opened */
  readonly scenarios: readonly ScenarioOffer[];
  /** what was opened before, the newest first */
  readonly recent: readonly string[];
  /** all files that the world was made from */
  readonly files: readonly string[];
  /** the text that is searched everywhere */
  readonly searched: string;
  /** where the text was found */
  readonly places: readonly FoundPlace[];
}

export interface Ghosts {
  /** figures without a body */
  readonly ghosts: readonly GhostBody[];
  /** what the selected agent imagines */
  readonly shapes: readonly ImaginedShape[];
  /** what shows the reason of the selected answer */
  readonly answer: AnswerLines;
}

/** The contents of a panel that is described by a document, and the number on its tab. */
export interface DocumentContent {
  readonly document?: Document;
  readonly badge?: string;
}

/** All contents by name. Those that have not arrived yet are missing. */
export interface Contents {
  moment?: Moment;
  agents?: DocumentContent;
  mind?: DocumentContent;
  memory?: DocumentContent;
  rules?: DocumentContent;
  why?: DocumentContent;
  links?: DocumentContent;
  messages?: DocumentContent;
  timeline?: Timeline;
  trace?: DocumentContent;
  plots?: DocumentContent;
  console?: DocumentContent;
  edit?: Edit;
  breakpoints?: DocumentContent;
  script?: DocumentContent;
  futures?: DocumentContent;
  problems?: DocumentContent;
  watch?: DocumentContent;
  minds?: DocumentContent;
  mission?: DocumentContent & Mission;
  longterm?: DocumentContent;
  learning?: DocumentContent;
  exercise?: DocumentContent;
  imagery?: DocumentContent;
  offers?: Offers;
  ghosts?: Ghosts;
}
export type ContentName = keyof Contents;
