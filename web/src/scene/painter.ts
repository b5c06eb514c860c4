// SPDX-License-Identifier: BSD-2-Clause
import { DataTexture, type Texture } from "three";

const SLICE_MS = 10;

/** Computes a picture row by row. */
export interface Canvas { readonly width: number; readonly height: number; row(y: number, into: Uint8Array): void }

let painted = (): void => {};
const waiting: (() => boolean)[] = [];
let isBusy = false;

/** `call` is called each time a picture is finished. */
export function whenPainted(call: () => void): void {
  painted = call;
}

/** Paints for a short time, then yields to other tasks. */
function work(): void {
  for (const end = performance.now() + SLICE_MS; performance.now() < end;) {
    if (waiting.length === 0) {
      isBusy = false;
      return;
    }
    if (waiting[0]!()) waiting.shift();
  }
  setTimeout(work, 0);
}

/**
 * Paints a picture into `pixels` after the pictures of earlier calls, unless `isGone` returns true. Then calls `done`.
 * Painting takes longer than drawing, and the first frame must not wait for it.
 */
export function paintInto({ width, height, row }: Canvas, pixels: () => Uint8Array, done: () => void, isGone: () => boolean = () => false): void {
  let into: Uint8Array | null = null, y = 0;
  waiting.push(() => {
    if (isGone()) return true;
    into ??= pixels();
    row(y, into.subarray(4 * width * y, 4 * width * (y + 1)));
    y += 1;
    if (y < height) return false;
    done();
    painted();
    return true;
  });
  if (isBusy) return;
  isBusy = true;
  setTimeout(work, 0);
}

/** Returns a texture with the small picture `first`, which is replaced after `canvas` is painted. */
export function paintLater(first: Uint8Array<ArrayBuffer>, firstHeight: number, canvas: Canvas): DataTexture {
  const { width, height } = canvas, texture = new DataTexture(first, first.length / 4 / firstHeight, firstHeight);
  let pixels = first, isGone = false;
  const gone = (): void => {
    isGone = true;
  };
  texture.addEventListener("dispose", gone);
  paintInto(canvas, () => (pixels = new Uint8Array(width * height * 4)), () => replace(texture, gone, pixels, width, height), () => isGone);
  return texture;
}

/** Replaces a picture by one of another size, so the texture is allocated again. */
function replace(texture: DataTexture, gone: () => void, data: Uint8Array<ArrayBuffer>, width: number, height: number): void {
  texture.removeEventListener("dispose", gone);
  (texture as Texture).dispose();
  texture.image = { data, width, height };
  texture.needsUpdate = true;
}
