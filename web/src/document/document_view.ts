// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { PanelContext } from "../panels/panel";
import { clock, filterField, toggle } from "../panels/parts";
import { icon } from "../app/icons";
import { CommandField, type CommandHistory } from "./command_field";
import { plainText, type Action, type Button, type Checklist, type Code, type Document, type DocumentNode, type Field, type Form, type Paragraph,
  type RowAction, type Section, type Span, type Spans, type Strip, type Tabs, type Tree, type TreeRow } from "./document";
import { PlotViews } from "./plot_view";
import { TableViews } from "./table_view";

/** Roles with a style class of a different name. */
const CLASSES: Readonly<Record<string, string>> = { new: "sign added", gone: "removed", name: "attribute", obj: "object", num: "num" };

const SIGNS = { passed: "check", failed: "cross", open: "open" } as const;

/** The word of a part, the same for each lesson: "grade" of "grade 01-a-rule". */
const partOf = (section: Section): string => section.key.split(" ")[0]!;

/** A transcript that is scrolled back by less than this follows its newest line. */
const NEAR_END_PX = 80;

/** Requests that only the user of the run can make, not somebody who watches. */
const OF_USERS = new Set(["lesson", "flow"]);

/** The user's settings in a part of a document, stored by the part's key. */
interface FieldState { text: string; told: string }

/** Draws documents, and stores the user's settings in them: filters, pages, unfolded rows, typed text. */
export class DocumentView {
  private readonly fields = new Map<string, FieldState>();
  private readonly pages = new Map<string, number>();
  private readonly reasons = new Map<string, string>();
  private readonly folds = new Map<string, boolean>();
  private readonly filters = new Map<string, string>();
  private readonly commands = new Map<string, CommandField>();
  private readonly history: CommandHistory = { lines: [], at: 0 };
  /** A command line was sent: its answer is to be seen. */
  private showsNewest = false;
  /** What sections had to say last, by key. */
  private readonly news = new Map<string, string>();
  /** The section that is to be scrolled to. */
  private awaited = "";
  private readonly tables: TableViews;
  private readonly plots: PlotViews;

  constructor(private readonly context: PanelContext, private readonly word: string) {
    this.tables = new TableViews({
      spans: (spans) => this.spans(spans), press: (action, row) => this.pressRow(action, row), redraw: () => this.redraw(),
    });
    this.plots = new PlotViews();
  }

  view(nodes: Document): Child[] {
    this.plots.keep(nodes);
    return this.nodes(nodes);
  }

  /** Looks for a section with news that the user waits for. Returns whether there is one. */
  hasNews(nodes: Document): boolean {
    let isNew = false;
    for (const node of nodes) {
      if (node.is !== "section" || node.news === undefined) continue;
      const before = this.news.get(node.key);
      this.news.set(node.key, node.news);
      if (before === undefined || before === node.news || node.news === "") continue;
      this.awaited = node.key;
      isNew = true;
    }
    return isNew;
  }

  redraw(): void {
    this.context.redraw(this.word);
  }

  private nodes(nodes: Document): Child[] {
    return nodes.map((node) => this.node(node));
  }

  private node(node: DocumentNode): Child {
    switch (node.is) {
      case "code": return code(node);
      case "line": return h("div.row", null, this.nodes(node.nodes));
      case "button": return this.button(node);
      case "form": return this.form(node);
      case "table": return this.tables.view(node);
      case "tree": return this.tree(node);
      case "plot": return this.plots.view(node, this.step, node.button === undefined ? false : this.button(node.button, "button.small"));
      case "strip": return this.strip(node);
      case "checklist": return checklist(node, (spans) => this.spans(spans));
      case "transcript": return h("ol.transcript", { key: node.key, attributes: { "aria-label": node.label, "aria-live": "polite", "data-count": node.count }, mounted: toNewest, patched: (element) => this.followNewest(element) }, node.lines.map((line) => h("li", null, this.span(line))));
      case "progress": return h("div.row", null, h("span.quiet", null, node.text), h("progress", { attributes: { max: Math.max(node.of, 1), value: node.value, "aria-label": node.text } }));
      case "section": return this.section(node);
      case "actions": return this.mayPress && h("div.row.actions", { key: "actions" }, this.nodes(node.nodes));
      case "tabs": return this.tabs(node);
      case "columns": return h("div.columns", null, node.parts.map((part) => h("section", { key: part.key },
        h("h3", null, this.spans(part.title)), this.nodes(part.nodes))));
      default: return this.paragraph(node);
    }
  }

  /** Whether this user can change the run. */
  private get mayPress(): boolean {
    return this.context.run.hello?.may_edit !== false;
  }

  private get step(): number {
    return this.context.run.contents?.moment?.time.step_s ?? 1 / 30;
  }

  // Texts and their actions -----------------------------------------------------------------------------------------

  private paragraph(text: Paragraph): View {
    const attributes = { title: text.hint };
    if (text.is === "empty") return h("div.empty", { attributes }, h("p", null, this.spans(text.s)));
    return h(text.is === "text" ? "p" : `h3${text.is === "title" ? ".title" : ""}`, { attributes }, this.spans(text.s));
  }

  spans(spans: Spans): Child[] {
    return typeof spans === "string" ? [spans] : spans.map((span) => this.span(span));
  }

  private span(span: Span): Child {
    if (typeof span === "string") return span;
    const [text, role = "plain", action, hint] = span, name = CLASSES[role] ?? role;
    if (typeof text === "number")
      return button(clock(text * this.step), () => this.context.run.ask("seek", { tick: text }), { attributes: { title: `Go to tick ${text}` } },
        `button.link.time${role === "quiet" ? ".quiet" : ""}`);
    const attributes = { title: hint };
    if (action !== undefined && action !== null)
      return button(text, () => this.press(action), { attributes }, role === "tag" ? "button.small" : `button.link.${name.replace(" ", ".")}`);
    if (role === "plain" && hint === undefined) return text;
    return h(role === "strong" ? "b" : role === "code" ? "code" : `span.${name.replace(" ", ".")}`, { attributes }, text);
  }

  /** Sends a request, and shows where its answer appears. Returns whether it was sent. */
  press([request, panel]: Action, more: Readonly<Record<string, unknown>> = {}): boolean {
    const { request: name, ...fields } = { ...request, ...more };
    if (name === "edit") this.context.beforeEdit();
    // The page itself opens lessons, and applies what was typed before it is graded.
    if (name === "lesson" && fields["what"] === "grade") return this.context.grade();
    if (name === "lesson" && fields["what"] === "open") return this.context.openWhat(`lesson:${String(fields["lesson"])}`), true;
    const isSent = this.context.run.ask(name, fields);
    if (isSent && panel !== undefined) this.context.reveal(panel);
    return isSent;
  }

  private pressRow(action: RowAction, row: { readonly k: string; readonly a?: readonly string[] }, more: Readonly<Record<string, unknown>> = {}): void {
    const value = action.argument === undefined ? row.k : row.a?.[action.argument - 1];
    if (value === undefined) return;
    const isNumber = typeof action.do[0][action.field] === "number";
    this.press(action.do, { [action.field]: isNumber ? Number(value) : value, ...more });
  }

  private button(one: Button, what = one.main === true ? "button.primary" : one.on === undefined ? "button.small" : "button.small.toggle"): Child {
    if (!this.mayPress && OF_USERS.has(one.do?.[0].request ?? "")) return false;
    return button(one.label, () => {
      if (one.copies !== undefined) void navigator.clipboard?.writeText(one.copies);
      if (one.do !== undefined) this.press(one.do);
    }, { attributes: { title: one.hint, disabled: one.off === true, "aria-pressed": one.on === undefined ? undefined : String(one.on) } }, what);
  }

  // Forms ------------------------------------------------------------------------------------------------------------

  /** A field shows the document's value until the user types, and again when the document's value changes. */
  private stateOf(form: Form, field: Field): FieldState {
    const key = `${form.key}/${field.name}`, isChosen = field.kind === "choice" || field.kind === "check";
    const told = field.value ?? (isChosen ? (field.options?.[0]?.[0] ?? "") : "");
    let state = this.fields.get(key);
    if (state === undefined) this.fields.set(key, (state = { text: told, told }));
    else if (state.told !== told) state.text = state.told = told;
    return state;
  }

  private form(form: Form): View {
    const send = (): void => {
      const values: Record<string, unknown> = {};
      for (const field of form.fields) {
        const text = this.commands.get(form.key)?.line ?? this.stateOf(form, field).text;
        if (field.needed === true && text.trim() === "") return;
        values[field.name] = typeof form.do[0][field.name] === "number" ? Math.max(0, Math.floor(Number(text))) || 0 : text.trim();
      }
      if (!this.press(form.do, values)) return;
      const command = this.commands.get(form.key);
      if (command !== undefined) this.showsNewest = true;
      command?.sent();
      if (form.clears !== true) return;
      for (const field of form.fields) if (field.kind === "line") this.stateOf(form, field).text = "";
      this.redraw();
    };
    const isLive = form.button === undefined;
    return h("form.row", { key: form.key, on: { submit: (event) => {
      event.preventDefault();
      send();
    } } }, form.fields.map((field) => this.field(form, field, isLive ? send : () => {})),
    !isLive && h("button", { attributes: { type: "submit", title: form.refusal ?? form.hint, disabled: form.refusal !== undefined } }, form.button));
  }

  /** The command line of a form. It keeps what is typed until it is sent. */
  private commandOf(form: Form, field: Field): CommandField {
    let command = this.commands.get(form.key);
    if (command === undefined) {
      const uses = { ask: (action: Action, line: string) => void this.press(action, { line }), redraw: () => this.redraw() };
      this.commands.set(form.key, (command = new CommandField(field.value ?? "", this.history, uses)));
    }
    return command;
  }

  private field(form: Form, field: Field, changed: () => void): Child {
    if (field.command !== undefined) return this.commandOf(form, field).view(field);
    const state = this.stateOf(form, field), options = field.options ?? [];
    const set = (text: string): void => {
      state.text = text;
      changed();
    };
    if (field.kind === "choice")
      return h("select", { value: state.text, attributes: { "aria-label": field.label }, on: { change: (event) => set((event.target as HTMLSelectElement).value) } },
        options.map(([value, label]) => h("option", { attributes: { value } }, label)));
    if (field.kind === "check") {
      const [off, on] = [options[0]?.[0] ?? "", options[1]?.[0] ?? ""];
      return h("label", null, h("input", { checked: state.text === on && on !== off, attributes: { type: "checkbox" },
        on: { change: (event) => set((event.target as HTMLInputElement).checked ? on : off) } }), ` ${field.label}`);
    }
    const list = field.kind === "suggested" ? `${this.word}-${form.key}-${field.name}` : undefined;
    return [h("input", {
      value: state.text, attributes: { type: form.button === undefined ? "search" : "text", "aria-label": field.label, title: field.label, placeholder: field.placeholder ?? field.label, list, spellcheck: false, autocomplete: "off" },
      on: { input: (event) => set((event.target as HTMLInputElement).value) },
    }), list !== undefined && h("datalist", { attributes: { id: list } }, options.map(([value, label]) => h("option", { attributes: { value } }, label)))];
  }

  private strip(strip: Strip): View {
    const choose = (event: Event): void => this.pressRow(strip.press, { k: (event.target as HTMLInputElement).value });
    return h("div.strip", { key: strip.key },
      h("div.marks", { attributes: { "aria-hidden": true } }, strip.marks.map((mark) => h("i", { style: { left: `${((mark - 0.5) / strip.count) * 100}%` } }))),
      h("input", { value: String(strip.chosen), on: { input: choose }, attributes: {
        type: "range", min: strip.chosen === 0 ? 0 : 1, max: strip.count, step: 1, "aria-label": strip.label,
        "aria-valuetext": strip.chosen === 0 ? "none" : `${strip.label} ${strip.chosen}${strip.marks.includes(strip.chosen) ? `, ${strip.mark}` : ""}`,
        title: `${strip.label} 1 to ${strip.count}; marked: ${strip.mark}` } }));
  }

  // Parts ------------------------------------------------------------------------------------------------------------

  private section(section: Section): Child {
    const hasTitle = section.title.length > 0;
    if (!hasTitle && section.nodes.length === 0) return false;
    if (section.open !== undefined)
      return h("details", { key: section.key, open: section.open }, h("summary", null, plainText(section.title)), this.nodes(section.nodes));
    const bring = (element: HTMLElement): void => this.bring(section, element);
    return h(`section${section.story === true ? ".story" : ""}${section.box === undefined ? "" : `.box.box-${section.box}`}`, {
      key: section.key, attributes: { "data-part": partOf(section), ...(section.news === undefined ? {} : { "aria-live": "polite", tabindex: -1, "aria-label": plainText(section.title) }) }, mounted: bring, patched: bring,
    }, hasTitle && h("h3", null, this.spans(section.title)), this.nodes(section.nodes));
  }

  /** Scrolls to the newest line, unless the user had scrolled back before it came. A sent command line always leads there. */
  private followNewest(element: HTMLElement): void {
    const { shown, count, height, room } = element.dataset, hasMore = shown !== count;
    // As it was before: lines have come, and the panel may have become lower.
    const isNear = Number(height ?? 0) - element.scrollTop - Math.max(element.clientHeight, Number(room ?? 0)) < NEAR_END_PX;
    if (isNear || (hasMore && this.showsNewest)) toNewest(element);
    else noteShown(element);
    if (hasMore) this.showsNewest = false;
  }

  /** Scrolls to the awaited section, and focuses it unless the user is typing elsewhere. */
  private bring(section: Section, element: HTMLElement): void {
    if (section.key !== this.awaited) return;
    this.awaited = "";
    const panel = element.closest<HTMLElement>(".panel"), now = document.activeElement;
    element.scrollIntoView({ block: element.getBoundingClientRect().height > (panel?.clientHeight ?? Infinity) ? "start" : "nearest" });
    if (now === null || now === document.body || panel?.contains(now) === true) element.focus({ preventScroll: true });
  }

  private tabs(tabs: Tabs): View {
    if (tabs.reason !== undefined && tabs.reason !== this.reasons.get(tabs.key)) this.pages.set(tabs.key, tabs.first ?? 0);
    this.reasons.set(tabs.key, tabs.reason ?? "");
    const page = Math.min(this.pages.get(tabs.key) ?? tabs.first ?? 0, tabs.pages.length - 1);
    return h("section.pages", { key: tabs.key }, h("div.row", { attributes: { role: "group", "aria-label": "Pages" } }, tabs.pages.map((one, i) => toggle(one.title, i === page, () => {
      this.pages.set(tabs.key, i);
      this.redraw();
    }, one.hint))), h("div.page", { key: String(page) }, this.nodes(tabs.pages[page]?.nodes ?? [])));
  }

  private tree(tree: Tree): Child[] {
    const filter = this.filters.get(tree.key) ?? "", rows = filter === "" ? tree.rows : tree.rows.filter((row) => hasText(row, filter.toLowerCase()));
    return [
      tree.filter !== undefined && filterField(tree.filter, filter, (text) => {
        this.filters.set(tree.key, text);
        this.redraw();
      }),
      h("ul.tree.top", { key: tree.key, attributes: { role: "tree", "aria-label": tree.label } }, rows.map((row) => this.treeRow(tree, row, tree.key))),
    ];
  }

  private treeRow(tree: Tree, row: TreeRow, path: string): View {
    const place = `${path}/${row.k}`, folds = row.open !== undefined, isKept = tree.unfold !== undefined;
    const isOpen = folds && (isKept ? row.open === true : (this.folds.get(place) ?? row.open === true));
    const change = typeof row.s === "string" ? "" : row.s.some((one) => one[1] === "new") ? ".added" : row.s.some((one) => one[1] === "gone") ? ".removed" : "";
    const leads = typeof row.s !== "string" && row.s.some((one) => typeof one !== "string" && (typeof one[0] === "number" || (one[2] ?? null) !== null));
    const text = this.spans(row.s), press = tree.press;
    return h(`li${change}`, { key: row.k, attributes: { role: "treeitem", "aria-expanded": folds ? isOpen : undefined } },
      h("div.fold-row", null, folds ? button(isOpen ? "▾" : "▸", () => {
        if (tree.unfold !== undefined) return this.pressRow(tree.unfold, row, { is_open: !isOpen });
        this.folds.set(place, !isOpen);
        this.redraw();
      }, { attributes: { "aria-expanded": String(isOpen), "aria-label": `${isOpen ? "Fold" : "Unfold"} ${plainText(row.s)}` } }, "button.fold") : h("span.fold", null, " "),
      press !== undefined && !leads ? button(text, () => this.pressRow(press, row), { attributes: { title: press.hint } }, "button.link") : h("span.text", null, text)),
      isOpen && row.below !== undefined && h("ul.tree", { attributes: { role: "group" } }, row.below.map((one) => this.treeRow(tree, one, place))));
  }
}

function hasText(row: TreeRow, text: string): boolean {
  return plainText(row.s).toLowerCase().includes(text) || (row.below ?? []).some((one) => hasText(one, text));
}

/** A text in a fixed font; of Soar with its colours. */
function code(one: Code): View {
  return h("pre.source", null, one.tokens === undefined ? one.text : one.tokens.map((token) => (typeof token === "string" ? token : h(`span.tok-${token[1]}`, null, token[0]))));
}

function checklist(list: Checklist, spans: (spans: Spans) => Child[]): View {
  return h("ul.checks", null, list.items.map((one) => h(`li.check.${one.result}`, { key: one.k, attributes: { title: one.hint } }, icon(SIGNS[one.result]), h("span.hidden", null, `${one.says}: `),
    h("span.text", null, spans(one.s), one.below !== undefined && h("span.below", null, spans(one.below))))));
}

/** Scrolls to the newest line of a transcript, and notes what was shown then. */
function toNewest(element: HTMLElement): void {
  element.scrollTop = element.scrollHeight;
  noteShown(element);
}

function noteShown(element: HTMLElement): void {
  element.dataset["shown"] = element.dataset["count"];
  element.dataset["height"] = String(element.scrollHeight);
  element.dataset["room"] = String(element.clientHeight);
}
