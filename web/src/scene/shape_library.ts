// SPDX-License-Identifier: BSD-2-Clause
import { Shape, type Agent, type Description, type Quat, type Vec3 } from "../format/scene";
import { readMotion, type Motion } from "./model_motion";

/**
 * Triangles as sent by the run (docs/dev/stream.md): the same as in the window. Counter-clockwise if seen from
 * outside.
 */
export interface ShapeMesh {
  /** Meshes with the same triangles have the same number. */
  readonly number: number;
  readonly count: number;
  readonly positions: Float32Array<ArrayBuffer>;
  readonly normals: Float32Array<ArrayBuffer>;
  readonly uvs: Float32Array<ArrayBuffer>;
  /**
   * For each vertex: a mix of the material's colour (1) and its second colour (0), a factor of the colour, and gloss.
   */
  readonly paint: Float32Array<ArrayBuffer>;
  readonly indices: Uint32Array<ArrayBuffer>;
  /** The material if the drawable has none. */
  readonly material: string;
  /** The four bones that move each vertex, and their weights; null: a mesh without a skeleton. */
  readonly skin: { readonly bones: Uint16Array<ArrayBuffer>; readonly shares: Float32Array<ArrayBuffer> } | null;
}
export interface Pose { place: Vec3; turn: Quat }
export interface BoneAt { parent: number; inModel: Pose; bind: Pose }
/** How bones move a shape, as in app/shape_contents.cpp: two bones and the share of the first, or four joints and their weights. */
const TWO_BONES = 1, FOUR_JOINTS = 2;
export type BodyLook = "body/soldier" | "body/dark" | "body/rifle";

/** The contents "shapes:KEY". */
export interface ShapeContent {
  /** For a mesh with a skeleton: the key of its body. */
  body?: BodyLook;
  material?: string;
  /** The triangles, deflated, in base 64. */
  fine?: string;
  /** The same with fewer triangles; if it is missing, `fine` is used instead. */
  coarse?: string;
  /** For a body: the triangles for a height of a few pixels. */
  tiny?: string;
  is_figure?: boolean;
  /** For a model from a file that moves: its bones, joints and animations, deflated, in base 64. */
  motion?: string;
  bones?: readonly { parent: number; bind: readonly number[]; in_model: readonly number[] }[];
}

/** The level of detail: fine, coarse or tiny. */
export type Level = 0 | 1 | 2;
interface Known { levels: (ShapeMesh | null)[]; body: BodyLook | null; isFigure: boolean; bones: readonly BoneAt[]; motion: Motion | null }

/** Reads numbers of one kind after another. */
class Columns {
  private at = 0;
  constructor(private readonly view: DataView) {}

  private room(bytes: number): number {
    const at = this.at;
    if (at + bytes > this.view.byteLength) throw new Error("a shape is cut off");
    this.at += bytes;
    return at;
  }
  number(): number {
    return this.view.getUint32(this.room(4), true);
  }
  /** Reads indices, which are stored as differences from the previous one. */
  indices(count: number): Uint32Array<ArrayBuffer> {
    const at = this.room(4 * count), into = new Uint32Array(count);
    for (let i = 0, value = 0; i < count; ++i) into[i] = value = (value + this.view.getUint32(at + 4 * i, true)) >>> 0;
    return into;
  }
  /** Reads 16-bit differences scaled between minimum and maximum, into every `step`-th element from `first` on. */
  scaled(into: Float32Array, first: number, step: number, count: number): void {
    const head = this.room(8), low = this.view.getFloat32(head, true), high = this.view.getFloat32(head + 4, true), at = this.room(2 * count), scale = (high - low) / 65535;
    for (let i = 0, value = 0; i < count; ++i) {
      value = (value + this.view.getUint16(at + 2 * i, true)) & 0xffff;
      into[first + step * i] = low + value * scale;
    }
  }
  signed(into: Float32Array, first: number, step: number, count: number): void {
    const at = this.room(count);
    for (let i = 0; i < count; ++i) into[first + step * i] = Math.max(-1, this.view.getInt8(at + i) / 127);
  }
  shares(into: Float32Array, first: number, step: number, count: number): void {
    const at = this.room(count);
    for (let i = 0; i < count; ++i) into[first + step * i] = this.view.getUint8(at + i) / 255;
  }
  bytes(into: Uint16Array, first: number, step: number, count: number): void {
    const at = this.room(count);
    for (let i = 0; i < count; ++i) into[first + step * i] = this.view.getUint8(at + i);
  }
}

let meshes = 0;

export function readShape(bytes: ArrayBuffer, material: string): ShapeMesh {
  const input = new Columns(new DataView(bytes)), count = input.number(), indexCount = input.number(), skinKind = input.number();
  const indices = input.indices(indexCount), positions = new Float32Array(3 * count), uvs = new Float32Array(2 * count), paint = new Float32Array(3 * count), normals = new Float32Array(3 * count);
  for (const axis of [0, 1, 2]) input.scaled(positions, axis, 3, count);
  for (const axis of [0, 1]) input.scaled(uvs, axis, 2, count);
  input.scaled(paint, 1, 3, count);
  for (const axis of [0, 1, 2]) input.signed(normals, axis, 3, count);
  for (const part of [0, 2]) input.shares(paint, part, 3, count);
  if (indices.some((index) => index >= count)) throw new Error("a shape has no such corner");
  const seen = trianglesOf(indices, positions, (_, shortest) => shortest > 0);
  meshes += 1;
  if (skinKind === 0) return { number: meshes, count, positions, normals, uvs, paint, indices: seen, material, skin: null };
  const bones = new Uint16Array(4 * count), shares = new Float32Array(4 * count);
  if (skinKind === TWO_BONES) {
    for (const part of [0, 1]) input.bytes(bones, part, 4, count);
    input.shares(shares, 0, 4, count);
    for (let i = 0; i < count; ++i) shares[4 * i + 1] = 1 - shares[4 * i]!;
  } else if (skinKind === FOUR_JOINTS) {
    for (const part of [0, 1, 2, 3]) input.bytes(bones, part, 4, count);
    for (const part of [0, 1, 2, 3]) input.shares(shares, part, 4, count);
  } else {
    throw new Error("a shape has an unknown skin");
  }
  return { number: meshes, count, positions, normals, uvs, paint, indices: seen, material, skin: { bones, shares } };
}

/** The triangles that pass a test of their longest and shortest edge, in m. */
function trianglesOf(indices: Uint32Array<ArrayBuffer>, positions: Float32Array, test: (longest: number, shortest: number) => boolean): Uint32Array<ArrayBuffer> {
  const edge = (a: number, b: number): number => Math.hypot(positions[3 * a]! - positions[3 * b]!, positions[3 * a + 1]! - positions[3 * b + 1]!, positions[3 * a + 2]! - positions[3 * b + 2]!);
  let kept = 0;
  const all = new Uint32Array(indices.length);
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const a = indices[i]!, b = indices[i + 1]!, c = indices[i + 2]!, edges = [edge(a, b), edge(b, c), edge(c, a)];
    if (!test(Math.max(...edges), Math.min(...edges))) continue;
    all.set([a, b, c], kept);
    kept += 3;
  }
  return all.slice(0, kept);
}

/** The same shape without triangles that are small from afar. */
export function withoutSmall(shape: ShapeMesh, leastM: number): ShapeMesh {
  return { ...shape, indices: trianglesOf(shape.indices, shape.positions, (longest) => longest >= leastM) };
}

async function unpack(packed: string): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

const poseOf = (numbers: readonly number[]): Pose => {
  const [x = 0, y = 0, z = 0, qx = 0, qy = 0, qz = 0, qw = 1] = numbers;
  return { place: [x, y, z], turn: [qx, qy, qz, qw] };
};

const bits = new DataView(new ArrayBuffer(4));
function hex(value: number): string {
  bits.setFloat32(0, value);
  return bits.getUint32(0).toString(16);
}

/** The key of a drawable's shape, equal to that of ShapeKey in app/shape_contents.cpp. */
export function shapeKey(d: Description, agentBody: boolean): string {
  if (d.shape === Shape.Mesh) return `mesh/${d.mesh}`;
  return `${d.shape}.${agentBody ? 1 : 0}.${d.size.map(hex).join(".")}.${hex(d.repeats[0])}.${hex(d.repeats[1])}.${d.material.startsWith("Soarbox/") ? d.material : ""}`;
}

/** Whether a capsule of an agent is its body rather than something that it carries. */
export function looksLikeABody(d: Description, agent: Agent | undefined): boolean {
  return d.ofAgent && agent !== undefined && d.shape === Shape.Capsule && d.size[1] > Math.fround(0.6) * agent.height;
}

/** The shapes that the run has sent so far. */
export class ShapeLibrary {
  private readonly known = new Map<string, Known>();
  /** Shapes by their packed triangles: many drawables differ only in their material. */
  private readonly unpacked = new Map<string, Promise<ShapeMesh>>();
  /** Number of shapes that have arrived so far. */
  changes = 0;

  /** `changed` is called when something new can be drawn. */
  constructor(private readonly changed: () => void) {}

  async add(key: string, content: ShapeContent): Promise<void> {
    if (this.known.has(key)) return;
    const known: Known = {
      levels: [null, null, null], body: content.body ?? null, isFigure: content.is_figure === true,
      bones: (content.bones ?? []).map((one) => ({ parent: one.parent, bind: poseOf(one.bind), inModel: poseOf(one.in_model) })),
      motion: null,
    };
    this.known.set(key, known);
    if (content.motion !== undefined) known.motion = readMotion(await unpack(content.motion));
    if (content.fine !== undefined) {
      const material = content.material ?? "White", fine = await this.unpack(content.fine, material);
      const coarse = content.coarse === undefined ? fine : await this.unpack(content.coarse, material);
      known.levels = [fine, coarse, content.tiny === undefined ? coarse : await this.unpack(content.tiny, material)];
    }
    this.changes += 1;
    this.changed();
  }

  private async unpack(packed: string, material: string): Promise<ShapeMesh> {
    let mesh = this.unpacked.get(packed);
    if (mesh === undefined) this.unpacked.set(packed, (mesh = unpack(packed).then((bytes) => readShape(bytes, material))));
    return { ...(await mesh), material };
  }

  clear(): void {
    this.known.clear();
    this.unpacked.clear();
  }

  /** Null: not received yet. */
  mesh(key: string, level: Level): ShapeMesh | null {
    return this.known.get(key)?.levels[level] ?? null;
  }

  isFigure(key: string): boolean {
    return this.known.get(key)?.isFigure === true;
  }

  bones(look: BodyLook): readonly BoneAt[] {
    return this.known.get(look)?.bones ?? [];
  }

  /** The movement of a drawable that shows a model from a file; null: it does not move. */
  motionOf(d: Description): Motion | null {
    return d.shape === Shape.Mesh ? (this.known.get(`mesh/${d.mesh}`)?.motion ?? null) : null;
  }

  /** The body of a drawable with a skeleton; null: it has no skeleton. */
  bodyOf(d: Description): BodyLook | null {
    if (d.shape !== Shape.Mesh) return null;
    const body = this.known.get(`mesh/${d.mesh}`)?.body ?? null;
    // A soldier may change its uniform by the name of its material.
    if (body === null || body === "body/rifle") return body;
    return d.material === "SF_Soldier_Body" ? "body/soldier" : d.material === "SF_Soldier_Body_Dark" ? "body/dark" : body;
  }
}
