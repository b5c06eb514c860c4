// SPDX-License-Identifier: BSD-2-Clause
import { button, h, patch, type Child } from "../dom/view";
import type { ContentName, Contents } from "../run/contents";
import type { Panel } from "../panels/panel";

const ROWS = "tr, li, .reason, details", PRESSED = "button, summary, a[href]";

/** Arrow keys in lists, tables and trees: up and down move between rows, left and right fold and unfold a row. */
function listKey(event: KeyboardEvent, body: HTMLElement): void {
  const now = event.target as HTMLElement;
  if (event.defaultPrevented || event.altKey || event.ctrlKey || event.metaKey || !now.matches(PRESSED) || now.closest(ROWS) === null || now.closest(".editor") !== null) return;
  if (event.key === "ArrowLeft" || event.key === "ArrowRight") {
    const isOpen = now.tagName === "SUMMARY" ? (now.parentElement as HTMLDetailsElement).open : now.getAttribute("aria-expanded") === "true";
    if ((now.tagName !== "SUMMARY" && !now.hasAttribute("aria-expanded")) || isOpen === (event.key === "ArrowRight")) return;
    event.preventDefault();
    return now.click();
  }
  // One stop in each row: the first thing in it that can be pressed.
  const stops = new Map<Element, HTMLElement>();
  for (const one of body.querySelectorAll<HTMLElement>(PRESSED)) {
    const row = one.closest(ROWS);
    if (row !== null && row.closest("thead") === null && one.offsetParent !== null && !stops.has(row)) stops.set(row, one);
  }
  const all = [...stops.values()], at = all.indexOf(stops.get(now.closest(ROWS)!) ?? now);
  const next = event.key === "ArrowDown" ? at + 1 : event.key === "ArrowUp" ? at - 1 : event.key === "Home" ? 0 : event.key === "End" ? all.length - 1 : -1;
  if (at < 0 || !["ArrowDown", "ArrowUp", "Home", "End"].includes(event.key)) return;
  event.preventDefault();
  all[next]?.focus();
}

/** An area for panels, with a tab for each; one panel is in front. */
export class Dock {
  readonly element: HTMLElement;
  private readonly tabs: HTMLElement;
  private readonly bodies = new Map<string, HTMLElement>();
  private front: string;
  private readonly stale = new Set<string>();
  private frame = 0;

  /** `kept`: the name under which the front panel is stored. */
  constructor(readonly name: string, private readonly kept: string, readonly panels: readonly Panel[], private readonly contents: () => Contents, private readonly changed: () => void) {
    const front = sessionStorage.getItem(`soarbox.dock.${kept}`) ?? "";
    this.front = panels.some((one) => one.word === front) ? front : (panels[0]?.word ?? "");
    this.element = document.createElement("section");
    this.element.className = `dock ${name}`;
    this.element.setAttribute("aria-label", name === "left" ? "Task" : name === "right" ? "Rules" : "Panels");
    this.tabs = document.createElement("div");
    this.tabs.className = "tabs";
    this.tabs.setAttribute("role", "tablist");
    this.element.append(this.tabs);
    for (const panel of panels) {
      const body = document.createElement("div");
      body.className = `panel ${panel.word}`;
      body.id = `panel-${panel.word}`;
      body.setAttribute("role", "tabpanel");
      body.setAttribute("aria-labelledby", `tab-${panel.word}`);
      body.tabIndex = 0;
      body.addEventListener("keydown", (event) => listKey(event, body));
      this.bodies.set(panel.word, body);
      this.element.append(body);
      this.stale.add(panel.word);
    }
    this.swipe();
    this.show(this.front);
  }

  get shownWord(): string {
    return this.element.offsetParent === null && this.element.isConnected ? "" : this.front;
  }

  has(word: string): boolean {
    return this.bodies.has(word);
  }

  show(word: string, focus = false): void {
    if (!this.has(word)) return;
    const before = this.front;
    this.front = word;
    sessionStorage.setItem(`soarbox.dock.${this.kept}`, word);
    for (const [name, body] of this.bodies) body.hidden = name !== word;
    if (before !== word) {
      this.panels.find((one) => one.word === before)?.shown?.(false);
      this.panels.find((one) => one.word === word)?.shown?.(true);
    }
    this.drawTabs();
    this.tabs.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest", inline: "nearest" });
    this.stale.add(word);
    this.later();
    if (focus) this.bodies.get(word)?.focus();
    this.changed();
  }

  /** Schedules a redraw of the panels that show these contents. */
  note(names: readonly ContentName[]): void {
    for (const panel of this.panels) {
      if (!panel.uses.some((one) => names.includes(one))) continue;
      this.stale.add(panel.word);
      panel.note?.(this.contents());
    }
    this.later();
  }

  redraw(word: string): void {
    this.stale.add(word);
    this.later();
  }

  private later(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.draw();
    });
  }

  private draw(): void {
    this.drawTabs();
    const panel = this.panels.find((one) => one.word === this.front), body = this.bodies.get(this.front);
    if (panel === undefined || body === undefined || !this.stale.has(this.front)) return;
    // Keeps a text selection that the user wants to copy.
    const marked = document.getSelection();
    if (marked !== null && !marked.isCollapsed && body.contains(marked.anchorNode) && panel.word !== "edit") {
      setTimeout(() => this.later(), 500);
      return;
    }
    this.stale.delete(this.front);
    // A panel begins with its name, for screen readers.
    patch(body, [h("h2.hidden", { key: "heading" }, panel.title), panel.view(this.contents())]);
  }

  private drawTabs(): void {
    this.tabs.hidden = this.panels.length < 2;
    patch(this.tabs, this.panels.map((panel): Child => {
      const badge = panel.badge?.(this.contents()) ?? "", isFront = panel.word === this.front;
      return button([panel.title, badge !== "" && h("span.badge", null, badge)], () => this.show(panel.word), {
        key: panel.word, attributes: { role: "tab", id: `tab-${panel.word}`, "aria-selected": String(isFront), "aria-controls": `panel-${panel.word}`, tabindex: isFront ? 0 : -1, title: panel.about },
        on: { keydown: (event) => this.tabKey(event, panel.word) },
      }, `button.tab${isFront ? ".front" : ""}`);
    }));
  }

  private tabKey(event: KeyboardEvent, word: string): void {
    const at = this.panels.findIndex((one) => one.word === word), count = this.panels.length;
    const next = event.key === "ArrowRight" ? (at + 1) % count : event.key === "ArrowLeft" ? (at + count - 1) % count : event.key === "Home" ? 0 : event.key === "End" ? count - 1 : -1;
    if (next < 0) return;
    event.preventDefault();
    this.show(this.panels[next]!.word);
    document.getElementById(`tab-${this.panels[next]!.word}`)?.focus();
  }

  /** A horizontal swipe shows the next panel. */
  private swipe(): void {
    let from: { x: number; y: number } | null = null;
    this.element.addEventListener("touchstart", (event) => {
      const touch = event.touches[0], inside = event.target as HTMLElement;
      from = event.touches.length === 1 && touch !== undefined && inside.closest(".editor, canvas, input, table, pre") === null ? { x: touch.clientX, y: touch.clientY } : null;
    }, { passive: true });
    this.element.addEventListener("touchend", (event) => {
      const touch = event.changedTouches[0];
      if (from === null || touch === undefined) return;
      const dx = touch.clientX - from.x, dy = touch.clientY - from.y, at = this.panels.findIndex((one) => one.word === this.front);
      from = null;
      if (Math.abs(dx) < 70 || Math.abs(dx) < 2 * Math.abs(dy)) return;
      const next = this.panels[at + (dx < 0 ? 1 : -1)];
      if (next !== undefined) this.show(next.word);
    }, { passive: true });
  }
}
