// SPDX-License-Identifier: BSD-2-Clause
import uPlot from "uplot";
import { button, h } from "../dom/view";
import type { Series } from "../run/contents";
import type { MakePanel } from "./panel";
import { empty, lineField, rowForm, short } from "./parts";

const HEIGHT_PX = 150;

/** A series as uPlot takes it: seconds and values. */
export function columnsOf(series: Series, stepS: number): [number[], number[]] {
  return [series.points.map(([tick]) => tick * stepS), series.points.map(([, value]) => value)];
}

export const plotsPanel: MakePanel = (context) => {
  const drawn = new Map<string, { plot: uPlot; element: HTMLElement }>();
  let what = "";

  const draw = (key: string, element: HTMLElement, series: Series, step: number): void => {
    const width = element.clientWidth;
    if (width === 0) return;
    let known = drawn.get(key);
    if (known !== undefined && known.element !== element) {
      known.plot.destroy();
      known = undefined;
    }
    if (known === undefined) {
      const ink = getComputedStyle(element).color, axis = { stroke: ink, grid: { stroke: "rgba(128,128,128,0.2)", width: 1 }, ticks: { stroke: "rgba(128,128,128,0.3)", width: 1 } };
      const plot = new uPlot({
        width, height: HEIGHT_PX, scales: { x: { time: false } }, legend: { show: false }, axes: [{ ...axis, values: (_self, ticks) => ticks.map((tick) => `${tick} s`) }, { ...axis, size: 56 }],
        series: [{}, { stroke: "#3a8fd6", width: 2, points: { show: false } }],
      }, columnsOf(series, step), element);
      drawn.set(key, { plot, element });
      return;
    }
    if (known.plot.width !== width) known.plot.setSize({ width, height: HEIGHT_PX });
    known.plot.setData(columnsOf(series, step));
  };

  return {
    word: "plots", title: "Plots", about: "Numbers over time: percepts, reward, decision time, rules fired.", uses: ["plots", "moment"],
    view: (contents) => {
      const all = contents.plots?.plots ?? [], choices = contents.plots?.plottable ?? [], agent = contents.moment?.agent ?? "", step = contents.moment?.time.step_s ?? 1 / 30;
      for (const [key, { plot }] of drawn) {
        if (all.some((one) => `${one.agent}/${one.what}` === key)) continue;
        plot.destroy();
        drawn.delete(key);
      }
      return [
        rowForm(() => {
          if (what !== "" && agent !== "") context.run.ask("plot", { agent, what, is_on: true });
        }, lineField("What to plot", "health, speed, reward, self.speed …", what, (text) => (what = text), "plottable"),
        h("datalist", { attributes: { id: "plottable" } }, choices.map((one) => h("option", { attributes: { value: one } }))), h("button", { attributes: { type: "submit", disabled: agent === "" } }, agent === "" ? "Plot" : `Plot of ${agent}`)),
        all.length === 0 ? empty(agent === "" ? "Select an agent, and choose a number that is drawn over time." : "Choose a number above, such as health or a percept: it is drawn over time.")
          : all.map((one) => {
            const key = `${one.agent}/${one.what}`;
            return h("section.plot", { key }, h("div.row", null, h("h3", null, `${one.agent}: ${one.what}`), h("span.quiet", null, one.points.length === 0 ? "no values yet" : `${short(one.minimum)} to ${short(one.maximum)}, now ${short(one.points.at(-1)![1])}`),
              button("Remove", () => context.run.ask("plot", { agent: one.agent, what: one.what, is_on: false }), { attributes: { "aria-label": `Remove ${key}` } }, "button.small")),
            h("div.uplot-place", { foreign: true, mounted: (element) => draw(key, element, one, step), patched: (element) => draw(key, element, one, step) }));
          }),
      ];
    },
  };
};
