// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { ElementStory, Memory, MemoryRow } from "../run/contents";
import type { MakePanel, PanelContext } from "./panel";
import { elementLink, elementRow, elementText, filterField, makerView, lacksMind, noMind, ruleLink, story as storyOf } from "./parts";

const DEEPEST = 12;

function foldButton(context: PanelContext, id: string, isOpen: boolean): View {
  return button(isOpen ? "▾" : "▸", () => context.run.ask("object", { id, is_open: !isOpen }), { attributes: { "aria-label": `${isOpen ? "Fold" : "Unfold"} ${id}` } }, "button.fold");
}

function rowView(context: PanelContext, memory: Memory, row: MemoryRow, path: readonly string[]): View {
  const change = row.change === undefined ? "" : `.${row.change}`, object = memory.objects[row.value], isOpen = object !== undefined;
  const isLoop = path.includes(row.value) || path.length > DEEPEST;
  return h(`li${change}`, { key: String(row.timetag), attributes: { role: "treeitem", "aria-expanded": row.object === true && !isLoop ? isOpen : undefined } },
    row.object === true && !isLoop ? foldButton(context, row.value, isOpen) : h("span.fold", null, " "),
    elementRow(row, () => context.run.ask("element", { timetag: row.timetag })),
    isOpen && !isLoop && objectView(context, memory, row.value, path));
}

function objectView(context: PanelContext, memory: Memory, id: string, path: readonly string[]): Child {
  const object = memory.objects[id];
  if (object === undefined) return null;
  return h("ul.tree", { attributes: { role: "group" } }, object.elements.map((row) => rowView(context, memory, row, [...path, id])), object.note !== undefined && h("li.quiet", null, object.note));
}

function storyView(context: PanelContext, story: ElementStory): View {
  return storyOf(elementText(story), "element", () => context.run.ask("element", { timetag: 0 }), button("Why?", () => context.why("element", String(story.timetag)), {}, "button.small"),
    h("p.quiet", null, `time tag ${story.timetag}`), story.note !== undefined && h("p.quiet", null, story.note),
    story.made_by.map((maker) => makerView(context, maker)),
    story.tested_by.length > 0 && h("ul.plain", null, story.tested_by.map((one) => h("li", null, "tested by ", ruleLink(context, one.rule),
      h("span.quiet", null, `, condition ${one.condition}${one.negated ? ", negated" : ""}${one.matches ? ", which matches" : ""}`)))));
}

export const memoryPanel: MakePanel = (context) => {
  let search = "", unfolded = "";
  return {
    word: "memory", title: "Memory", about: "Working memory as a tree; what changed is marked.", uses: ["memory", "moment"],
    view: (contents) => {
      const memory = contents.memory;
      const field = filterField("Search in memory", search, (text) => {
        search = text;
        context.run.ask("search-memory", { text });
      });
      if (memory === undefined || lacksMind(context, contents) || memory.stack.states.length === 0) return [field, noMind(context, contents, "Select an agent with a Soar mind: its working memory is shown here as a tree.")];
      // The topmost state is unfolded to begin with.
      const agent = contents.moment?.agent ?? "", top = memory.stack.states[0]!.state;
      if (agent !== unfolded && agent !== "") {
        unfolded = agent;
        if (memory.objects[top] === undefined) context.run.ask("object", { id: top, is_open: true });
      }
      return [
        field,
        memory.element !== null && storyView(context, memory.element),
        search !== "" && h("section", null, h("h3", null, `${memory.found.length} elements with “${search}”`), h("ul.plain", null, memory.found.map((one) => h("li", null, elementLink(context, one))))),
        h("ul.tree.top", { attributes: { role: "tree", "aria-label": "Working memory" } }, memory.stack.states.map((state) => {
          const isOpen = memory.objects[state.state] !== undefined;
          return h("li", { key: state.state, attributes: { role: "treeitem", "aria-expanded": isOpen } },
            foldButton(context, state.state, isOpen),
            h("b", null, state.state), state.impasse !== "" && h("span.warn", null, ` ${state.impasse}`), isOpen && objectView(context, memory, state.state, []));
        })),
      ];
    },
  };
};
