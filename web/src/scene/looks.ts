// SPDX-License-Identifier: BSD-2-Clause
import TABLES from "../../../src/viewer/looks.json";
import type { Agent } from "../format/scene";

/** The appearance of materials, by name: the same colours as in the window. */
export type Paint = "plain" | "ground" | "concrete" | "brick" | "crate" | "cloth" | "leaves" | "stone" | "missing" | "corners";
export type Rgb = readonly [number, number, number];

export interface Look {
  base: Rgb;
  /** The second colour, for visors, glass and faces. Ground: the colour of its plants. */
  trim: Rgb | null;
  opacity: number;
  gloss: number;
  glow: number;
  paint: Paint;
  /** Number of repetitions of the paint per unit of uv. */
  repeats: number;
}

type Row = readonly [name: string, base: readonly number[], trim: readonly number[], gloss: number, glow: number, paint: string, repeats: number];

const rgb = ([r, g, b]: readonly number[]): Rgb => [r!, g!, b!];
/** The window's table. A transparent second colour is none. */
const LOOKS: ReadonlyMap<string, Look> = new Map((TABLES.looks as unknown as readonly Row[]).map(([name, base, trim, gloss, glow, paint, repeats]) =>
  [name, { base: rgb(base), trim: trim[3] === 0 ? null : rgb(trim), opacity: base[3]!, gloss, glow, paint: paint as Paint, repeats }]));

/** The look of a material's name; conspicuous squares for an unknown name. */
export function lookOf(material: string): Look {
  return LOOKS.get(material) ?? LOOKS.get("Soarbox/Missing")!;
}

const utf8 = new TextEncoder();

/** The colour of the first word that a name contains; with "=" before it, of this name alone. */
function colorIn(colors: readonly unknown[], name: string): Rgb | null {
  const found = (colors as readonly (readonly [string, readonly number[]])[]).find(([word]) => (word.startsWith("=") ? word.slice(1) === name : name.includes(word)));
  return found === undefined ? null : rgb(found[1]);
}

/** The colour of a kind of agent; an unknown kind gets one computed from its name. */
export function kindColor(kind: string): Rgb {
  let hash = 2166136261;
  for (const byte of utf8.encode(kind)) hash = Math.imul(hash ^ byte, 16777619) >>> 0;
  return colorIn(TABLES.kinds, kind) ?? rgb(TABLES.others[hash % TABLES.others.length]!);
}

export function teamColor(team: string): Rgb {
  return colorIn(TABLES.teams, team) ?? kindColor(team);
}

export function agentColor(agent: Pick<Agent, "team" | "kind">): Rgb {
  return agent.team === "" ? kindColor(agent.kind) : teamColor(agent.team);
}

/** Lines need brighter colours than cloth. */
export const bright = (color: Rgb): Rgb => [0.3 + 0.7 * color[0], 0.3 + 0.7 * color[1], 0.3 + 0.7 * color[2]];

export function cssColor(color: readonly number[], alpha = 1): string {
  const [r, g, b] = color.map((part) => Math.round(Math.min(Math.max(part, 0), 1) * 255));
  return `rgb(${r ?? 0} ${g ?? 0} ${b ?? 0} / ${alpha})`;
}

/** The kind of agents that another simulation moves; they are marked by a hollow lozenge. */
export const FOREIGN = "foreign";

/** Generic material names of an agent's body, which do not select a colour. */
export function isJustSomeTexture(material: string): boolean {
  return TABLES.textures.includes(material);
}
