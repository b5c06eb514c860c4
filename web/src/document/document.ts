// SPDX-License-Identifier: BSD-2-Clause

/** The document of a panel, as written by src/workbench/document/document_json.cpp: roles and keys, no colours or sizes. */

/** A request with its fields, and the panel that then comes to the front. */
export type Action = readonly [{ readonly request: string } & Readonly<Record<string, unknown>>, string?];

/** A plain text, or [text, role, action, hint]. A tick instead of the text is shown as a time that leads to the moment. */
export type Span = string | readonly [string | number, string?, (Action | null)?, string?];
export type Spans = string | readonly Span[];

/** An action of rows: the request's field is the row's key, or its n-th argument. */
export interface RowAction { readonly do: Action; readonly field: string; readonly argument?: number; readonly hint?: string }

export interface Paragraph { readonly is: "text" | "heading" | "title" | "empty"; readonly s: Spans; readonly hint?: string }
export interface Code { readonly is: "code"; readonly text?: string; readonly tokens?: readonly (string | readonly [string, string])[] }
export interface Line { readonly is: "line"; readonly nodes: readonly DocumentNode[] }
export interface Button {
  readonly is: "button";
  readonly label: string;
  readonly do?: Action;
  readonly hint?: string;
  readonly copies?: string;
  readonly on?: boolean;
  readonly off?: boolean;
  readonly main?: boolean;
}
export interface Field {
  readonly kind: "line" | "choice" | "check" | "suggested" | "command";
  readonly name: string;
  readonly label: string;
  readonly placeholder?: string;
  readonly value?: string;
  readonly options?: readonly (readonly [string, string])[];
  readonly needed?: boolean;
  /** Of a command line: its requests get the text as `line`. The words complete `completed_line` from `begin` on. */
  readonly command?: { readonly complete: Action; readonly keep: Action; readonly completed_line: string; readonly begin: number; readonly words: readonly string[]; readonly common: string };
}
export interface Form {
  readonly is: "form";
  readonly key: string;
  readonly do: Action;
  readonly fields: readonly Field[];
  readonly button?: string;
  readonly hint?: string;
  readonly refusal?: string;
  readonly clears?: boolean;
}
export interface Column { readonly title: string; readonly number?: boolean; readonly wide?: boolean; readonly wraps?: boolean; readonly hint?: string }
export type Cell = Spans | { readonly s: Spans; readonly n?: number; readonly bar?: number };
export interface TableRow {
  readonly k: string;
  readonly c: readonly Cell[];
  readonly hint?: string;
  readonly a?: readonly string[];
  /** The body of the row: team, kind, and whether another simulation moves it. */
  readonly sign?: readonly [string, string, boolean];
  readonly depth?: number;
  /** The groups of the row, one bit for each. */
  readonly g?: number;
  readonly chosen?: boolean;
  /** Its deeper rows can be folded. */
  readonly open?: boolean;
}
export interface Table {
  readonly is: "table";
  readonly key: string;
  readonly columns: readonly Column[];
  readonly rows: readonly TableRow[];
  readonly caption?: string;
  readonly filter?: string;
  readonly press?: RowAction;
  readonly groups?: readonly string[];
  readonly groups_hint?: string;
  readonly none?: readonly [string, string];
  readonly sorts?: boolean;
  readonly headless?: boolean;
}
export interface TreeRow {
  readonly k: string;
  readonly s: Spans;
  readonly a?: readonly string[];
  /** Whether the row is unfolded; missing: it cannot be unfolded. */
  readonly open?: boolean;
  readonly below?: readonly TreeRow[];
}
export interface Tree {
  readonly is: "tree";
  readonly key: string;
  readonly label: string;
  readonly rows: readonly TreeRow[];
  readonly press?: RowAction;
  readonly unfold?: RowAction;
  readonly filter?: string;
}
export interface Plot {
  readonly is: "plot";
  readonly key: string;
  readonly title: string;
  readonly value: string;
  readonly range?: string;
  readonly curves: readonly { readonly name: string; readonly points: readonly (readonly [number, number])[] }[];
  readonly stepped?: boolean;
  readonly button?: Button;
}
/** Numbers from 1 to count, of which one is chosen. */
export interface Strip {
  readonly is: "strip";
  readonly key: string;
  readonly label: string;
  readonly count: number;
  readonly chosen: number;
  readonly marks: readonly number[];
  readonly mark: string;
  readonly press: RowAction;
}
/** Requirements, each with its present result. */
export interface Checklist {
  readonly is: "checklist";
  readonly items: readonly {
    readonly k: string; readonly result: "open" | "passed" | "failed"; readonly says: string; readonly s: Spans; readonly below?: Spans; readonly hint?: string;
  }[];
}
/** Lines that are appended; the newest is visible unless the user has scrolled back. */
export interface Transcript { readonly is: "transcript"; readonly key: string; readonly label: string; readonly lines: readonly Span[]; readonly count: number }
export interface Progress { readonly is: "progress"; readonly text: string; readonly value: number; readonly of: number }
/** Stays visible while the rest of the panel scrolls. */
export interface Actions { readonly is: "actions"; readonly nodes: readonly DocumentNode[] }
export interface Section {
  readonly is: "section";
  readonly key: string;
  readonly title: Spans;
  readonly nodes: readonly DocumentNode[];
  readonly open?: boolean;
  readonly story?: boolean;
  readonly box?: string;
  /** If it changes to another text, the user waits for this section. */
  readonly news?: string;
}
export interface Tabs {
  readonly is: "tabs";
  readonly key: string;
  readonly first?: number;
  /** If it changes, the first page is shown again. */
  readonly reason?: string;
  readonly pages: readonly { readonly title: string; readonly hint: string; readonly nodes: readonly DocumentNode[] }[];
}
export interface Columns { readonly is: "columns"; readonly parts: readonly Section[] }
export interface Facts { readonly is: "facts"; readonly rows: readonly (readonly [string, Spans])[] }
export type DocumentNode = Paragraph | Code | Line | Button | Form | Table | Tree | Plot | Strip | Checklist | Progress | Transcript | Section | Actions | Tabs | Columns | Facts;
export type Document = readonly DocumentNode[];

/** The text of spans, without their actions and without times. */
export function plainText(spans: Spans): string {
  if (typeof spans === "string") return spans;
  return spans.map((span) => (typeof span === "string" ? span : typeof span[0] === "string" ? span[0] : "")).join("");
}
