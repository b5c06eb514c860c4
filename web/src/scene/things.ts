// SPDX-License-Identifier: BSD-2-Clause
import { Group, InstancedMesh, Matrix4, Quaternion, Vector3, type BufferGeometry, type Material } from "three";
import { Shape, type Agent, type Drawable } from "../format/scene";
import { isJustSomeTexture, kindColor, lookOf, type Look, type Rgb } from "./looks";
import { geometryOf, type Materials } from "./materials";
import { figureMesh, isFigure } from "./meshes/figures";
import type { MeshData } from "./meshes/mesh_data";
import { modularMesh } from "./meshes/modular";
import { sceneryMesh } from "./meshes/scenery";
import { agentMesh, boxMesh, capsuleMesh, coarsely, cylinderMesh, planeMesh, sphereMesh } from "./meshes/shapes";
import { bodyLook } from "./meshes/skeletons";
import type { Between } from "../run/playout";

interface Made { geometry: BufferGeometry; material: Material; castsShadow: boolean }
interface Batch { mesh: InstancedMesh; count: number }

function buildMesh(d: Drawable, coarse: boolean): MeshData {
  return coarsely(coarse, () => meshOf(d, coarse));
}

function meshOf(d: Drawable, coarse: boolean): MeshData {
  const [x, y, z] = d.size;
  const extents: readonly [number, number, number] = d.shape === Shape.Capsule ? [2 * x, y, 2 * x] : d.size;
  if (d.shape === Shape.Box || d.shape === Shape.Capsule) {
    const figure = figureMesh(d.material, extents, coarse);
    if (figure !== null) return figure;
  }
  switch (d.shape) {
    case Shape.Box: return boxMesh([-x / 2, -y / 2, -z / 2], [x / 2, y / 2, z / 2], { repeats: [d.repeats[0], d.repeats[1]] });
    case Shape.Capsule: return d.ofAgent ? agentMesh(x, y) : capsuleMesh(x, y);
    case Shape.Cylinder: return cylinderMesh(x, y);
    case Shape.Plane: return planeMesh(x, z, d.repeats[0], d.repeats[1]);
    case Shape.Sphere: return sphereMesh(x);
    default: break;
  }
  const known = modularMesh(d.mesh) ?? sceneryMesh(d.mesh);
  if (known !== null) return known;
  const box = boxMesh([-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]);
  box.material = "Soarbox/Missing";
  return box;
}

function dulled(color: Rgb, keep: number, grey: number): Rgb {
  return [color[0] * keep + grey * (1 - keep), color[1] * keep + grey * (1 - keep), color[2] * keep + grey * (1 - keep)];
}

function agentLook(agent: Agent): Look {
  let base = kindColor(agent.kind);
  if (agent.failed) base = dulled(base, 0.35, 0.25);
  if (!agent.alive) base = dulled(base, 0, 0.3);
  return { ...lookOf("White"), base, gloss: 0.42 };
}

/** Everything that has no skeleton: one draw call for all things that look the same. */
export class Things {
  readonly group = new Group();
  private readonly made = new Map<string, Made>();
  private readonly keys = new WeakMap<Drawable, string>();
  private readonly batches = new Map<string, Batch>();
  private readonly matrix = new Matrix4();
  private readonly place = new Vector3();
  private readonly turn = new Quaternion();
  private readonly other = new Quaternion();
  private readonly scale = new Vector3();

  constructor(private readonly materials: Materials) {}

  show({ before, after, share }: Between): void {
    for (const batch of this.batches.values()) batch.count = 0;
    for (const [id, drawable] of after.drawables) {
      if (!drawable.visible || (drawable.shape === Shape.Mesh && bodyLook(drawable.mesh) !== null)) continue;
      const agent = drawable.ofAgent ? after.agents.get(drawable.owner) : undefined;
      const old = before.drawables.get(id);
      this.place.set(...drawable.place);
      this.turn.set(...drawable.turn);
      if (old !== undefined && share < 1 && old !== drawable) {
        const gap = Math.hypot(drawable.place[0] - old.place[0], drawable.place[1] - old.place[1], drawable.place[2] - old.place[2]);
        if (gap < 3) {
          this.place.set(...old.place).lerp(new Vector3(...drawable.place), share);
          this.other.copy(this.turn);
          this.turn.set(...old.turn).slerp(this.other, share);
        }
      }
      this.scale.set(...drawable.scale);
      this.add(this.keyOf(drawable, agent), drawable, agent, this.matrix.compose(this.place, this.turn, this.scale));
    }
    for (const batch of this.batches.values()) {
      batch.mesh.count = batch.count;
      batch.mesh.visible = batch.count > 0;
      batch.mesh.instanceMatrix.needsUpdate = true;
    }
  }

  /** True if the world lies on the usual plain, which has hills around it. */
  private keyOf(d: Drawable, agent: Agent | undefined): string {
    const ownColor = agent !== undefined && isJustSomeTexture(d.material);
    const suffix = ownColor ? `|${agent.kind}|${agent.alive ? 1 : 0}${agent.failed ? 1 : 0}` : "";
    let key = this.keys.get(d);
    if (key === undefined) {
      key = d.shape === Shape.Mesh ? `m|${d.mesh}|${d.material}` : `${d.shape}|${d.ofAgent ? 1 : 0}|${d.size.join()}|${d.repeats[0]},${d.repeats[1]}|${d.material}`;
      this.keys.set(d, key);
    }
    return key + suffix;
  }

  private add(key: string, d: Drawable, agent: Agent | undefined, matrix: Matrix4): void {
    let batch = this.batches.get(key);
    if (batch === undefined || batch.count >= batch.mesh.instanceMatrix.count) {
      const { geometry, material, castsShadow } = this.make(key, d, agent), room = batch === undefined ? 4 : batch.mesh.instanceMatrix.count * 2;
      const mesh = new InstancedMesh(geometry, material, room);
      mesh.castShadow = castsShadow;
      mesh.receiveShadow = true;
      mesh.frustumCulled = false;
      const count = batch?.count ?? 0;
      if (batch !== undefined) {
        mesh.instanceMatrix.array.set(batch.mesh.instanceMatrix.array);
        this.group.remove(batch.mesh);
        batch.mesh.dispose();
      }
      this.group.add(mesh);
      this.batches.set(key, (batch = { mesh, count }));
    }
    batch.mesh.setMatrixAt(batch.count, matrix);
    batch.count += 1;
  }

  private make(key: string, d: Drawable, agent: Agent | undefined): Made {
    const known = this.made.get(key);
    if (known !== undefined) return known;
    const mesh = buildMesh(d, this.materials.isSlow), ownColor = agent !== undefined && isJustSomeTexture(d.material);
    // "NobiaxModular" is what the pieces of the kit wear anyway.
    const fromMesh = d.material === "" || (d.shape === Shape.Mesh && d.material === "NobiaxModular");
    const name = ownColor ? `agent|${agent.kind}|${agent.alive}${agent.failed}` : fromMesh ? mesh.material : d.material;
    const look = ownColor ? agentLook(agent) : lookOf(name);
    // Figures of an agent that fell or failed are grey.
    const shown = agent !== undefined && isFigure(d.material) && (!agent.alive || agent.failed) ? { ...look, base: dulled(look.base, 0.2, 0.35) } : look;
    const made = { geometry: geometryOf(mesh, shown), material: this.materials.of(ownColor ? "agent" : name, shown), castsShadow: d.shape !== Shape.Plane && look.opacity >= 1 };
    this.made.set(key, made);
    return made;
  }

  clear(): void {
    for (const { mesh } of this.batches.values()) {
      this.group.remove(mesh);
      mesh.dispose();
    }
    for (const { geometry } of this.made.values()) geometry.dispose();
    this.batches.clear();
    this.made.clear();
  }
}
