// SPDX-License-Identifier: BSD-2-Clause
import type { Drawables } from "./drawables";

/** The visible scene at one moment, as in the scene stream. Metres, radians and seconds unless a name says otherwise. */

export type Vec3 = readonly [number, number, number];
/** Red, green, blue, alpha: 0 to 1. */
export type Color = readonly [number, number, number, number];
/** x, y, z, w. */
export type Quat = readonly [number, number, number, number];

export enum Shape { Mesh, Box, Capsule, Cylinder, Plane, Sphere }

export interface Bone { turn: Quat; place: Vec3 }

/** An animation of a model from a file: its number in the model, the time in it in s, and its weight. */
export interface Movement { clip: number; time: number; weight: number }

/** What does not change while a drawable moves. */
export interface Description {
  owner: number;
  ofAgent: boolean;
  visible: boolean;
  skeletonShown: boolean;
  shape: Shape;
  mesh: string;
  material: string;
  size: Vec3;
  repeats: Vec3;
  scale: Vec3;
}

export interface Drawable extends Description {
  place: Vec3;
  turn: Quat;
  /** Relative to their parents. */
  bones: readonly Bone[];
  /** For models from files that have animations. */
  movements?: readonly Movement[];
}

export interface Agent {
  name: string;
  kind: string;
  script: string;
  team: string;
  radius: number;
  height: number;
  place: Vec3;
  forward: Vec3;
  health: number;
  alive: boolean;
  failed: boolean;
  lastCommand: string;
}

export interface Light {
  id: number;
  directional: boolean;
  castsShadows: boolean;
  place: Vec3;
  direction: Vec3;
  diffuse: Vec3;
  specular: Vec3;
  range: number;
  attenuation: Vec3;
}

export interface Surroundings { ambient: Vec3; sky: string; skyTurnDeg: Vec3; palette: readonly Color[]; lights: readonly Light[] }
export interface Camera { moves: number; place: Vec3; turn: Quat; fovDeg: number }
export interface Line { from: Vec3; to: Vec3; color: Color }
export interface Circle { center: Vec3; radius: number; color: Color }
export interface Triangle { a: Vec3; b: Vec3; c: Vec3; color: Color }
export interface Lines { lines: readonly Line[]; circles: readonly Circle[]; triangles: readonly Triangle[] }
export interface Contact { agent: number; place: Vec3; visible: boolean; heard: boolean; alive: boolean; forgotten: number }
export interface Mind {
  operator: string;
  doing: string;
  senses: { sight: number; viewDeg: number; hearing: number } | null;
  measured: Vec3 | null;
  goal: Vec3 | null;
  target: number;
  leader: number;
  pathIsWhole: boolean;
  path: readonly Vec3[];
  contacts: readonly Contact[];
}
export interface Shot { from: Vec3; to: Vec3; shooter: number; hit: number; time: number }
export interface Speech { from: number; to: number; text: string; time: number }
export interface Particle { id: number; effect: string; visible: boolean; directed: boolean; restarts: number; place: Vec3; direction: Vec3 }
/** A sound that began in the last second. */
export interface Sound { id: number; file: string; volume: number; place: Vec3 | null }
export enum Font { Small, SmallMono, Medium, MediumMono, Large, LargeMono }

/** A box of text that a script shows: on the screen in pixels, or in the world. */
export interface Component {
  id: number;
  /** The box to which the position is relative; 0: the screen. */
  parent: number;
  layer: number;
  x: number;
  y: number;
  width: number;
  height: number;
  marginLeft: number;
  marginTop: number;
  visible: boolean;
  gradient: null | { from: Color; to: Color; direction: "vertical" | "horizontal" | "diagonal" };
  isMarkup: boolean;
  textColor: Color;
  font: Font;
  text: string;
  /** A material, or the key of an image ("assets:KEY"). */
  material: string;
  caption: string;
  /** The name of the button; empty: the box is no button. */
  button: string;
  /** A bar that fills this share of the width; null: none. */
  bar: null | { share: number; color: Color };
  /** Position of the top left corner in the world, where 1 px is 5 mm; null: the box is on the screen. */
  world: null | { place: Vec3; turn: Quat };
}
/** A force that a script or a command applied to a body in the last step. */
export interface Push { owner: number; place: Vec3; force: Vec3; mass: number }
export interface NamedPlace { kind: "waypoint" | "region" | "item" | "thing"; name: string; place: Vec3 }

export interface Scene {
  tick: number;
  time: number;
  surroundings: Surroundings | null;
  camera: Camera | null;
  drawables: Drawables;
  agents: ReadonlyMap<number, Agent>;
  lines: Lines;
  overlayLines: Lines;
  minds: ReadonlyMap<number, Mind>;
  shots: readonly Shot[];
  speech: readonly Speech[];
  places: readonly NamedPlace[];
  pushes: readonly Push[];
  components: readonly Component[];
  particles: readonly Particle[];
  sounds: readonly Sound[];
}
