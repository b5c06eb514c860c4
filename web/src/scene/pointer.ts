// SPDX-License-Identifier: BSD-2-Clause
import type { SceneView } from "./scene_view";

const CLICK_PX = 6, WHEEL_ZOOM = 0.0012, KEY_TURN_PX = 24;

/** Mouse, fingers and keys on the picture: turn, move, zoom, select. */
export function listenToPointer(canvas: HTMLElement, view: SceneView, select: (name: string) => void): void {
  const pointers = new Map<number, { x: number; y: number }>();
  let travelled = 0, pinch = 0, buttons = 0;

  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", (event) => {
    try {
      canvas.setPointerCapture(event.pointerId);
    } catch {
      // A finger that was already lifted cannot be captured; its movements still count.
    }
    if (pointers.size === 0) travelled = 0;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    buttons = event.button;
    pinch = 0;
  });
  canvas.addEventListener("pointermove", (event) => {
    const last = pointers.get(event.pointerId);
    if (last === undefined) return;
    const dx = event.clientX - last.x, dy = event.clientY - last.y;
    travelled += Math.abs(dx) + Math.abs(dy);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 2) {
      const [a, b] = [...pointers.values()] as [{ x: number; y: number }, { x: number; y: number }], apart = Math.hypot(a.x - b.x, a.y - b.y);
      if (pinch > 0 && apart > 0) view.rig.zoom(pinch / apart);
      pinch = apart;
      view.rig.pan(dx / 2, dy / 2);
    } else if (pointers.size === 1) {
      if (buttons === 2 || buttons === 1 || event.shiftKey) view.rig.pan(dx, dy);
      else view.rig.turn(dx, dy);
    }
    view.wake();
  });
  const up = (event: PointerEvent): void => {
    if (!pointers.delete(event.pointerId)) return;
    if (event.type === "pointerup" && pointers.size === 0 && travelled < CLICK_PX && event.button === 0) {
      const at = canvas.getBoundingClientRect(), id = view.agentAt(event.clientX - at.left, event.clientY - at.top);
      if (id !== 0) select(view.nameOf(id));
    }
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    view.rig.zoom(Math.exp(event.deltaY * WHEEL_ZOOM * (event.deltaMode === 1 ? 16 : 1)));
    view.wake();
  }, { passive: false });
  canvas.addEventListener("dblclick", () => view.frameSelected());
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const by = (dx: number, dy: number): void => (event.shiftKey ? view.rig.pan(dx, dy) : view.rig.turn(dx, dy));
    if (event.key === "ArrowLeft") by(KEY_TURN_PX, 0);
    else if (event.key === "ArrowRight") by(-KEY_TURN_PX, 0);
    else if (event.key === "ArrowUp") by(0, KEY_TURN_PX);
    else if (event.key === "ArrowDown") by(0, -KEY_TURN_PX);
    else if (event.key === "+" || event.key === "=") view.rig.zoom(0.85);
    else if (event.key === "-") view.rig.zoom(1 / 0.85);
    else return;
    event.preventDefault();
    view.wake();
  });
}
