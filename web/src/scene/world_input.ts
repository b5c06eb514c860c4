// SPDX-License-Identifier: BSD-2-Clause
import { isTyping } from "../app/keys";

/** The events that scripts of a world receive: an `input` request without its name (docs/serve_protocol.md). */
export type WorldEvent = { readonly kind: "key" | "button" | "pointer" | "wheel" | "panel" | "pad" } & Readonly<Record<string, string | number | boolean>>;

/** Minimum interval between two pointer events for scripts. */
const POINTER_EVERY_MS = 80;
const NOTCH_PX = 100;

/** Keys by their place on the keyboard, as scripts name them. */
const NAMED: Readonly<Record<string, string>> = {
  Enter: "return", Escape: "escape", Backspace: "back", Tab: "tab", Space: "space", Minus: "minus", Equal: "equals", BracketLeft: "left_bracket", BracketRight: "right_bracket", Backslash: "backslash",
  Semicolon: "semicolon", Quote: "apostrophe", Backquote: "grave", Comma: "comma", Period: "period", Slash: "slash", IntlBackslash: "oem_102", CapsLock: "capital", PrintScreen: "system_request",
  ScrollLock: "scroll", Pause: "pause", Insert: "insert", Delete: "delete", Home: "home", End: "end", PageUp: "page_up", PageDown: "page_down", ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left",
  ArrowRight: "right", NumLock: "numlock", NumpadAdd: "add", NumpadSubtract: "subtract", NumpadMultiply: "multiply", NumpadDivide: "divide", NumpadDecimal: "decimal", NumpadEnter: "numpad_enter",
  NumpadEqual: "numpad_equals", NumpadComma: "numpad_comma", ShiftLeft: "left_shift", ShiftRight: "right_shift", ControlLeft: "left_control", ControlRight: "right_control", AltLeft: "left_menu",
  AltRight: "right_menu", MetaLeft: "left_windows", MetaRight: "right_windows", ContextMenu: "application",
};

/** "a_key", "f1_key", "numpad_3_key"; as in the window, so that a script works in both. `code`: of a keyboard event. */
export function keyName(code: string): string {
  const plain = /^Key([A-Z])$|^Digit([0-9])$|^(F(?:[1-9]|1[0-5]))$/.exec(code), pad = /^Numpad([0-9])$/.exec(code);
  if (plain !== null) return `${(plain[1] ?? plain[2] ?? plain[3] ?? "").toLowerCase()}_key`;
  if (pad !== null) return `numpad_${pad[1]}_key`;
  return Object.hasOwn(NAMED, code) ? `${NAMED[code]}_key` : "unknown_key";
}

/** `button`: of a mouse event. */
export function buttonName(button: number): string {
  return ["left_button", "middle_button", "right_button"][button] ?? (button <= 7 ? `mouse_button_${button}` : "unknown_button");
}

/** Keys and mouse over the picture, for the scripts of the world. Keys that are typed into panels are not sent. */
export class WorldInput {
  private readonly held = new Set<string>();
  private last: { x: number; y: number } | null = null;
  private waiting: { x: number; y: number } | null = null;
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(private readonly place: HTMLElement, private readonly canvas: HTMLElement, private readonly tell: (event: WorldEvent) => void) {
    document.addEventListener("keydown", (event) => this.key(event, true));
    document.addEventListener("keyup", (event) => this.key(event, false));
    addEventListener("blur", () => this.release());
    canvas.addEventListener("pointerdown", (event) => this.button(event, true));
    canvas.addEventListener("pointerup", (event) => this.button(event, false));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("wheel", (event) => this.tell({ kind: "wheel", notches: -event.deltaY / (event.deltaMode === 1 ? 3 : NOTCH_PX), ...this.at(event) }), { passive: true });
  }

  private isMeant(event: KeyboardEvent): boolean {
    const target = event.target;
    if (isTyping(target) || this.place.offsetParent === null || document.querySelector("[role=dialog]") !== null) return false;
    return target === document.body || (target instanceof Node && this.place.contains(target));
  }

  private key(event: KeyboardEvent, pressed: boolean): void {
    const name = keyName(event.code);
    if (event.repeat || (pressed ? !this.isMeant(event) : !this.held.has(name))) return;
    if (pressed) this.held.add(name);
    else this.held.delete(name);
    // The browser also uses these keys; while the picture has the focus, they go to the world.
    if (pressed && /^F\d$/.test(event.code) && event.target === this.canvas && !event.ctrlKey && !event.altKey) event.preventDefault();
    this.tell({ kind: "key", name, pressed });
  }

  /** Releases all keys, because a key that is released elsewhere would stay pressed. */
  private release(): void {
    for (const name of this.held) this.tell({ kind: "key", name, pressed: false });
    this.held.clear();
  }

  private at(event: MouseEvent): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    return { x: Math.round(event.clientX - box.left), y: Math.round(event.clientY - box.top) };
  }

  private button(event: PointerEvent, pressed: boolean): void {
    this.sendMove();
    this.tell({ kind: "button", name: buttonName(event.button), pressed, ...this.at(event) });
  }

  private move(event: PointerEvent): void {
    this.waiting = this.at(event);
    this.timer ??= setTimeout(() => this.sendMove(), POINTER_EVERY_MS);
  }

  private sendMove(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    if (this.waiting === null) return;
    const { x, y } = this.waiting, before = this.last ?? this.waiting;
    this.waiting = null;
    this.last = { x, y };
    if (x !== before.x || y !== before.y) this.tell({ kind: "pointer", x, y, dx: x - before.x, dy: y - before.y });
  }
}
