// SPDX-License-Identifier: BSD-2-Clause
import type { Drawables } from "../format/drawables";
import { Shape, type Scene, type Vec3 } from "../format/scene";
import { clamp, dot, length, minus, plus, rotate, times } from "./vectors";

/** Something that the picture is to show: its middle in m, its velocity in m/s, radius and height in m. */
export interface FramedBody { readonly place: Vec3; readonly velocity: Vec3; readonly radius: number; readonly height: number }
/** A camera at `target` plus `away` metres against the direction of view. `heading` 0 looks north, `tilt` 0 looks along the ground. In rad. */
export interface View { target: [number, number, number]; heading: number; tilt: number; away: number }
/** The free part of the picture, from its middle to each edge: 1 is the complete half. */
export interface Free { readonly left: number; readonly right: number; readonly top: number; readonly bottom: number }
/** The picture: `slope` is the tangent of half its vertical angle. */
export interface Lens { readonly slope: number; readonly aspect: number; readonly free: Free }

export const ALL_FREE: Free = { left: 1, right: 1, top: 1, bottom: 1 };
const NO_MOVE: Vec3 = [0, 0, 0];

/** Free parts of the picture in which bodies are framed: the rest is a margin for names. */
const MARGIN_X = 0.86, MARGIN_Y = 0.8;
/** A single agent does not fill the picture: the camera stays this far away, in m. */
const LEAST_AWAY_M = 6.5;
/** Maximum distances of the camera, in m: to show places, to show scenery, and to show agents. */
const PLACES_WITHIN_M = 46, SCENERY_WITHIN_M = 58, FURTHEST_M = 260;
const PLACE_RADIUS_M = 0.6, PLACE_HEIGHT_M = 0.6;
/** Maximum distance of scenery from the agents, its maximum length, in m, and its maximum number; a world with more has none. */
const BESIDE_M = 6, LONGEST_PIECE_M = 16, MOST_PIECES = 100;

interface Axes { right: Vec3; up: Vec3; ahead: Vec3 }

export function axesOf(heading: number, tilt: number): Axes {
  const sh = Math.sin(heading), ch = Math.cos(heading), st = Math.sin(tilt), ct = Math.cos(tilt);
  return { right: [ch, 0, -sh], up: [-st * sh, ct, -st * ch], ahead: [-ct * sh, -st, -ct * ch] };
}

export function eyeOf(view: View): Vec3 {
  return minus(view.target, times(axesOf(view.heading, view.tilt).ahead, view.away));
}

export function middleOf(bodies: readonly FramedBody[]): Vec3 {
  const low: [number, number, number] = [Infinity, Infinity, Infinity], high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const { place } of bodies) for (let axis = 0; axis < 3; ++axis) low[axis] = Math.min(low[axis]!, place[axis]!), high[axis] = Math.max(high[axis]!, place[axis]!);
  return times(plus(low, high), 0.5);
}

const ends = ({ place, height }: FramedBody): readonly [Vec3, Vec3] => [[place[0], place[1] - height / 2, place[2]], [place[0], place[1] + height / 2, place[2]]];

/** The nearest view in this direction that shows all the bodies in the free part of the picture. */
export function framingView(bodies: readonly FramedBody[], heading: number, tilt: number, lens: Lens): View {
  const { right, up, ahead } = axesOf(heading, tilt), { free } = lens, wide = MARGIN_X * lens.slope * Math.max(lens.aspect, 0.2), high = MARGIN_Y * lens.slope;
  const slopeRight = wide * free.right, slopeLeft = wide * free.left, slopeTop = high * free.top, slopeBottom = high * free.bottom;
  // Each point keeps the camera behind two planes per direction; the outermost planes determine its position.
  let toRight = -1e9, toLeft = -1e9, toTop = -1e9, toBottom = -1e9, nearest = 1e9;
  for (const body of bodies) {
    const reach = 2 * body.radius;
    for (const at of ends(body)) {
      const x = dot(at, right), y = dot(at, up), z = dot(at, ahead);
      toRight = Math.max(toRight, x + reach - z * slopeRight);
      toLeft = Math.max(toLeft, reach - x - z * slopeLeft);
      toTop = Math.max(toTop, y + reach - z * slopeTop);
      toBottom = Math.max(toBottom, reach - y - z * slopeBottom);
      nearest = Math.min(nearest, z);
    }
  }
  const depth = Math.min(-(toRight + toLeft) / (slopeRight + slopeLeft), -(toTop + toBottom) / (slopeTop + slopeBottom), nearest - LEAST_AWAY_M);
  // If there is room to spare, the bodies are in the middle of the free area.
  const x = (toRight + slopeRight * depth - toLeft - slopeLeft * depth) / 2, y = (toTop + slopeTop * depth - toBottom - slopeBottom * depth) / 2;
  const eye = plus(plus(times(right, x), times(up, y)), times(ahead, depth)), away = Math.max(dot(minus(middleOf(bodies), eye), ahead), 1);
  const [tx, ty, tz] = plus(eye, times(ahead, away));
  return { target: [tx, ty, tz], heading, tilt, away };
}

/** Whether head and feet are in this share of the free part of the picture. */
export function isInside(body: FramedBody, at: Vec3, view: View, lens: Lens, share: number): boolean {
  const { right, up, ahead } = axesOf(view.heading, view.tilt), eye = eyeOf(view), { slope, aspect, free } = lens;
  return ends({ ...body, place: at }).every((end) => {
    const off = minus(end, eye), depth = dot(off, ahead), x = dot(off, right) / (depth * slope * aspect), y = dot(off, up) / (depth * slope);
    return depth >= 1 && x < share * free.right && -x < share * free.left && y < share * free.top && -y < share * free.bottom;
  });
}

/** Adds the nearest places to the agents, as long as the agents stay large enough. Then adds all scenery, or none. */
export function withPlaces(agents: readonly FramedBody[], places: readonly Vec3[], heading: number, tilt: number, lens: Lens, scenery: readonly FramedBody[] = []): FramedBody[] {
  const all = [...agents];
  if (all.length === 0) return all;
  const middle = middleOf(agents), awayOf = (bodies: readonly FramedBody[]): number => length(minus(eyeOf(framingView(bodies, heading, tilt, lens)), middleOf(bodies)));
  for (const place of [...places].sort((a, b) => length(minus(a, middle)) - length(minus(b, middle)))) {
    if (!place.every(Number.isFinite)) continue;
    all.push({ place: [place[0], place[1] + PLACE_HEIGHT_M / 2, place[2]], velocity: NO_MOVE, radius: PLACE_RADIUS_M, height: PLACE_HEIGHT_M });
    if (awayOf(all) > PLACES_WITHIN_M) {
      // The remaining places are further away.
      all.pop();
      break;
    }
  }
  if (scenery.length === 0) return all;
  const whole = [...all, ...scenery];
  return awayOf(whole) > SCENERY_WITHIN_M ? all : whole;
}

/** Removes the agents that are furthest from the middle, if the camera would otherwise be too far away. */
export function withinReach(bodies: readonly FramedBody[], heading: number, tilt: number, lens: Lens): readonly FramedBody[] {
  const reaches = (some: readonly FramedBody[]): boolean => length(minus(eyeOf(framingView(some, heading, tilt, lens)), middleOf(some))) <= FURTHEST_M;
  if (reaches(bodies)) return bodies;
  const mean = times(bodies.reduce<Vec3>((sum, one) => plus(sum, one.place), [0, 0, 0]), 1 / bodies.length);
  const sorted = [...bodies].sort((a, b) => length(minus(a.place, mean)) - length(minus(b.place, mean)));
  let fits = 1, tooMany = sorted.length;
  while (tooMany - fits > 1) {
    const half = (fits + tooMany) >> 1;
    if (reaches(sorted.slice(0, half))) fits = half;
    else tooMany = half;
  }
  return sorted.slice(0, fits);
}

/** The footprint of a box or of a standing figure; nothing for parts of an agent or of the landscape. */
function cornersOf(drawables: Drawables, slot: number): FramedBody[] {
  const description = drawables.structure.descriptions[slot] ?? null;
  if (description === null || description.ofAgent || !description.visible || (description.shape !== Shape.Box && !drawables.hasBones(slot))) return [];
  const one = drawables.at(slot);
  if (one.bones.length > 0) return [{ place: plus(one.place, [0, 0.9, 0]), velocity: NO_MOVE, radius: 0.5, height: 1.8 }];
  const size: Vec3 = [one.size[0] * one.scale[0], one.size[1] * one.scale[1], one.size[2] * one.scale[2]];
  if (Math.max(...size) > LONGEST_PIECE_M) return [];
  return [-0.5, 0.5].flatMap((x) => [-0.5, 0.5].map((z): FramedBody => ({ place: plus(one.place, rotate(one.turn, [x * size[0], 0, z * size[2]])), velocity: NO_MOVE, radius: 0.1, height: size[1] })));
}

/** Footprints of walls, crates and figures between and near the agents, as corners. None in a wide landscape. */
export function sceneryAround(scene: Scene, places: readonly Vec3[]): FramedBody[] {
  let lowX = Infinity, lowZ = Infinity, highX = -Infinity, highZ = -Infinity;
  const reach = ([x, , z]: Vec3): void => {
    if (!Number.isFinite(x) || !Number.isFinite(z)) return;
    lowX = Math.min(lowX, x), lowZ = Math.min(lowZ, z), highX = Math.max(highX, x), highZ = Math.max(highZ, z);
  };
  for (const agent of scene.agents.values()) reach(agent.place);
  places.forEach(reach);
  if (lowX > highX) return [];
  let pieces: FramedBody[][] = [];
  for (let slot = 0; slot < scene.drawables.structure.ids.length; ++slot) {
    const corners = cornersOf(scene.drawables, slot);
    if (corners.length > 0) pieces.push(corners);
    if (pieces.length > MOST_PIECES) return [];
  }
  // Also includes pieces that are next to an included piece.
  const found: FramedBody[] = [];
  for (let grows = true; grows;) {
    const isNear = (piece: FramedBody[]): boolean => piece.some(({ place: [x, , z] }) => x > lowX - BESIDE_M && x < highX + BESIDE_M && z > lowZ - BESIDE_M && z < highZ + BESIDE_M);
    const near = pieces.filter(isNear);
    grows = near.length > 0;
    pieces = pieces.filter((piece) => !near.includes(piece));
    for (const corner of near.flat()) reach(corner.place), found.push(corner);
  }
  return found;
}

/** A game's board: the corners of everything that was built on it. */
export function boardOf(scene: Scene): FramedBody[] {
  let low: Vec3 | null = null, high: Vec3 = NO_MOVE;
  for (const [slot, one] of scene.drawables.structure.descriptions.entries()) {
    if (one === null || one.ofAgent || !one.visible || one.shape !== Shape.Box) continue;
    const half: Vec3 = [(one.size[0] * one.scale[0]) / 2, (one.size[1] * one.scale[1]) / 2, (one.size[2] * one.scale[2]) / 2];
    for (const sign of [-1, 1]) {
      const corner = plus(scene.drawables.placeAt(slot), times(half, sign));
      high = low === null ? corner : [Math.max(high[0], corner[0]), Math.max(high[1], corner[1]), Math.max(high[2], corner[2])];
      low = low === null ? corner : [Math.min(low[0], corner[0]), Math.min(low[1], corner[1]), Math.min(low[2], corner[2])];
    }
  }
  if (low === null) return [];
  const [left, bottom, back] = low, [right, , front] = high;
  return [left, right].flatMap((x) => [back, front].map((z): FramedBody => ({ place: [x, Math.max(bottom, 0), z], velocity: NO_MOVE, radius: 0, height: 0 })));
}

/** Whether the scene contains many pieces of buildings. Then agents are visible only from above. */
export function hasWalls(scene: Scene): boolean {
  const MANY_PIECES = 40;
  let count = 0;
  for (const one of scene.drawables.structure.descriptions) if (one !== null && !one.ofAgent && one.shape === Shape.Mesh && one.mesh.includes("/modular_")) count += 1;
  return count > MANY_PIECES;
}

/** A box that reaches further into the picture than this share from each edge is ignored. */
const MOST_INSET = 0.45;

/** The free rectangle of a picture under boxes. Each box takes a strip along the edge where this costs least. */
export function freeOf(boxes: readonly { left: number; top: number; width: number; height: number }[], width: number, height: number): Free {
  const inset = { left: 0, right: 0, top: 0, bottom: 0 };
  for (const box of boxes) {
    const costs = { left: (box.left + box.width) / width, right: (width - box.left) / width, top: (box.top + box.height) / height, bottom: (height - box.top) / height };
    if (!Object.values(costs).every(Number.isFinite) || box.width <= 0 || box.height <= 0) continue;
    const [side, cost] = (Object.entries(costs) as [keyof Free, number][]).reduce((best, one) => (one[1] < best[1] ? one : best));
    if (cost > 0 && cost < MOST_INSET) inset[side] = Math.max(inset[side], cost);
  }
  return { left: 1 - 2 * inset.left, right: 1 - 2 * inset.right, top: 1 - 2 * inset.top, bottom: 1 - 2 * inset.bottom };
}

/** Limits a tilt, so that the camera looks neither along the ground nor straight down. */
export function comfortable(tilt: number): number {
  return clamp(tilt, 0.42, 1.05);
}
