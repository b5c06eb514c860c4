// SPDX-License-Identifier: BSD-2-Clause
import type { Vec3 } from "../format/scene";
import type { Ghosts, ImaginedShape } from "../run/contents";
import { ink, type Ink, type LineBatch } from "./line_batch";
import { agentColor, type Rgb } from "./looks";
import type { BelievedBody } from "./overlays";

const WIRE: Readonly<Record<ImaginedShape["kind"], Ink>> = { "made-up": [0.86, 0.66, 1, 0.95], sensed: [0.45, 0.85, 1, 0.8], remembered: [0.78, 0.8, 0.86, 0.7] };
const SKIN: Readonly<Record<ImaginedShape["kind"], number>> = { "made-up": 0.22, sensed: 0.08, remembered: 0.05 };
const ANSWER: Rgb = [1, 0.88, 0.3], CROSSED: Rgb = [1, 0.32, 0.2], NOBODY: Rgb = [0.75, 0.85, 1];
/** Maximum number of names: more would hide the nodes. */
const MOST_NAMES = 40;
const END_M = 0.12;

/** A name for an object that is drawn elsewhere, or a figure: see BelievedBody. */
const nameOver = (name: string, place: Vec3, height: number, color: Rgb): BelievedBody => ({ name, place, color, opacity: 0.4, radius: 0, height });

function middleOf(shape: ImaginedShape): { place: Vec3; height: number } {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  shape.points.forEach((value, i) => {
    low[i % 3] = Math.min(low[i % 3]!, value);
    high[i % 3] = Math.max(high[i % 3]!, value);
  });
  return { place: [(low[0]! + high[0]!) / 2, (low[1]! + high[1]!) / 2, (low[2]! + high[2]!) / 2], height: high[1]! - low[1]! };
}

/** Draws imagined and remembered objects, and the agent's position in another future. Returns bodies and names. */
export function paintImagined(out: LineBatch, { ghosts, shapes, answer }: Ghosts): BelievedBody[] {
  const shown: BelievedBody[] = ghosts.map((one) => ({
    name: one.name, place: one.position, color: one.agent_id === 0 ? NOBODY : agentColor({ kind: one.kind, team: one.team }), opacity: 0.8, radius: one.radius_m, height: one.height_m,
  }));
  let names = 0;
  for (const shape of shapes) {
    if (shape.points.length < 3) continue;
    const wire = WIRE[shape.kind], skin = ink([wire[0], wire[1], wire[2]], SKIN[shape.kind]), at = (number: number): Vec3 => [shape.points[3 * number] ?? 0, shape.points[3 * number + 1] ?? 0, shape.points[3 * number + 2] ?? 0];
    for (let i = 0; i + 1 < shape.edges.length; i += 2) out.line(at(shape.edges[i]!), at(shape.edges[i + 1]!), wire);
    for (let i = 0; i + 2 < shape.faces.length; i += 3) out.fill(at(shape.faces[i]!), at(shape.faces[i + 1]!), at(shape.faces[i + 2]!), skin);
    // Nodes that the world updates already have a name there.
    if (shape.kind === "sensed" || ++names > MOST_NAMES) continue;
    const { place, height } = middleOf(shape);
    shown.push(nameOver(`${shape.name} · ${shape.state}`, place, height, [wire[0], wire[1], wire[2]]));
  }
  for (const { from, to, is_crossed } of answer.lines) {
    const color = ink(is_crossed ? CROSSED : ANSWER);
    out.line(from, to, color);
    for (const end of [from, to])
      for (const axis of [0, 1, 2]) {
        const arm = [0, 0, 0].map((_, i) => (i === axis ? END_M : 0));
        out.line([end[0] - arm[0]!, end[1] - arm[1]!, end[2] - arm[2]!], [end[0] + arm[0]!, end[1] + arm[1]!, end[2] + arm[2]!], color);
      }
  }
  const first = answer.lines[0];
  if (first !== undefined) shown.push(nameOver(answer.text, [(first.from[0] + first.to[0]) / 2, (first.from[1] + first.to[1]) / 2, (first.from[2] + first.to[2]) / 2], 0, ANSWER));
  return shown;
}
