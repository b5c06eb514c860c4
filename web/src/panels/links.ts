// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type View } from "../dom/view";
import type { MemoryObject, MemoryRow } from "../run/contents";
import type { MakePanel, PanelContext } from "./panel";
import { elementRow, lacksMind, noMind } from "./parts";

function treeOf(context: PanelContext, rows: readonly MemoryRow[]): View {
  return h("ul.tree", null, rows.map((row) => {
    const line = elementRow(row, () => {
      context.run.ask("element", { timetag: row.timetag });
      context.reveal("memory");
    });
    const key = String(row.timetag), change = row.change === undefined ? "" : `.${row.change}`;
    return (row.elements ?? []).length === 0 ? h(`li${change}`, { key }, line) : h(`li${change}`, { key }, h("details", { open: true }, h("summary", null, line), treeOf(context, row.elements ?? [])));
  }));
}

function linkView(context: PanelContext, title: string, object: MemoryObject): View {
  return h("section", null, h("h3", null, `${title} ${object.id}`), object.note !== undefined && h("p.quiet", null, object.note), treeOf(context, object.elements));
}

export const linksPanel: MakePanel = (context) => ({
  word: "links", title: "Senses", about: "What the agent perceives (input link) and which commands it gives (output link).", uses: ["links", "moment"],
  view: (contents) => {
    const io = contents.links?.io;
    if (io === undefined || lacksMind(context, contents)) return noMind(context, contents, "Select an agent with a Soar mind: what it perceives and what it commands is shown here.");
    return [
      io.commands.length > 0 && h("table", null, h("caption", null, "Commands"), h("tbody", null, io.commands.map((one) => h("tr", { key: `${one.timetag}` }, h("td", null, h("b", null, one.command)), h("td", null, one.parameters),
        h("td", null, one.status, one.progress !== undefined && h("progress", { attributes: { max: 1, value: one.progress, "aria-label": `${one.command} is under way` } }), one.reason !== undefined && h("span.warn", null, ` ${one.reason}`)),
        h("td", null, button("Why?", () => context.why("command", one.command), { attributes: { "aria-label": `Why ${one.command}?` } }, "button.small")))))),
      linkView(context, "Input link", io.input), linkView(context, "Output link", io.output),
    ];
  },
});
