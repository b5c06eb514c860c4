// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { Imagery, SceneAnswer, SceneNode, SceneQuestion } from "../run/contents";
import type { MakePanel, PanelContext } from "./panel";
import { empty, ruleLink, short, table, toggle } from "./parts";
import { reasonView } from "./why";

const placeText = (at: readonly number[]): string => at.map((one) => one.toFixed(2)).join(", ");
const tagsText = (node: SceneNode): string => Object.entries(node.tags).map(([name, value]) => `^${name} ${value}`).join(" ");
/** What it is about: its nodes, or what the filter was given. */
const aboutText = (one: SceneAnswer): string => (one.nodes.length > 0 ? one.nodes.join(", ") : one.why.text.replace(/^[^:]*: \S* ?/, ""));
/** A number without the digits that say nothing; other texts as they are. */
const valueText = (text: string): string => (text !== "" && Number.isFinite(Number(text)) ? short(Number(text)) : text);

/** What the agent imagines, and what of it is drawn over the world. */
export const imageryPanel: MakePanel = (context) => {
  const imagine = (state: string, record: string): void => {
    context.run.ask("imagine", { state, record });
  };
  const choice = (now: Imagery, state: string, label: string, title: string): View =>
    toggle(label, now.state === state, () => imagine(state, now.record), title);
  return {
    word: "imagery", title: "Imagery", about: "What the agent imagines: the scene of each state, what its rules ask of it, the answers, and why they are so.", uses: ["imagery", "moment"],
    view: (contents) => {
      const now = contents.imagery, moment = contents.moment;
      if (moment === undefined || moment.agent === "") return empty("No agent is selected. Select one to see what it imagines.");
      if (now === undefined || now.imagery.scenes.length === 0) return empty(moment.not_available || now?.imagery.note || "It imagines nothing.");
      return [
        h("div.row", { attributes: { role: "group", "aria-label": "What is drawn over the world" } }, h("span.quiet", null, "Draw"),
          choice(now, "", "made up", "What the agent made up in any state: what the world did not feed"),
          now.imagery.scenes.map((scene) => choice(now, scene.state, `all of ${scene.state}`, "The whole scene of this state"))),
        now.imagery.scenes.map((scene): Child => [
          h("h3", null, scene.state),
          scene.extracts.length === 0 ? h("p.quiet", null, "No rule asks anything of this scene.") : scene.extracts.map((one) => questionView(context, now, one, imagine)),
          h("details.nodes", { key: `nodes ${scene.state}`, open: now.imagery.scenes.length === 1 }, h("summary", null, `${scene.nodes.length} ${scene.nodes.length === 1 ? "node" : "nodes"}`), nodesView(scene.nodes)),
        ]),
      ];
    },
  };
};

function questionView(context: PanelContext, now: Imagery, question: SceneQuestion, imagine: (state: string, record: string) => void): View {
  const answer = (one: SceneAnswer): Child => {
    const isShown = one.record !== "" && now.record === one.record, text = [h("b", null, valueText(one.value)), h("span.quiet", null, ` ${aboutText(one)}`)];
    return h("li", { key: one.record === "" ? one.value : one.record },
      one.record === "" ? h("span", null, text) : button(text, () => imagine(now.state, isShown ? "" : one.record), {
        attributes: { "aria-expanded": String(isShown), title: one.lines.length === 0 ? "What it was made from" : "Show it in the picture, and what it was made from" },
      }, "button.link"),
      isShown && reasonView(context, one.why));
  };
  return h("div.question", { key: question.id },
    h("div", null, h("b", null, question.filter === "" ? question.command : question.filter), h("span.quiet", null, ` ${question.id}`), question.rule !== "" && [h("span.quiet", null, ", asked by "), ruleLink(context, question.rule)]),
    question.problem !== undefined && h("p.bad", null, `${question.problem}: ${question.hint ?? ""}`),
    question.filter !== "" && question.count === 0 && h("p.quiet", null, "no answer"),
    question.values.length > 0 && h("ul.plain", null, question.values.map(answer)),
    question.count > question.values.length && h("p.quiet", null, `and ${question.count - question.values.length} more`));
}

function nodesView(nodes: readonly SceneNode[]): View {
  return table(["Node", "At", "Tags"], nodes.map((node) => h("tr", { key: node.name },
    h("td", { style: { "padding-left": `${0.4 + 0.8 * node.depth}em` } }, node.name), h("td.quiet", null, node.depth === 0 ? "" : placeText(node.at)),
    h("td.quiet", null, `${node.shape === "hull" || node.depth === 0 ? "" : `${node.shape} `}${tagsText(node)}`))));
}
