// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { textOf, type Child, type View } from "../dom/view";
import type { PanelContext } from "../panels/panel";
import { plainText, type Document, type Table, type Tree } from "./document";
import { documentPanel } from "./document_panel";
import { DocumentView } from "./document_view";
import { columnsOf } from "./plot_view";

const MARKUP = "<img onerror=alert(1)>";

function made(answers = true, mayEdit = true): { view: DocumentView; asked: unknown[]; context: PanelContext } {
  const asked: unknown[] = [];
  const run = { ask: (request: string, fields: unknown) => (asked.push([request, fields]), answers), contents: {}, hello: { may_edit: mayEdit } };
  const context = { run, redraw: (word: string) => asked.push(`redraw ${word}`), reveal: (word: string) => asked.push(`reveal ${word}`), beforeEdit: () => asked.push("flush"), grade: () => asked.push("grade"), openWhat: (what: string) => asked.push(`open ${what}`) } as unknown as PanelContext;
  return { view: new DocumentView(context, "rules"), asked, context };
}

function all(child: Child): View[] {
  if (Array.isArray(child)) return (child as readonly Child[]).flatMap(all);
  return typeof child === "object" && child !== null ? [child as View, ...all((child as View).children)] : [];
}
function find(child: Child, label: string): View {
  const found = all(child).find((one) => one.tag === "button" && (textOf(one) === label || one.props.attributes?.["aria-label"] === label));
  assert.ok(found, `there is no button ${label} in ${textOf(child)}`);
  return found;
}
const press = (child: Child, label: string): void => find(child, label).props.on!.click!({} as MouseEvent);
const type = (child: Child, label: string, text: string): void => {
  const field = all(child).find((one) => one.props.attributes?.["aria-label"] === label);
  assert.ok(field, `there is no field ${label}`);
  const event = { target: { value: text, checked: text !== "" } } as unknown as Event;
  (field.props.on!.input ?? field.props.on!.change)!(event as never);
};

const TABLE: Table = {
  is: "table", key: "rules", columns: [{ title: "Rule" }, { title: "Fired", number: true }], filter: "Filter by text", groups: ["all", "match now"], groups_hint: "Which rows are shown", sorts: true, none: ["No rule matches.", "Choose 'all'."],
  press: { do: [{ request: "rule", rule: "" }], field: "rule" },
  rows: [
    { k: "seek", c: ["seek", { s: "2", n: 2 }], g: 3 }, { k: "flee", c: [[["flee", "good"]], { s: "10", n: 10 }], g: 1, chosen: true },
    { k: MARKUP, c: [[[MARKUP, "quiet"]], { s: "0", n: 0 }], g: 1 },
  ],
};
const firstCells = (view: Child): string[] => all(view).filter((one) => one.tag === "tr").slice(1).map((row) => textOf(all(row).find((one) => one.tag === "td")!));

test("a panel without a document describes its contents, one with a document shows it", () => {
  const panel = documentPanel(made().context, { word: "rules", title: "Rules", about: "The rules.", hasDocument: true });
  assert.equal(textOf(panel.view({})), "The rules.");
  assert.equal(textOf(panel.view({ rules: { document: [{ is: "empty", s: ["No rules. ", ["Write one.", "quiet"]] }] } })), "No rules. Write one.");
  assert.deepEqual([panel.badge!({}), panel.badge!({ rules: { document: [], badge: "3" } })], ["", "3"]);
});

test("texts have roles and send requests; markup in a text is shown as text", () => {
  const { view, asked } = made();
  const shown = view.view([{ is: "title", s: MARKUP }, { is: "text", s: ["by ", ["my*rule", "name", [{ request: "rule", rule: "my*rule" }, "rules"], "Look at it"], " at ", [30], ["Edit", "tag", [{ request: "edit", file: "a.soar", line: 3 }, "edit"]]] }]);
  assert.ok(all(shown).every((one) => one.tag !== "img"));
  assert.equal(textOf(shown), `${MARKUP}by my*rule at 0:01.00Edit`);
  press(shown, "my*rule");
  press(shown, "0:01.00");
  press(shown, "Edit");
  assert.deepEqual(asked, [["rule", { rule: "my*rule" }], "reveal rules", ["seek", { tick: 30 }], "flush", ["edit", { file: "a.soar", line: 3 }], "reveal edit"]);
});

test("texts have no links for a person who only watches", () => {
  const { view, asked } = made(false);
  press(view.view([{ is: "button", label: "Why?", do: [{ request: "ask", about: "agent" }, "why"] }]), "Why?");
  assert.deepEqual(asked, [["ask", { about: "agent" }]]);
});

test("a row of a table is pressed by its key, rows are filtered, grouped and sorted", () => {
  const { view, asked } = made();
  const shown = view.view([TABLE]);
  press(shown, "seek");
  assert.deepEqual(asked.splice(0), [["rule", { rule: "seek" }]]);
  assert.ok(all(shown).some((one) => one.tag === "tr" && one.classes === "chosen"));
  type(shown, "Filter by text", "FL");
  assert.deepEqual(firstCells(view.view([TABLE])), ["flee"]);
  type(shown, "Filter by text", "nothing like it");
  assert.match(textOf(view.view([TABLE])), /No rule matches/);
  type(shown, "Filter by text", "");
  type(shown, "Which rows are shown", "1");
  assert.deepEqual(firstCells(view.view([TABLE])), ["seek"]);
  type(shown, "Which rows are shown", "0");
  press(shown, "Fired");
  assert.deepEqual(firstCells(view.view([TABLE])), ["flee", "seek", MARKUP], "numbers begin with the greatest");
  press(view.view([TABLE]), "Fired ▾");
  assert.deepEqual(firstCells(view.view([TABLE])), [MARKUP, "seek", "flee"]);
  press(view.view([TABLE]), "Fired ▴");
  assert.deepEqual(firstCells(view.view([TABLE])), ["seek", "flee", MARKUP], "the first order is back");
});

test("deeper rows fold with their parent row", () => {
  const { view } = made();
  const table: Table = { is: "table", key: "operators", columns: [{ title: "Operator" }], rows: [{ k: "O1", c: ["seek"], open: false }, { k: "a", c: ["+ acceptable"], depth: 1 }, { k: "O2", c: ["rest"] }] };
  assert.deepEqual(firstCells(view.view([table])).map((text) => text.replace(/^[▸▾]/, "")), ["seek", "rest"]);
  press(view.view([table]), "Unfold seek");
  assert.deepEqual(firstCells(view.view([table])).map((text) => text.replace(/^[▸▾]/, "")), ["seek", "+ acceptable", "rest"]);
});

test("a tree with objects from the run unfolds by a request, other trees by themselves", () => {
  const { view, asked } = made();
  const memory: Tree = {
    is: "tree", key: "memory", label: "Working memory", press: { do: [{ request: "element", timetag: 0 }], field: "timetag" }, unfold: { do: [{ request: "object", id: "", is_open: true }], field: "id", argument: 1 },
    rows: [{ k: "S1", s: [["S1", "strong"]], a: ["S1"], open: true, below: [{ k: "9", s: [["+ ", "new"], ["^io", "name"], [" I1", "obj"]], a: ["I1"], open: false }] }],
  };
  const shown = view.view([memory]);
  press(shown, "Unfold + ^io I1");
  press(shown, "+ ^io I1");
  assert.deepEqual(asked.splice(0), [["object", { id: "I1", is_open: true }], ["element", { timetag: 9 }]]);
  assert.ok(all(shown).some((one) => one.tag === "li" && one.classes === "added"));
  const reasons: Tree = { is: "tree", key: "reasons", label: "Reasons", filter: "Filter", rows: [{ k: "0", s: "command seek", open: true, below: [{ k: "1", s: "given by a rule" }] }] };
  assert.match(textOf(view.view([reasons])), /given by a rule/);
  press(view.view([reasons]), "Fold command seek");
  assert.doesNotMatch(textOf(view.view([reasons])), /given by a rule/);
  type(view.view([reasons]), "Filter", "given");
  assert.match(textOf(view.view([reasons])), /command seek/, "what leads to a found row stays");
  type(view.view([reasons]), "Filter", "absent");
  assert.doesNotMatch(textOf(view.view([reasons])), /command seek/);
});

test("a form sends the typed text, and keeps it while the document's value is the same", () => {
  const { view, asked } = made();
  const nodes: Document = [{ is: "form", key: "new", do: [{ request: "break", kind: "fire", agent: "", what: "" }], button: "Add", clears: true, fields: [
    { kind: "choice", name: "kind", label: "What", options: [["fire", "a rule fires"], ["match", "a rule matches"]] }, { kind: "check", name: "agent", label: "only", options: [["", ""], ["scout", "scout"]] }, { kind: "line", name: "what", label: "Which", needed: true },
  ] }];
  const submit = (): void => all(view.view(nodes)).find((one) => one.tag === "form")!.props.on!.submit!({ preventDefault: () => {} } as SubmitEvent);
  submit();
  assert.deepEqual(asked, [], "what is needed is missing");
  type(view.view(nodes), "What", "match");
  all(view.view(nodes)).find((one) => one.props.attributes?.["type"] === "checkbox")!.props.on!.change!({ target: { checked: true } } as unknown as Event);
  type(view.view(nodes), "Which", " my*rule ");
  submit();
  assert.deepEqual(asked.splice(0), [["break", { kind: "match", agent: "scout", what: "my*rule" }], "redraw rules"]);
  submit();
  assert.deepEqual(asked, [], "the line is empty again");
});

test("a form without a button sends while the user types; a number is sent as a number", () => {
  const { view, asked } = made();
  const search: Document = [{ is: "form", key: "search", do: [{ request: "search-memory", text: "" }], fields: [{ kind: "line", name: "text", label: "Search" }] }];
  type(view.view(search), "Search", "io");
  const episode: Document = [{ is: "form", key: "episode", do: [{ request: "episode", number: 0 }], button: "Look", fields: [{ kind: "line", name: "number", label: "Episode" }] }];
  type(view.view(episode), "Episode", "3");
  all(view.view(episode)).find((one) => one.tag === "form")!.props.on!.submit!({ preventDefault: () => {} } as SubmitEvent);
  assert.deepEqual(asked, [["search-memory", { text: "io" }], ["episode", { number: 3 }]]);
});

test("pages, stories and columns are drawn; the page that was chosen stays", () => {
  const { view } = made();
  const nodes: Document = [
    { is: "tabs", key: "pages", first: 1, pages: [{ title: "Rules 0", hint: "", nodes: [{ is: "text", s: "none yet" }] }, { title: "Values 2", hint: "", nodes: [{ is: "code", tokens: [["sp", "command"], " {x"] }] }] },
    { is: "section", key: "rule", title: [["my*rule", "strong"]], story: true, nodes: [{ is: "text", s: [["before: ", "quiet"], ["nothing", "warn"]] }] },
    { is: "columns", parts: [{ is: "section", key: "a", title: "scout", nodes: [{ is: "line", nodes: [{ is: "button", label: "scout", on: true }] }] }] },
  ];
  assert.match(textOf(view.view(nodes)), /sp \{x.*my\*rule.*before.*nothing.*scout/s);
  press(view.view(nodes), "Rules 0");
  assert.match(textOf(view.view(nodes)), /none yet/);
});

test("a checklist says each result in words; progress has a bar; actions follow the rest", () => {
  const { view, asked } = made();
  const nodes: Document = [
    { is: "progress", text: "1 of 2 checks", value: 1, of: 2 },
    { is: "checklist", items: [{ k: "a", result: "passed", says: "passed", s: ["it waves ", [30]] }, { k: "b", result: "failed", says: "failed", s: "it rests", below: [["it never did", "bad"]], hint: "it should rest" }] },
    { is: "actions", nodes: [{ is: "button", label: "Grade", do: [{ request: "lesson", what: "grade" }], main: true }, { is: "button", label: "Hint 1 of 3", do: [{ request: "lesson", what: "hint" }] }, { is: "button", label: "Next lesson", do: [{ request: "lesson", what: "open", lesson: "02" }] }] },
  ];
  const shown = view.view(nodes);
  assert.match(textOf(shown), /passed: it waves 0:01\.00failed: it restsit never did/);
  assert.deepEqual(all(shown).filter((one) => one.tag === "progress").map((one) => [one.props.attributes!["value"], one.props.attributes!["max"]]), [[1, 2]]);
  for (const label of ["Grade", "Hint 1 of 3", "Next lesson"]) press(shown, label);
  assert.deepEqual(asked, ["grade", ["lesson", { what: "hint" }], "open lesson:02"], "the page applies texts before a grade, and opens lessons itself");
  assert.equal(find(shown, "Grade").classes, "primary");
  assert.equal(all(made(true, false).view.view(nodes)).filter((one) => one.tag === "button" && one.classes !== "link time").length, 0, "who watches cannot press them");
});

test("a command line is completed with Tab, sent with Enter, and brought back with the arrow keys", () => {
  const { view, asked } = made();
  const nodes = (agent: string, command: { completed_line: string; begin: number; words: string[]; common: string }, value = ""): Document => [
    { is: "transcript", key: `output ${agent}`, label: "Output", count: 2, lines: [["> print s1", "name"], "(S1 ^io I1)", ["a.soar:3: error", "bad", [{ request: "edit", file: "a.soar", line: 3 }, "edit"]]] },
    { is: "actions", nodes: [{ is: "form", key: `command ${agent}`, do: [{ request: "console", agent, line: "" }], button: "Send", clears: true, fields: [
      { kind: "command", name: "line", label: `A Soar command for ${agent}`, prompt: `${agent}>`, value, needed: true, command: { complete: [{ request: "complete", agent, line: "" }], keep: [{ request: "keep-line", agent, line: "" }], ...command } },
    ] }] },
  ];
  const none = { completed_line: "", begin: 0, words: [], common: "" };
  const field = (shown: Child): View => all(shown).find((one) => one.tag === "input")!;
  const key = (shown: Child, name: string): void => field(shown).props.on!.keydown!({ key: name, shiftKey: false, preventDefault: () => {} } as KeyboardEvent);
  const submit = (shown: Child): void => all(shown).find((one) => one.tag === "form")!.props.on!.submit!({ preventDefault: () => {} } as SubmitEvent);
  let shown = view.view(nodes("porter", none));
  assert.deepEqual(all(shown).filter((one) => one.tag === "li").map(textOf), ["> print s1", "(S1 ^io I1)", "a.soar:3: error"]);
  submit(shown);
  assert.deepEqual(asked, [], "an empty line is not sent");
  type(shown, "A Soar command for porter", "pri");
  assert.match(textOf(shown), /porter>Send/, "the prompt is shown");
  key(shown, "Tab");
  assert.deepEqual(asked.splice(0), [["complete", { agent: "porter", line: "pri" }]]);
  shown = view.view(nodes("porter", { completed_line: "pri", begin: 0, words: ["print", "prints"], common: "print" }));
  assert.equal(field(view.view(nodes("porter", none))).props.value, "print", "Tab inserts what all words have in common");
  press(shown, "prints");
  shown = view.view(nodes("porter", none));
  assert.equal(field(shown).props.value, "prints");
  asked.length = 0;
  field(shown).props.on!.change!({} as Event);
  assert.deepEqual(asked.splice(0), [["keep-line", { agent: "porter", line: "prints" }]]);
  type(shown, "A Soar command for porter", "print s1");
  assert.equal(field(view.view(nodes("anna", none, "begun"))).props.value, "begun", "another agent has its own line");
  assert.equal(field(view.view(nodes("porter", none))).props.value, "print s1", "and this one keeps its own");
  submit(shown);
  assert.deepEqual(asked[0], ["console", { agent: "porter", line: "print s1" }]);
  shown = view.view(nodes("porter", none));
  assert.equal(field(shown).props.value, "");
  key(shown, "ArrowUp");
  assert.equal(field(view.view(nodes("porter", none))).props.value, "print s1");
  key(shown, "ArrowDown");
  const other = view.view(nodes("anna", none, "begun"));
  type(other, "A Soar command for anna", "matches x");
  submit(other);
  key(shown, "ArrowUp");
  assert.equal(field(view.view(nodes("porter", none))).props.value, "matches x", "the newest line comes first, whichever agent it was for");
  key(shown, "ArrowDown");
  assert.equal(field(view.view(nodes("porter", none))).props.value, "");
});

test("a transcript follows its newest line unless the user reads earlier ones, and shows the answer to a sent line", () => {
  const { view } = made();
  const nodes = (count: number): Document => [
    { is: "transcript", key: "output porter", label: "Output", count, lines: ["a line"] },
    { is: "form", key: "command porter", do: [{ request: "console", agent: "porter", line: "" }], button: "Send", fields: [{ kind: "command", name: "line", label: "Command", value: "", command: {
      complete: [{ request: "complete", agent: "porter", line: "" }], keep: [{ request: "keep-line", agent: "porter", line: "" }], completed_line: "", begin: 0, words: [], common: "" } }] },
  ];
  const list = { scrollTop: 0, scrollHeight: 1000, clientHeight: 200, dataset: {} as Record<string, string> }, element = list as unknown as HTMLElement;
  const draw = (count: number, height: number, hook: "mounted" | "patched" = "patched"): number => {
    const shown = all(view.view(nodes(count))).find((one) => one.classes === "transcript")!;
    list.dataset["count"] = String(count);
    list.scrollHeight = height;
    shown.props[hook]!(element);
    list.scrollTop = Math.min(list.scrollTop, height - list.clientHeight);
    return list.scrollTop;
  };
  assert.equal(draw(1, 1000, "mounted"), 800);
  assert.equal(draw(2, 1500), 1300, "many lines at once are followed, too");
  list.clientHeight = 100;
  assert.equal(draw(2, 1500), 1400, "a lower panel shows the newest line, too");
  list.clientHeight = 200;
  list.scrollTop = 400;
  assert.equal(draw(3, 1600), 400, "who reads earlier lines is left alone");
  const shown = view.view(nodes(3));
  type(shown, "Command", "print s1");
  all(shown).find((one) => one.tag === "form")!.props.on!.submit!({ preventDefault: () => {} } as SubmitEvent);
  assert.equal(draw(3, 1600), 400, "the answer is not there yet");
  assert.equal(draw(4, 1700), 1500);
  list.scrollTop = 400;
  assert.equal(draw(5, 1800), 400, "once");
});

test("news of a section bring its panel to the front, but neither the first ones nor empty ones", () => {
  const { asked, context } = made();
  const panel = documentPanel(context, { word: "rules", title: "Rules", about: "", hasDocument: true });
  const told = (key: string, news: string): void => panel.note!({ rules: { document: [{ is: "section", key, title: news === "" ? "" : "Grade", nodes: [], news }] } });
  told("grade 01", "old");
  assert.deepEqual(asked, []);
  told("grade 01", "grading");
  told("grade 01", "grading");
  assert.deepEqual(asked.splice(0), ["reveal rules"]);
  told("grade 01", "");
  told("grade 02", "another lesson");
  assert.deepEqual(asked, []);
});

test("a strip of numbers chooses one and marks others", () => {
  const { view, asked } = made();
  const shown = view.view([{ is: "strip", key: "episode", label: "Episode", count: 4, chosen: 2, marks: [2, 4], mark: "recalled by rules", press: { do: [{ request: "episode", number: 0 }], field: "number" } }]);
  const field = all(shown).find((one) => one.props.attributes?.["type"] === "range")!;
  assert.equal(field.props.attributes!["aria-valuetext"], "Episode 2, recalled by rules");
  field.props.on!.input!({ target: { value: "3" } } as unknown as Event as never);
  assert.deepEqual(asked, [["episode", { number: 3 }]]);
  assert.deepEqual(all(shown).filter((one) => one.tag === "i").map((one) => one.props.style!["left"]), ["37.5%", "87.5%"]);
});

test("curves share their times", () => {
  const columns = columnsOf({ is: "plot", key: "p", title: "p", value: "", curves: [{ name: "a", points: [[0, 1], [30, 2]] }, { name: "b", points: [[15, 5]] }] }, 1 / 30);
  assert.deepEqual(columns, [[0, 0.5, 1], [1, null, 2], [null, 5, null]]);
  assert.equal(plainText(["a ", ["b", "good"], [30]]), "a b");
});
