// SPDX-License-Identifier: BSD-2-Clause
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Frustum, Group, Matrix4, Mesh, Sphere, type PerspectiveCamera } from "three";
import { POSE_NUMBERS, type Structure } from "../format/drawables";
import type { Drawable } from "../format/scene";
import { lookOf, teamColor, type Look, type Rgb } from "./looks";
import { geometryOf, type Materials } from "./materials";
import { BONE_NUMBERS, moveSkin, poseBones, type Moved } from "./skinning";
import { withoutSmall, type BodyLook, type Level, type ShapeLibrary, type ShapeMesh } from "./shape_library";
import type { Between } from "../run/playout";

/**
 * Maximum distances, in m, and numbers of full and coarse bodies, and the distance for rifles: with a graphics card,
 * and if the processor draws.
 */
const DETAIL = { fineUntil: 14, mostFine: 24, coarseUntil: 45, mostCoarse: 200, rifleUntil: 150 }, SLOW_DETAIL = { fineUntil: 0, mostFine: 0, coarseUntil: 14, mostCoarse: 6, rifleUntil: 24 };
/** If the processor draws, distant bodies lack parts smaller than this: caps of limbs, seams. */
const SEEN_FROM_AFAR_M = 0.12;
/** Radius around a body that includes its outstretched arms and its raised rifle. */
const REACH_M = 1.6;

interface Wanted { now: Drawable; old: Drawable | undefined }
/** All bodies of one look, detail and team: one mesh. The processor moves its vertices. */
interface Batch { mesh: Mesh<BufferGeometry>; room: number; wanted: Wanted[]; look: BodyLook; level: Level; shape: ShapeMesh; moved: Moved }

/** Bodies with bones: soldiers and their rifles. */
export class Bodies {
  readonly group = new Group();
  private readonly batches = new Map<string, Batch>();
  private readonly frustum = new Frustum();
  private readonly sphere = new Sphere();
  private readonly matrix = new Matrix4();
  private bones = new Float32Array(0);
  /** The visible bodies with bones, and what they were found in. */
  private found: { slot: number; look: BodyLook }[] = [];
  private structure: Structure | null = null;
  private shapesSeen = 0;

  constructor(private readonly materials: Materials, private readonly shapes: ShapeLibrary) {}

  show({ before, after, share }: Between, camera: PerspectiveCamera, isSlow: boolean): void {
    camera.updateMatrixWorld();
    this.frustum.setFromProjectionMatrix(this.matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    for (const batch of this.batches.values()) batch.wanted.length = 0;
    const detail = isSlow ? SLOW_DETAIL : DETAIL;
    const now = after.drawables, near: { slot: number; look: BodyLook; away: number }[] = [], at = camera.position;
    this.find(now.structure);
    for (const { slot, look } of this.found) {
      this.sphere.center.fromArray(now.poses, slot * POSE_NUMBERS);
      this.sphere.center.y += look === "body/rifle" ? 0 : 0.9;
      this.sphere.radius = REACH_M;
      if (!this.frustum.intersectsSphere(this.sphere)) continue;
      const away = this.sphere.center.distanceTo(at);
      if (look !== "body/rifle" || away <= detail.rifleUntil) near.push({ slot, look, away });
    }
    for (const [i, { slot, look, away }] of near.sort((a, b) => a.away - b.away).entries()) {
      const level = i < detail.mostFine && away < detail.fineUntil ? 0 : i < detail.mostCoarse && away < detail.coarseUntil ? 1 : 2;
      const drawable = now.at(slot), team = drawable.ofAgent ? (after.agents.get(drawable.owner)?.team ?? "") : "";
      this.batchFor(look, level, team, isSlow)?.wanted.push({ now: drawable, old: now.hasSame(slot, before.drawables) ? before.drawables.at(slot) : undefined });
    }
    for (const [key, batch] of this.batches) this.fill(key, batch, share);
  }

  private find(structure: Structure): void {
    if (structure === this.structure && this.shapes.changes === this.shapesSeen) return;
    this.structure = structure;
    this.shapesSeen = this.shapes.changes;
    this.found = [];
    structure.descriptions.forEach((one, slot) => {
      const look = one?.visible === true ? this.shapes.bodyOf(one) : null;
      if (look !== null && this.shapes.mesh(look, 1) !== null) this.found.push({ slot, look });
    });
  }

  private fill(key: string, batch: Batch, share: number): void {
    const { wanted, look, shape } = batch;
    batch.mesh.visible = wanted.length > 0;
    if (wanted.length === 0) return;
    if (wanted.length > batch.room) this.grow(key, batch, wanted.length);
    const bones = this.shapes.bones(look);
    if (this.bones.length < bones.length * BONE_NUMBERS) this.bones = new Float32Array(bones.length * BONE_NUMBERS);
    const { geometry } = batch.mesh;
    wanted.forEach(({ now, old }, i) => {
      poseBones(bones, now, old, share, this.bones);
      moveSkin(shape, this.bones, batch.moved, i * shape.count);
    });
    for (const name of ["position", "normal"] as const) {
      const attribute = geometry.getAttribute(name) as BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, wanted.length * shape.count * attribute.itemSize);
      attribute.needsUpdate = true;
    }
    geometry.setDrawRange(0, wanted.length * shape.indices.length);
  }

  private batchFor(look: BodyLook, level: Level, team: string, isSlow: boolean): Batch | null {
    const key = `${look}|${level}|${team}`, known = this.batches.get(key);
    if (known !== undefined) return known;
    const told = this.shapes.mesh(look, level);
    if (told === null) return null;
    const mesh = new Mesh(new BufferGeometry(), this.materials.of("Soarbox/Soldier", CLOTH_LOOK));
    mesh.castShadow = mesh.receiveShadow = !isSlow || level < 2;
    // Bodies out of sight are left out.
    mesh.frustumCulled = false;
    this.group.add(mesh);
    const batch: Batch = { mesh, room: 0, wanted: [], look, level, shape: isSlow && level === 2 ? withoutSmall(told, SEEN_FROM_AFAR_M) : told, moved: { positions: new Float32Array(0), normals: new Int8Array(0) } };
    this.batches.set(key, batch);
    return batch;
  }

  /** Makes room for more bodies. The constant data of each vertex is stored once per body. */
  private grow(key: string, batch: Batch, least: number): void {
    const { shape } = batch, one = geometryOf(shape, { ...CLOTH_LOOK, trim: teamColor(key.slice(key.lastIndexOf("|") + 1)) });
    const room = Math.max(least, 2 * batch.room, 4), { count, indices } = shape, all = new Uint32Array(room * indices.length), geometry = new BufferGeometry();
    for (let i = 0; i < room; ++i) for (let k = 0; k < indices.length; ++k) all[i * indices.length + k] = indices[k]! + i * count;
    geometry.setIndex(new BufferAttribute(all, 1));
    for (const name of ["uv", "color", "gloss"]) {
      const attribute = one.getAttribute(name), repeated = new Float32Array(room * attribute.array.length);
      for (let i = 0; i < room; ++i) repeated.set(attribute.array, i * attribute.array.length);
      geometry.setAttribute(name, new BufferAttribute(repeated, attribute.itemSize));
    }
    batch.moved = { positions: new Float32Array(3 * count * room), normals: new Int8Array(4 * count * room) };
    geometry.setAttribute("position", new BufferAttribute(batch.moved.positions, 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("normal", new BufferAttribute(batch.moved.normals, 4, true).setUsage(DynamicDrawUsage));
    one.dispose();
    batch.mesh.geometry.dispose();
    batch.mesh.geometry = geometry;
    batch.room = room;
  }

  clear(): void {
    for (const { mesh } of this.batches.values()) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
    }
    this.batches.clear();
    this.structure = null;
  }
}

const CLOTH: Rgb = [1, 1, 1];
const CLOTH_LOOK: Look = { ...lookOf("White"), base: CLOTH, paint: "cloth", gloss: 0.02 };
