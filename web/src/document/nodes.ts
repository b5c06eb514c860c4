// SPDX-License-Identifier: BSD-2-Clause
// Written by reference_pages from src/workbench/document/document_fields.h.
import type { Action, Span, Spans } from "./document";

export type DocumentNode =
  | Paragraph
  | Code
  | Line
  | Button
  | Form
  | Table
  | Tree
  | Plot
  | Strip
  | Checklist
  | Progress
  | Transcript
  | Section
  | Actions
  | Tabs
  | Columns;

export type Cell = Spans | CellValue;

/** A text. `empty` says why a panel shows nothing, and what to do. */
export interface Paragraph {
  /** what the node is */
  readonly is: "text" | "heading" | "title" | "empty";
  /** the text */
  readonly s: Spans;
  /** tooltip */
  readonly hint?: string;
}

/** A text in a monospaced font. */
export interface Code {
  /** what it is */
  readonly is: "code";
  /** the text, if it is not Soar code */
  readonly text?: string;
  /** the text, if it is */
  readonly tokens?: readonly (string | readonly [string, string])[];
}

/** Buttons, forms and texts in one line. */
export interface Line {
  /** what it is */
  readonly is: "line";
  /** one after another */
  readonly nodes: readonly DocumentNode[];
}

/** A button. */
export interface Button {
  /** what it is */
  readonly is: "button";
  /** its label */
  readonly label: string;
  /** what it does */
  readonly do?: Action;
  /** tooltip */
  readonly hint?: string;
  /** or the text that it copies to the clipboard */
  readonly copies?: string;
  /** it is a toggle, and whether it is on */
  readonly on?: boolean;
  /** it cannot be pressed */
  readonly off?: boolean;
  /** it is the most likely next thing to do */
  readonly main?: boolean;
}

/** Fields that are sent together. */
export interface Form {
  /** what it is */
  readonly is: "form";
  /** stays the same from one document to the next */
  readonly key: string;
  /** its request gets the values of the fields */
  readonly do: Action;
  /** its fields */
  readonly fields: readonly Field[];
  /** label of the button; absent: it is sent while the user types */
  readonly button?: string;
  /** tooltip of the button */
  readonly hint?: string;
  /** why it cannot be sent now */
  readonly refusal?: string;
  /** sending it clears its fields */
  readonly clears?: boolean;
}

/** A field of a form. */
export interface Field {
  /** how it is filled in */
  readonly kind: "line" | "choice" | "check" | "suggested" | "command";
  /** in the request */
  readonly name: string;
  /** its label */
  readonly label: string;
  /** shown while it is empty */
  readonly placeholder?: string;
  /** initial value */
  readonly value?: string;
  /** values and labels; of `check`: off, then on; of `suggested`: suggestions */
  readonly options?: readonly (readonly [string, string])[];
  /** the form is not sent while it is empty */
  readonly needed?: boolean;
  /** of `command`: it has a history (arrow keys) and completion (Tab) */
  readonly command?: CommandLine;
  /** of `command`: shown before the field instead of the label */
  readonly prompt?: string;
}

/** What a command line needs. Its requests get the typed text as `line`. */
export interface CommandLine {
  /** asks for completions */
  readonly complete: Action;
  /** stores a text that is not sent */
  readonly keep: Action;
  /** the line for which completions were last requested */
  readonly completed_line: string;
  /** where the completed word begins in that line */
  readonly begin: number;
  /** its completions */
  readonly words: readonly string[];
  /** what all of them begin with */
  readonly common: string;
}

/** A table. */
export interface Table {
  /** what it is */
  readonly is: "table";
  /** stays the same from one document to the next */
  readonly key: string;
  /** its columns */
  readonly columns: readonly Column[];
  /** its rows */
  readonly rows: readonly TableRow[];
  /** its caption */
  readonly caption?: string;
  /** label of a field that filters rows */
  readonly filter?: string;
  /** what a click on a row does */
  readonly press?: RowAction;
  /** the user chooses one of them; initially the first */
  readonly groups?: readonly string[];
  /** tooltip of this choice */
  readonly groups_hint?: string;
  /** what is shown if no row passes the filter */
  readonly none?: readonly [string, string];
  /** the user can sort it */
  readonly sorts?: boolean;
  /** titles of columns are not shown */
  readonly headless?: boolean;
}

/** A column of a table. */
export interface Column {
  /** its title */
  readonly title: string;
  /** it has numbers */
  readonly number?: boolean;
  /** it is shown only if there is room */
  readonly wide?: boolean;
  /** its texts may wrap */
  readonly wraps?: boolean;
  /** tooltip */
  readonly hint?: string;
}

/** A row of a table. */
export interface TableRow {
  /** its key */
  readonly k: string;
  /** its cells */
  readonly c: readonly Cell[];
  /** tooltip */
  readonly hint?: string;
  /** arguments for `press` */
  readonly a?: readonly string[];
  /** the body that is drawn before the first cell */
  readonly sign?: readonly [string, string, boolean];
  /** a deeper row belongs to the row above it */
  readonly depth?: number;
  /** bits of the groups that it belongs to; absent: all */
  readonly g?: number;
  /** it is selected */
  readonly chosen?: boolean;
  /** deeper rows fold, and whether they are initially shown */
  readonly open?: boolean;
}

/** What a click on a row does. */
export interface RowAction {
  /** what it does */
  readonly do: Action;
  /** the field of the request that becomes the row's key, or its argument */
  readonly field: string;
  /** its number, from 1; absent: the key */
  readonly argument?: number;
  /** tooltip of rows of a tree */
  readonly hint?: string;
}

/** A tree. */
export interface Tree {
  /** what it is */
  readonly is: "tree";
  /** stays the same from one document to the next */
  readonly key: string;
  /** what it shows */
  readonly label: string;
  /** its rows */
  readonly rows: readonly TreeRow[];
  /** what a click on a row does */
  readonly press?: RowAction;
  /** the run stores which rows are unfolded */
  readonly unfold?: RowAction;
  /** label of a field that filters rows */
  readonly filter?: string;
}

/** A row of a tree. */
export interface TreeRow {
  /** its key */
  readonly k: string;
  /** its text */
  readonly s: Spans;
  /** arguments for `press` */
  readonly a?: readonly string[];
  /** it can be unfolded, and whether it is */
  readonly open?: boolean;
  /** the rows below it */
  readonly below?: readonly TreeRow[];
}

/** Curves over the time of the run. */
export interface Plot {
  /** what it is */
  readonly is: "plot";
  /** stays the same from one document to the next */
  readonly key: string;
  /** its title */
  readonly title: string;
  /** the newest value, or why there is none */
  readonly value: string;
  /** its curves */
  readonly curves: readonly Curve[];
  /** values hold until the next one */
  readonly stepped?: boolean;
  /** the minimum and the maximum */
  readonly range?: string;
  /** a button next to the title */
  readonly button?: Button;
}

/** A curve of a plot. */
export interface Curve {
  /** its name */
  readonly name: string;
  /** tick and value of each */
  readonly points: readonly (readonly [number, number])[];
}

/** Numbers from 1 to `count`, of which one is chosen. */
export interface Strip {
  /** what it is */
  readonly is: "strip";
  /** stays the same from one document to the next */
  readonly key: string;
  /** what a number means: "Episode" */
  readonly label: string;
  /** the last number */
  readonly count: number;
  /** 0: none */
  readonly chosen: number;
  /** numbers that are marked */
  readonly marks: readonly number[];
  /** what these are */
  readonly mark: string;
  /** what a click on a number does */
  readonly press: RowAction;
}

/** Requirements, each with its present result. */
export interface Checklist {
  /** what it is */
  readonly is: "checklist";
  /** the requirements */
  readonly items: readonly ChecklistItem[];
}

/** A requirement. */
export interface ChecklistItem {
  /** its key */
  readonly k: string;
  /** its present result */
  readonly result: "open" | "passed" | "failed";
  /** the result in words */
  readonly says: string;
  /** its text */
  readonly s: Spans;
  /** a text in a line of its own */
  readonly below?: Spans;
  /** tooltip */
  readonly hint?: string;
}

/** A text with a bar. */
export interface Progress {
  /** what it is */
  readonly is: "progress";
  /** the text */
  readonly text: string;
  /** how many are done */
  readonly value: number;
  /** of how many */
  readonly of: number;
}

/** Lines that are appended. The newest is visible, unless the user has scrolled back. */
export interface Transcript {
  /** what it is */
  readonly is: "transcript";
  /** stays the same from one document to the next */
  readonly key: string;
  /** what it shows */
  readonly label: string;
  /** the newest 500 lines, a span for each */
  readonly lines: readonly Span[];
  /** changes when a line is appended */
  readonly count: number;
}

/** A part with a heading. */
export interface Section {
  /** what it is */
  readonly is: "section";
  /** stays the same from one document to the next */
  readonly key: string;
  /** its heading */
  readonly title: Spans;
  /** what it contains */
  readonly nodes: readonly DocumentNode[];
  /** it folds, and whether it is initially open */
  readonly open?: boolean;
  /** it shows all about one thing */
  readonly story?: boolean;
  /** it is set off in the colour of this role */
  readonly box?: string;
  /** if this changes, the panel comes to the front and scrolls to it */
  readonly news?: string;
}

/** A line at the lower edge that does not scroll; the last node of a document. */
export interface Actions {
  /** what it is */
  readonly is: "actions";
  /** one after another */
  readonly nodes: readonly DocumentNode[];
}

/** Several pages, of which one is shown. */
export interface Tabs {
  /** what it is */
  readonly is: "tabs";
  /** stays the same from one document to the next */
  readonly key: string;
  /** the page that is shown initially, from 0 */
  readonly first?: number;
  /** if it changes, that page is shown again */
  readonly reason?: string;
  /** the pages */
  readonly pages: readonly Page[];
}

/** One of several pages. */
export interface Page {
  /** its title */
  readonly title: string;
  /** tooltip */
  readonly hint: string;
  /** what it contains */
  readonly nodes: readonly DocumentNode[];
}

/** Sections side by side. */
export interface Columns {
  /** what it is */
  readonly is: "columns";
  /** the sections */
  readonly parts: readonly Section[];
}

/** A cell that is sorted by a number, or has a bar. */
export interface CellValue {
  /** its text */
  readonly s: Spans;
  /** it is sorted by this */
  readonly n?: number;
  /** -1 to 1: length of a bar in the background */
  readonly bar?: number;
}
