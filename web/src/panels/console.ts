// SPDX-License-Identifier: BSD-2-Clause
import { button, h } from "../dom/view";
import { infoOf, type MakePanel } from "./panel";
import { noMind } from "./parts";

export const consolePanel: MakePanel = (context) => {
  let line = "", place = 0, asked = "";
  const history: string[] = [];
  return {
    ...infoOf("console"), uses: ["console", "moment"],
    view: (contents) => {
      const agent = contents.moment?.agent ?? "", lines = contents.console?.lines ?? [], completion = contents.console?.completion;
      if (agent === "") return noMind(context, contents, "Select an agent: you can give the kernel of its mind commands here, such as print s1 or matches my*rule, and its script Lua, such as lua agent:GetPosition().");
      const words = completion !== undefined && contents.console?.completed_line === asked && asked !== "" && line === asked ? completion.words : [];
      const take = (word: string): void => {
        line = line.slice(0, completion?.begin ?? line.length) + word;
        asked = "";
        context.redraw("console");
      };
      if (words.length > 0 && completion !== undefined && completion.common.length > line.length - completion.begin) take(completion.common);
      return [
        h("ol.console", { attributes: { "aria-label": "Output", "aria-live": "polite" }, patched: (element) => {
          if (element.scrollHeight - element.scrollTop - element.clientHeight < 80) element.scrollTop = element.scrollHeight;
        } }, lines.length === 0 && h("li.hint", null, "Type a Soar command: print s1, matches RULE, preferences, help ..."), lines.map((one) => h(`li.${one.kind}`, null, one.kind === "input" ? `${agent}> ${one.text}` : one.text))),
        words.length > 1 && h("div.row.words", null, words.slice(0, 24).map((word) => button(word, () => take(word), {}, "button.small"))),
        h("form.row", { on: { submit: (event) => {
          event.preventDefault();
          if (line.trim() === "") return;
          if (!context.run.ask("console", { agent, line })) return;
          history.push(line);
          place = history.length;
          line = "";
          context.redraw("console");
        } } }, h("input", {
          value: line, attributes: { type: "text", "aria-label": `A Soar command for ${agent}`, placeholder: `${agent}>`, spellcheck: "false", autocomplete: "off", autocapitalize: "off" },
          on: {
            input: (event) => (line = (event.target as HTMLInputElement).value),
            keydown: (event) => {
              if (event.key === "Tab" && !event.shiftKey && line !== "") {
                event.preventDefault();
                asked = line;
                context.run.ask("complete", { agent, line });
              } else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
                event.preventDefault();
                place = Math.min(Math.max(place + (event.key === "ArrowUp" ? -1 : 1), 0), history.length);
                line = history[place] ?? "";
                context.redraw("console");
              }
            },
          },
        }), h("button", { attributes: { type: "submit" } }, "Send"), button("Clear", () => context.run.ask("clear-console"))),
      ];
    },
  };
};
