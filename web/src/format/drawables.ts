// SPDX-License-Identifier: BSD-2-Clause
import { BadBytes, type ByteReader } from "./byte_reader";
import type { Bone, Description, Drawable, Movement, Quat, Vec3 } from "./scene";

/** A pose in Drawables.poses: x, y, z, then x, y, z, w of the turn. */
export const POSE_NUMBERS = 7;
const PER_METRE = 1000, PER_RADIAN = 2048, BONE_PER_RADIAN = 256, BONE_PER_METRE = 250;
/** A pose as it is sent: x, y, z in mm, and axis times angle in 1/2048 rad. */
const STEPS = 6;
const NO_BONES: readonly Bone[] = [];
const NO_MOVEMENTS: ReadonlyMap<number, readonly Movement[]> = new Map();

/** Number of the last block that was read by any reader, so that the versions of two readers always differ. */
let blocks = 0;

/** Which drawables exist, and their descriptions. Two moments with the same drawables share one structure. */
export class Structure {
  private slots: Map<number, number> | null = null;

  /** Both are indexed by slot; null: the slot is free. */
  constructor(readonly ids: readonly number[], readonly descriptions: readonly (Description | null)[], readonly size: number) {}

  slotOf(id: number): number | undefined {
    if (this.slots === null) {
      this.slots = new Map();
      for (let slot = 0; slot < this.ids.length; ++slot) if (this.descriptions[slot] !== null) this.slots.set(this.ids[slot]!, slot);
    }
    return this.slots.get(id);
  }
}

/**
 * All drawables of one moment, as columns. A drawable keeps its slot while it exists. Nothing changes after the moment
 * was read.
 */
export class Drawables {
  private readonly made: Drawable[] = [];

  /**
   * `versions`: per slot, the number of the block in which its pose changed last. `table`: only moments of the same
   * table have the same slots. `movements`: per slot, of models that have animations.
   */
  constructor(
    private readonly table: object, readonly structure: Structure, readonly poses: Float32Array, readonly versions: Uint32Array,
    private readonly bones: ReadonlyMap<number, readonly Bone[]>, private readonly movements: ReadonlyMap<number, readonly Movement[]> = NO_MOVEMENTS,
  ) {}

  get size(): number {
    return this.structure.size;
  }

  /** Whether this slot contains the same drawable at the other moment. */
  hasSame(slot: number, other: Drawables): boolean {
    return this.table === other.table && this.structure.ids[slot] === other.structure.ids[slot] && (other.structure.descriptions[slot] ?? null) !== null;
  }

  get(id: number): Drawable | undefined {
    const slot = this.structure.slotOf(id);
    return slot === undefined ? undefined : this.at(slot);
  }

  /** The drawable of a slot that is in use. Creates one object per slot and moment. */
  at(slot: number): Drawable {
    return (this.made[slot] ??= this.make(slot));
  }

  private make(slot: number): Drawable {
    const made = { ...this.structure.descriptions[slot]!, place: this.placeAt(slot), turn: this.turnAt(slot), bones: this.bones.get(slot) ?? NO_BONES }, movements = this.movements.get(slot);
    return movements === undefined ? made : { ...made, movements };
  }

  placeAt(slot: number): Vec3 {
    const { poses } = this, at = slot * POSE_NUMBERS;
    return [poses[at]!, poses[at + 1]!, poses[at + 2]!];
  }

  turnAt(slot: number): Quat {
    const { poses } = this, at = slot * POSE_NUMBERS + 3;
    return [poses[at]!, poses[at + 1]!, poses[at + 2]!, poses[at + 3]!];
  }

  hasBones(slot: number): boolean {
    return this.bones.has(slot);
  }
}

export const NO_DRAWABLES = new Drawables({}, new Structure([], [], 0), new Float32Array(0), new Uint32Array(0), new Map());

interface RawBone { turn: Vec3; place: Vec3 }
/** A movement as it is sent: how its time and its weight change per second. */
interface RawMovement extends Movement { speed: number; weightPerS: number }
interface RawMovements { atS: number; list: readonly RawMovement[] }

const bonePlace = (steps: Vec3): Vec3 => [steps[0] / BONE_PER_METRE, steps[1] / BONE_PER_METRE, steps[2] / BONE_PER_METRE];
function boneTurn(steps: Vec3): Quat {
  const turn = [0, 0, 0, 1] as [number, number, number, number];
  setTurn(turn, 0, steps[0] / BONE_PER_RADIAN, steps[1] / BONE_PER_RADIAN, steps[2] / BONE_PER_RADIAN);
  return turn;
}

/** Writes the quaternion of a rotation vector. */
function setTurn(into: Float32Array | number[], at: number, x: number, y: number, z: number): void {
  const angle = Math.sqrt(x * x + y * y + z * z), s = angle === 0 ? 0 : Math.sin(angle / 2) / angle;
  into[at] = x * s;
  into[at + 1] = y * s;
  into[at + 2] = z * s;
  into[at + 3] = Math.cos(angle / 2);
}

/** The same description as `old` returns `old`, so that equal descriptions are the same object. */
function readDescription(input: ByteReader, word: () => string, old: Description | null): Description {
  const end = input.endOfPiece();
  const owner = input.number(), flags = input.byte(), shape = input.byte(), mesh = word(), material = word();
  const ofAgent = (flags & 1) !== 0, visible = (flags & 2) !== 0, skeletonShown = (flags & 4) !== 0;
  const a = input.float(), b = input.float(), c = input.float(), d = input.float(), e = input.float(), f = input.float(), g = input.float(), h = input.float(), i = input.float();
  input.skipTo(end);
  const isSame = old !== null && old.owner === owner && old.ofAgent === ofAgent && old.visible === visible && old.skeletonShown === skeletonShown && old.shape === shape &&
    old.mesh === mesh && old.material === material && old.size[0] === a && old.size[1] === b && old.size[2] === c && old.repeats[0] === d && old.repeats[1] === e &&
    old.repeats[2] === f && old.scale[0] === g && old.scale[1] === h && old.scale[2] === i;
  return isSame ? old : { owner, ofAgent, visible, skeletonShown, shape, mesh, material, size: [a, b, c], repeats: [d, e, f], scale: [g, h, i] };
}

function readMovements(input: ByteReader): RawMovement[] {
  const list: RawMovement[] = [];
  for (let left = input.count(); left > 0; --left) list.push({ clip: input.number(), time: input.float(), weight: input.float(), speed: input.float(), weightPerS: input.float() });
  return list;
}

/**
 * Reads the sections of drawables. A pose that a full block repeats keeps its version, and a repeated description
 * stays the same object.
 */
export class DrawableTable {
  private ids: number[] = [];
  private descriptions: (Description | null)[] = [];
  private readonly slots = new Map<number, number>();
  private readonly free: number[] = [];
  private steps = new Int32Array(0);
  private poses = new Float32Array(0);
  private versions = new Uint32Array(0);
  /** The block that mentioned each slot last. */
  private seen = new Uint32Array(0);
  private readonly rawBones = new Map<number, RawBone[]>();
  private bones: Map<number, readonly Bone[]> = new Map();
  private readonly rawMovements = new Map<number, RawMovements>();
  private isOther = { structure: false, poses: false, bones: false };
  private last = NO_DRAWABLES;

  /** `word` reads a text of the block's table. `timeS`: the time of the moment that is read. */
  read(input: ByteReader, isFull: boolean, word: () => string, timeS = 0): Drawables {
    blocks += 1;
    let id = 0;
    for (let left = input.count(); left > 0; --left) this.remove((id += input.number()));
    for (id = 0; !input.atEnd();) this.readOne((id += input.number()), input, isFull, timeS, word);
    if (isFull) for (const [other, slot] of [...this.slots]) if (this.seen[slot] !== blocks) this.remove(other);
    return this.moment(timeS);
  }

  /** The moment of a block that changes no drawable: animations go on. */
  continued(timeS: number): Drawables {
    return this.rawMovements.size === 0 ? this.last : this.moment(timeS);
  }

  private readOne(id: number, input: ByteReader, isFull: boolean, timeS: number, word: () => string): void {
    const parts = input.byte(), known = this.slots.get(id);
    const before = known === undefined ? null : this.descriptions[known]!, isTold = (parts & 1) !== 0;
    if (!isTold && (before === null || isFull)) throw new BadBytes("a drawable has no description");
    const description = isTold ? readDescription(input, word, before) : before!, slot = known ?? this.add(id);
    this.seen[slot] = blocks;
    if (description !== before) {
      this.descriptions[slot] = description;
      this.isOther.structure = true;
    }
    // In a full block, values are differences from 0.
    const { steps } = this, at = slot * STEPS;
    let isMoved = known === undefined;
    for (let part = 0; part < 2; ++part) {
      const isSent = (parts & (2 << part)) !== 0;
      if (!isSent && !isFull) continue;
      for (let i = at + 3 * part; i < at + 3 * part + 3; ++i) {
        const value = (isFull ? 0 : steps[i]!) + (isSent ? input.signed() : 0);
        if (value === steps[i]) continue;
        steps[i] = value;
        isMoved = true;
      }
    }
    if (isMoved) this.pose(slot);
    if ((parts & 8) !== 0) this.readBones(slot, input, isFull);
    else if (isFull) this.removeBones(slot);
    if ((parts & 16) !== 0) this.setMovements(slot, { atS: timeS, list: readMovements(input) });
    else if (isFull) this.rawMovements.delete(slot);
  }

  private pose(slot: number): void {
    const { steps, poses } = this, from = slot * STEPS, to = slot * POSE_NUMBERS;
    for (let i = 0; i < 3; ++i) poses[to + i] = steps[from + i]! / PER_METRE;
    setTurn(poses, to + 3, steps[from + 3]! / PER_RADIAN, steps[from + 4]! / PER_RADIAN, steps[from + 5]! / PER_RADIAN);
    this.versions[slot] = blocks;
    this.isOther.poses = true;
  }

  private readBones(slot: number, input: ByteReader, isFull: boolean): void {
    const before = isFull ? [] : (this.rawBones.get(slot) ?? []), raw: RawBone[] = [];
    const moved = (from: Vec3): Vec3 => [from[0] + input.signed(), from[1] + input.signed(), from[2] + input.signed()];
    for (let left = input.count(); left > 0; --left) {
      const how = input.byte(), old: RawBone = before[raw.length] ?? { turn: [0, 0, 0], place: [0, 0, 0] };
      const turn = (how & 1) !== 0 ? moved(old.turn) : old.turn;
      raw.push({ turn, place: (how & 2) !== 0 ? moved(old.place) : old.place });
    }
    this.rawBones.set(slot, raw);
    this.changeBones().set(slot, raw.map((one): Bone => ({ turn: boneTurn(one.turn), place: bonePlace(one.place) })));
  }

  private setMovements(slot: number, movements: RawMovements): void {
    if (movements.list.length > 0) this.rawMovements.set(slot, movements);
    else this.rawMovements.delete(slot);
  }

  private removeBones(slot: number): void {
    if (this.rawBones.delete(slot)) this.changeBones().delete(slot);
  }

  /** The bones of the moment that is read; earlier moments keep theirs. */
  private changeBones(): Map<number, readonly Bone[]> {
    if (!this.isOther.bones) this.bones = new Map(this.bones);
    this.isOther.bones = true;
    return this.bones;
  }

  private add(id: number): number {
    const slot = this.free.pop() ?? this.ids.length;
    if (slot * STEPS >= this.steps.length) this.grow();
    this.slots.set(id, slot);
    this.ids[slot] = id;
    this.descriptions[slot] = null;
    this.steps.fill(0, slot * STEPS, (slot + 1) * STEPS);
    this.isOther.structure = true;
    return slot;
  }

  private remove(id: number): void {
    const slot = this.slots.get(id);
    if (slot === undefined) return;
    this.slots.delete(id);
    this.free.push(slot);
    this.descriptions[slot] = null;
    this.removeBones(slot);
    this.rawMovements.delete(slot);
    this.isOther.structure = true;
  }

  private grow(): void {
    const room = Math.max(64, (2 * this.steps.length) / STEPS);
    const bigger = <T extends Int32Array | Uint32Array | Float32Array>(made: T, old: T): T => {
      made.set(old);
      return made;
    };
    this.steps = bigger(new Int32Array(room * STEPS), this.steps);
    this.poses = bigger(new Float32Array(room * POSE_NUMBERS), this.poses);
    this.versions = bigger(new Uint32Array(room), this.versions);
    this.seen = bigger(new Uint32Array(room), this.seen);
  }

  private movementsAt(timeS: number): ReadonlyMap<number, readonly Movement[]> {
    if (this.rawMovements.size === 0) return NO_MOVEMENTS;
    return new Map([...this.rawMovements].map(([slot, { atS, list }]) => [slot, list.map(({ clip, time, weight, speed, weightPerS }): Movement => ({ clip, time: time + speed * (timeS - atS), weight: weight + weightPerS * (timeS - atS) }))]));
  }

  private moment(timeS: number): Drawables {
    const { isOther, last } = this, count = this.ids.length;
    this.isOther = { structure: false, poses: false, bones: false };
    const structure = isOther.structure ? new Structure(this.ids.slice(), this.descriptions.slice(), this.slots.size) : last.structure;
    const isOtherPose = isOther.poses || count !== last.versions.length;
    this.last = new Drawables(this, structure, isOtherPose ? this.poses.slice(0, count * POSE_NUMBERS) : last.poses, isOtherPose ? this.versions.slice(0, count) : last.versions, this.bones, this.movementsAt(timeS));
    return this.last;
  }
}
