// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type View } from "../dom/view";
import type { Problem } from "../run/contents";
import { infoOf, type MakePanel, type PanelContext } from "./panel";
import { empty, moment } from "./parts";

export function problemView(context: PanelContext, one: Problem, ...more: View[]): View {
  const place = one.file === undefined ? "" : `${one.file.split("/").at(-1) ?? ""}${one.line === undefined ? "" : `:${one.line}`}${one.column === undefined ? "" : `:${one.column}`}`;
  return h(`li.problem.${one.severity}`, null,
    h("div.row", null, h("span.severity", null, one.severity), more, place !== "" && button(place, () => context.edit(one.file ?? "", one.line), { attributes: { title: "Edit it there" } }, "button.link")),
    h("p", null, one.message, one.more !== undefined && h("span.quiet", null, ` and ${one.more} more`)), one.excerpt !== undefined && h("pre", null, one.excerpt), one.hint !== undefined && h("p.hint", null, one.hint));
}

export const problemsPanel: MakePanel = (context) => ({
  ...infoOf("problems"), uses: ["problems"],
  badge: (contents) => {
    const count = (contents.problems?.problems ?? []).filter((one) => one.severity !== "note" && !context.attempt.isMended(one)).length;
    return count === 0 ? "" : String(count);
  },
  view: (contents) => {
    // The cause comes first, as ranked by the run. Corrected problems are removed.
    const all = (contents.problems?.problems ?? []).filter((one) => !context.attempt.isMended(one));
    if (all.length === 0) return empty("No problems. Errors and warnings about rules, scripts and commands would be listed here, with what to do about them.");
    return [h("div.row", null, button("Clear", () => context.run.ask("clear-problems"))), h("ul.plain", null, all.map((one) => problemView(context, one, h("b", null, one.agent), moment(context, one.tick, one.time_s))))];
  },
});
