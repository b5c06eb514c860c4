// SPDX-License-Identifier: BSD-2-Clause

/** Boxes on the picture, in pixels. */
export interface Box { left: number; top: number; width: number; height: number }

/** Approximate distance from the head to the end of the body. */
const BODY_PX = 44;

const overlaps = (a: Box, b: Box): boolean => a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;

/** Finds places for labels, so that none covers another. */
export class LabelLayout {
  private readonly taken: Box[] = [];

  constructor(private readonly width: number, private readonly height: number, private readonly gap = 3) {}

  block(box: Box): void {
    this.taken.push(box);
  }

  /** A free position above (x, y), otherwise to its side, further up or below; null if there is none nearby. */
  place(x: number, y: number, width: number, height: number): Box | null {
    const { gap } = this, above = y - height - gap;
    const row = height + 2 * gap, beside = width / 2 + 4 * gap;
    const tries: readonly (readonly [number, number])[] = [
      [x - width / 2, above], [x - width / 2 + beside, above + row / 2], [x - width / 2 - beside, above + row / 2], [x - width / 2, above - row], [x - width / 2 + 2 * beside, above - row / 2],
      [x - width / 2 - 2 * beside, above - row / 2], [x - width / 2, above - 2 * row], [x - width / 2 + 1.2 * beside, above - 1.5 * row], [x - width / 2 - 1.2 * beside, above - 1.5 * row],
      // Below the body, if everything above it is covered.
      [x - width / 2, y + BODY_PX], [x - width / 2 + beside, y + BODY_PX], [x - width / 2 - beside, y + BODY_PX],
    ];
    for (const [left, top] of tries) {
      const box: Box = { left: Math.min(Math.max(left, gap), this.width - width - gap), top: Math.max(top, gap), width, height };
      if (box.top + height > this.height || this.taken.some((other) => overlaps(box, other))) continue;
      this.taken.push({ left: box.left - gap, top: box.top - gap, width: width + 2 * gap, height: height + 2 * gap });
      return box;
    }
    return null;
  }
}
