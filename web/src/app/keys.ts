// SPDX-License-Identifier: BSD-2-Clause

import { FLOWS, LIVE } from "./flow_table";

/** Keys of the page. Letters work outside of text fields. */
export interface Key { keys: string; does: string; group: "Run" | "Picture" | "Panels" | "Rules" | "Page" }

const of = (keys: string, what: keyof typeof FLOWS): Key => ({ keys, does: FLOWS[what].title, group: "Run" });

export const KEYS: readonly Key[] = [
  { keys: "Space", does: "Run, or pause", group: "Run" },
  of(".", "step-tick"),
  of("D", "step-decision"),
  of("P", "step-phase"),
  of("C", "step-change"),
  { keys: "< and >", does: "Slower, faster", group: "Run" },
  of("R", "begin-again"),
  { keys: "L", does: LIVE, group: "Run" },
  { keys: "Drag, arrow keys", does: "Turn the view around its centre", group: "Picture" },
  { keys: "Shift and drag or arrow", does: "Move along the ground", group: "Picture" },
  { keys: "Wheel, pinch, + and -", does: "Nearer, further", group: "Picture" },
  { keys: "O, F, M", does: "Orbit, follow the selected agent, map", group: "Picture" },
  { keys: "U", does: "Sound on or off", group: "Picture" },
  { keys: "A", does: "Show everybody", group: "Picture" },
  { keys: "N", does: "Select the next agent", group: "Picture" },
  { keys: "All keys, the mouse", does: "Over the picture, the world's scripts receive them, too", group: "Picture" },
  { keys: "Alt and 1 to 9", does: "Show a panel below the picture", group: "Panels" },
  { keys: "Arrow keys on a tab", does: "The panel beside it", group: "Panels" },
  { keys: "Up and down in a list", does: "From row to row; left and right fold", group: "Panels" },
  { keys: "Arrow keys on a bar between panels", does: "Wider, narrower; Home and End: to the limit", group: "Panels" },
  { keys: "Ctrl+Enter, Ctrl+S", does: "Save the rules and put them into effect", group: "Rules" },
  { keys: "Ctrl+Space", does: "Complete the word", group: "Rules" },
  { keys: "F8", does: "Go to the next problem", group: "Rules" },
  { keys: "F9", does: "In a script: stop at this line, or no longer", group: "Rules" },
  { keys: "F8, F10, F11, Shift+F11", does: "A stopped script: continue, step over, into, out", group: "Rules" },
  { keys: "F2", does: "Rename what is at the caret, in all files", group: "Rules" },
  { keys: "F12", does: "Go to where the name at the caret is made", group: "Rules" },
  { keys: "Shift+Alt+F", does: "Format the rules", group: "Rules" },
  { keys: "Escape, then Tab", does: "Leave the editor with the keyboard", group: "Rules" },
  { keys: "?", does: "Show or hide this list", group: "Page" },
  { keys: "Escape", does: "Close what is open", group: "Page" },
];

/** Whether a pressed key belongs to a text field. */
export function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  return target.isContentEditable || ["INPUT", "TEXTAREA", "SELECT"].includes(target.tagName);
}
