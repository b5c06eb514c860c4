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

/** A field for commands: Tab completes the typed line, and the arrow keys bring earlier lines back. */
export class CommandField {
  line: string;
  private place: number;
  private asked = "";

  constructor(text: string, private readonly history: string[], private readonly uses: CommandUses) {
    this.line = text;
    this.place = history.length;
  }

  /** The line was sent: it is stored in the history, and the field is empty again. */
  sent(): void {
    if (this.history.at(-1) !== this.line) this.history.push(this.line);
    this.set("");
    this.place = this.history.length;
  }

  view(field: Field): Child[] {
    const command = field.command!, isAnswer = this.asked !== "" && command.completed_line === this.asked && this.line === this.asked;
    const words = isAnswer ? command.words : [];
    if (words.length > 0 && command.common.length > this.line.length - command.begin) this.take(command.begin, command.common);
    return [
      h("label", null, h("span.attribute", null, field.label), h("input.source", {
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
      this.place = Math.min(Math.max(this.place + step, 0), this.history.length);
      this.set(this.history[this.place] ?? "");
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
