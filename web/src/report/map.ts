// SPDX-License-Identifier: BSD-2-Clause
import { h, type Child, type View } from "../dom/view";
import { chart, paints } from "./chart";
import { positionAt, type PlaceReport, type RunReport, type ThingReport, type Way } from "./data";
import type { Time } from "./time";

type Anchor = "start" | "end";
interface Dot { x: number; y: number; name: string }
export interface NamePlace { dx: number; dy: number; anchor: Anchor }

const SIDES: readonly NamePlace[] = [[9, 4, "start"], [-9, 4, "end"], [9, 17, "start"], [9, -9, "start"], [-9, 17, "end"], [-9, -9, "end"], [9, 30, "start"], [9, -22, "start"]]
  .map(([dx, dy, anchor]) => ({ dx, dy, anchor }) as NamePlace);
const LETTER_PX = 7.2, DOT_PX = 7;

/** Positions of names next to dots in a square picture. If possible, a name covers no other name and no dot; it is always inside the picture. */
export function placeNames(dots: readonly Dot[], side: number): NamePlace[] {
  type Box = readonly [number, number, number, number];
  const boxes: Box[] = dots.map(({ x, y }) => [x - DOT_PX, y - DOT_PX, x + DOT_PX, y + DOT_PX]);
  return dots.map((dot, own) => {
    const width = LETTER_PX * dot.name.length;
    const boxAt = ({ dx, dy, anchor }: NamePlace): Box => {
      const left = dot.x + dx - (anchor === "end" ? width : 0);
      return [left, dot.y + dy - 11, left + width, dot.y + dy + 3];
    };
    const isInside = ([left, top, right, bottom]: Box): boolean => left >= 0 && top >= 0 && right <= side && bottom <= side;
    const isFree = (box: Box): boolean => boxes.every((other, i) => i === own || box[2] < other[0] || box[0] > other[2] || box[3] < other[1] || box[1] > other[3]);
    const inside = SIDES.filter((one) => isInside(boxAt(one))), place = inside.find((one) => isFree(boxAt(one))) ?? inside[0] ?? SIDES[0]!;
    boxes.push(boxAt(place));
    return place;
  });
}

export interface Extent { x: number; z: number; side: number }

/** A square that contains all paths and places, with a margin; null if there are none. */
export function extentOf(ways: readonly (Way | null)[], places: readonly PlaceReport[]): Extent | null {
  let x0 = Infinity, x1 = -Infinity, z0 = Infinity, z1 = -Infinity;
  const take = (x: number, z: number): void => {
    x0 = Math.min(x0, x);
    x1 = Math.max(x1, x);
    z0 = Math.min(z0, z);
    z1 = Math.max(z1, z);
  };
  for (const way of ways) way?.x.forEach((x, i) => take(x, way.z[i]!));
  for (const place of places) take(place.x, place.z);
  if (x0 > x1) return null;
  const span = Math.max(x1 - x0, z1 - z0), side = Math.max(span + 6, span * 1.14, 8);
  return { x: (x0 + x1) / 2 - side / 2, z: (z0 + z1) / 2 - side / 2, side };
}

const WIDEST_PX = 860;

/** The paths of all agents, seen from above, and their current positions. */
export function mapFigure(run: RunReport, ways: readonly (Way | null)[], time: Time): View {
  const extent = extentOf(ways, [...run.waypoints, ...run.regions]);
  if (extent === null) return h("p.quiet", null, "Nobody has a body here.");
  const paint = paints(run.agents);
  const caption = `The paths of all bodies, seen from above; the map is ${Math.round(extent.side)} m wide. The dots show where the bodies are at the slider's time.`;
  return chart({ label: `Map of ${run.agents.length} agents and their paths`, caption, id: "ways", most: WIDEST_PX, time }, (width) => {
    const m = (metres: number): number => (metres / extent.side) * width, x = (at: number): number => m(at - extent.x), y = (at: number): number => m(at - extent.z);
    const quiet = { fill: "none", stroke: "var(--quiet)" }, dashed = { ...quiet, "stroke-dasharray": "4 4" };
    const thing = (one: ThingReport): Child => one.round ? h("circle", { attributes: { cx: x(one.x), cy: y(one.z), r: m(one.w / 2), fill: "var(--line)" } })
      : h("rect", { attributes: { x: x(one.x - one.w / 2), y: y(one.z - one.d / 2), width: m(one.w), height: m(one.d), fill: "var(--line)", transform: `rotate(${-one.turn} ${x(one.x)} ${y(one.z)})` } });
    const region = (one: PlaceReport): Child => [
      one.hx > 0 ? h("rect", { attributes: { ...dashed, x: x(one.x - one.hx), y: y(one.z - one.hz), width: m(2 * one.hx), height: m(2 * one.hz) } }) : h("circle", { attributes: { ...dashed, cx: x(one.x), cy: y(one.z), r: m(one.r) } }),
      h("text.quiet", { attributes: { x: x(one.x), y: y(one.z) - 4, "text-anchor": "middle" } }, one.name)];
    const waypoint = (one: PlaceReport): Child => [h("circle", { attributes: { ...quiet, cx: x(one.x), cy: y(one.z), r: 5 } }), h("text.quiet", { attributes: { x: x(one.x) + 8, y: y(one.z) + 4 } }, one.name)];
    const path = (way: Way | null, i: number): Child => {
      if (way === null) return null;
      let d = "", lastX = Infinity, lastZ = Infinity;
      way.x.forEach((at, k) => {
        const z = way.z[k]!;
        if (d !== "" && k < way.x.length - 1 && Math.hypot(at - lastX, z - lastZ) < extent.side / 500) return;
        d += `${d === "" ? "M" : "L"}${x(at).toFixed(1)} ${y(z).toFixed(1)}`;
        [lastX, lastZ] = [at, z];
      });
      return h("path", { attributes: { d, fill: "none", stroke: paint[i]!.color, "stroke-width": 1.5, "stroke-dasharray": paint[i]!.dash, "stroke-opacity": 0.6 } });
    };
    const dots = (seconds: number): Child => {
      const there = ways.flatMap((way, i) => (way === null ? [] : [{ ...positionAt(way, run.times, seconds), i }])).map((one) => ({ ...one, x: x(one.x), y: y(one.z), name: run.agents[one.i]!.name }));
      const names = placeNames(there, width);
      return there.map((one, n) => h("g.dot", { key: String(one.i), attributes: { transform: `translate(${one.x.toFixed(1)} ${one.y.toFixed(1)})`, opacity: one.isAlive ? 1 : 0.4 } },
        h("circle", { attributes: { r: 6, fill: paint[one.i]!.color, stroke: "var(--card)", "stroke-width": 1.5 } }), h("text", { attributes: { x: names[n]!.dx, y: names[n]!.dy, "text-anchor": names[n]!.anchor } }, one.name)));
    };
    return { height: width, children: [run.things.map(thing), run.regions.map(region), run.waypoints.map(waypoint), ways.map(path)], at: dots };
  });
}
