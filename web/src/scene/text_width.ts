// SPDX-License-Identifier: BSD-2-Clause

/** Fonts of labels, as scene.css has them. */
export const NAME_FONT = "bold 13px system-ui, sans-serif", DOING_FONT = "12px system-ui, sans-serif", SPEECH_FONT = "13px system-ui, sans-serif";

const MOST_KEPT = 2000;
const widths = new Map<string, number>();
let pen: OffscreenCanvasRenderingContext2D | null | undefined;

/** Width of a text in pixels, as a browser draws it; outside of browsers an estimate. */
export function textWidth(text: string, font: string): number {
  const key = `${font}\n${text}`, known = widths.get(key);
  if (known !== undefined) return known;
  pen ??= typeof OffscreenCanvas === "undefined" ? null : new OffscreenCanvas(1, 1).getContext("2d");
  let width = text.length * (font.startsWith("bold") ? 8 : 7);
  if (pen !== null && pen !== undefined) {
    pen.font = font;
    width = pen.measureText(text).width;
  }
  if (widths.size > MOST_KEPT) widths.clear();
  widths.set(key, width);
  return width;
}
