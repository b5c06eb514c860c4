// SPDX-License-Identifier: BSD-2-Clause

/** Keys of the page. Letters work outside of text fields. */
export interface Key { keys: string; does: string; group: "Run" | "Picture" | "Panels" | "Rules" | "Page" }

export const KEYS: readonly Key[] = [
  { keys: "Space", does: "Run, or pause", group: "Run" },
  { keys: ".", does: "One tick", group: "Run" },
  { keys: "D", does: "One decision of the selected agent", group: "Run" },
  { keys: "P", does: "One phase of the selected agent", group: "Run" },
  { keys: "C", does: "On to the next change in the selected agent", group: "Run" },
  { keys: "< and >", does: "Slower, faster", group: "Run" },
  { keys: "R", does: "Begin again", group: "Run" },
  { keys: "L", does: "Back to the newest moment", group: "Run" },
  { keys: "Drag, arrow keys", does: "Turn around what is looked at", group: "Picture" },
  { keys: "Shift and drag or arrow", does: "Move along the ground", group: "Picture" },
  { keys: "Wheel, pinch, + and -", does: "Nearer, further", group: "Picture" },
  { keys: "O, F, M", does: "Orbit, follow the selected agent, map", group: "Picture" },
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
  { keys: "F2", does: "Rename what is at the caret, in all files", group: "Rules" },
  { keys: "F12", does: "Go to where the name at the caret is made", group: "Rules" },
  { keys: "Shift+Alt+F", does: "Lay the rules out", group: "Rules" },
  { keys: "Escape, then Tab", does: "Leave the editor with the keyboard", group: "Rules" },
  { keys: "?", does: "Show or hide this list", group: "Page" },
  { keys: "Escape", does: "Close what is open", group: "Page" },
];

/** Whether a pressed key belongs to a text field. */
export function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  return target.isContentEditable || ["INPUT", "TEXTAREA", "SELECT"].includes(target.tagName);
}
