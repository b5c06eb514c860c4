// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { buttonName, keyName } from "./world_input";

test("keys have the names that scripts know from the window", () => {
  const names = { KeyA: "a_key", Digit0: "0_key", Digit7: "7_key", F1: "f1_key", F12: "f12_key", Numpad3: "numpad_3_key", Space: "space_key", ArrowLeft: "left_key", Enter: "return_key", ControlLeft: "left_control_key", AltRight: "right_menu_key", NumpadAdd: "add_key", IntlBackslash: "oem_102_key" };
  for (const [code, name] of Object.entries(names)) assert.equal(keyName(code), name);
  for (const odd of ["", "F16", "Numpad10", "KeyAB", "toString", "Lang9"]) assert.equal(keyName(odd), "unknown_key");
});

test("buttons of a mouse likewise", () => {
  assert.deepEqual([0, 1, 2, 3, 7, 8].map(buttonName), ["left_button", "middle_button", "right_button", "mouse_button_3", "mouse_button_7", "unknown_button"]);
});
