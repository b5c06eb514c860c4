// SPDX-License-Identifier: BSD-2-Clause
import type { Child } from "../dom/view";
import type { ContentName, Contents } from "../run/contents";
import type { Run } from "../run/run";
import { PANELS, type PanelInfo } from "./panel_table";

/** Files of a place, by the names that the run gives them ("/place/home/..."). Both throw an error with the reason. */
export interface PlaceFiles {
  read(file: string): Promise<string>;
  write(file: string, text: string): Promise<void>;
}

/** The services that a panel can use: the run, and the page around it. */
export interface PanelContext {
  readonly run: Run;
  /** Redraws the panel, after its own state has changed. */
  redraw(word: string): void;
  /** The number on a panel's tab. */
  titleOf(word: string): string;
  /** Brings a panel to the front. */
  reveal(word: string): void;
  /** Asks why something is so, and shows the answer. */
  why(about: string, what?: string): void;
  /** Sends the typed text to the run. Call it before another file is opened in the editor. */
  beforeEdit(): void;
  /** Opens a file in the editor. */
  edit(file: string, line?: number): void;
  openWhat(what: string): void;
  /** Applies what the learner typed last, and starts to grade the rules. Returns whether the request was sent. */
  grade(): boolean;
  /** The files of the place; null: they cannot be reached from here. */
  readonly files: PlaceFiles | null;
}

/** A panel. It converts contents to views, and sends requests. */
export interface Panel {
  /** As in docs/workbench.md. */
  readonly word: string;
  readonly title: string;
  /** What the panel shows; displayed while it is empty. */
  readonly about: string;
  readonly uses: readonly ContentName[];
  view(contents: Contents): Child;
  /** Called when the contents that it uses have changed, also if the panel is not in front. */
  note?(contents: Contents): void;
  /** The small number on its tab; "": none. */
  badge?(contents: Contents): string;
  /** Called when the panel comes to the front, or is no longer in front. */
  shown?(isShown: boolean): void;
}

export type MakePanel = (context: PanelContext) => Panel;

/** Word, title and description of a panel of the table. */
export function infoOf(word: string): Pick<PanelInfo, "word" | "title" | "about"> {
  const { title, about } = PANELS.find((one) => one.word === word)!;
  return { word, title, about };
}
