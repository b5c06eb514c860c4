// SPDX-License-Identifier: BSD-2-Clause
// Written by reference_pages from src/stream/scene_layout.h.
import type { ByteReader } from "./byte_reader";
import { readColor, readFloats, readPlace, readTurn, type Color, type Quat, type Vec3, type Values } from "./scene_values";

/** The records of a scene's stream. `_BYTES`: the least number of bytes of one. */

/** A light. */
export interface Light {
  readonly id: number;
  readonly directional: boolean;
  readonly castsShadows: boolean;
  readonly place: Vec3;
  readonly direction: Vec3;
  readonly diffuse: Vec3;
  readonly specular: Vec3;
  readonly range: number;
  readonly attenuation: Vec3;
}
export const LIGHT_BYTES = 67;
export function readLight(input: ByteReader): Light {
  const id = input.number();
  const directional = input.byte() === 0;
  const castsShadows = input.byte() !== 0;
  const place = readFloats(input);
  const direction = readFloats(input);
  const diffuse = readFloats(input);
  const specular = readFloats(input);
  const range = input.float();
  const attenuation = readFloats(input);
  return { id, directional, castsShadows, place, direction, diffuse, specular, range, attenuation };
}

/** The camera. */
export interface Camera {
  readonly moves: number;
  readonly place: Vec3;
  readonly turn: Quat;
  readonly fovDeg: number;
}
export const CAMERA_BYTES = 11;
export function readCamera(input: ByteReader): Camera {
  const moves = input.number();
  const place = readPlace(input, 1000);
  const turn = readTurn(input, 2048);
  const fovDeg = input.float();
  return { moves, place, turn, fovDeg };
}

/** What seldom changes of an agent. */
export interface AgentLooks {
  readonly name: string;
  readonly kind: string;
  readonly script: string;
  readonly team: string;
  readonly radius: number;
  readonly height: number;
}
export const AGENT_LOOKS_BYTES = 12;
export function readAgentLooks(input: ByteReader, values: Values): AgentLooks {
  const name = values.word();
  const kind = values.word();
  const script = values.word();
  const team = values.word();
  const radius = input.float();
  const height = input.float();
  return { name, kind, script, team, radius, height };
}

/** How an agent is. */
export interface AgentState {
  readonly health: number;
  readonly alive: boolean;
  readonly failed: boolean;
  readonly lastCommand: string;
}
export const AGENT_STATE_BYTES = 3;
export function readAgentState(input: ByteReader, values: Values): AgentState {
  const health = input.signed() / 10;
  const flags = input.byte();
  const lastCommand = values.word();
  return { health, alive: (flags & 1) !== 0, failed: (flags & 2) !== 0, lastCommand };
}

/** An effect of particles. */
export interface Particle {
  readonly id: number;
  readonly effect: string;
  readonly visible: boolean;
  readonly directed: boolean;
  readonly restarts: number;
  readonly place: Vec3;
  readonly direction: Vec3;
}
export const PARTICLE_BYTES = 10;
export function readParticle(input: ByteReader, values: Values): Particle {
  const id = input.number();
  const effect = values.word();
  const flags = input.byte();
  const restarts = input.number();
  const place = readPlace(input, 1000);
  const direction = readPlace(input, 500);
  return { id, effect, visible: (flags & 1) !== 0, directed: (flags & 2) !== 0, restarts, place, direction };
}

/** A sound that began in the last second. */
export interface Sound {
  readonly id: number;
  readonly file: string;
  readonly volume: number;
  readonly place: Vec3 | null;
}
export const SOUND_BYTES = 7;
export function readSound(input: ByteReader, values: Values): Sound {
  const id = input.number();
  const file = values.word();
  const volume = input.float();
  const place = input.byte() !== 0 ? readPlace(input, 1000) : null;
  return { id, file, volume, place };
}

/** A line. */
export interface Line {
  readonly from: Vec3;
  readonly to: Vec3;
  readonly color: Color;
}
export const LINE_BYTES = 10;
export function readLine(input: ByteReader, values: Values): Line {
  const from = values.point();
  const to = values.point();
  const color = readColor(input);
  return { from, to, color };
}

/** A circle on the ground. */
export interface Circle {
  readonly center: Vec3;
  readonly radius: number;
  readonly color: Color;
}
export const CIRCLE_BYTES = 8;
export function readCircle(input: ByteReader, values: Values): Circle {
  const center = values.point();
  const radius = input.signed() / 1000;
  const color = readColor(input);
  return { center, radius, color };
}

/** A triangle. */
export interface Triangle {
  readonly a: Vec3;
  readonly b: Vec3;
  readonly c: Vec3;
  readonly color: Color;
}
export const TRIANGLE_BYTES = 13;
export function readTriangle(input: ByteReader, values: Values): Triangle {
  const a = values.point();
  const b = values.point();
  const c = values.point();
  const color = readColor(input);
  return { a, b, c, color };
}

/** Another agent, as an agent remembers it. */
export interface Contact {
  readonly agent: number;
  readonly place: Vec3;
  readonly visible: boolean;
  readonly heard: boolean;
  readonly alive: boolean;
  readonly forgotten: number;
}
export const CONTACT_BYTES = 6;
export function readContact(input: ByteReader): Contact {
  const agent = input.number();
  const place = readPlace(input, 10);
  const flags = input.byte();
  const forgotten = input.byte() / 20;
  return { agent, place, visible: (flags & 1) !== 0, heard: (flags & 2) !== 0, alive: (flags & 4) !== 0, forgotten };
}

/** A shot. */
export interface Shot {
  readonly from: Vec3;
  readonly to: Vec3;
  readonly shooter: number;
  readonly hit: number;
  readonly time: number;
}
export const SHOT_BYTES = 9;
export function readShot(input: ByteReader): Shot {
  const from = readPlace(input, 1000);
  const to = readPlace(input, 1000);
  const shooter = input.number();
  const hit = input.number();
  const time = input.signed() / 100;
  return { from, to, shooter, hit, time };
}

/** What an agent says to another. */
export interface Speech {
  readonly from: number;
  readonly to: number;
  readonly text: string;
  readonly time: number;
}
export const SPEECH_BYTES = 4;
export function readSpeech(input: ByteReader, values: Values): Speech {
  const from = input.number();
  const to = input.number();
  const text = values.word();
  const time = input.signed() / 100;
  return { from, to, text, time };
}

/** A place with a name. */
export interface NamedPlace {
  readonly kind: "waypoint" | "region" | "item" | "thing";
  readonly name: string;
  readonly place: Vec3;
}
export const NAMED_PLACE_BYTES = 5;
export function readNamedPlace(input: ByteReader, values: Values): NamedPlace {
  const kind = (["waypoint", "region", "item", "thing"] as const)[input.byte()] ?? "thing";
  const name = values.word();
  const place = readPlace(input, 100);
  return { kind, name, place };
}

/** A force that a script or a command applied to a body in the last step. */
export interface Push {
  readonly owner: number;
  readonly place: Vec3;
  readonly force: Vec3;
  readonly mass: number;
}
export const PUSH_BYTES = 20;
export function readPush(input: ByteReader): Push {
  const owner = input.number();
  const place = readPlace(input, 1000);
  const force = readFloats(input);
  const mass = input.float();
  return { owner, place, force, mass };
}
