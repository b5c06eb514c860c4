// SPDX-License-Identifier: BSD-2-Clause

/**
 * QR codes for links: bytes, level M, versions 1 to 10 (213 bytes at most). ISO/IEC 18004 has the tables: by version,
 * the check codewords of a block, then the data codewords of its blocks.
 */
const BLOCKS: readonly (readonly [checks: number, ...data: number[]])[] = [
  [10, 16], [16, 28], [26, 44], [18, 32, 32], [24, 43, 43], [16, 27, 27, 27, 27], [18, 31, 31, 31, 31], [22, 38, 38, 39, 39], [22, 36, 36, 36, 37, 37], [26, 43, 43, 43, 43, 44],
];
const ALIGNMENT: readonly (readonly number[])[] = [[], [6, 18], [6, 22], [6, 26], [6, 30], [6, 34], [6, 22, 38], [6, 24, 42], [6, 26, 46], [6, 28, 50]];
const LEVEL_M = 0, BYTE_MODE = 4;

// The field of 256 elements by x^8 + x^4 + x^3 + x^2 + 1.
const POWERS: number[] = [], LOGS: number[] = [];
for (let i = 0, value = 1; i < 255; ++i) {
  POWERS[i] = value;
  LOGS[value] = i;
  value = value < 128 ? value * 2 : (value * 2) ^ 0x11d;
}
export const product = (a: number, b: number): number => (a === 0 || b === 0 ? 0 : POWERS[(LOGS[a]! + LOGS[b]!) % 255]!);
export const power = (exponent: number): number => POWERS[exponent % 255]!;

/** Reed-Solomon: the remainder of the data, followed by zeros, divided by (x - 1)(x - a)(x - a^2)... */
function checkWords(data: readonly number[], count: number): number[] {
  let divisor = [1];
  for (let i = 0; i < count; ++i) {
    const next = [...divisor, 0];
    divisor.forEach((coefficient, at) => (next[at + 1] = next[at + 1]! ^ product(coefficient, power(i))));
    divisor = next;
  }
  const rest = [...data, ...Array.from({ length: count }, () => 0)];
  for (let i = 0; i < data.length; ++i) {
    const factor = rest[i]!;
    divisor.forEach((coefficient, at) => (rest[i + at] = rest[i + at]! ^ product(coefficient, factor)));
  }
  return rest.slice(data.length);
}

function codewords(bytes: Uint8Array, version: number): number[] {
  const [checks, ...sizes] = BLOCKS[version - 1]!, room = sizes.reduce((sum, one) => sum + one, 0), bits: number[] = [];
  const put = (value: number, count: number): void => {
    for (let i = count - 1; i >= 0; --i) bits.push((value >> i) & 1);
  };
  put(BYTE_MODE, 4);
  put(bytes.length, version < 10 ? 8 : 16);
  for (const byte of bytes) put(byte, 8);
  put(0, Math.min(4, room * 8 - bits.length));
  while (bits.length % 8 !== 0) bits.push(0);
  const data: number[] = [];
  for (let i = 0; i < bits.length; i += 8) data.push(bits.slice(i, i + 8).reduce((sum, bit) => sum * 2 + bit, 0));
  for (let pad = 0xec; data.length < room; pad ^= 0xec ^ 0x11) data.push(pad);

  let at = 0;
  const blocks = sizes.map((size) => {
    const block = data.slice(at, at + size);
    at += size;
    return { block, check: checkWords(block, checks) };
  });
  const woven: number[] = [];
  for (let i = 0; i < Math.max(...sizes); ++i) for (const { block } of blocks) if (i < block.length) woven.push(block[i]!);
  for (let i = 0; i < checks; ++i) for (const { check } of blocks) woven.push(check[i]!);
  return woven;
}

/** The remainder of a code of the field with two elements. */
function withRemainder(value: number, divisor: number, bits: number): number {
  let rest = value << bits;
  for (let i = 31 - Math.clz32(rest); rest !== 0 && i >= bits; i = 31 - Math.clz32(rest)) rest ^= divisor << (i - bits);
  return (value << bits) | rest;
}

export const MASKS: readonly ((row: number, column: number) => boolean)[] = [
  (r, c) => (r + c) % 2 === 0, (r) => r % 2 === 0, (_r, c) => c % 3 === 0, (r, c) => (r + c) % 3 === 0, (r, c) => (Math.floor(r / 2) + Math.floor(c / 3)) % 2 === 0,
  (r, c) => ((r * c) % 2) + ((r * c) % 3) === 0, (r, c) => (((r * c) % 2) + ((r * c) % 3)) % 2 === 0, (r, c) => (((r + c) % 2) + ((r * c) % 3)) % 2 === 0,
];

/** The places of data, in the order in which they are filled: two columns at a time, up and down in turns. */
export function dataPlaces(size: number, isFixed: (row: number, column: number) => boolean): [number, number][] {
  const places: [number, number][] = [];
  let up = true;
  for (let right = size - 1; right > 0; right -= 2) {
    if (right === 6) right = 5;
    for (let step = 0; step < size; ++step) for (const column of [right, right - 1]) {
      const row = up ? size - 1 - step : step;
      if (!isFixed(row, column)) places.push([row, column]);
    }
    up = !up;
  }
  return places;
}

/** The penalty of a mask: runs, squares, patterns that resemble finder marks, and imbalance of dark and light. */
function unevenness(dark: readonly (readonly boolean[])[]): number {
  const size = dark.length, sign = [true, false, true, true, true, false, true];
  let points = 0, count = 0;
  const line = (at: (i: number) => boolean): void => {
    for (let i = 0, run = 0; i < size; ++i) {
      run = i > 0 && at(i) === at(i - 1) ? run + 1 : 1;
      if (run === 5) points += 3;
      else if (run > 5) points += 1;
    }
    for (let i = 0; i + 7 <= size; ++i) {
      if (!sign.every((want, k) => at(i + k) === want)) continue;
      const isLight = (from: number): boolean => [0, 1, 2, 3].every((k) => from + k < 0 || from + k >= size || !at(from + k));
      if (isLight(i - 4) || isLight(i + 7)) points += 40;
    }
  };
  for (let i = 0; i < size; ++i) {
    line((k) => dark[i]![k]!);
    line((k) => dark[k]![i]!);
    for (let k = 0; k < size; ++k) {
      if (dark[i]![k]!) count += 1;
      if (i > 0 && k > 0 && dark[i]![k] === dark[i - 1]![k] && dark[i]![k] === dark[i]![k - 1] && dark[i]![k] === dark[i - 1]![k - 1]) points += 3;
    }
  }
  return points + 10 * Math.floor(Math.abs((count * 20) / (size * size) - 10));
}

export interface QrCode { size: number; dark: readonly (readonly boolean[])[]; version: number; mask: number; isFixed: (row: number, column: number) => boolean }

/** Null if the text is too long. */
export function qrCode(text: string): QrCode | null {
  const bytes = new TextEncoder().encode(text);
  const version = BLOCKS.findIndex(([, ...sizes], i) => sizes.reduce((sum, one) => sum + one, 0) >= bytes.length + (i < 9 ? 2 : 3)) + 1;
  if (version === 0) return null;
  const size = 17 + 4 * version, dark: boolean[][] = Array.from({ length: size }, () => Array.from({ length: size }, () => false)), fixed = new Set<number>();
  const set = (row: number, column: number, isDark: boolean): void => {
    if (row < 0 || column < 0 || row >= size || column >= size) return;
    dark[row]![column] = isDark;
    fixed.add(row * size + column);
  };
  for (let i = 0; i < size; ++i) {
    set(6, i, i % 2 === 0);
    set(i, 6, i % 2 === 0);
  }
  const square = (row: number, column: number, rings: number, isDark: (ring: number) => boolean): void => {
    for (let r = -rings; r <= rings; ++r) for (let c = -rings; c <= rings; ++c) set(row + r, column + c, isDark(Math.max(Math.abs(r), Math.abs(c))));
  };
  for (const [row, column] of [[3, 3], [3, size - 4], [size - 4, 3]] as const) square(row, column, 4, (ring) => ring !== 2 && ring !== 4);
  const centres = ALIGNMENT[version - 1]!;
  for (const row of centres) for (const column of centres) {
    const isCorner = (row === 6 && (column === 6 || column === size - 7)) || (row === size - 7 && column === 6);
    if (!isCorner) square(row, column, 2, (ring) => ring !== 1);
  }
  if (version >= 7) {
    const told = withRemainder(version, 0x1f25, 12);
    for (let i = 0; i < 18; ++i) {
      const isDark = ((told >> i) & 1) !== 0, a = Math.floor(i / 3), b = size - 11 + (i % 3);
      set(a, b, isDark);
      set(b, a, isDark);
    }
  }
  const format = (mask: number): void => {
    const told = withRemainder((LEVEL_M << 3) | mask, 0x537, 10) ^ 0x5412, bit = (i: number): boolean => ((told >> i) & 1) !== 0;
    for (let i = 0; i < 15; ++i) {
      if (i < 8) set(i < 6 ? i : i + 1, 8, bit(i));
      else set(8, i === 8 ? 7 : 14 - i, bit(i));
      if (i < 8) set(8, size - 1 - i, bit(i));
      else set(size - 15 + i, 8, bit(i));
    }
    set(size - 8, 8, true);
  };
  format(0);
  const isFixed = (row: number, column: number): boolean => fixed.has(row * size + column), words = codewords(bytes, version);
  const places = dataPlaces(size, isFixed);
  places.forEach(([row, column], i) => (dark[row]![column] = (((words[i >> 3] ?? 0) >> (7 - (i & 7))) & 1) !== 0));
  const flip = (mask: number): void => {
    for (const [row, column] of places) if (MASKS[mask]!(row, column)) dark[row]![column] = !dark[row]![column];
  };
  let best = 0, least = Infinity;
  for (let mask = 0; mask < MASKS.length; ++mask) {
    format(mask);
    flip(mask);
    const points = unevenness(dark);
    if (points < least) [best, least] = [mask, points];
    flip(mask);
  }
  format(best);
  flip(best);
  return { size, dark, version, mask: best, isFixed };
}
