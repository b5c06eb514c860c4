// SPDX-License-Identifier: BSD-2-Clause
import { BadBytes, ByteReader } from "./byte_reader";
import { DrawableTable, NO_DRAWABLES } from "./drawables";
import type { Agent, Camera, Circle, Color, Component, Contact, Light, Line, Lines, Mind, NamedPlace, Particle, Push, Quat, Scene, Shot, Sound, Speech, Surroundings, Triangle, Vec3 } from "./scene";

const MARK = 0x53, VERSION = 1, FULL = 1, DEFLATED = 2;
const HEAD_BYTES = 3;
const PER_METRE = 1000, PER_RADIAN = 2048, PER_DIRECTION = 500, PER_SIGN = 10;
const NO_LINES: Lines = { lines: [], circles: [], triangles: [] };
const KINDS = ["waypoint", "region", "item", "thing"] as const;

type Steps = [number, number, number];
interface RawAgent { made: Agent; place: Steps; forward: Steps }

/** Whether a reader may begin with this block. */
export function isFull(block: Uint8Array): boolean {
  return ((block[2] ?? 0) & FULL) !== 0;
}

/** The decompressed payload of a block. */
export async function unpack(block: Uint8Array): Promise<Uint8Array> {
  if (block[0] !== MARK || block.length < HEAD_BYTES) throw new BadBytes("this is not a block of a scene");
  if (block[1] !== VERSION) throw new BadBytes("this page and the engine are of different versions: load the page again");
  const rest = block.slice(HEAD_BYTES);
  if (((block[2] ?? 0) & DEFLATED) === 0) return rest;
  const plain = new Blob([rest]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(plain).arrayBuffer());
}

function vector(steps: Steps, perUnit: number): Vec3 {
  return [steps[0] / perUnit, steps[1] / perUnit, steps[2] / perUnit];
}

function quaternion(steps: Steps, perRadian: number): Quat {
  const [x, y, z] = vector(steps, perRadian);
  const angle = Math.hypot(x, y, z);
  if (angle === 0) return [0, 0, 0, 1];
  const s = Math.sin(angle / 2) / angle;
  return [x * s, y * s, z * s, Math.cos(angle / 2)];
}

function add(input: ByteReader, steps: Steps): Steps {
  return [steps[0] + input.signed(), steps[1] + input.signed(), steps[2] + input.signed()];
}

function whole(input: ByteReader, perUnit: number): Vec3 {
  return vector(add(input, [0, 0, 0]), perUnit);
}

function floats(input: ByteReader): Vec3 {
  return [input.float(), input.float(), input.float()];
}

function color(input: ByteReader): Color {
  return [input.byte() / 255, input.byte() / 255, input.byte() / 255, input.byte() / 255];
}

function list<T>(input: ByteReader, leastBytes: number, one: () => T): T[] {
  const made: T[] = [];
  for (let left = input.count(leastBytes); left > 0; --left) made.push(one());
  return made;
}

/** Converts blocks to moments. A returned moment is never changed. */
export class SceneReader {
  private texts: string[] = [""];
  private things = new DrawableTable();
  private people = new Map<number, RawAgent>();
  private minds = new Map<number, Mind>();
  private last: Scene | null = null;

  /** `payload`: of unpack(). Null while no full block was read. Throws BadBytes; the next full block is read again. */
  read(payload: Uint8Array, full: boolean): Scene | null {
    if (full) this.begin();
    else if (this.last === null) return null;
    try {
      this.last = this.readMoment(new ByteReader(payload), full);
      return this.last;
    } catch (error) {
      this.forget();
      throw error;
    }
  }

  private forget(): void {
    this.begin();
    this.things = new DrawableTable();
  }

  /** Before a full block. The table of drawables recognizes those that the block repeats. */
  private begin(): void {
    this.texts = [""];
    this.people.clear();
    this.minds.clear();
    this.last = null;
  }

  private readMoment(input: ByteReader, full: boolean): Scene {
    const before = this.last;
    const scene: Scene = {
      tick: input.number(),
      time: input.double(),
      surroundings: before?.surroundings ?? null,
      camera: before?.camera ?? null,
      drawables: before?.drawables ?? NO_DRAWABLES,
      agents: before?.agents ?? new Map(),
      lines: before?.lines ?? NO_LINES,
      overlayLines: before?.overlayLines ?? NO_LINES,
      minds: before?.minds ?? new Map(),
      shots: before?.shots ?? [],
      speech: before?.speech ?? [],
      places: before?.places ?? [],
      pushes: before?.pushes ?? [],
      components: before?.components ?? [],
      particles: before?.particles ?? [],
      sounds: before?.sounds ?? [],
    };
    this.texts.push(...list(input, 1, () => input.text()));
    for (let tag = input.byte(); tag !== 0; tag = input.byte()) this.readSection(tag, new ByteReader(input.piece()), scene, full);
    // A full block without drawables.
    if (scene.drawables === NO_DRAWABLES) this.things = new DrawableTable();
    else if (scene.drawables === before?.drawables) scene.drawables = this.things.continued(scene.time);
    return scene;
  }

  private readSection(tag: number, input: ByteReader, scene: Scene, full: boolean): void {
    switch (tag) {
      case 1: scene.surroundings = this.surroundings(input); break;
      case 2: scene.camera = this.camera(input); break;
      case 3: scene.drawables = this.things.read(input, full, () => this.word(input), scene.time); break;
      case 4: scene.agents = this.agents(input); break;
      case 5: scene.components = this.components(input); break;
      case 6: scene.lines = this.lines(input); break;
      case 7: scene.particles = this.particles(input); break;
      case 8: scene.minds = this.readMinds(input); break;
      case 9: [scene.shots, scene.speech] = this.shotsAndSpeech(input); break;
      case 10: scene.places = this.places(input); break;
      case 11: scene.pushes = this.pushes(input); break;
      case 13: scene.sounds = this.sounds(input); break;
      case 12: scene.overlayLines = this.lines(input); break;
      default: break;
    }
  }

  private word(input: ByteReader): string {
    const text = this.texts[input.number()];
    if (text === undefined) throw new BadBytes("a text is missing");
    return text;
  }

  private surroundings(input: ByteReader): Surroundings {
    const ambient = floats(input), sky = this.word(input), skyTurnDeg = floats(input);
    const palette: Color[] = [];
    for (let i = 0; i < 10; ++i) palette.push(color(input));
    const lights = list(input, 60, (): Light => ({
      id: input.number(), directional: input.byte() === 0, castsShadows: input.byte() !== 0, place: floats(input), direction: floats(input),
      diffuse: floats(input), specular: floats(input), range: input.float(), attenuation: floats(input),
    }));
    return { ambient, sky, skyTurnDeg, palette, lights };
  }

  private camera(input: ByteReader): Camera {
    return { moves: input.number(), place: whole(input, PER_METRE), turn: quaternion(add(input, [0, 0, 0]), PER_RADIAN), fovDeg: input.float() };
  }

  /** Removes the deleted entries, then reads the changed ones. */
  private entries(input: ByteReader, gone: (id: number) => void, changed: (id: number) => void): void {
    let id = 0;
    for (let left = input.count(); left > 0; --left) gone((id += input.number()));
    for (id = 0; !input.atEnd();) changed((id += input.number()));
  }

  private agents(input: ByteReader): Map<number, Agent> {
    this.entries(input, (id) => this.people.delete(id), (id) => {
      const parts = input.byte();
      const raw = this.people.get(id);
      let made: Agent = raw?.made ?? {
        name: "", kind: "", script: "", team: "", radius: 0.5, height: 2, place: [0, 0, 0], forward: [0, 0, 1], health: 100, alive: true,
        failed: false, lastCommand: "",
      };
      if ((parts & 1) !== 0) {
        const told = new ByteReader(input.piece());
        made = {
          ...made, name: this.word(told), kind: this.word(told), script: this.word(told), team: this.word(told), radius: told.float(),
          height: told.float(),
        };
      }
      const place = (parts & 2) !== 0 ? add(input, raw?.place ?? [0, 0, 0]) : (raw?.place ?? [0, 0, 0]);
      const forward = (parts & 4) !== 0 ? add(input, raw?.forward ?? [0, 0, 0]) : (raw?.forward ?? [0, 0, 0]);
      made = { ...made, place: vector(place, PER_METRE), forward: vector(forward, PER_DIRECTION) };
      if ((parts & 16) !== 0) {
        const state = new ByteReader(input.piece());
        const health = state.signed() / 10, flags = state.byte();
        made = { ...made, health, alive: (flags & 1) !== 0, failed: (flags & 2) !== 0, lastCommand: this.word(state) };
      }
      this.people.set(id, { made, place, forward });
    });
    return new Map([...this.people].map(([id, raw]) => [id, raw.made]));
  }

  private components(input: ByteReader): Component[] {
    return list(input, 43, (): Component => {
      const id = input.number(), parent = input.number(), layer = input.signed();
      const x = input.float(), y = input.float(), width = input.float(), height = input.float(), marginLeft = input.float(), marginTop = input.float();
      const flags = input.byte(), from = color(input), to = color(input), textColor = color(input), font = input.byte();
      const text = this.word(input), material = this.word(input), caption = this.word(input);
      const button = (flags & 64) !== 0 ? this.word(input) : "";
      const bar = (flags & 128) !== 0 ? { share: input.float(), color: color(input) } : null;
      const direction = (flags & 8) !== 0 ? "diagonal" : (flags & 4) !== 0 ? "vertical" : "horizontal";
      return {
        id, parent, layer, x, y, width, height, marginLeft, marginTop, visible: (flags & 1) !== 0, gradient: (flags & 2) !== 0 ? { from, to, direction } : null,
        isMarkup: (flags & 16) !== 0, textColor, font, text, material, caption, button, bar,
        world: (flags & 32) !== 0 ? { place: whole(input, PER_METRE), turn: quaternion(add(input, [0, 0, 0]), PER_RADIAN) } : null,
      };
    });
  }

  private particles(input: ByteReader): Particle[] {
    return list(input, 10, (): Particle => {
      const id = input.number(), effect = this.word(input), flags = input.byte(), restarts = input.number();
      return { id, effect, visible: (flags & 1) !== 0, directed: (flags & 2) !== 0, restarts, place: whole(input, PER_METRE), direction: whole(input, PER_DIRECTION) };
    });
  }

  private sounds(input: ByteReader): Sound[] {
    return list(input, 7, (): Sound => {
      const id = input.number(), file = this.word(input), volume = input.float(), isPlaced = input.byte() !== 0;
      return { id, file, volume, place: isPlaced ? whole(input, PER_METRE) : null };
    });
  }

  private lines(input: ByteReader): Lines {
    let last: Steps = [0, 0, 0];
    const point = (): Vec3 => vector((last = add(input, last)), PER_METRE);
    const lines = list(input, 10, (): Line => ({ from: point(), to: point(), color: color(input) }));
    const circles = list(input, 8, (): Circle => ({ center: point(), radius: input.signed() / PER_METRE, color: color(input) }));
    const triangles = list(input, 13, (): Triangle => ({ a: point(), b: point(), c: point(), color: color(input) }));
    return { lines, circles, triangles };
  }

  private readMinds(input: ByteReader): Map<number, Mind> {
    this.entries(input, (id) => this.minds.delete(id), (id) => this.minds.set(id, this.mind(new ByteReader(input.piece()))));
    return new Map(this.minds);
  }

  private mind(input: ByteReader): Mind {
    const operator = this.word(input), doing = this.word(input), flags = input.byte();
    const senses = (flags & 1) !== 0 ? { sight: input.signed() / PER_SIGN, viewDeg: input.signed(), hearing: input.signed() / PER_SIGN } : null;
    const measured = (flags & 2) !== 0 ? whole(input, PER_SIGN) : null;
    const goal = (flags & 4) !== 0 ? whole(input, PER_SIGN) : null;
    const target = input.number(), leader = input.number();
    let last: Steps = [0, 0, 0];
    const path = list(input, 3, (): Vec3 => vector((last = add(input, last)), PER_SIGN));
    const contacts = list(input, 6, (): Contact => {
      const agent = input.number(), place = whole(input, PER_SIGN), how = input.byte();
      return { agent, place, visible: (how & 1) !== 0, heard: (how & 2) !== 0, alive: (how & 4) !== 0, forgotten: input.byte() / 20 };
    });
    return { operator, doing, senses, measured, goal, target, leader, pathIsWhole: (flags & 8) !== 0, path, contacts };
  }

  private shotsAndSpeech(input: ByteReader): [Shot[], Speech[]] {
    const shots = list(input, 9, (): Shot => ({
      from: whole(input, PER_METRE), to: whole(input, PER_METRE), shooter: input.number(), hit: input.number(), time: input.signed() / 100,
    }));
    const speech = list(input, 4, (): Speech => ({ from: input.number(), to: input.number(), text: this.word(input), time: input.signed() / 100 }));
    return [shots, speech];
  }

  private pushes(input: ByteReader): Push[] {
    return list(input, 20, (): Push => ({ owner: input.number(), place: whole(input, PER_METRE), force: floats(input), mass: input.float() }));
  }

  private places(input: ByteReader): NamedPlace[] {
    return list(input, 5, (): NamedPlace => ({ kind: KINDS[input.byte()] ?? "thing", name: this.word(input), place: whole(input, 100) }));
  }
}
