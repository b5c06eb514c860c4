// SPDX-License-Identifier: BSD-2-Clause
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

const DARK: Rgb = [0.05, 0.06, 0.08], WHITE: Rgb = [0.88, 0.88, 0.87], RED: Rgb = [0.8, 0.16, 0.13], GREEN: Rgb = [0.22, 0.62, 0.24];
const BLUE: Rgb = [0.16, 0.36, 0.78], YELLOW: Rgb = [0.92, 0.78, 0.2];

function look(base: Rgb, trim: Rgb | null = DARK, gloss = 0.25, more: Partial<Look> = {}): Look {
  return { base, trim, gloss, opacity: 1, glow: 0, paint: "plain", repeats: 1, ...more };
}
const clear = (base: Rgb): Look => look(base, DARK, 0.4, { opacity: 0.45 });

const LOOKS: Readonly<Record<string, Look>> = {
  White: look(WHITE, DARK, 0.2), Red: look(RED, DARK, 0.3), Green: look(GREEN, DARK, 0.3), Blue: look(BLUE, DARK, 0.3),
  RedGlow: look(RED, DARK, 0.3, { glow: 1.2 }), GreenGlow: look(GREEN, DARK, 0.3, { glow: 1.2 }), BlueGlow: look(BLUE, DARK, 0.3, { glow: 1.2 }),
  TransparentRed: clear(RED), TransparentGreen: clear(GREEN), TransparentBlue: clear(BLUE), TransparentYellow: clear(YELLOW), TransparentWhite: clear(WHITE),
  Ground: look([0.55, 0.52, 0.47], null, 0.05, { paint: "ground" }), Ground2: look([0.6, 0.605, 0.56], [0.36, 0.44, 0.22], 0.05, { paint: "ground" }),
  NobiaxModular: look([0.8, 0.79, 0.76], [0.1, 0.13, 0.16], 0.1, { paint: "concrete", repeats: 0.39 }),
  base_material: look(WHITE, DARK, 0.2), base_animated_material: look(WHITE, DARK, 0.2),
  SF_Soldier_Body: look([0.55, 0.58, 0.55], DARK, 0.35), SF_Soldier_Body_Dark: look([0.22, 0.24, 0.26], DARK, 0.35),
  SF_Weapon_WeaponBody: look([0.2, 0.21, 0.23], DARK, 0.5),
  "Particles/Bullet": look([1, 0.85, 0.45], DARK, 0.2, { glow: 1.5 }), "Particles/Impact": look([0.85, 0.8, 0.7], DARK, 0.1, { glow: 0.3 }),
  debug_draw: look(WHITE, DARK, 0.1, { glow: 0.5, opacity: 0.45 }), debug_opaque_draw: look(WHITE, DARK, 0.1, { glow: 0.5 }),
  "Soarbox/Brick": look([0.98, 0.97, 0.95], [0.1, 0.14, 0.17], 0.06, { paint: "brick", repeats: 0.78 }),
  "Soarbox/Concrete": look([0.8, 0.79, 0.76], [0.1, 0.13, 0.16], 0.1, { paint: "concrete", repeats: 0.39 }),
  "Soarbox/Crate": look([0.9, 0.66, 0.38], [0.2, 0.19, 0.18], 0.14, { paint: "crate", repeats: 1.25 }),
  "Soarbox/Metal": look([0.62, 0.66, 0.7], [0.15, 0.16, 0.17], 0.38, { paint: "concrete", repeats: 0.5 }),
  "Soarbox/Leaves": look([0.62, 0.74, 0.42], [0.31, 0.24, 0.17], 0.02, { paint: "leaves" }),
  "Soarbox/Stone": look([0.78, 0.77, 0.74], DARK, 0.05, { paint: "stone", repeats: 0.5 }), "Soarbox/Rock": look([0.62, 0.6, 0.56], DARK, 0.05, { paint: "stone", repeats: 0.5 }),
  "Soarbox/Medkit": look([0.95, 0.95, 0.93], [0.83, 0.06, 0.06]), "Soarbox/Ammunition": look([0.3, 0.34, 0.2], [0.86, 0.62, 0.18], 0.15),
  "Soarbox/Sack": look([0.71, 0.58, 0.38], [0.35, 0.22, 0.12], 0.02), "Soarbox/Sheep": look([0.93, 0.91, 0.84], [0.16, 0.13, 0.12], 0.02),
  "Soarbox/Bear": look([0.36, 0.22, 0.12], [0.62, 0.45, 0.3], 0.04), "Soarbox/Hare": look([0.66, 0.53, 0.38], [0.88, 0.8, 0.72], 0.03),
  "Soarbox/Cook": look([0.97, 0.97, 0.96], [0.85, 0.62, 0.48], 0.05), "Soarbox/Wolf": look([0.4, 0.41, 0.43], [0.72, 0.7, 0.67], 0.03),
  "Soarbox/Villager": look([0.24, 0.36, 0.56], [0.84, 0.64, 0.44], 0.03), "Soarbox/Robot": look([0.9, 0.42, 0.1], [0.16, 0.17, 0.19], 0.3),
  "Soarbox/Cart": look([0.58, 0.4, 0.22], [0.42, 0.34, 0.16], 0.03), "Soarbox/Bee": look([0.96, 0.74, 0.1], [0.09, 0.08, 0.07], 0.15),
  "Soarbox/Bell": look([0.82, 0.58, 0.2], [0.42, 0.28, 0.17], 0.05), "Soarbox/Gold": look([1, 0.76, 0.16], DARK, 0.6),
  "Soarbox/Silver": look([0.82, 0.85, 0.89], DARK, 0.6), "Soarbox/Bronze": look([0.68, 0.38, 0.17], DARK, 0.6),
  "Soarbox/RedFlower": look([0.86, 0.12, 0.14], [0.52, 0.62, 0.14], 0.05), "Soarbox/BlueFlower": look([0.2, 0.34, 0.9], [0.52, 0.62, 0.14], 0.05),
  "Soarbox/WhiteFlower": look([0.95, 0.95, 0.93], [0.52, 0.62, 0.14], 0.05), "Soarbox/Hedge": look([0.2, 0.38, 0.13], DARK, 0.02),
  "Soarbox/Yellow": look(YELLOW, DARK, 0.3), "Soarbox/Purple": look([0.46, 0.2, 0.62], DARK, 0.3), "Soarbox/Orange": look([0.94, 0.46, 0.1], DARK, 0.3),
  "Soarbox/Black": look([0.07, 0.07, 0.08], DARK, 0.4), "Soarbox/BoardLight": look([0.66, 0.68, 0.62], DARK, 0.05), "Soarbox/BoardDark": look([0.56, 0.59, 0.53], DARK, 0.05),
  // Models from files: each corner has its own colour, stored as u, v and light.
  "Soarbox/Model": look([1, 1, 1], DARK, 0.15, { paint: "corners" }),
  "Soarbox/Hills": look([0.4, 0.47, 0.24], [0.33, 0.28, 0.22], 0.02), "Soarbox/Missing": look([1, 1, 1], DARK, 0.1, { glow: 0.35, paint: "missing" }),
};

/** The look of a material's name; conspicuous squares for an unknown name. */
export function lookOf(material: string): Look {
  return Object.hasOwn(LOOKS, material) ? LOOKS[material]! : LOOKS["Soarbox/Missing"]!;
}

const OTHERS: readonly Rgb[] = [[0.5, 0.3, 0.72], [0.09, 0.6, 0.62], [0.83, 0.31, 0.55], [0.62, 0.6, 0.16], [0.55, 0.37, 0.24], [0.44, 0.5, 0.58]];
const utf8 = new TextEncoder();

/** The colour of a kind of agent; an unknown kind gets one computed from its name. */
export function kindColor(kind: string): Rgb {
  if (kind.includes("seek")) return [0.86, 0.22, 0.17];
  if (kind.includes("follow")) return [0.13, 0.47, 0.8];
  if (kind.includes("waypoint")) return [0.2, 0.62, 0.36];
  if (kind.includes("lua")) return [0.95, 0.56, 0.1];
  if (kind === "soar") return [0.5, 0.3, 0.72];
  let hash = 2166136261;
  for (const byte of utf8.encode(kind)) hash = Math.imul(hash ^ byte, 16777619) >>> 0;
  return OTHERS[hash % OTHERS.length]!;
}

export function teamColor(team: string): Rgb {
  if (team === "") return [0.33, 0.33, 0.27];
  if (team === "team1" || team.includes("blue")) return [0.05, 0.36, 0.88];
  if (team === "team2" || team.includes("red")) return [0.9, 0.24, 0.06];
  if (team.includes("green")) return [0, 0.66, 0.5];
  if (team.includes("yellow")) return [0.97, 0.86, 0.24];
  return kindColor(team);
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
  return ["", "Ground", "Ground2", "White", "NobiaxModular", "base_material", "base_animated_material"].includes(material);
}
