// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type View } from "../dom/view";
import type { MemoryObject, MemoryRow } from "../run/contents";
import type { MakePanel, PanelContext } from "./panel";
import { elementRow, lacksMind, noMind } from "./parts";

/** Elements whose objects are folded, by their time tags. */
type Folded = Set<number>;

function foldButton(context: PanelContext, row: MemoryRow, folded: Folded): View {
  const isOpen = !folded.has(row.timetag);
  return button(isOpen ? "▾" : "▸", () => {
    if (!folded.delete(row.timetag)) folded.add(row.timetag);
    context.redraw("links");
  }, { attributes: { "aria-expanded": String(isOpen), "aria-label": `${isOpen ? "Fold" : "Unfold"} ^${row.attribute} ${row.value}` } }, "button.fold");
}

function treeOf(context: PanelContext, rows: readonly MemoryRow[], folded: Folded): View {
  return h("ul.tree", null, rows.map((row) => {
    const line = elementRow(row, () => {
      context.run.ask("element", { timetag: row.timetag });
      context.reveal("memory");
    });
    const key = String(row.timetag), change = row.change === undefined ? "" : `.${row.change}`;
    return (row.elements ?? []).length === 0 ? h(`li${change}`, { key }, line) : h(`li${change}`, { key }, [h("div.fold-row", null, foldButton(context, row, folded), line), !folded.has(row.timetag) && treeOf(context, row.elements ?? [], folded)]);
  }));
}

function linkView(context: PanelContext, title: string, object: MemoryObject, folded: Folded): View {
  return h("section", null, h("h3", null, `${title} ${object.id}`), object.note !== undefined && h("p.quiet", null, object.note), treeOf(context, object.elements, folded));
}

export const linksPanel: MakePanel = (context) => {
  const folded: Folded = new Set();
  return {
  word: "links", title: "Senses", about: "What the agent perceives (input link) and which commands it gives (output link).", uses: ["links", "moment"],
  view: (contents) => {
    const io = contents.links?.io;
    if (io === undefined || lacksMind(context, contents)) return noMind(context, contents, "Select an agent with a Soar mind: what it perceives and what it commands is shown here.");
    return [
      io.commands.length > 0 && h("table", null, h("caption", null, "Commands"), h("tbody", null, io.commands.map((one) => h("tr", { key: `${one.timetag}` }, h("td", null, h("b", null, one.command)), h("td", null, one.parameters),
        h("td", null, one.status, one.progress !== undefined && h("progress", { attributes: { max: 1, value: one.progress, "aria-label": `${one.command} is under way` } }), one.reason !== undefined && h("span.warn", null, ` ${one.reason}`)),
        h("td", null, button("Why?", () => context.why("command", one.command), { attributes: { "aria-label": `Why ${one.command}?` } }, "button.small")))))),
      linkView(context, "Input link", io.input, folded), linkView(context, "Output link", io.output, folded),
    ];
  },
  };
};
