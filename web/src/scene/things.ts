// SPDX-License-Identifier: BSD-2-Clause
import { Group, InstancedMesh, Matrix4, Quaternion, Vector3, type BufferGeometry, type Material } from "three";
import { Shape, type Agent, type Drawable } from "../format/scene";
import { isJustSomeTexture, kindColor, lookOf, type Look, type Rgb } from "./looks";
import { geometryOf, type Materials } from "./materials";
import { looksLikeABody, shapeKey, type ShapeLibrary } from "./shape_library";
import type { Between } from "../run/playout";

/** The key of a drawable's shape, and the key of its complete appearance. */
interface Key { shape: string; whole: string }
interface Made { geometry: BufferGeometry; material: Material; castsShadow: boolean }
interface Batch { mesh: InstancedMesh; count: number }

function dulled(color: Rgb, keep: number, grey: number): Rgb {
  return [color[0] * keep + grey * (1 - keep), color[1] * keep + grey * (1 - keep), color[2] * keep + grey * (1 - keep)];
}

function agentLook(agent: Agent): Look {
  let base = kindColor(agent.kind);
  if (agent.failed) base = dulled(base, 0.35, 0.25);
  if (!agent.alive) base = dulled(base, 0, 0.3);
  return { ...lookOf("White"), base, gloss: 0.42 };
}

/** All drawables without a skeleton. Those with the same appearance share one draw call. */
export class Things {
  readonly group = new Group();
  private readonly made = new Map<string, Made>();
  private readonly keys = new WeakMap<Drawable, Key>();
  private readonly batches = new Map<string, Batch>();
  private readonly matrix = new Matrix4();
  private readonly place = new Vector3();
  private readonly turn = new Quaternion();
  private readonly other = new Quaternion();
  private readonly scale = new Vector3();

  constructor(private readonly materials: Materials, private readonly shapes: ShapeLibrary) {}

  show({ before, after, share }: Between): void {
    for (const batch of this.batches.values()) batch.count = 0;
    for (const [id, drawable] of after.drawables) {
      if (!drawable.visible || this.shapes.bodyOf(drawable) !== null) continue;
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
      this.add(drawable, agent, this.matrix.compose(this.place, this.turn, this.scale));
    }
    for (const batch of this.batches.values()) {
      batch.mesh.count = batch.count;
      batch.mesh.visible = batch.count > 0;
      batch.mesh.instanceMatrix.needsUpdate = true;
    }
  }

  private keyOf(d: Drawable, agent: Agent | undefined): Key {
    let key = this.keys.get(d);
    if (key === undefined) {
      const shape = shapeKey(d, looksLikeABody(d, agent));
      key = { shape, whole: `${shape}|${d.material}` };
      this.keys.set(d, key);
    }
    if (agent === undefined) return key;
    return { shape: key.shape, whole: `${key.whole}|${isJustSomeTexture(d.material) ? agent.kind : ""}|${agent.alive ? 1 : 0}${agent.failed ? 1 : 0}` };
  }

  /** Does not draw shapes that have not arrived yet. */
  private add(d: Drawable, agent: Agent | undefined, matrix: Matrix4): void {
    const key = this.keyOf(d, agent);
    let batch = this.batches.get(key.whole);
    if (batch === undefined || batch.count >= batch.mesh.instanceMatrix.count) {
      const made = this.make(key, d, agent);
      if (made === null) return;
      const { geometry, material, castsShadow } = made, room = batch === undefined ? 4 : batch.mesh.instanceMatrix.count * 2;
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
      this.batches.set(key.whole, (batch = { mesh, count }));
    }
    batch.mesh.setMatrixAt(batch.count, matrix);
    batch.count += 1;
  }

  private make(key: Key, d: Drawable, agent: Agent | undefined): Made | null {
    const known = this.made.get(key.whole);
    if (known !== undefined) return known;
    const mesh = this.shapes.mesh(key.shape, this.materials.isSlow ? 1 : 0);
    if (mesh === null) return null;
    // A model from a file has colours of its own.
    const isModel = mesh.material === "Soarbox/Model";
    const ownColor = agent !== undefined && isJustSomeTexture(d.material) && !isModel;
    // "NobiaxModular" is the default material of the kit's pieces.
    const fromMesh = d.material === "" || isModel || (d.shape === Shape.Mesh && d.material === "NobiaxModular");
    const name = ownColor ? `agent|${agent.kind}|${agent.alive}${agent.failed}` : fromMesh ? mesh.material : d.material;
    const look = ownColor ? agentLook(agent) : lookOf(name);
    // Figures of an agent that fell or failed are grey.
    const shown = agent !== undefined && this.shapes.isFigure(key.shape) && (!agent.alive || agent.failed) ? { ...look, base: dulled(look.base, 0.2, 0.35) } : look;
    const made = { geometry: geometryOf(mesh, shown), material: this.materials.of(ownColor ? "agent" : name, shown), castsShadow: d.shape !== Shape.Plane && look.opacity >= 1 };
    this.made.set(key.whole, made);
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
