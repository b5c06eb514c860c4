// SPDX-License-Identifier: BSD-2-Clause
import { h, type View } from "../dom/view";

/** A world from above in its first tick (make_maps.py), in 1/200 of its width. A thing: x, z, width, depth (0: round), turn in degrees. */
export interface WorldMap { things: readonly (readonly number[])[]; agents: readonly (readonly number[])[] }
export type WorldMaps = Readonly<Record<string, WorldMap>>;

const WIDTH = 200, LARGEST_DOT = 9, SMALLEST_DOT = 4;
/** Colours of the first agents; a single agent has the first one. */
const COLORS = ["#d9481c", "#1f6fc4", "#7a3fb0", "#0f8a6c", "#b8860b", "#c2347f"] as const;

/** The picture on a card; null if the world has no map. */
export function worldMap(map: WorldMap | undefined): View | null {
  if (map === undefined || map.things.length + map.agents.length === 0) return null;
  const r = map.agents.length > 12 ? SMALLEST_DOT : LARGEST_DOT;
  return h("svg.map", { attributes: { viewBox: `0 0 ${WIDTH} ${WIDTH}`, "aria-hidden": "true", focusable: "false" } },
    map.things.map(([x = 0, z = 0, width = 0, depth = 0, turn = 0]) => depth === 0 ? h("circle.thing", { attributes: { cx: x, cy: z, r: width / 2 } })
      : h("rect.thing", { attributes: { x: x - width / 2, y: z - depth / 2, width, height: depth, transform: `rotate(${-turn} ${x} ${z})` } })),
    map.agents.map(([x = 0, z = 0], i) => h("circle.agent", { attributes: { cx: x, cy: z, r, fill: COLORS[i % COLORS.length]!, "stroke-width": r / 4 } })));
}
