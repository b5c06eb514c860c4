// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { Contents, WhyNode } from "../run/contents";
import type { MakePanel, PanelContext } from "./panel";
import { empty, lineField, moment, rowForm } from "./parts";

/** What a link of a reason leads to; null: it cannot be asked about. */
function asks(node: WhyNode): { about: string; title: string } | null {
  if (node.link === undefined || node.link === "") return null;
  switch (node.kind) {
    case "agent": return { about: "agent", title: "Why does it do what it does?" };
    case "operator": return { about: "operator", title: "Why this operator?" };
    case "command": return { about: "command", title: "Why this command?" };
    case "element": case "percept": return { about: "element", title: "Why is this element there?" };
    default: return null;
  }
}

/** A time that goes to that moment, if the run can go back. */
function goTo(context: PanelContext, seconds: number): Child {
  const now = context.run.contents.moment?.time;
  return now !== undefined && now.can_go_back && moment(context, Math.round(seconds / now.step_s), seconds);
}

/** A tree of reasons; those near the top are unfolded. */
export function reasonView(context: PanelContext, node: WhyNode, depth = 0): View {
  const below = node.below ?? [], ask = asks(node);
  const text = h("span.text", null, node.text), tools = [
    ask !== null && button("Why?", () => context.why(ask.about, node.link), { attributes: { title: ask.title, "aria-label": `Why? ${node.text}` } }, "button.small"),
    node.time !== undefined && goTo(context, node.time),
    (node.kind === "rule" || node.kind === "learned") && node.link !== undefined && node.link !== "" && button("Rule", () => {
      context.run.ask("rule", { rule: node.link });
      context.reveal("rules");
    }, { attributes: { title: `Look at ${node.link}`, "aria-label": `Look at the rule ${node.link}` } }, "button.small"),
    node.kind === "imagined" && node.link !== undefined && node.link !== "" && button("Show", () => {
      context.run.ask("imagine", { state: context.run.contents.imagery?.state ?? "", record: node.link });
      context.reveal("imagery");
    }, { attributes: { title: "Show it in the picture", "aria-label": `Show in the picture: ${node.text}` } }, "button.small"),
  ].filter((one) => one !== false);
  if (below.length === 0) return h(`div.reason.${node.kind}`, null, text, tools);
  // What can be pressed stands beside what is folded: a summary holds text alone.
  return h(`div.reason.folds.${node.kind}`, null, tools.length > 0 && h("span.tools", null, tools), h(`details${tools.length > 0 ? `.with-tools.n${tools.length}` : ""}`, { open: depth < 3 }, h("summary", null, text), below.map((one) => reasonView(context, one, depth + 1))));
}

export const whyPanel: MakePanel = (context) => {
  let about = "";
  const form = (contents: Contents): View => {
    const agent = contents.moment?.agent ?? "";
    const send = (kind: string): void => {
      if (about.trim() !== "") context.run.ask("ask", { about: kind, what: about.trim() });
    };
    return rowForm(() => send("not"),
      button("Why this?", () => context.why("agent"), { attributes: { disabled: agent === "", title: "Why does the selected agent do what it does?" } }),
      lineField("What to ask about", "a rule, operator or command", about, (text) => (about = text)),
      h("button", { attributes: { type: "submit", disabled: agent === "", title: "Why does it not happen?" } }, "Why not?"));
  };
  return {
    word: "why", title: "Why", about: "Why the agent does what it does, and why it does not do something else.", uses: ["why", "moment"],
    view: (contents) => {
      const why = contents.why;
      if (why === undefined || why.question === "")
        return [form(contents), empty("Ask why the selected agent does what it does. Or type a rule, an operator or a command that you expected, and ask why it is not there.")];
      return [form(contents), h("h3", null, why.question), why.answer === null ? empty("There is no answer: what you ask about is not there now.") : reasonView(context, why.answer)];
    },
  };
};
