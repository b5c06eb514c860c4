// SPDX-License-Identifier: BSD-2-Clause
import type { Child } from "../dom/view";
import type { Attempt } from "../lesson/attempt";
import type { ContentName, Contents } from "../run/contents";
import type { Run } from "../run/run";
import { PANELS, type PanelInfo } from "./panel_table";

/** Files of a place, by the names that the run gives them ("/place/home/..."). Both throw what was wrong. */
export interface PlaceFiles {
  read(file: string): Promise<string>;
  write(file: string, text: string): Promise<void>;
}

/** What a panel may use: the run, and the page around it. */
export interface PanelContext {
  readonly run: Run;
  /** Shows the panel again, after something of its own changed. */
  redraw(word: string): void;
  /** The number on a panel's tab. */
  titleOf(word: string): string;
  /** Brings a panel to the front. */
  reveal(word: string): void;
  /** Asks why something is so, and shows the answer. */
  why(about: string, what?: string): void;
  /** Before another file is opened in the editor: what was typed goes to the run. */
  beforeEdit(): void;
  /** Opens a file in the editor. */
  edit(file: string, line?: number): void;
  openWhat(what: string): void;
  /** Shows the start page: lessons and worlds. */
  goHome(): void;
  /** Has the learner's rules graded; what was typed last is applied before. */
  grade(): void;
  /** The files of the place; null: they cannot be reached from here. */
  readonly files: PlaceFiles | null;
  /** What the learner has done with the rules of this run. */
  readonly attempt: Attempt;
}

/** One panel: contents in, views out, requests back. */
export interface Panel {
  /** As in docs/workbench.md. */
  readonly word: string;
  readonly title: string;
  /** What the panel shows; displayed while it is empty. */
  readonly about: string;
  readonly uses: readonly ContentName[];
  view(contents: Contents): Child;
  /** A small number on its tab; nothing: "". */
  badge?(contents: Contents): string;
  /** The panel is in front now, or no longer. */
  shown?(isShown: boolean): void;
}

export type MakePanel = (context: PanelContext) => Panel;

/** Word, title and description of a panel of the table. */
export function infoOf(word: string): Pick<PanelInfo, "word" | "title" | "about"> {
  const { title, about } = PANELS.find((one) => one.word === word)!;
  return { word, title, about };
}
