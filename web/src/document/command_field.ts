// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child } from "../dom/view";
import type { Action, Field } from "./document";

/** Maximum number of offered words that are shown. */
const MOST_WORDS = 24;

export interface CommandUses {
  /** Sends a request about a typed line. */
  ask(action: Action, line: string): void;
  redraw(): void;
}

/** The lines that were sent by the command fields of a document, and the place of the arrow keys among them. */
export interface CommandHistory {
  readonly lines: string[];
  at: number;
}

/** A field for commands: Tab completes the typed line, and the arrow keys bring earlier lines back. */
export class CommandField {
  line: string;
  private asked = "";

  constructor(text: string, private readonly history: CommandHistory, private readonly uses: CommandUses) {
    this.line = text;
  }

  /** The line was sent: it is stored in the history, and the field is empty again. */
  sent(): void {
    const { lines } = this.history;
    if (lines.at(-1) !== this.line) lines.push(this.line);
    this.history.at = lines.length;
    this.set("");
  }

  view(field: Field): Child[] {
    const command = field.command!, isAnswer = this.asked !== "" && command.completed_line === this.asked && this.line === this.asked;
    const words = isAnswer ? command.words : [];
    if (words.length > 0 && command.common.length > this.line.length - command.begin) this.take(command.begin, command.common);
    return [
      h("label", null, h("span.attribute", { attributes: { "aria-hidden": field.prompt === undefined ? undefined : "true" } }, field.prompt ?? field.label), h("input.source", {
        value: this.line, attributes: { type: "text", "aria-label": field.label, placeholder: field.placeholder, spellcheck: false, autocomplete: "off", autocapitalize: "off" },
        on: {
          input: (event) => (this.line = (event.target as HTMLInputElement).value),
          change: () => this.uses.ask(command.keep, this.line),
          keydown: (event) => this.key(event, command.complete),
        },
      })),
      words.length > 1 && h("div.row.words", null, words.slice(0, MOST_WORDS).map((word) => button(word, () => this.take(command.begin, word), {}, "button.small"))),
    ];
  }

  private key(event: KeyboardEvent, complete: Action): void {
    const step = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    if (event.key === "Tab" && !event.shiftKey && this.line !== "") {
      event.preventDefault();
      this.asked = this.line;
      this.uses.ask(complete, this.line);
    } else if (step !== 0) {
      event.preventDefault();
      const { lines } = this.history;
      this.history.at = Math.min(Math.max(this.history.at + step, 0), lines.length);
      this.set(lines[this.history.at] ?? "");
    }
  }

  private take(begin: number, word: string): void {
    this.set(this.line.slice(0, begin) + word);
  }

  private set(line: string): void {
    this.line = line;
    this.asked = "";
    this.uses.redraw();
  }
}
