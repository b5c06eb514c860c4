// SPDX-License-Identifier: BSD-2-Clause
import { Group, type InstancedMesh } from "three";
import { NO_DRAWABLES, POSE_NUMBERS, type Drawables, type Structure } from "../format/drawables";
import { Shape, type Agent, type Description } from "../format/scene";
import { isJustSomeTexture, kindColor, lookOf, type Look, type Rgb } from "./looks";
import { geometryOf, type Materials } from "./materials";
import { looksLikeABody, shapeKey, type ShapeLibrary, type ShapeMesh } from "./shape_library";
import { inkedGeometry, inksOf, ThingBatch, type Inks } from "./thing_batch";
import type { Between } from "../run/playout";

/** A body that moves further than this between two moments was teleported. */
export const JUMP_M = 3;
/** The number of a drawable's batch if it is in none. */
const NONE = -1;

/** How a drawable is drawn. `named`: the name of a look that instances cannot have; empty: instances have colours. */
interface Worn { look: Look; named: string }
/** A drawable of an agent. Its look depends on the agent. */
interface OfAgent { slot: number; owner: number; agent: Agent | undefined }

function dulled(color: Rgb, keep: number, grey: number): Rgb {
  return [color[0] * keep + grey * (1 - keep), color[1] * keep + grey * (1 - keep), color[2] * keep + grey * (1 - keep)];
}

function agentLook(agent: Agent): Look {
  let base = kindColor(agent.kind);
  if (agent.failed) base = dulled(base, 0.35, 0.25);
  if (!agent.alive) base = dulled(base, 0, 0.3);
  return { ...lookOf("White"), base, gloss: 0.42 };
}

const looksSame = (a: Agent | undefined, b: Agent | undefined): boolean => a === b || (a !== undefined && b !== undefined && a.kind === b.kind && a.alive === b.alive && a.failed === b.failed && a.height === b.height);

/**
 * All drawables without a skeleton. Those with the same shape share one draw call, whatever their materials are. A
 * picture writes only the matrices of those that move.
 */
export class Things {
  readonly group = new Group();
  private readonly batches = new Map<string, ThingBatch>();
  private readonly inks = new Map<string, Inks>();
  /** By slot: the description that is drawn, the batch and the instance in it, and the version of the written pose. */
  private shown: (Description | null)[] = [];
  private batchOf: (ThingBatch | null)[] = [];
  private instanceOf = new Int32Array(0);
  private written = new Uint32Array(0);
  private ofAgents: OfAgent[] = [];
  private structure: Structure | null = null;
  private agents: ReadonlyMap<number, Agent> | null = null;
  private shapesSeen = 0;

  constructor(private readonly materials: Materials, private readonly shapes: ShapeLibrary) {}

  show({ before, after, share }: Between): void {
    const now = after.drawables;
    if (after.agents !== this.agents) this.dress(after.agents);
    if (now.structure !== this.structure || this.shapes.changes !== this.shapesSeen) this.arrange(now.structure, after.agents);
    this.move(share < 1 ? before.drawables : NO_DRAWABLES, now, share);
    for (const batch of this.batches.values()) batch.finish();
  }

  private move(before: Drawables, now: Drawables, share: number): void {
    const { versions, poses } = now, old = before.versions, { written, batchOf } = this, count = versions.length;
    for (let slot = 0; slot < count; ++slot) {
      const version = versions[slot]!;
      // It rests between the two moments, and its pose is written.
      if (written[slot] === version && (old[slot] === version || before === NO_DRAWABLES)) continue;
      const batch = batchOf[slot];
      if (batch === null || batch === undefined) continue;
      const isMoving = slot < old.length && old[slot] !== version && now.hasSame(slot, before) && !jumps(before.poses, poses, slot);
      if (!isMoving && written[slot] === version) continue;
      batch.place(this.instanceOf[slot]!, slot, before.poses, poses, isMoving ? share : 1, this.shown[slot]!.scale);
      written[slot] = isMoving ? 0 : version;
    }
  }

  /** Distributes new and changed drawables to batches, and those whose shapes have arrived since the last call. */
  private arrange(structure: Structure, agents: ReadonlyMap<number, Agent>): void {
    const { descriptions } = structure, count = Math.max(descriptions.length, this.shown.length), hasShapes = this.shapes.changes !== this.shapesSeen;
    if (this.instanceOf.length < count) {
      const instances = new Int32Array(2 * count), versions = new Uint32Array(2 * count);
      instances.set(this.instanceOf);
      versions.set(this.written);
      this.instanceOf = instances;
      this.written = versions;
    }
    for (let slot = 0; slot < count; ++slot) {
      const description = descriptions[slot] ?? null, shown = this.shown[slot] ?? null;
      if (description === shown && !(hasShapes && description !== null && (this.batchOf[slot] ?? null) === null)) continue;
      this.shown[slot] = description;
      this.put(slot, description, description?.ofAgent === true ? agents.get(description.owner) : undefined);
    }
    this.ofAgents = [];
    descriptions.forEach((one, slot) => one?.ofAgent === true && this.ofAgents.push({ slot, owner: one.owner, agent: agents.get(one.owner) }));
    this.structure = structure;
    this.agents = agents;
    this.shapesSeen = this.shapes.changes;
  }

  /** Changes the looks of drawables whose agents look different now. */
  private dress(agents: ReadonlyMap<number, Agent>): void {
    this.agents = agents;
    for (const one of this.ofAgents) {
      const agent = agents.get(one.owner);
      if (!looksSame(agent, one.agent)) this.put(one.slot, this.shown[one.slot]!, agent);
      one.agent = agent;
    }
  }

  /** Moves a drawable to the batch that draws it. In none: it is not visible, or its shape has not arrived yet. */
  private put(slot: number, d: Description | null, agent: Agent | undefined): void {
    this.leave(slot);
    if (d === null || !d.visible || this.shapes.bodyOf(d) !== null || this.shapes.motionOf(d) !== null) return;
    const key = shapeKey(d, looksLikeABody(d, agent)), mesh = this.shapes.mesh(key, this.materials.isSlow ? 1 : 0);
    if (mesh === null) return;
    const { look, named } = this.wornBy(d, agent, mesh, this.shapes.isFigure(key)), castsShadow = d.shape !== Shape.Plane && look.opacity >= 1;
    const batch = this.batchFor(mesh, look, named, castsShadow);
    this.batchOf[slot] = batch;
    this.instanceOf[slot] = batch.add(slot, named === "" ? this.inksFor(look) : null);
  }

  private leave(slot: number): void {
    const batch = this.batchOf[slot] ?? null, instance = this.instanceOf[slot]!;
    this.batchOf[slot] = null;
    this.written[slot] = 0;
    if (batch === null) return;
    const moved = batch.remove(instance);
    if (moved !== NONE) this.instanceOf[moved] = instance;
  }

  private wornBy(d: Description, agent: Agent | undefined, mesh: ShapeMesh, isFigure: boolean): Worn {
    // A model from a file has colours of its own.
    const isModel = mesh.material === "Soarbox/Model";
    const ownColor = agent !== undefined && isJustSomeTexture(d.material) && !isModel;
    // "NobiaxModular" is the default material of the kit's pieces.
    const fromMesh = d.material === "" || isModel || (d.shape === Shape.Mesh && d.material === "NobiaxModular");
    const name = fromMesh ? mesh.material : d.material, look = ownColor ? agentLook(agent) : lookOf(name);
    if (look.paint === "ground" || look.paint === "corners") return { look, named: name };
    // Figures of an agent that fell or failed are grey.
    const isGrey = agent !== undefined && isFigure && (!agent.alive || agent.failed);
    return { look: isGrey ? { ...look, base: dulled(look.base, 0.2, 0.35) } : look, named: "" };
  }

  private inksFor(look: Look): Inks {
    const key = `${look.base.join()}|${look.trim?.join() ?? ""}|${look.gloss}|${look.glow}|${look.paint}|${look.repeats}`;
    let inks = this.inks.get(key);
    if (inks === undefined) this.inks.set(key, (inks = inksOf(look)));
    return inks;
  }

  private batchFor(mesh: ShapeMesh, look: Look, named: string, castsShadow: boolean): ThingBatch {
    const key = `${mesh.number}|${named}|${look.opacity}|${castsShadow}`, known = this.batches.get(key);
    if (known !== undefined) return known;
    const isInked = named === "", material = isInked ? this.materials.inked(look.opacity) : this.materials.of(named, look);
    const replaced = (old: InstancedMesh, by: InstancedMesh): void => {
      this.group.remove(old);
      this.group.add(by);
    };
    const batch = new ThingBatch(() => (isInked ? inkedGeometry(mesh) : geometryOf(mesh, look)), material, castsShadow, isInked, replaced);
    this.group.add(batch.mesh);
    this.batches.set(key, batch);
    return batch;
  }

  clear(): void {
    for (const batch of this.batches.values()) {
      this.group.remove(batch.mesh);
      batch.dispose();
    }
    this.batches.clear();
    this.shown = [];
    this.batchOf = [];
    this.written.fill(0);
    this.ofAgents = [];
    this.structure = null;
    this.agents = null;
  }
}

function jumps(before: Float32Array, after: Float32Array, slot: number): boolean {
  const at = slot * POSE_NUMBERS, x = after[at]! - before[at]!, y = after[at + 1]! - before[at + 1]!, z = after[at + 2]! - before[at + 2]!;
  return x * x + y * y + z * z >= JUMP_M * JUMP_M;
}
