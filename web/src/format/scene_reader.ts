// SPDX-License-Identifier: BSD-2-Clause
import { BadBytes, ByteReader } from "./byte_reader";
import { DrawableTable, NO_DRAWABLES } from "./drawables";
import type { Agent, Color, Component, Lines, Mind, Scene, Surroundings, Vec3 } from "./scene";
import * as records from "./scene_records";
import { add, readColor, readFloats, readPlace, readTurn, vector, type Steps, type Values } from "./scene_values";

const MARK = 0x53, VERSION = 1, FULL = 1, DEFLATED = 2;
const HEAD_BYTES = 3;
const PER_METRE = 1000, PER_RADIAN = 2048, PER_DIRECTION = 500, PER_SIGN = 10;
const NO_LINES: Lines = { lines: [], circles: [], triangles: [] };

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
      case 2: scene.camera = records.readCamera(input); break;
      case 3: scene.drawables = this.things.read(input, full, () => this.word(input), scene.time); break;
      case 4: scene.agents = this.agents(input); break;
      case 5: scene.components = this.components(input); break;
      case 6: scene.lines = this.lines(input); break;
      case 7: scene.particles = this.records(input, records.PARTICLE_BYTES, records.readParticle); break;
      case 8: scene.minds = this.readMinds(input); break;
      case 9:
        scene.shots = this.records(input, records.SHOT_BYTES, records.readShot);
        scene.speech = this.records(input, records.SPEECH_BYTES, records.readSpeech);
        break;
      case 10: scene.places = this.records(input, records.NAMED_PLACE_BYTES, records.readNamedPlace); break;
      case 11: scene.pushes = this.records(input, records.PUSH_BYTES, records.readPush); break;
      case 13: scene.sounds = this.records(input, records.SOUND_BYTES, records.readSound); break;
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
    const ambient = readFloats(input), sky = this.word(input), skyTurnDeg = readFloats(input);
    const palette: Color[] = [];
    for (let i = 0; i < 10; ++i) palette.push(readColor(input));
    const lights = this.records(input, records.LIGHT_BYTES, records.readLight);
    return { ambient, sky, skyTurnDeg, palette, lights };
  }

  private values(input: ByteReader): Values {
    let last: Steps = [0, 0, 0];
    return { word: () => this.word(input), point: () => vector((last = add(input, last)), PER_METRE) };
  }

  private records<T>(input: ByteReader, leastBytes: number, read: (input: ByteReader, values: Values) => T, values = this.values(input)): T[] {
    return list(input, leastBytes, () => read(input, values));
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
        made = { ...made, ...records.readAgentLooks(told, this.values(told)) };
      }
      const at = (parts & 2) !== 0 ? add(input, raw?.place ?? [0, 0, 0]) : (raw?.place ?? [0, 0, 0]);
      const forward = (parts & 4) !== 0 ? add(input, raw?.forward ?? [0, 0, 0]) : (raw?.forward ?? [0, 0, 0]);
      made = { ...made, place: vector(at, PER_METRE), forward: vector(forward, PER_DIRECTION) };
      if ((parts & 16) !== 0) {
        const state = new ByteReader(input.piece());
        made = { ...made, ...records.readAgentState(state, this.values(state)) };
      }
      this.people.set(id, { made, place: at, forward });
    });
    return new Map([...this.people].map(([id, raw]) => [id, raw.made]));
  }

  private components(input: ByteReader): Component[] {
    return list(input, 43, (): Component => {
      const id = input.number(), parent = input.number(), layer = input.signed();
      const x = input.float(), y = input.float(), width = input.float(), height = input.float(), marginLeft = input.float(), marginTop = input.float();
      const flags = input.byte(), from = readColor(input), to = readColor(input), textColor = readColor(input), font = input.byte();
      const text = this.word(input), material = this.word(input), caption = this.word(input);
      const button = (flags & 64) !== 0 ? this.word(input) : "";
      const bar = (flags & 128) !== 0 ? { share: input.float(), color: readColor(input) } : null;
      const direction = (flags & 8) !== 0 ? "diagonal" : (flags & 4) !== 0 ? "vertical" : "horizontal";
      return {
        id, parent, layer, x, y, width, height, marginLeft, marginTop, visible: (flags & 1) !== 0, gradient: (flags & 2) !== 0 ? { from, to, direction } : null,
        isMarkup: (flags & 16) !== 0, textColor, font, text, material, caption, button, bar,
        world: (flags & 32) !== 0 ? { place: readPlace(input, PER_METRE), turn: readTurn(input, PER_RADIAN) } : null,
      };
    });
  }

  private lines(input: ByteReader): Lines {
    const values = this.values(input);
    const lines = this.records(input, records.LINE_BYTES, records.readLine, values);
    const circles = this.records(input, records.CIRCLE_BYTES, records.readCircle, values);
    const triangles = this.records(input, records.TRIANGLE_BYTES, records.readTriangle, values);
    return { lines, circles, triangles };
  }

  private readMinds(input: ByteReader): Map<number, Mind> {
    this.entries(input, (id) => this.minds.delete(id), (id) => this.minds.set(id, this.mind(new ByteReader(input.piece()))));
    return new Map(this.minds);
  }

  private mind(input: ByteReader): Mind {
    const operator = this.word(input), doing = this.word(input), flags = input.byte();
    const senses = (flags & 1) !== 0 ? { sight: input.signed() / PER_SIGN, viewDeg: input.signed(), hearing: input.signed() / PER_SIGN } : null;
    const measured = (flags & 2) !== 0 ? readPlace(input, PER_SIGN) : null;
    const goal = (flags & 4) !== 0 ? readPlace(input, PER_SIGN) : null;
    const target = input.number(), leader = input.number();
    let last: Steps = [0, 0, 0];
    const path = list(input, 3, (): Vec3 => vector((last = add(input, last)), PER_SIGN));
    const contacts = this.records(input, records.CONTACT_BYTES, records.readContact);
    return { operator, doing, senses, measured, goal, target, leader, pathIsWhole: (flags & 8) !== 0, path, contacts };
  }
}
