// SPDX-License-Identifier: BSD-2-Clause
import type { ByteReader } from "./byte_reader";

/** The values of a scene's stream, as in docs/dev/stream.md. Metres, radians and seconds unless a name says otherwise. */

export type Vec3 = readonly [number, number, number];
/** Red, green, blue, alpha: 0 to 1. */
export type Color = readonly [number, number, number, number];
/** x, y, z, w. */
export type Quat = readonly [number, number, number, number];
export type Steps = [number, number, number];

/** Reads values that depend on earlier ones: a text of the table, and a point as the difference to the point before. */
export interface Values { word(): string; point(): Vec3 }

export function vector(steps: Steps, perUnit: number): Vec3 {
  return [steps[0] / perUnit, steps[1] / perUnit, steps[2] / perUnit];
}

export function add(input: ByteReader, steps: Steps): Steps {
  return [steps[0] + input.signed(), steps[1] + input.signed(), steps[2] + input.signed()];
}

export function readTurn(input: ByteReader, perRadian: number): Quat {
  const [x, y, z] = readPlace(input, perRadian);
  const angle = Math.hypot(x, y, z);
  if (angle === 0) return [0, 0, 0, 1];
  const s = Math.sin(angle / 2) / angle;
  return [x * s, y * s, z * s, Math.cos(angle / 2)];
}

export function readPlace(input: ByteReader, perUnit: number): Vec3 {
  return vector(add(input, [0, 0, 0]), perUnit);
}

export function readFloats(input: ByteReader): Vec3 {
  return [input.float(), input.float(), input.float()];
}

export function readColor(input: ByteReader): Color {
  return [input.byte() / 255, input.byte() / 255, input.byte() / 255, input.byte() / 255];
}
