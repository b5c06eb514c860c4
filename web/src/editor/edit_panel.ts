// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import { FLOWS } from "../app/flow_table";
import type { Contents, Problem } from "../run/contents";
import { EMPTY } from "../panels/panel_table";
import { infoOf, type Panel, type PanelContext } from "../panels/panel";
import { Applying } from "./applying";
import type { Editor, EditorCommand } from "./editor";
import { unpackText } from "../app/address";
import { fileName, firstFile } from "./first_file";
import { LanguageClient } from "./language_client";
import { merged, problemOf, type PlacedProblem } from "./problem_place";
import { changesOf, edited } from "./text_edits";

const SIGNS = ["(", ")", "<", ">", "^", ".", "-->", "{", "}", "|", "*", "+", "-", "="] as const;
const RESTARTS = "soarbox.restarts";
const ANSWERED_AFTER_MS = 500;

function problemView(context: PanelContext, one: Problem): View {
  const place = one.file === undefined ? "" : `${one.file.split("/").at(-1) ?? ""}${one.line === undefined ? "" : `:${one.line}`}${one.column === undefined ? "" : `:${one.column}`}`;
  return h(`li.problem.${one.severity}`, null,
    h("div.row", null, h("span.severity", null, one.severity), place !== "" && button(place, () => context.edit(one.file ?? "", one.line), { attributes: { title: "Edit it there" } }, "button.link")),
    h("p", null, one.message, one.more !== undefined && h("span.quiet", null, ` and ${one.more} more`)), one.excerpt !== undefined && h("pre", null, one.excerpt), one.hint !== undefined && h("p.hint", null, one.hint));
}

/** The panel with the editor: files, text, problems, and Apply. The editor itself is loaded when it is needed. */
export class EditPanel implements Panel {
  readonly word = "edit";
  readonly title = infoOf("edit").title;
  readonly about = infoOf("edit").about;
  readonly uses = ["edit", "moment", "mission"] as const;
  private editor: Editor | null = null;
  private readonly client: LanguageClient;
  private file = "";
  private version = -1;
  private goCount = -1;
  private problems = "";
  private stops = "";
  private asked = "";
  private loading = false;
  private what = "";
  private readonly applying = new Applying();
  private wanted = "";
  private tellsAgain = false;
  private offered: { file: string; text: string } | null = null;
  /** The text that was typed here before the file was changed elsewhere; null: none. */
  private older: string | null = null;
  /** The input for a name: of a new file, or a new name for the one at a position; null: not open. */
  private asks: { what: "rename" | "new"; old: string; name: string; line: number; character: number } | null = null;
  /** Whether the editor contains text that was typed or restored here. Otherwise it follows the text of the run. */
  private isOwn = false;

  /** `applied`: called when the run has reloaded changed rules. */
  constructor(private readonly context: PanelContext, private readonly applied: () => void) {
    this.client = new LanguageClient(context.run, () => {
      this.mark();
      context.redraw("edit");
    });
    this.what = context.run.hello?.what ?? "";
    context.run.on("hello", ({ what }) => {
      this.asked = "";
      // If the same world begins again, its text and caret are kept; the text of another world is dropped.
      if (what !== this.what) {
        this.file = this.wanted = "";
        this.version = -1;
        this.editor?.show("", true);
        this.editor?.showProblems([]);
        this.problems = "";
      }
      this.tellsAgain = what === this.what;
      this.what = what;
      this.editor?.setReadOnly(!this.mayType);
    });
    context.run.on("tabs", () => {
      this.editor?.setReadOnly(!this.mayType);
      // Another tab may have changed the text meanwhile.
      this.file = "";
      this.take(context.run.contents);
      context.redraw("edit");
    });
    addEventListener("pagehide", () => this.flush());
  }

  /** Whether a lesson's run begins again with each Apply. */
  get restarts(): boolean {
    return localStorage.getItem(RESTARTS) !== "no";
  }

  private get mayType(): boolean {
    return this.context.run.hello?.may_edit !== false && this.context.run.mayType;
  }

  badge(contents: Contents): string {
    const errors = contents.edit === undefined ? 0 : this.allProblems().filter((one) => one.severity === "error").length;
    return errors === 0 ? "" : String(errors);
  }

  view(contents: Contents): Child {
    const edit = contents.edit?.edit, files = contents.edit?.files ?? [], isOpen = edit !== undefined && edit.file !== "";
    this.openFirst(contents);
    const problems = isOpen ? this.allProblems() : [];
    const mayEdit = this.mayType, choices = new Set([...files.map((one) => one.file), ...(contents.edit?.open_files.map((one) => one.file) ?? [])]);
    if (isOpen) choices.add(edit.file);
    return [
      h("div.row.bar", null,
        h("select", { value: isOpen ? edit.file : "", attributes: { "aria-label": "File", disabled: choices.size === 0 }, on: { change: (event) => this.context.edit((event.target as HTMLSelectElement).value) } },
          choices.size === 0 && h("option", { attributes: { value: "" } }, "no file"),
          [...choices].map((file) => h("option", { key: file, attributes: { value: file } }, fileName(file) + (contents.edit?.open_files.some((one) => one.file === file && one.is_unsaved) === true ? " •" : "")))),
        mayEdit && button("Apply", () => this.editor?.apply(), { attributes: { disabled: !isOpen, title: "Save, and reload the rules in the running world (Ctrl+Enter, Ctrl+S)" } }, "button.primary"),
        mayEdit && contents.mission?.lesson !== undefined && contents.mission.lesson !== null && button("Grade", () => this.context.grade(), { attributes: { disabled: contents.mission.lesson.is_graded, title: "Apply, and run your rules with ten seeds" } }),
        mayEdit && button("Revert", () => this.revert(), { attributes: { disabled: !isOpen || !edit.is_unsaved, title: "Back to what was saved" } })),
      mayEdit && isOpen && this.commands(edit.is_rules),
      mayEdit && this.asks !== null && this.asking(this.asks),
      !this.context.run.mayType && h("div.row.bar", { key: "tabs", attributes: { role: "status" } }, h("p.warn", null, "Another tab edits the texts of this place."), button("Edit here", () => this.context.run.takeOver(), {}, "button.primary")),
      isOpen && this.older !== null && h("div.row.bar", { key: "older", attributes: { role: "status" } }, h("p.warn", null, "This text was changed elsewhere. What you had typed here is kept in this browser."),
        mayEdit && button("Show what I typed", () => this.bringBack(edit.file)), button("Forget it", () => this.forget(edit.file))),
      mayEdit && isOpen && edit.is_rules && this.signs(),
      h("div.editor", { key: "editor", foreign: true, mounted: (element) => void this.load(element) }),
      h("div.under", { attributes: { "aria-live": "polite" } },
        isOpen && edit.notice !== "" && !(edit.notice === "No errors." && problems.length > 0) && h(`p.${edit.problems.some((one) => one.severity === "error") ? "warn" : "good"}`, null, edit.notice),
        isOpen && problems.length > 0 && h("ul.plain.problems", null, problems.map((one) => problemView(this.context, { ...one, ...(one.file === undefined ? { file: edit.file } : {}) }))),
        mayEdit && this.what.startsWith("lesson:") && h("label.choice", { attributes: { title: "A running world begins again when you apply rules, so that the checks follow your new rules" } },
          h("input", { checked: this.restarts, attributes: { type: "checkbox" }, on: { change: (event) => localStorage.setItem(RESTARTS, (event.target as HTMLInputElement).checked ? "yes" : "no") } }), ` ${FLOWS["begin-again"].button} with each Apply`),
        !isOpen && h("p.quiet", null, files.length === 0 ? "Select an agent: the files that it was made from can be edited here." : EMPTY.edit)),
    ];
  }

  /** Further actions on the text. All except "new file" also have keys. */
  private commands(isRules: boolean): View {
    const small = (label: string, title: string, press: () => void): View => button(label, press, { attributes: { title } }, "button.small");
    return h("div.row.bar.commands", { key: "commands", attributes: { role: "group", "aria-label": "More for the text" } },
      isRules && [small("Lay out", "Format the rules (Shift+Alt+F)", () => this.command("format")), small("Rename", "Rename what is at the caret, wherever it is used (F2)", () => this.command("rename")),
        small("Go to definition", "Go where the name at the caret is made (F12)", () => this.command("definition"))],
      this.context.files !== null && small("New file", "A new file beside this one", () => this.ask({ what: "new", old: "", name: "", line: 0, character: 0 })));
  }

  private asking(asks: NonNullable<EditPanel["asks"]>): View {
    const label = asks.what === "new" ? "Name of the new file" : `New name of ${asks.old}`;
    return h("form.row.bar", { key: "asking", on: { submit: (event) => {
      event.preventDefault();
      this.asks = null;
      this.context.redraw("edit");
      void (asks.what === "new" ? this.newFile(asks.name) : this.rename(asks)).catch((error: unknown) => this.fail(error));
    } } }, h("input", { value: asks.name, attributes: { type: "text", "aria-label": label, placeholder: label, spellcheck: false, autocomplete: "off" }, mounted: (element) => (element as HTMLInputElement).select(), on: { input: (event) => (asks.name = (event.target as HTMLInputElement).value) } }),
    h("button.primary", { attributes: { type: "submit" } }, asks.what === "new" ? "Create" : "Rename"), button("Cancel", () => this.ask(null)));
  }

  private ask(asks: EditPanel["asks"]): void {
    this.asks = asks;
    this.context.redraw("edit");
    if (asks === null) this.focus();
  }

  private fail(error: unknown): void {
    const told = error as { message?: string; hint?: string };
    this.context.run.remark(told.message ?? String(error), told.hint ?? "");
  }

  private command(what: EditorCommand): void {
    const { editor } = this;
    if (editor === null || !this.mayType || this.file === "") return;
    const { text, caret } = editor;
    const work = async (): Promise<void> => {
      if (what === "format") {
        const edits = await this.client.format(text);
        if (editor.text === text) editor.change(changesOf(text, edits));
        return;
      }
      if (what === "definition") {
        const found = await this.client.definition(text, caret.line, caret.character);
        if (found === null) throw new Error("No rule in these files makes what is at the caret.");
        if (found.path === this.file) editor.goTo(found.line);
        else this.context.edit(found.path, found.line);
        return;
      }
      const old = await this.client.nameAt(text, caret.line, caret.character);
      if (old === null) throw new Error("There is no name at the caret that can be renamed. Put the caret into a variable, an attribute or the name of a rule.");
      this.ask({ what: "rename", old, name: old, ...caret });
    };
    void work().catch((error: unknown) => this.fail(error));
  }

  /** Renames in this text, as a draft, and in other files of the place, which are saved. */
  private async rename(asks: NonNullable<EditPanel["asks"]>): Promise<void> {
    const { editor } = this, { files } = this.context;
    if (editor === null || asks.name === asks.old) return;
    const text = editor.text, renamed = await this.client.rename(text, asks.line, asks.character, asks.name);
    const others = renamed.filter((one) => one.path !== this.file), open = this.context.run.contents.edit?.open_files ?? [];
    const unsaved = others.find((one) => open.some((file) => file.file === one.path && file.is_unsaved));
    if (unsaved !== undefined) throw new Error(`${fileName(unsaved.path)} uses ${asks.old}, too, and has text that is not applied. Apply it first.`);
    if (others.length > 0 && files === null) throw new Error(`${others.map((one) => fileName(one.path)).join(", ")} would have to change as well, and cannot be reached from here.`);
    const texts = await Promise.all(others.map(async (one) => ({ path: one.path, text: edited(await files!.read(one.path), one.edits) })));
    if (editor.text !== text) throw new Error("The text has changed meanwhile. Rename again.");
    for (const one of texts) await files!.write(one.path, one.text);
    editor.change(changesOf(text, renamed.find((one) => one.path === this.file)?.edits ?? []));
    if (others.length > 0) this.context.run.remark(`Renamed in ${others.map((one) => fileName(one.path)).join(", ")}, too.`, "", false);
    this.focus();
  }

  /** Creates an empty file next to the one that is shown. */
  private async newFile(name: string): Promise<void> {
    const { files } = this.context, plain = name.trim();
    if (files === null) return;
    if (!/^[A-Za-z0-9_][A-Za-z0-9_.-]*$/.test(plain)) throw new Error("A file's name has letters, digits, - and _ only.");
    const file = /\.\w+$/.test(plain) ? plain : `${plain}.soar`, path = this.file.slice(0, this.file.lastIndexOf("/") + 1) + file;
    if (await files.read(path).then(() => true, () => false)) throw new Error(`There is a file ${file} already.`);
    const first = fileName(this.file);
    await files.write(path, `# ${file}\n`);
    this.context.edit(path);
    this.context.run.remark(`${file} is there.`, file.endsWith(".soar") ? `Write  source ${file}  into ${first}, so that it is loaded.` : "", false);
  }

  /** Buttons for characters that are hard to reach on a phone's keyboard; shown on touch devices. */
  private signs(): View {
    return h("div.row.signs", { key: "signs", attributes: { role: "group", "aria-label": "Signs of rules" } }, SIGNS.map((sign) => button(sign, () => this.editor?.type(sign), {
      key: sign, attributes: { "aria-label": `Type ${sign}` },
      // Keeps the focus in the editor, so that the phone's keyboard stays open.
      on: { pointerdown: (event) => event.preventDefault() },
    }, "button.small")));
  }

  /** The rules of the selected agent, until the user chooses something else. */
  private openFirst(contents: Contents): void {
    const agent = contents.moment?.agent ?? "", first = firstFile(contents, this.wanted);
    if (agent === "" || first === "" || this.asked === agent || (contents.edit?.edit.file ?? "") !== "") return;
    this.asked = agent;
    this.context.run.ask("edit", { file: first });
  }

  /** Shows this file, by its name, as soon as it can be shown. */
  showFile(file: string): void {
    this.wanted = file;
    this.context.run.ask("edit", { file });
  }

  private async load(element: HTMLElement): Promise<void> {
    if (this.editor !== null) {
      element.append(this.editor.view.dom);
      return;
    }
    if (this.loading) return;
    this.loading = true;
    const { Editor } = await import("./editor");
    this.editor = new Editor(element, {
      typing: (text) => {
        this.isOwn = true;
        const edit = this.context.run.contents.edit?.edit;
        if (edit !== undefined && edit.file === this.file && this.mayType) this.context.run.kept.keep(this.file, text, edit.text);
      },
      typed: (text) => {
        // Without a connection the text waits in the browser's storage, and comes back with the run.
        if (this.context.run.connection !== "open" || !this.mayType) return;
        this.context.run.ask("edit-text", { what: "check", text });
        void this.client.tell(text);
        // Unchanged problems are not sent again, so they are marked again in the new text.
        setTimeout(() => {
          this.problems = "";
          this.mark();
        }, ANSWERED_AFTER_MS);
      },
      command: (what) => this.command(what),
      stop: (line, isOn) => {
        if (this.file === "") return;
        this.moveStops();
        this.context.run.ask("line-stop", { file: this.file, line, is_on: isOn });
      },
      apply: (text) => {
        void this.client.tell(text);
        if (!this.context.run.ask("edit-text", { what: "save", text })) return;
        const edit = this.context.run.contents.edit?.edit;
        if (edit !== undefined) this.applying.begin(edit, text);
        this.context.run.ask("edit-text", { what: "apply", text });
        this.moveStops();
      },
    }, this.client);
    this.editor.setReadOnly(!this.mayType);
    this.file = "";
    this.take(this.context.run.contents);
  }

  /** The run's stops follow the lines that typing has moved. */
  private moveStops(): void {
    const { editor } = this, edit = this.context.run.contents.edit?.edit;
    if (editor === null || edit === undefined || edit.file !== this.file || edit.can_stop !== true) return;
    const before = edit.stops ?? [], conditions = edit.stop_conditions ?? [], now = editor.stopLines;
    for (const line of before) if (!now.includes(line)) this.context.run.ask("line-stop", { file: this.file, line, is_on: false });
    // Stops keep their order, and so their conditions, unless two of them have met in one line.
    const isSame = before.length === now.length;
    now.forEach((line, i) => {
      const known = before.indexOf(line), condition = (isSame ? conditions[i] : conditions[known]) ?? "";
      if (known < 0 || condition !== (conditions[known] ?? "")) this.context.run.ask("line-stop", { file: this.file, line, condition });
    });
  }

  /** Shows stops again only if they or the text have changed, because typing moves them. */
  private markStops(isNew: boolean): void {
    const edit = this.context.run.contents.edit?.edit;
    if (this.editor === null || edit === undefined) return;
    const stops = { can: edit.can_stop === true, lines: edit.stops ?? [], stoppedLine: edit.stopped_line ?? 0 }, told = JSON.stringify(stops);
    if (told === this.stops && !isNew) return;
    this.stops = told;
    this.editor.showStops(stops);
  }

  /** Whether the editor's text differs from the text that the run uses. */
  get isUnsaved(): boolean {
    const edit = this.context.run.contents.edit?.edit;
    return this.editor !== null && edit !== undefined && edit.file !== "" && edit.file === this.file && (edit.is_unsaved || edit.text !== this.editor.text);
  }

  apply(): void {
    this.editor?.apply();
  }

  /** The text in the editor; null: no file. */
  get text(): string | null {
    return this.editor === null || this.file === "" ? null : this.editor.text;
  }

  /** The position of the caret; null: no file is shown. */
  get where(): { file: string; line: number } | null {
    return this.editor === null || this.file === "" ? null : { file: fileName(this.file), line: this.editor.line };
  }

  /** A packed, shared text. It is put into the editor as a draft as soon as its file exists. */
  async offer(file: string, packed: string): Promise<void> {
    const text = await unpackText(packed);
    if (text === null) return this.context.run.remark("The rules in this link are damaged: it may have been cut off.", "Ask for the link again.");
    this.offered = { file: fileName(file), text };
    this.takeOffered();
  }

  private takeOffered(): void {
    const { offered, editor } = this;
    if (offered === null || editor === null || fileName(this.file) !== offered.file) return;
    this.offered = null;
    if (editor.text === offered.text) return;
    editor.show(offered.text, true);
    this.isOwn = true;
    this.context.run.ask("edit-text", { what: "check", text: offered.text });
    this.context.run.remark(`This text of ${offered.file} came with the link.`, "Apply puts it into effect. Revert brings your own back.", false);
  }

  /** Called when new contents have arrived. */
  take(contents: Contents): void {
    const edit = contents.edit?.edit, editor = this.editor;
    if (this.applying.isDone(edit)) this.applied();
    if (editor === null || edit === undefined || edit.file === "") return;
    const isNew = edit.file !== this.file || edit.version !== this.version;
    if (isNew || (!this.isOwn && edit.text !== editor.text)) {
      this.file = edit.file;
      this.version = edit.version;
      const typed = this.context.run.kept.find(edit.file, edit.text), isBack = typed !== null && !typed.isOlder && this.mayType;
      this.older = typed !== null && typed.isOlder ? typed.text : null;
      this.isOwn = isBack;
      editor.show(isBack ? typed.text : edit.text, edit.is_rules);
      if (isBack) this.context.run.ask("edit-text", { what: "check", text: typed.text });
      if (edit.is_rules) this.client.look(edit.file, edit.text);
      this.problems = "";
    }
    // A restarted run or server may lack the text that was typed last.
    if (this.tellsAgain && !isNew && this.isOwn && this.mayType && edit.text !== editor.text) this.context.run.ask("edit-text", { what: "check", text: editor.text });
    this.tellsAgain = false;
    this.context.run.kept.confirm(edit.file, edit.text);
    this.takeOffered();
    this.mark();
    this.markStops(isNew || !this.isOwn);
    if (edit.go_to_count !== this.goCount) {
      this.goCount = edit.go_to_count;
      if (edit.go_to_line > 0) editor.goTo(edit.go_to_line);
    }
  }

  /** Shows what was typed here, as a draft: the server has it from now on. */
  private bringBack(file: string): void {
    const text = this.older;
    if (text === null || this.editor === null) return;
    this.forget(file);
    this.isOwn = true;
    this.editor.show(text, true);
    this.context.run.ask("edit-text", { what: "check", text });
  }

  private revert(): void {
    this.context.run.kept.drop(this.file);
    this.context.run.ask("edit-text", { what: "revert", text: this.editor?.text ?? "" });
  }

  private forget(file: string): void {
    this.context.run.kept.drop(file);
    this.older = null;
    this.context.redraw("edit");
  }

  /** Problems from the kernel's reader, and from the language server about all rules together. */
  private allProblems(): PlacedProblem[] {
    const edit = this.context.run.contents.edit?.edit, text = this.editor?.text ?? "";
    const told = edit?.is_rules === true ? (this.client.diagnostics ?? []).map((one) => problemOf(one, text)) : [];
    return merged(told, edit?.problems ?? []);
  }

  private mark(): void {
    const all = this.allProblems(), told = JSON.stringify(all);
    if (this.editor === null || told === this.problems) return;
    this.problems = told;
    this.editor.showProblems(all);
  }

  flush(): void {
    this.editor?.flush();
  }

  focus(): void {
    this.editor?.focus();
  }
}
