// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { InstancedMesh } from "three";
import { Drawables, Structure } from "../format/drawables";
import { Shape, type Agent, type Description, type Scene, type Vec3 } from "../format/scene";
import { Materials } from "./materials";
import { shapeKey, ShapeLibrary } from "./shape_library";
import { Things } from "./things";

const TABLE = {};
const box = (material: string, more: Partial<Description> = {}): Description => ({
  owner: 1, ofAgent: false, visible: true, skeletonShown: false, shape: Shape.Box, mesh: "", material, size: [1, 1, 1], repeats: [1, 1, 1], scale: [1, 1, 1], ...more,
});

/** A moment with these drawables at these places; each has the version of its pose. */
function moment(structure: Structure, places: readonly Vec3[], versions: readonly number[], agents: ReadonlyMap<number, Agent> = new Map()): Scene {
  const poses = Float32Array.from(places.flatMap((place) => [...place, 0, 0, 0, 1]));
  return { drawables: new Drawables(TABLE, structure, poses, Uint32Array.from(versions), new Map()), agents } as Scene;
}
const structureOf = (descriptions: (Description | null)[]): Structure => new Structure(descriptions.map((_, i) => 10 + i), descriptions, descriptions.length);
const still = (scene: Scene): { before: Scene; after: Scene; share: number } => ({ before: scene, after: scene, share: 1 });

/** Packs a triangle as the run does; `high` makes triangles different. */
async function triangle(high: number): Promise<string> {
  const bytes = new DataView(new ArrayBuffer(12 + 12 + 6 * (8 + 6) + 3 * 5));
  [3, 3, 0, 0, 1, 1].forEach((value, i) => bytes.setUint32(4 * i, value, true));
  // Each column of numbers: minimum, maximum, then differences.
  [[0, 65535, 0], [0, 0, 65535], [0, 0, 0]].forEach((values, axis) => {
    const at = 24 + axis * 14;
    bytes.setFloat32(at + 4, axis === 1 ? high : 1, true);
    values.forEach((value, i) => bytes.setUint16(at + 8 + 2 * i, (value - (values[i - 1] ?? 0)) & 0xffff, true));
  });
  return Buffer.from(await new Response(new Blob([bytes.buffer]).stream().pipeThrough(new CompressionStream("deflate"))).arrayBuffer()).toString("base64");
}

async function thingsFor(...descriptions: readonly Description[]): Promise<{ things: Things; library: ShapeLibrary }> {
  const library = new ShapeLibrary(() => undefined);
  for (const one of descriptions) await library.add(shapeKey(one, false), { material: "White", fine: await triangle(one.size[1]) });
  return { things: new Things(new Materials(), library), library };
}
const meshes = (things: Things): InstancedMesh[] => things.group.children as InstancedMesh[];
const placeOf = (mesh: InstancedMesh, instance: number): number[] => [...mesh.instanceMatrix.array.slice(16 * instance + 12, 16 * instance + 15)];

test("bodies of one shape share a draw call, whatever their materials; transparent ones do not", async () => {
  const all = [box("Red"), box("Blue"), box("Soarbox/Crate"), box("RedGlow"), box("TransparentRed"), box("Red", { size: [1, 2, 1] })];
  const { things } = await thingsFor(...all), scene = moment(structureOf(all), all.map((_, i) => [i, 0, 0]), all.map(() => 1));
  things.show(still(scene));
  assert.deepEqual(meshes(things).map((mesh) => mesh.count), [4, 1, 1]);
  const inks = meshes(things)[0]!.geometry.getAttribute("baseInk");
  assert.ok(inks.getX(0) > inks.getZ(0), "the first one is red");
  assert.ok(inks.getZ(1) > inks.getX(1), "the second one is blue");
  assert.ok(meshes(things)[0]!.geometry.getAttribute("paintInk").getX(2) >= 0, "the third one has a picture");
  assert.deepEqual(placeOf(meshes(things)[0]!, 3), [3, 0, 0]);
});

test("a picture writes the bodies that move, and no others", async () => {
  const all = Array.from({ length: 100 }, () => box("Red")), { things } = await thingsFor(box("Red")), structure = structureOf(all), places = all.map((_, i): Vec3 => [i, 0, 0]);
  const first = moment(structure, places, all.map(() => 1));
  const second = moment(structure, places.map((place, i): Vec3 => (i === 40 ? [40, 1, 0] : place)), all.map((_, i) => (i === 40 ? 2 : 1)));
  things.show(still(first));
  const matrices = meshes(things)[0]!.instanceMatrix, written = (): { start: number; count: number }[] => {
    const ranges = matrices.updateRanges.map((one) => ({ ...one }));
    // The renderer does this after it has sent the values.
    matrices.clearUpdateRanges();
    return ranges;
  };
  assert.deepEqual(written(), [{ start: 0, count: 1600 }]);
  things.show(still(first));
  assert.deepEqual(written(), []);
  for (const share of [0.25, 0.75]) {
    things.show({ before: first, after: second, share });
    assert.deepEqual(written(), [{ start: 640, count: 16 }]);
    assert.deepEqual(placeOf(meshes(things)[0]!, 40), [40, share, 0]);
  }
  // Its last position is written once.
  things.show(still(second));
  assert.deepEqual(written(), [{ start: 640, count: 16 }]);
  things.show(still(second));
  things.show({ before: second, after: second, share: 0.5 });
  assert.deepEqual(written(), []);
});

test("a picture that is not drawn does not lose what it wrote", async () => {
  const all = [box("Red"), box("Red"), box("Red")], { things } = await thingsFor(box("Red")), structure = structureOf(all), at = (y: number): Vec3[] => [[0, y, 0], [1, 0, 0], [2, y, 0]];
  const scene = moment(structure, at(0), [1, 1, 1]);
  things.show(still(scene));
  const matrices = meshes(things)[0]!.instanceMatrix;
  matrices.clearUpdateRanges();
  things.show(still(moment(structure, at(1), [2, 1, 1])));
  things.show(still(moment(structure, at(1), [2, 1, 3])));
  assert.deepEqual(matrices.updateRanges, [{ start: 0, count: 48 }]);
});

test("a teleported body, and another one in the same slot, are not interpolated", async () => {
  const { things } = await thingsFor(box("Red")), structure = structureOf([box("Red")]), before = moment(structure, [[0, 0, 0]], [1]);
  things.show({ before, after: moment(structure, [[3, 0, 0]], [2]), share: 0.5 });
  assert.deepEqual(placeOf(meshes(things)[0]!, 0), [3, 0, 0]);
  things.show({ before, after: moment(new Structure([99], [box("Red")], 1), [[1, 0, 0]], [3]), share: 0.5 });
  assert.deepEqual(placeOf(meshes(things)[0]!, 0), [1, 0, 0]);
});

test("bodies that leave, hide or change do not disturb the others", async () => {
  const all: (Description | null)[] = [box("Red"), box("Blue"), box("Green"), box("White")], { things } = await thingsFor(box("Red")), places = all.map((_, i): Vec3 => [i, 0, 0]);
  const show = (): void => things.show(still(moment(structureOf([...all]), places, [1, 1, 1, 1])));
  show();
  all[0] = null;
  all[1] = box("Blue", { visible: false });
  show();
  const shown = (): number[][] => Array.from({ length: meshes(things)[0]!.count }, (_, i) => placeOf(meshes(things)[0]!, i)).sort((a, b) => a[0]! - b[0]!);
  assert.deepEqual(shown(), [[2, 0, 0], [3, 0, 0]]);
  all[0] = box("Green");
  all[1] = box("Blue");
  show();
  assert.deepEqual(shown(), places);
});

test("a body is drawn as soon as its shape has arrived", async () => {
  const { things, library } = await thingsFor(), scene = moment(structureOf([box("Red")]), [[0, 0, 0]], [1]);
  things.show(still(scene));
  assert.equal(meshes(things).length, 0);
  await library.add(shapeKey(box("Red"), false), { fine: await triangle(1) });
  things.show(still(scene));
  assert.equal(meshes(things)[0]!.count, 1);
});

test("an agent that falls in the moment in which something appears becomes grey, too", async () => {
  const part = box("White", { ofAgent: true, owner: 5 }), other = box("White"), { things } = await thingsFor(part);
  const agent = { kind: "seeker", alive: true, failed: false, height: 2 } as Agent;
  things.show(still(moment(structureOf([part]), [[0, 0, 0]], [1], new Map([[5, agent]]))));
  things.show(still(moment(structureOf([part, other]), [[0, 0, 0], [1, 0, 0]], [1, 1], new Map([[5, { ...agent, alive: false }]]))));
  const inks = meshes(things)[0]!.geometry.getAttribute("baseInk"), greys = [0, 1].filter((i) => inks.getX(i) === inks.getZ(i) && inks.getX(i) < 0.9);
  assert.ok(greys.length > 0);
});

test("an agent that fell becomes grey", async () => {
  const part = box("White", { ofAgent: true, owner: 5 }), { things } = await thingsFor(part), structure = structureOf([part]);
  const agent = { kind: "seeker", alive: true, failed: false, height: 2 } as Agent, places: Vec3[] = [[0, 0, 0]];
  const color = (): number[] => [0, 1, 2].map((part) => meshes(things)[0]!.geometry.getAttribute("baseInk").getComponent(0, part));
  things.show(still(moment(structure, places, [1], new Map([[5, agent]]))));
  assert.notEqual(color()[0], color()[2]);
  things.show(still(moment(structure, places, [1], new Map([[5, { ...agent, alive: false }]]))));
  assert.equal(color()[0], color()[2]);
});
