// SPDX-License-Identifier: BSD-2-Clause

/** Seeded lattice noise for shapes and pictures that are made by code; the same as the window's. */
export function latticeValue(x: number, y: number, z: number, seed: number): number {
  let h = (seed + Math.imul(x, 0x8da6b343) + Math.imul(y, 0xd8163841) + Math.imul(z, 0xcb1ab31f)) >>> 0;
  h ^= h >>> 16;
  h = Math.imul(h, 0x7feb352d) >>> 0;
  h ^= h >>> 15;
  h = Math.imul(h, 0x846ca68b) >>> 0;
  h ^= h >>> 16;
  return ((h >>> 0) >>> 8) / 16777216;
}

/** Cached values of repeating noise. */
const LARGEST_TABLE = 128;
const tables = new Map<number, Float32Array>();
function tableOf(seed: number, period: number): Float32Array {
  const key = seed * (LARGEST_TABLE + 1) + period;
  let table = tables.get(key);
  if (table === undefined) {
    table = new Float32Array(period * period);
    for (let y = 0; y < period; ++y) for (let x = 0; x < period; ++x) table[y * period + x] = latticeValue(x, y, 0, seed);
    tables.set(key, table);
  }
  return table;
}

/** Smooth noise in the plane, 0..1; repeats every `period` cells if that is positive. */
export function noise2(x: number, y: number, seed: number, period = 0): number {
  const x0 = Math.floor(x), y0 = Math.floor(y), fx = x - x0, fy = y - y0;
  const wrap = (i: number): number => (period > 0 ? ((i % period) + period) % period : i);
  const xa = wrap(x0), xb = wrap(x0 + 1), ya = wrap(y0), yb = wrap(y0 + 1);
  const sx = fx * fx * (3 - 2 * fx), sy = fy * fy * (3 - 2 * fy);
  if (period > 0 && period <= LARGEST_TABLE && Number.isInteger(period)) {
    const table = tableOf(seed, period), low = ya * period, high = yb * period, p = table[low + xa]!, q = table[low + xb]!, r = table[high + xa]!, s = table[high + xb]!;
    return p + (q - p) * sx + (r - p) * sy + (p - q - r + s) * sx * sy;
  }
  const a = latticeValue(xa, ya, 0, seed), b = latticeValue(xb, ya, 0, seed), c = latticeValue(xa, yb, 0, seed), d = latticeValue(xb, yb, 0, seed);
  return a + (b - a) * sx + (c - a) * sy + (a - b - c + d) * sx * sy;
}

/** Octaves of noise2, each twice as fine and half as strong, scaled to 0..1. */
export function fractal2(x: number, y: number, octaves: number, seed: number, period = 0): number {
  let sum = 0, weight = 0.5, total = 0, size = 1;
  for (let i = 0; i < octaves; ++i) {
    sum += weight * noise2(x * size, y * size, seed + i * 101, period * size);
    total += weight;
    weight *= 0.5;
    size *= 2;
  }
  return sum / total;
}
