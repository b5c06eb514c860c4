// SPDX-License-Identifier: BSD-2-Clause
import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { bracketMatching, foldGutter, indentOnInput, indentUnit } from "@codemirror/language";
import { forEachDiagnostic, lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState, Transaction } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers, type ViewUpdate } from "@codemirror/view";
import { lineStops, showing, stopLines, type ShownStops } from "./line_stops";
import { completeWith, hoverWith, type LanguageClient } from "./language_client";
import { placeOf, remedyOf, type PlacedProblem } from "./problem_place";
import { soarColors, soarLanguage } from "./soar_language";

const TYPED_AFTER_MS = 350;

export interface EditorEvents {
  /** The text changed by typing; called when typing pauses. */
  typed(text: string): void;
  /** The text changed by typing; called at each change. */
  typing(text: string): void;
  apply(text: string): void;
  /** Keys of further actions: format, rename, go to the definition. */
  command(what: EditorCommand): void;
  /** A stop at a line is wanted, or no longer. */
  stop(line: number, isOn: boolean): void;
}
export type EditorCommand = "format" | "rename" | "definition";

/** The editor of rules: colours, problems at their place, remedies as fixes. */
export class Editor {
  readonly view: EditorView;
  private readonly language = new Compartment();
  private readonly readOnly = new Compartment();
  private timer: ReturnType<typeof setTimeout> | null = null;
  private fromElsewhere = false;

  constructor(place: HTMLElement, private readonly events: EditorEvents, client: LanguageClient) {
    this.view = new EditorView({
      parent: place,
      state: EditorState.create({
        extensions: [
          lineStops((line, isOn) => this.events.stop(line, isOn)), lineNumbers(), highlightActiveLineGutter(), foldGutter(), lintGutter(), history(), drawSelection(), indentOnInput(), indentUnit.of("   "), bracketMatching(), closeBrackets(),
          highlightActiveLine(), highlightSelectionMatches(), EditorView.lineWrapping, EditorState.tabSize.of(3),
          hoverWith(client), autocompletion({ override: [completeWith(client)], activateOnTyping: true }),
          this.language.of([soarLanguage, soarColors]), this.readOnly.of([]),
          EditorView.contentAttributes.of({ "aria-label": "Rules", spellcheck: "false", autocapitalize: "off", autocorrect: "off" }),
          keymap.of([
            { key: "Mod-s", preventDefault: true, run: () => this.apply() }, { key: "Mod-Enter", run: () => this.apply() },
            { key: "Shift-Alt-f", preventDefault: true, run: () => this.command("format") }, { key: "F2", preventDefault: true, run: () => this.command("rename") }, { key: "F12", preventDefault: true, run: () => this.command("definition") },
            ...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...completionKeymap, ...lintKeymap, indentWithTab,
          ]),
          EditorView.updateListener.of((update) => this.changed(update)),
        ],
      }),
    });
    this.makeScrollable();
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  /** Shows a text from elsewhere. The caret keeps its position if possible. */
  show(text: string, isRules: boolean): void {
    this.stopTimer();
    this.fromElsewhere = true;
    const caret = Math.min(this.view.state.selection.main.head, text.length);
    this.view.dispatch({
      changes: { from: 0, to: this.view.state.doc.length, insert: text }, selection: { anchor: caret }, annotations: Transaction.addToHistory.of(false),
      effects: this.language.reconfigure(isRules ? [soarLanguage, soarColors] : []),
    });
    this.fromElsewhere = false;
  }

  private makeScrollable(): void {
    // Users without a mouse must be able to scroll it, too.
    this.view.scrollDOM.tabIndex = 0;
    this.view.scrollDOM.setAttribute("role", "group");
    this.view.scrollDOM.setAttribute("aria-label", "Text of the rules");
  }

  setReadOnly(isReadOnly: boolean): void {
    this.view.dispatch({ effects: this.readOnly.reconfigure(isReadOnly ? [EditorState.readOnly.of(true), EditorView.editable.of(false)] : []) });
  }

  showProblems(problems: readonly PlacedProblem[]): void {
    const text = this.text;
    const shown = problems.map((problem): Diagnostic => {
      const place = placeOf(problem, text), remedy = remedyOf(problem, text), hint = problem.hint ?? "";
      return {
        ...place, severity: problem.severity === "error" ? "error" : problem.severity === "warning" ? "warning" : "info", message: hint === "" ? problem.message : `${problem.message}\n${hint}`,
        actions: remedy === null ? [] : [{ name: `Change to ${remedy.insert}`, apply: (view: EditorView, from: number, to: number) => {
          // The text may have changed: the fix is looked up at the mark's current position.
          const moved = remedyOf({ ...problem, place: { from, to } }, view.state.doc.toString());
          const change = moved ?? { from, to, insert: remedy.insert };
          view.dispatch({ changes: change, userEvent: "input.fix" });
          view.focus();
        } }],
      };
    }).filter((one) => one.to >= one.from && one.to <= text.length);
    // Existing marks are kept, so that a hint does not disappear while it is read.
    const there: string[] = [];
    forEachDiagnostic(this.view.state, (one, from, to) => there.push(`${from}-${to} ${one.message}`));
    if (there.sort().join() === shown.map((one) => `${one.from}-${one.to} ${one.message}`).sort().join()) return;
    this.view.dispatch(setDiagnostics(this.view.state, shown));
  }

  showStops(stops: ShownStops): void {
    this.view.dispatch({ effects: showing(stops) });
  }

  /** The lines of the stops; typing above a stop has moved it. */
  get stopLines(): number[] {
    return stopLines(this.view.state);
  }

  /** The line of the caret, from 1. */
  get line(): number {
    return this.view.state.doc.lineAt(this.view.state.selection.main.head).number;
  }

  goTo(line: number): void {
    const doc = this.view.state.doc, at = doc.line(Math.min(Math.max(line, 1), doc.lines)).from;
    this.view.dispatch({ selection: { anchor: at }, effects: EditorView.scrollIntoView(at, { y: "center" }) });
  }

  /** Sends the last typed text immediately. */
  flush(): void {
    if (this.timer === null) return;
    this.stopTimer();
    this.events.typed(this.text);
  }

  apply(): boolean {
    this.stopTimer();
    this.events.apply(this.text);
    return true;
  }

  focus(): void {
    this.view.focus();
  }

  private command(what: EditorCommand): boolean {
    this.events.command(what);
    return true;
  }

  /** The position of the caret: line and character, from 0. */
  get caret(): { line: number; character: number } {
    const { head } = this.view.state.selection.main, line = this.view.state.doc.lineAt(head);
    return { line: line.number - 1, character: head - line.from };
  }

  /** Changes the text as if it had been typed; one step for Undo. */
  change(changes: readonly { from: number; to: number; insert: string }[]): void {
    if (changes.length > 0) this.view.dispatch({ changes: [...changes], userEvent: "input.change" });
  }

  /** Inserts this at the caret, as if it was typed. */
  type(text: string): void {
    this.view.dispatch({ ...this.view.state.replaceSelection(text), userEvent: "input.type", scrollIntoView: true });
    this.view.focus();
  }

  private changed(update: ViewUpdate): void {
    if (!update.docChanged || this.fromElsewhere) return;
    this.events.typing(this.text);
    this.stopTimer();
    this.timer = setTimeout(() => {
      this.timer = null;
      this.events.typed(this.text);
    }, TYPED_AFTER_MS);
  }

  private stopTimer(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
  }
}
