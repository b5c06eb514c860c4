// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { LabelLayout } from "./label_layout";
import { kindColor, lookOf, teamColor } from "./looks";
import { figureMesh } from "./meshes/figures";
import { MeshData } from "./meshes/mesh_data";
import { modularMesh } from "./meshes/modular";
import { sceneryMesh } from "./meshes/scenery";
import { agentMesh, boxMesh, capsuleMesh, cylinderMesh, planeMesh, sphereMesh } from "./meshes/shapes";
import { bodyLook, SOLDIER_BONES } from "./meshes/skeletons";
import { bodyMesh } from "./meshes/soldier";
import { parseMarkup } from "./script_ui";

/** Finite, with unit normals, and its faces turned outwards: the volume is positive. */
function checkMesh(name: string, mesh: MeshData, isClosed = true): void {
  assert.ok(mesh.count > 0 && mesh.indices.length > 0, name);
  assert.ok([...mesh.positions, ...mesh.normals, ...mesh.uvs, ...mesh.paint].every(Number.isFinite), name);
  assert.ok(mesh.indices.every((i) => i >= 0 && i < mesh.count), name);
  let volume = 0;
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => mesh.positions.slice(3 * mesh.indices[i + k]!, 3 * mesh.indices[i + k]! + 3) as [number, number, number]) as [[number, number, number], [number, number, number], [number, number, number]];
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  if (isClosed) assert.ok(volume > 0, `${name} has the volume ${volume}`);
}

test("shapes are whole and face outwards", () => {
  checkMesh("box", boxMesh([-1, -1, -1], [1, 1, 1]));
  checkMesh("capsule", capsuleMesh(0.5, 2));
  checkMesh("cylinder", cylinderMesh(0.5, 2));
  checkMesh("sphere", sphereMesh(1));
  checkMesh("agent", agentMesh(0.5, 2));
  checkMesh("plane", planeMesh(2, 2, 1, 1), false);
  checkMesh("nothing", boxMesh([0, 0, 0], [0, 0, 0]), false);
  checkMesh("bad", capsuleMesh(NaN, -1), false);
});

test("figures, pieces and scenery are whole and face outwards", () => {
  for (const name of ["Rock", "Medkit", "Ammunition", "Sack", "Sheep", "Bear", "Hare", "Cook", "Wolf", "Villager", "Robot", "Cart", "Bee", "Bell", "Gold", "RedFlower", "Hedge"])
    checkMesh(name, figureMesh(`Soarbox/${name}`, [1, 1.7, 1])!);
  for (const name of ["modular_block", "modular_brick_door", "modular_pillar_concrete_1", "modular_roof", "modular_hangar_door", "modular_concrete_double_window"])
    checkMesh(name, modularMesh(`models/nobiax_modular/${name}.mesh`)!);
  for (const name of ["pine_1", "oak_2", "rock_3"]) checkMesh(name, sceneryMesh(`models/soarbox/${name}.mesh`)!);
  assert.equal(figureMesh("constructor", [1, 1, 1]), null);
  assert.equal(modularMesh("models/nobiax_modular/constructor.mesh"), null);
  assert.equal(sceneryMesh("models/soarbox/toString.mesh"), null);
});

test("bodies are whole, and each vertex hangs on bones that there are", () => {
  for (const look of ["soldier", "dark", "rifle"] as const) {
    for (const coarse of [false, true]) {
      const skin = bodyMesh(look, coarse);
      checkMesh(look, skin.mesh);
      assert.equal(skin.bones.length, skin.mesh.count * 4);
      assert.ok(skin.bones.every((bone) => bone >= 0 && bone < (look === "rifle" ? 6 : SOLDIER_BONES.length)));
    }
  }
  assert.equal(bodyLook("models/soarbox/rifle.mesh"), "rifle");
  assert.equal(bodyLook("valueOf"), null);
});

test("a soldier stands on the ground and is as tall as a soldier", () => {
  const heights = bodyMesh("soldier", false).mesh.positions.filter((_, i) => i % 3 === 1);
  assert.ok(Math.min(...heights) > -0.02 && Math.min(...heights) < 0.03);
  assert.ok(Math.max(...heights) > 1.7 && Math.max(...heights) < 1.8);
});

test("colours follow teams and kinds; unknown materials are seen", () => {
  assert.deepEqual(teamColor("blue"), [0.05, 0.36, 0.88]);
  assert.deepEqual(kindColor("soar"), [0.5, 0.3, 0.72]);
  assert.equal(lookOf("__proto__").paint, "missing");
  assert.equal(lookOf("Ground2").paint, "ground");
});

test("labels do not cover each other", () => {
  const layout = new LabelLayout(800, 600), boxes = Array.from({ length: 6 }, () => layout.place(400, 300, 90, 40)).filter((one) => one !== null);
  assert.ok(boxes.length >= 4);
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1)) assert.ok(a.left + a.width <= b.left || b.left + b.width <= a.left || a.top + a.height <= b.top || b.top + b.height <= a.top);
});

test("scripts' markup: colours, fonts, percent signs, and what is cut off", () => {
  assert.deepEqual(parseMarkup("a%1b%%%R\n%@24%c").map((line) => line.map((run) => [run.text, run.color, run.font])), [[["a", 0, 0], ["b%", 1, 0]], [["c", 0, 4]]]);
  assert.deepEqual(parseMarkup("<b>%").map((line) => line.map((run) => run.text)), [["<b>"]]);
  assert.deepEqual(parseMarkup("x%@24"), [[{ text: "x", color: 0, font: 0, mono: false }]]);
});
