// SPDX-License-Identifier: BSD-2-Clause
import type { Drawables } from "./drawables";
import type { AgentLooks, AgentState, Camera, Circle, Contact, Light, Line, NamedPlace, Particle, Push, Shot, Sound, Speech, Triangle } from "./scene_records";
import type { Color, Quat, Vec3 } from "./scene_values";

/** The visible scene at one moment, as in the scene stream. Metres, radians and seconds unless a name says otherwise. */

export type { Color, Quat, Vec3 } from "./scene_values";
export type { Camera, Circle, Contact, Light, Line, NamedPlace, Particle, Push, Shot, Sound, Speech, Triangle } from "./scene_records";

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

export interface Agent extends AgentLooks, AgentState { readonly place: Vec3; readonly forward: Vec3 }

export interface Surroundings { ambient: Vec3; sky: string; skyTurnDeg: Vec3; palette: readonly Color[]; lights: readonly Light[] }
export interface Lines { lines: readonly Line[]; circles: readonly Circle[]; triangles: readonly Triangle[] }
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
