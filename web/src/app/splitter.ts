// SPDX-License-Identifier: BSD-2-Clause

const STEP_PX = 24;

/** A bar between two parts of the page that can be dragged, with the mouse or with arrow keys. `sign`: 1 if dragging right or down makes the part larger. */
export function splitter(label: string, property: string, direction: "vertical" | "horizontal", sign: 1 | -1, root: HTMLElement, least: number, most: () => number, usual: number): HTMLElement {
  const bar = document.createElement("div"), key = `soarbox.size.${property}`;
  bar.className = `splitter ${direction}`;
  bar.tabIndex = 0;
  bar.setAttribute("role", "separator");
  bar.setAttribute("aria-label", label);
  bar.setAttribute("aria-orientation", direction);
  let size = Number(localStorage.getItem(key)) || usual;
  const set = (wanted: number, keep = false): void => {
    size = Math.round(Math.min(Math.max(wanted, least), Math.max(least, most())));
    root.style.setProperty(property, `${size}px`);
    bar.setAttribute("aria-valuenow", String(size));
    bar.setAttribute("aria-valuemin", String(least));
    bar.setAttribute("aria-valuemax", String(Math.max(least, most())));
    if (keep) localStorage.setItem(key, String(size));
  };
  const along = (event: PointerEvent): number => (direction === "vertical" ? event.clientX : event.clientY);
  bar.addEventListener("pointerdown", (event) => {
    event.preventDefault();
    bar.setPointerCapture(event.pointerId);
    const from = along(event), before = size;
    const move = (next: PointerEvent): void => set(before + sign * (along(next) - from), true);
    bar.addEventListener("pointermove", move);
    bar.addEventListener("lostpointercapture", () => bar.removeEventListener("pointermove", move), { once: true });
  });
  bar.addEventListener("dblclick", () => set(usual, true));
  bar.addEventListener("keydown", (event) => {
    const more = direction === "vertical" ? "ArrowRight" : "ArrowDown", less = direction === "vertical" ? "ArrowLeft" : "ArrowUp";
    if (event.key === "Home" || event.key === "End") {
      event.preventDefault();
      return set(event.key === "Home" ? least : Math.max(least, most()), true);
    }
    if (event.key !== more && event.key !== less) return;
    event.preventDefault();
    set(size + sign * (event.key === more ? STEP_PX : -STEP_PX), true);
  });
  addEventListener("resize", () => set(size));
  set(size);
  return bar;
}
