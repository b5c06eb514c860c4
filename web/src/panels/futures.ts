// SPDX-License-Identifier: BSD-2-Clause
import { h } from "../dom/view";
import type { MakePanel } from "./panel";
import { clock, empty, numberHead, short, table } from "./parts";

export const futuresPanel: MakePanel = () => ({
  word: "futures", title: "Futures", about: "After going back: the old future beside the new one, and where they differ.", uses: ["futures", "moment"],
  view: (contents) => {
    const futures = contents.futures?.futures ?? null, step = contents.moment?.time.step_s ?? 1 / 30;
    if (futures === null) return empty("Go back to a past moment, change something, and press Go on from here. What became different is shown here.");
    const steps = Math.max(1, Math.ceil(futures.course.length / 60));
    return [
      h("p", null, `You went on from ${clock(futures.branch_tick * step)}.`, !futures.old_is_known && " The old future is not known that far."),
      Array.isArray(futures.percepts) ? h("ul.plain", null, futures.percepts.map((line) => h("li", null, line))) : typeof futures.percepts === "string" && h("p", null, futures.percepts),
      table(["Time", numberHead("Apart (m)"), "Furthest", ...["Health, old", "new", "Alive, old", "new"].map(numberHead)],
        futures.course.filter((_, i) => i % steps === 0).map((one) => h("tr", null, h("td", null, clock(one.time_s)), h("td.number", null, short(one.mean_distance_m)), h("td", null, one.farthest),
          h("td.number", null, short(one.health_old)), h("td.number", null, short(one.health_new)), h("td.number", null, one.alive_old), h("td.number", null, one.alive_new)))),
    ];
  },
});
