// SPDX-License-Identifier: BSD-2-Clause
import type { WorldEvent } from "./world_input";

/** As scripts name them, in the order of the standard layout of browsers. */
const BUTTONS = [
  "a_button", "b_button", "x_button", "y_button", "left_shoulder_button", "right_shoulder_button", "left_trigger", "right_trigger", "back_button", "start_button", "left_stick_button",
  "right_stick_button", "up_button", "down_button", "left_button", "right_button", "guide_button",
] as const;
const AXES = ["left_x", "left_y", "right_x", "right_y"] as const;
const MOST_PADS = 8;
/** Centred sticks report values near 0; the same threshold as in the window. */
const DEAD_ZONE = 0.12;

/** The value of an axis for scripts: two digits, and 0 near the centre. */
export function axisValue(value: number): number {
  if (!Number.isFinite(value) || Math.abs(value) < DEAD_ZONE) return 0;
  return Math.round(Math.min(1, Math.max(-1, value)) * 100) / 100;
}

interface PadState { readonly index: number; readonly connected: boolean; readonly buttons: readonly { readonly pressed: boolean; readonly value: number }[]; readonly axes: readonly number[] }

/** Reports what changed at the gamepads since the last look. */
export class Gamepads {
  private readonly values = new Map<string, number>();

  constructor(private readonly tell: (event: WorldEvent) => void) {}

  look(pads: readonly (PadState | null)[]): void {
    const seen = new Set<string>();
    for (const pad of pads) {
      if (pad === null || !pad.connected || pad.index >= MOST_PADS) continue;
      const note = (name: string, value: number): void => {
        const key = `${pad.index} ${name}`;
        seen.add(key);
        this.change(key, pad.index + 1, name, value);
      };
      BUTTONS.forEach((name, i) => {
        const button = pad.buttons[i];
        if (button !== undefined) note(name, name.endsWith("_trigger") ? axisValue(button.value) : button.pressed ? 1 : 0);
      });
      AXES.forEach((name, i) => note(name, axisValue(pad.axes[i] ?? 0)));
    }
    // A disconnected gamepad releases all its buttons.
    for (const key of [...this.values.keys()]) {
      if (seen.has(key)) continue;
      const [index = "0", name = ""] = key.split(" ");
      this.change(key, Number(index) + 1, name, 0);
    }
  }

  private change(key: string, pad: number, name: string, value: number): void {
    if ((this.values.get(key) ?? 0) === value) return;
    if (value === 0) this.values.delete(key);
    else this.values.set(key, value);
    this.tell({ kind: "pad", pad, name, value });
  }
}

/** Polls the browser's gamepads once per picture, while the page has the focus. */
export function listenToGamepads(tell: (event: WorldEvent) => void): void {
  const pads = new Gamepads(tell);
  let listens = false;
  const look = (): void => {
    pads.look(document.hasFocus() ? navigator.getGamepads() : []);
    requestAnimationFrame(look);
  };
  addEventListener("gamepadconnected", () => {
    if (!listens) requestAnimationFrame(look);
    listens = true;
  });
}
