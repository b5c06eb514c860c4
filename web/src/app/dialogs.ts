// SPDX-License-Identifier: BSD-2-Clause
import { correction, generate, type Bitmap2D } from "lean-qr/nano";
import { button, h, type Child, type View } from "../dom/view";
import { KEYS } from "./keys";

function dialog(title: string, close: () => void, ...body: Child[]): View {
  return h("div.veil", { key: title, on: { click: (event) => event.target === event.currentTarget && close() } },
    h("div.dialog", { attributes: { role: "dialog", "aria-modal": "true", "aria-label": title, tabindex: -1 }, mounted: (element) => keepFocus(element) },
      h("div.row", null, h("h2", null, title), button("Close", close)), body));
}

/** Tab stays inside the dialog. When it is closed, the focus returns to its previous element. */
function keepFocus(element: HTMLElement): void {
  const before = document.activeElement as HTMLElement | null;
  element.focus();
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Tab") return;
    const all = [...element.querySelectorAll<HTMLElement>("button, input, a[href]")], first = all[0], last = all.at(-1);
    if (first === undefined || last === undefined) return;
    if (event.shiftKey && (document.activeElement === first || document.activeElement === element)) last.focus(), event.preventDefault();
    else if (!event.shiftKey && document.activeElement === last) first.focus(), event.preventDefault();
  });
  new MutationObserver((_changes, observer) => {
    if (element.isConnected) return;
    observer.disconnect();
    before?.focus();
  }).observe(document.body, { childList: true, subtree: true });
}

/** The licence notices of the page: a separate file, or a part of a single-file page. */
function licencesAddress(): string {
  const inPage = document.getElementById("soarbox-licences")?.textContent;
  return inPage === undefined || inPage === null ? new URL("licences.txt", import.meta.url).href : URL.createObjectURL(new Blob([inPage], { type: "text/plain" }));
}

export function keysDialog(close: () => void): View {
  const groups = [...new Set(KEYS.map((one) => one.group))];
  return dialog("Keys", close, h("div.keys", null, groups.map((group) => h("section", null, h("h3", null, group),
    h("dl", null, KEYS.filter((one) => one.group === group).map((one) => [h("dt", null, h("kbd", null, one.keys)), h("dd", null, one.does)]))))),
    h("p.quiet", null, h("a", { attributes: { href: licencesAddress(), target: "_blank" } }, "Licences of the programs that this page contains")));
}

/** The light edge around a QR code that readers require. */
const EDGE = 4;

/** A QR code as one path; null if the text is too long. */
export function qrView(text: string): View | null {
  let code: Bitmap2D;
  try {
    code = generate(text, { minCorrectionLevel: correction.M });
  } catch {
    return null;
  }
  const size = code.size + 2 * EDGE;
  let path = "";
  for (let y = 0; y < code.size; ++y) for (let x = 0; x < code.size; ++x) if (code.get(x, y)) path += `M${x + EDGE} ${y + EDGE}h1v1h-1z`;
  return h("svg.qr", { attributes: { viewBox: `0 0 ${size} ${size}`, role: "img", "aria-label": "QR code of the link" } }, h("rect", { attributes: { width: size, height: size, fill: "#fff" } }), h("path", { attributes: { d: path, fill: "#000" } }));
}

/** `make` creates the link, if it does not exist yet. `withdraw` revokes it, if that is possible. */
export interface Link { title: string; about: string; address: string; isPlace?: boolean; make?: () => void; withdraw?: () => void }

/** Links to share, where they lead, and what each of them allows. */
export function linkDialog(links: readonly Link[], isSecret: boolean, told: string, copy: (address: string) => void, close: () => void): View {
  const place = links.find((one) => one.isPlace === true);
  return dialog("Links to share", close,
    links.map((one, i) => h("section.link", { key: one.title }, h("h3", null, one.title), h("p", null, one.about),
      one.make !== undefined ? h("div.row", null, button("Make this link", one.make)) : h("div.row", null, h("input.address", { value: one.address, attributes: { type: "text", readonly: true, "aria-label": one.title }, on: { focus: (event) => (event.target as HTMLInputElement).select() } }),
        button("Copy", () => copy(one.address), { attributes: { "aria-label": `Copy: ${one.title}` } }, i === 0 ? "button.primary" : "button"),
        one.withdraw !== undefined && button("Withdraw", one.withdraw)))),
    isSecret && h("p.quiet", null, "The links do not contain the token that this server requires."),
    h("p.good", { attributes: { role: "status" } }, told),
    place !== undefined && h("figure", null, qrView(place.address.replace(/#.*$/, "")), h("figcaption.quiet", null, "Your whole place, for another machine of yours")));
}
