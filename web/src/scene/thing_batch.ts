// SPDX-License-Identifier: BSD-2-Clause
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, InstancedBufferAttribute, InstancedMesh, type Material } from "three";
import { POSE_NUMBERS } from "../format/drawables";
import type { Vec3 } from "../format/scene";
import type { Look } from "./looks";
import { linear } from "./materials";
import { layerOf } from "./paint";
import type { ShapeMesh } from "./shape_library";

const FIRST_ROOM = 16, MATRIX_NUMBERS = 16;
/** Numbers of the instance attributes: see INKS in materials.ts. */
const INKS = { baseInk: 4, trimInk: 4, paintInk: 2 } as const;
type InkName = keyof typeof INKS;
const INK_NAMES = Object.keys(INKS) as InkName[];

/** The colours of an instance, for the attributes of the same names. */
export type Inks = Readonly<Record<InkName, readonly number[]>>;

export function inksOf(look: Look): Inks {
  const base = linear(look.base), trim = linear(look.trim ?? look.base);
  return {
    baseInk: [...base, Math.min(1, Math.max(0.2, 0.95 - 0.75 * look.gloss))], trimInk: [...trim, 0.5 * look.glow], paintInk: [layerOf(look.paint), look.repeats],
  };
}

/** A geometry whose corners get the colours of their instance. */
export function inkedGeometry(mesh: ShapeMesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(mesh.normals, 3));
  geometry.setAttribute("uv", new BufferAttribute(mesh.uvs, 2));
  geometry.setAttribute("paint", new BufferAttribute(mesh.paint, 3));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  return geometry;
}

/** Drawables that one call draws: instances of a geometry. The instances have no order. */
export class ThingBatch {
  mesh: InstancedMesh;
  /** The slot of the drawable of each instance. */
  private readonly slots: number[] = [];
  private matrices = new Float32Array(FIRST_ROOM * MATRIX_NUMBERS);
  private readonly inks = new Map<InkName, Float32Array<ArrayBuffer>>();
  /** The instances whose matrices have changed since the last picture. */
  private first = Infinity;
  private last = -1;
  private readonly range = { start: 0, count: 0 };

  /** `makeGeometry` is called again if the batch grows. `hasInks`: instances have colours. */
  constructor(private readonly makeGeometry: () => BufferGeometry, private readonly material: Material, private readonly castsShadow: boolean, private readonly hasInks: boolean, private readonly replaced: (mesh: InstancedMesh, by: InstancedMesh) => void) {
    if (hasInks) for (const name of INK_NAMES) this.inks.set(name, new Float32Array(FIRST_ROOM * INKS[name]));
    this.mesh = this.makeMesh();
  }

  get count(): number {
    return this.slots.length;
  }

  /** Returns the number of the new instance. Its matrix must be set before the next picture. */
  add(slot: number, inks: Inks | null): number {
    if ((this.count + 1) * MATRIX_NUMBERS > this.matrices.length) this.grow();
    const index = this.slots.push(slot) - 1;
    if (this.hasInks && inks !== null) for (const name of INK_NAMES) this.inks.get(name)!.set(inks[name], index * INKS[name]);
    this.changeCount();
    return index;
  }

  /** The last instance gets the number of the removed one. Returns its slot; -1 if there is none. */
  remove(index: number): number {
    const from = this.count - 1, slot = this.slots.pop()!;
    this.changeCount();
    if (from === index) return -1;
    this.slots[index] = slot;
    this.matrices.copyWithin(index * MATRIX_NUMBERS, from * MATRIX_NUMBERS, (from + 1) * MATRIX_NUMBERS);
    for (const [name, values] of this.inks) values.copyWithin(index * INKS[name], from * INKS[name], (from + 1) * INKS[name]);
    this.touch(index);
    return slot;
  }

  /**
   * Sets the matrix of an instance. Its pose lies between two poses: `share` 0 is the pose in `before`, 1 the pose in
   * `after`. Both have the pose at the slot.
   */
  place(index: number, slot: number, before: Float32Array, after: Float32Array, share: number, scale: Vec3): void {
    const m = this.matrices, at = index * MATRIX_NUMBERS, p = slot * POSE_NUMBERS;
    let px = after[p]!, py = after[p + 1]!, pz = after[p + 2]!, x = after[p + 3]!, y = after[p + 4]!, z = after[p + 5]!, w = after[p + 6]!;
    if (share < 1) {
      const left = 1 - share, ax = before[p + 3]!, ay = before[p + 4]!, az = before[p + 5]!, aw = before[p + 6]!;
      // Along the shorter rotation.
      const side = ax * x + ay * y + az * z + aw * w < 0 ? -share : share;
      px = before[p]! * left + px * share;
      py = before[p + 1]! * left + py * share;
      pz = before[p + 2]! * left + pz * share;
      x = ax * left + x * side;
      y = ay * left + y * side;
      z = az * left + z * side;
      w = aw * left + w * side;
      const size = 1 / Math.max(Math.sqrt(x * x + y * y + z * z + w * w), 1e-6);
      x *= size;
      y *= size;
      z *= size;
      w *= size;
    }
    const sx = scale[0], sy = scale[1], sz = scale[2];
    m[at] = (1 - 2 * (y * y + z * z)) * sx;
    m[at + 1] = 2 * (x * y + z * w) * sx;
    m[at + 2] = 2 * (x * z - y * w) * sx;
    m[at + 4] = 2 * (x * y - z * w) * sy;
    m[at + 5] = (1 - 2 * (x * x + z * z)) * sy;
    m[at + 6] = 2 * (y * z + x * w) * sy;
    m[at + 8] = 2 * (x * z + y * w) * sz;
    m[at + 9] = 2 * (y * z - x * w) * sz;
    m[at + 10] = (1 - 2 * (x * x + y * y)) * sz;
    m[at + 12] = px;
    m[at + 13] = py;
    m[at + 14] = pz;
    m[at + 15] = 1;
    this.touch(index);
  }

  /** Marks the changed part of the matrices for the graphics card. */
  finish(): void {
    const { instanceMatrix } = this.mesh, { range } = this;
    let start = this.first * MATRIX_NUMBERS, end = Math.min(this.last + 1, this.count) * MATRIX_NUMBERS;
    this.first = Infinity;
    this.last = -1;
    if (start >= end) return;
    if (instanceMatrix.updateRanges.length === 0) {
      instanceMatrix.updateRanges.push(range);
    } else {
      // The last changes were not drawn.
      start = Math.min(start, range.start);
      end = Math.max(end, range.start + range.count);
    }
    range.start = start;
    range.count = end - start;
    instanceMatrix.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.dispose();
  }

  private touch(index: number): void {
    if (index < this.first) this.first = index;
    if (index > this.last) this.last = index;
  }

  private changeCount(): void {
    this.mesh.count = this.count;
    this.mesh.visible = this.count > 0;
    if (this.hasInks) for (const name of INK_NAMES) this.mesh.geometry.getAttribute(name).needsUpdate = true;
  }

  private grow(): void {
    const bigger = (old: Float32Array): Float32Array<ArrayBuffer> => {
      const made = new Float32Array(2 * old.length);
      made.set(old);
      return made;
    };
    this.matrices = bigger(this.matrices);
    for (const [name, values] of this.inks) this.inks.set(name, bigger(values));
    const old = this.mesh;
    this.dispose();
    this.mesh = this.makeMesh();
    this.replaced(old, this.mesh);
  }

  private makeMesh(): InstancedMesh {
    const geometry = this.makeGeometry(), mesh = new InstancedMesh(geometry, this.material, 0);
    for (const [name, values] of this.inks) geometry.setAttribute(name, new InstancedBufferAttribute(values, INKS[name]).setUsage(DynamicDrawUsage));
    mesh.instanceMatrix = new InstancedBufferAttribute(this.matrices, MATRIX_NUMBERS).setUsage(DynamicDrawUsage);
    mesh.count = this.count;
    mesh.visible = this.count > 0;
    mesh.castShadow = this.castsShadow;
    mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    return mesh;
  }
}
