// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { Api, TeacherNote } from "../app/api";
import type { Run } from "../run/run";

/** A learner's parts of a class: the button to raise a hand, and the teacher's messages. */
export class LearnerDesk {
  private isHandUp = false;
  private notes: readonly TeacherNote[] = [];

  /** `path`: of the place, "/api/p/ID"; `goTo` shows a line of a file. */
  constructor(private readonly api: Api, private readonly path: string, run: Run, private readonly changed: () => void, private readonly failed: (error: unknown) => void, private readonly goTo: (file: string, line: number) => void) {
    run.on("class", ({ is_hand_up, notes }) => {
      this.isHandUp = is_hand_up;
      this.notes = notes;
      this.changed();
    });
  }

  private post(what: string, body: unknown = {}): void {
    void this.api.json<unknown>(`${this.path}/${what}`, { method: "POST", body: JSON.stringify(body) }).catch((error: unknown) => this.failed(error));
  }

  /** The view for the head of the page. */
  handButton(): View {
    return button(this.isHandUp ? "Your hand is up" : "Raise hand", () => this.post("hand", { is_up: !this.isHandUp }),
      { attributes: { "aria-pressed": this.isHandUp, title: this.isHandUp ? "Take your hand down" : "Your teacher sees that you want help" } }, `button.toggle${this.isHandUp ? ".primary" : ""}`);
  }

  /** Messages stay until they are read. */
  notesView(): Child {
    return this.notes.map((note) => h("div.remark.note", { key: `note ${note.id}` }, h("div", null, h("p.hint", null, "From your teacher"), h("p", null, note.text),
      h("div.row", null, note.line > 0 && button(`${note.file}, line ${note.line}`, () => this.goTo(note.file, note.line), {}, "button.link"), button("I have read it", () => this.post(`notes/${note.id}`), {}, "button.small")))));
  }
}
