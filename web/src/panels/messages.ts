// SPDX-License-Identifier: BSD-2-Clause
import { h } from "../dom/view";
import type { MakePanel } from "./panel";
import { agentLink, empty, filterField, moment, passes, table } from "./parts";

export const messagesPanel: MakePanel = (context) => {
  let filter = "";
  return {
    word: "messages", title: "Messages", about: "What agents said to each other.", uses: ["messages"],
    view: (contents) => {
      const all = contents.messages?.messages ?? [];
      if (all.length === 0) return empty("Nobody has said anything yet. An agent speaks when its mind gives the command broadcast or send.");
      const shown = all.filter((one) => passes(filter, `${one.from} ${one.to} ${one.about} ${one.text}`)).slice().reverse();
      return [filterField("Filter by text", filter, (text) => {
        filter = text;
        context.redraw("messages");
      }), table(["Time", "From", "To", "About", "Text"],
        shown.map((one) => h("tr", null, h("td", null, moment(context, one.tick, one.time_s)), h("td", null, agentLink(context, one.from)), h("td", null, one.to), h("td", null, one.about), h("td", null, one.text))))];
    },
  };
};
