// SPDX-License-Identifier: BSD-2-Clause
import uPlot from "uplot";
import { h, type Child, type View } from "../dom/view";
import type { Document, Plot } from "./document";

const HEIGHT_PX = 150, COLORS = ["#3a8fd6", "#e08a1e", "#1d9e74", "#cc79a7", "#b8a500", "#d5541a"];

/** The columns that uPlot takes: seconds, and the values of each curve at these times; null where it has none. */
export function columnsOf(plot: Plot, stepS: number): (number | null)[][] {
  const ticks = [...new Set(plot.curves.flatMap((curve) => curve.points.map(([tick]) => tick)))].sort((a, b) => a - b);
  const at = new Map(ticks.map((tick, i) => [tick, i]));
  return [ticks.map((tick) => tick * stepS), ...plot.curves.map((curve) => {
    const values: (number | null)[] = new Array<number | null>(ticks.length).fill(null);
    for (const [tick, value] of curve.points) values[at.get(tick)!] = value;
    return values;
  })];
}

/** Curves over the time of the run, drawn by uPlot; they stay while their documents have them. */
export class PlotViews {
  private readonly drawn = new Map<string, { plot: uPlot; element: HTMLElement; curves: number }>();

  /** Releases plots that the document no longer contains. */
  keep(nodes: Document): void {
    const text = this.drawn.size === 0 ? "" : JSON.stringify(nodes);
    for (const [key, { plot }] of this.drawn) {
      if (text.includes(JSON.stringify(key))) continue;
      plot.destroy();
      this.drawn.delete(key);
    }
  }

  view(plot: Plot, stepS: number, tool: Child): View {
    const draw = (element: HTMLElement): void => this.draw(plot, element, stepS);
    const hasPoints = plot.curves.some((curve) => curve.points.length > 0);
    return h("section.plot", { key: plot.key }, h("div.row", null, h("h3", null, plot.title), h("span.quiet", null, plot.range === undefined ? plot.value : `${plot.value} (${plot.range})`), tool),
      plot.curves.length > 1 && h("p.legend", null, plot.curves.map((curve, i) => h("span", { style: { color: COLORS[i % COLORS.length]! } }, `— ${curve.name} `))),
      hasPoints && h("div.uplot-place", { foreign: true, mounted: draw, patched: draw }));
  }

  private draw(plot: Plot, element: HTMLElement, stepS: number): void {
    const width = element.clientWidth, columns = columnsOf(plot, stepS) as uPlot.AlignedData;
    if (width === 0) return;
    let known = this.drawn.get(plot.key);
    if (known !== undefined && (known.element !== element || known.curves !== plot.curves.length)) {
      known.plot.destroy();
      known = undefined;
    }
    if (known === undefined) {
      const ink = getComputedStyle(element).color, axis = { stroke: ink, grid: { stroke: "rgba(128,128,128,0.2)", width: 1 }, ticks: { stroke: "rgba(128,128,128,0.3)", width: 1 } };
      const paths = plot.stepped === true ? uPlot.paths.stepped?.({ align: 1 }) : undefined;
      this.drawn.set(plot.key, { element, curves: plot.curves.length, plot: new uPlot({
        width, height: HEIGHT_PX, scales: { x: { time: false } }, legend: { show: false }, axes: [{ ...axis, values: (_self, ticks) => ticks.map((tick) => `${tick} s`) }, { ...axis, size: 56 }],
        series: [{}, ...plot.curves.map((_, i) => ({ stroke: COLORS[i % COLORS.length]!, width: 2, spanGaps: true, points: { show: false }, ...(paths === undefined ? {} : { paths }) }))],
      }, columns, element) });
      return;
    }
    if (known.plot.width !== width) known.plot.setSize({ width, height: HEIGHT_PX });
    known.plot.setData(columns);
  }
}
