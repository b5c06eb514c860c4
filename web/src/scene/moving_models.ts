// SPDX-License-Identifier: BSD-2-Clause
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Frustum, Group, Matrix4, Mesh, Sphere, type PerspectiveCamera } from "three";
import type { Structure } from "../format/drawables";
import type { Drawable } from "../format/scene";
import type { Between } from "../run/playout";
import { lookOf } from "./looks";
import { geometryOf, type Materials } from "./materials";
import { JOINT_NUMBERS, moveCorners, poseJoints, type Motion } from "./model_motion";
import { shapeKey, type ShapeLibrary, type ShapeMesh } from "./shape_library";
import { JUMP_M } from "./things";

/** Animations may move corners away from where they are at rest. */
const REACH = 2;

interface Made { mesh: Mesh<BufferGeometry>; key: string; shape: ShapeMesh; motion: Motion; positions: Float32Array<ArrayBuffer>; normals: Int8Array<ArrayBuffer>; radius: number }

/** Whether a drawable shows the same model as at the earlier moment, and was not teleported. */
function continues(old: Drawable | undefined, now: Drawable): boolean {
  return old !== undefined && old.mesh === now.mesh && Math.hypot(now.place[0] - old.place[0], now.place[1] - old.place[1], now.place[2] - old.place[2]) < JUMP_M;
}

/** Models from files with skins or animations, one mesh for each drawable. The processor moves their vertices. */
export class MovingModels {
  readonly group = new Group();
  private readonly made = new Map<number, Made>();
  private readonly frustum = new Frustum();
  private readonly sphere = new Sphere();
  private readonly matrix = new Matrix4();
  private joints = new Float32Array(0);
  private found: { slot: number; motion: Motion }[] = [];
  private structure: Structure | null = null;
  private shapesSeen = 0;

  constructor(private readonly materials: Materials, private readonly shapes: ShapeLibrary) {}

  show({ before, after, share }: Between, camera: PerspectiveCamera): void {
    camera.updateMatrixWorld();
    this.frustum.setFromProjectionMatrix(this.matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    for (const one of this.made.values()) one.mesh.visible = false;
    const { structure } = after.drawables;
    this.find(structure);
    for (const { slot, motion } of this.found) {
      const now = after.drawables.at(slot), old = before.drawables.get(structure.ids[slot]!);
      this.place(structure.ids[slot]!, now, continues(old, now) ? old : undefined, share, motion);
    }
    for (const [id, one] of this.made) {
      if (structure.slotOf(id) !== undefined) continue;
      this.remove(one);
      this.made.delete(id);
    }
  }

  /** Searches the models again if drawables or shapes have changed since the last picture. */
  private find(structure: Structure): void {
    if (structure === this.structure && this.shapes.changes === this.shapesSeen) return;
    this.structure = structure;
    this.shapesSeen = this.shapes.changes;
    this.found = [];
    structure.descriptions.forEach((description, slot) => {
      const motion = description?.visible === true ? this.shapes.motionOf(description) : null;
      if (motion !== null) this.found.push({ slot, motion });
    });
  }

  private place(id: number, now: Drawable, old: Drawable | undefined, share: number, motion: Motion): void {
    const key = shapeKey(now, false);
    let one = this.made.get(id);
    if (one === undefined || one.key !== key) {
      if (one !== undefined) this.remove(one);
      const shape = this.shapes.mesh(key, 0);
      if (shape === null) return;
      one = this.make(key, shape, motion);
      this.made.set(id, one);
    }
    this.sphere.center.set(...now.place);
    this.sphere.radius = REACH * one.radius * Math.max(...now.scale.map(Math.abs));
    one.mesh.visible = this.frustum.intersectsSphere(this.sphere);
    if (!one.mesh.visible) return;
    if (this.joints.length < JOINT_NUMBERS * motion.joints.length) this.joints = new Float32Array(JOINT_NUMBERS * motion.joints.length);
    poseJoints(motion, now, old, share, this.joints);
    moveCorners(one.shape, this.joints, one.positions, one.normals);
    for (const name of ["position", "normal"] as const) one.mesh.geometry.getAttribute(name).needsUpdate = true;
  }

  private make(key: string, shape: ShapeMesh, motion: Motion): Made {
    const look = lookOf(shape.material), geometry = geometryOf(shape, look);
    const positions = new Float32Array(3 * shape.count), normals = new Int8Array(4 * shape.count);
    geometry.setAttribute("position", new BufferAttribute(positions, 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("normal", new BufferAttribute(normals, 4, true).setUsage(DynamicDrawUsage));
    const mesh = new Mesh(geometry, this.materials.named(shape.material));
    mesh.castShadow = mesh.receiveShadow = true;
    // Models out of sight are left out.
    mesh.frustumCulled = false;
    this.group.add(mesh);
    let radius = 0;
    for (let i = 0; i < shape.count; ++i) radius = Math.max(radius, Math.hypot(shape.positions[3 * i]!, shape.positions[3 * i + 1]!, shape.positions[3 * i + 2]!));
    return { mesh, key, shape, motion, positions, normals, radius };
  }

  private remove(one: Made): void {
    this.group.remove(one.mesh);
    one.mesh.geometry.dispose();
  }

  clear(): void {
    this.found = [];
    this.structure = null;
    for (const one of this.made.values()) this.remove(one);
    this.made.clear();
  }
}
