// SPDX-License-Identifier: BSD-2-Clause
import { DataArrayTexture, LinearFilter, LinearMipmapLinearFilter, LinearMipmapNearestFilter, NoColorSpace, RepeatWrapping, SRGBColorSpace, type DataTexture, type Texture } from "three";
import type { Paint, Rgb } from "./looks";
import { fractal2, latticeValue, noise2 } from "./noise";
import { paintInto, paintLater, type Canvas } from "./painter";

/** Surface materials of bodies: cells of one picture, by the names that shapes use. */
enum Cloth { Camouflage, Webbing, Skin, Leather, Metal, Glass, Helmet, Rubber, Steel, Team, DarkCamouflage, DarkWebbing, DarkHelmet }
const CLOTHS = 13;

/** The colour of a texture at a position. Textures are painted by code when they are first needed. */
type Shade = (u: number, v: number, x: number, y: number) => Rgb;

/** A picture of a shade. */
const canvasOf = (size: number, shade: Shade): Canvas => ({
  width: size, height: size,
  row: (y, pixels) => {
    for (let x = 0; x < size; ++x) {
      const tone = shade((x + 0.5) / size, (y + 0.5) / size, x, y), at = 4 * x;
      for (let c = 0; c < 3; ++c) pixels[at + c] = byteOf(tone[c]!);
      pixels[at + 3] = 255;
    }
  },
});

const byteOf = (tone: number): number => Math.min(Math.max(tone, 0), 1) * 255 + 0.5;

/** A texture that is painted later; `first` is its colour until then. */
function painted(size: number, first: Rgb, shade: Shade, isData = false): DataTexture {
  const texture = paintLater(Uint8Array.of(...first.map(byteOf), 255), 1, canvasOf(size, shade));
  return repeated(texture, isData);
}

/** Settings of textures that are sampled from near and far. */
function repeated<T extends Texture>(texture: T, isData: boolean): T {
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.colorSpace = isData ? NoColorSpace : SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

const grey = (value: number): Rgb => [value, value, value];
const mix = (a: Rgb, b: Rgb, t: number): Rgb => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];

/** 0 at the border of the cell that a value falls into, 1 inside. */
function insideCell(value: number, width: number): number {
  const inside = value - Math.floor(value);
  return Math.min(Math.max(Math.min(inside, 1 - inside) / width, 0), 1);
}

const concrete: Shade = (u, v) => {
  const blotch = fractal2(u * 4, v * 4, 6, 3, 4), pores = noise2(u * 96, v * 96, 9, 96);
  return grey((0.72 + 0.22 * blotch - (pores > 0.86 ? 0.1 : 0)) * (0.92 + 0.08 * insideCell(v * 2, 0.02)));
};

const brick: Shade = (u, v) => {
  const row = Math.floor(v * 8), shifted = u * 4 + (row % 2 !== 0 ? 0.5 : 0);
  const fired = Math.min(insideCell(v * 8, 0.09), insideCell(shifted, 0.045)), tone = 0.68 + 0.3 * latticeValue(Math.floor(shifted) % 4, row, 0, 5);
  const rough = 0.85 + 0.3 * (fractal2(u * 16, v * 16, 4, 7, 16) - 0.5), mortar = 0.74 + 0.2 * noise2(u * 64, v * 64, 13, 64);
  const of = (red: number, lime: number): number => lime * mortar * (1 - fired) + red * tone * rough * fired;
  return [of(0.78, 0.82), of(0.43, 0.79), of(0.33, 0.74)];
};

const crate: Shade = (u, v) => {
  const number = Math.floor(v * 8), fibre = fractal2(u * 6, v * 96, 4, 41 + number), tone = 0.8 + 0.16 * latticeValue(number, 0, 0, 19);
  const value = tone * (0.9 + 0.36 * (fibre - 0.5)) * (0.62 + 0.38 * insideCell(v * 8, 0.05));
  return [value, value * 0.965, value * 0.9];
};

const leaves: Shade = (u, v) => {
  const light = 0.45 + 0.45 * fractal2(u * 6, v * 6, 4, 89, 6) + 0.5 * (noise2(u * 40, v * 40, 83, 40) - 0.5), hue = noise2(u * 20, v * 20, 97, 20);
  return [light * (0.62 + 0.3 * hue), light * 0.95, light * (0.52 + 0.1 * hue)];
};

const stone: Shade = (u, v) => {
  const crack = Math.abs(fractal2(u * 4, v * 4, 5, 107, 4) - 0.5), lichen = 0.12 * Math.min(Math.max(6 * (fractal2(u * 9, v * 9, 5, 109, 9) - 0.6), 0), 1);
  const value = 0.5 + 0.26 * fractal2(u * 5, v * 5, 6, 103, 5) + 0.2 * (fractal2(u * 40, v * 40, 3, 105, 40) - 0.5) - 0.09 * Math.max(0, 1 - crack / 0.012);
  return [value - 0.1 * lichen, value + 0.1 * lichen, value * 0.96 - 0.4 * lichen];
};

const missing: Shade = (u, v) => ((Math.floor(u * 8) + Math.floor(v * 8)) % 2 !== 0 ? [1, 0, 1] : [0.06, 0.02, 0.06]);

function camouflage(u: number, v: number): Rgb {
  if (fractal2(u * 22, v * 22, 2, 71) > 0.66) return [0.58, 0.54, 0.42];
  if (fractal2(u * 11 + 7, v * 11, 3, 67) > 0.6) return [0.3, 0.25, 0.17];
  return fractal2(u * 9, v * 9, 3, 61) > 0.53 ? [0.33, 0.36, 0.23] : [0.47, 0.45, 0.33];
}

function clothTone(cloth: Cloth, u: number, v: number): Rgb {
  switch (cloth) {
    case Cloth.Camouflage: return camouflage(u, v);
    case Cloth.Webbing: return [0.34, 0.335, 0.255];
    case Cloth.Skin: return mix([0.74, 0.53, 0.42], [0.66, 0.45, 0.35], fractal2(u * 14, v * 14, 3, 5));
    case Cloth.Leather: return [0.2, 0.155, 0.115];
    case Cloth.Metal: return [0.2, 0.205, 0.215];
    case Cloth.Glass: return [0.05, 0.07, 0.09];
    case Cloth.Helmet: return mix([0.38, 0.385, 0.285], [0.33, 0.335, 0.25], fractal2(u * 10, v * 10, 3, 9));
    case Cloth.Rubber: return [0.105, 0.1, 0.095];
    case Cloth.Steel: return [0.42, 0.43, 0.45];
    case Cloth.DarkCamouflage: {
      const tone = camouflage(u, v), dull = (0.35 * (tone[0] + tone[1] + tone[2])) / 3;
      return [0.22 * tone[0] + dull, 0.25 * tone[1] + dull, 0.42 * tone[2] + dull];
    }
    case Cloth.DarkWebbing: return [0.125, 0.13, 0.14];
    case Cloth.DarkHelmet: return mix([0.15, 0.155, 0.165], [0.12, 0.125, 0.135], fractal2(u * 10, v * 10, 3, 9));
    default: return [1, 1, 1];
  }
}

const CELL = 96;
const cloths: Shade = (_u, _v, x, y) => {
  const cell = Math.floor(y / CELL) * 4 + Math.floor(x / CELL);
  if (cell >= CLOTHS) return [1, 1, 1];
  const u = (x % CELL) / CELL, v = (y % CELL) / CELL, tone = clothTone(cell, u, v);
  const shade = (0.88 + 0.24 * fractal2(u * 7, v * 7, 4, 31 + cell)) * (1 + 0.1 * (latticeValue(x, y, cell, 3) - 0.5));
  return [tone[0] * shade, tone[1] * shade, tone[2] * shade];
};

const made = new Map<string, DataTexture>();
function once(name: string, make: () => DataTexture): DataTexture {
  let texture = made.get(name);
  if (texture === undefined) made.set(name, (texture = make()));
  return texture;
}

/** Reduces the number of samples per pixel, because on a processor each sample costs as much as the first one. */
export function sampleCoarsely<T extends Texture>(texture: T): T {
  texture.anisotropy = 1;
  texture.minFilter = LinearMipmapNearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Size, first colour and shade of the paints that are pictures. */
const PICTURES: Partial<Record<Paint, readonly [size: number, first: Rgb, shade: Shade]>> = {
  concrete: [256, grey(0.8), concrete], brick: [256, [0.66, 0.4, 0.32], brick], crate: [256, [0.82, 0.8, 0.74], crate], leaves: [128, [0.5, 0.64, 0.38], leaves],
  stone: [256, grey(0.62), stone], cloth: [CELL * 4, [0.36, 0.35, 0.26], cloths], missing: [64, [0.5, 0, 0.5], missing],
};

/** The texture of a paint; null if it has none. */
export function paintTexture(paint: Paint): DataTexture | null {
  const picture = PICTURES[paint];
  return picture === undefined ? null : once(paint, () => painted(...picture));
}

const LAYERS: readonly Paint[] = ["concrete", "brick", "crate", "leaves", "stone", "missing"], LAYER_SIDE = 256, LAYER_BYTES = 4 * LAYER_SIDE * LAYER_SIDE;
let layers: DataArrayTexture | null = null;
const layersPainted = new Set<number>();

/** Paints that instances of one draw call may have, as the layers of one texture. */
export function paintLayers(): DataArrayTexture {
  layers ??= repeated(new DataArrayTexture(new Uint8Array(LAYERS.length * LAYER_BYTES), LAYER_SIDE, LAYER_SIDE, LAYERS.length), false);
  return layers;
}

/** The layer of a paint, which is painted after the first call; -1: a plain colour. */
export function layerOf(paint: Paint): number {
  const layer = LAYERS.indexOf(paint), picture = PICTURES[paint];
  if (layer < 0 || picture === undefined || layersPainted.has(layer)) return layer;
  layersPainted.add(layer);
  const texture = paintLayers(), pixels = (texture.image.data as Uint8Array).subarray(layer * LAYER_BYTES, (layer + 1) * LAYER_BYTES), [, first, shade] = picture;
  for (let i = 0; i < LAYER_BYTES; i += 4) pixels.set([...first.map(byteOf), 255], i);
  const upload = (): void => {
    texture.needsUpdate = true;
  };
  upload();
  paintInto(canvasOf(LAYER_SIDE, shade), () => pixels, upload);
  return layer;
}

/** Three kinds of noise that repeats, for the ground. */
export function grainTexture(): DataTexture {
  return once("grain", () => painted(256, grey(0.5), (u, v) => [fractal2(u * 8, v * 8, 5, 11, 8), fractal2(u * 8, v * 8, 5, 23, 8), fractal2(u * 8, v * 8, 5, 37, 8)], true));
}

/** The plain of a world as one picture, if the processor draws: grass, soil, tracks, and lines every ten metres. */
export function plainTexture(base: Rgb, grass: Rgb | null, sideM: number): DataTexture {
  return once(`plain${base.join()}${grass?.join() ?? ""}${sideM}`, () => {
    const size = 1024, grain = grainTexture();
    const noise = (x: number, y: number, channel: number): number => {
      const wrap = (value: number): number => ((Math.floor(value * 256) % 256) + 256) % 256;
      return (grain.image.data as Uint8Array)[4 * (wrap(y) * 256 + wrap(x)) + channel]! / 255;
    };
    // The grain was requested before, so it is already painted.
    const texture = painted(size, grass ?? base, (u, v) => {
      const x = (u - 0.5) * sideM, z = (v - 0.5) * sideM, bx = z * 0.0061 + 0.11, by = x * 0.0061 + 0.11;
      const broad = noise(bx, by, 1), dry = noise(bx, by, 2), grains = 0.45 * noise(x * 0.31, z * 0.31, 0) + 0.3 * broad + 0.25 * dry;
      const along = Math.abs(z - 15 - 6 * Math.sin(x * 0.045) - 2 * Math.sin(x * 0.13 + 1.3)), across = Math.abs(x + 19 - 5 * Math.sin(z * 0.05 + 0.7) - 1.5 * Math.sin(z * 0.17));
      const t = Math.min(Math.max((Math.min(along, across) + 1.3 * (broad - 0.5) - 0.75) / 0.6, 0), 1), track = grass === null ? 1 : 1 - t * t * (3 - 2 * t);
      const toDry = Math.min(Math.max((dry - 0.45) / 0.3, 0), 1), lines = Math.min(Math.abs(((x / 10 + 1000.5) % 1) - 0.5), Math.abs(((z / 10 + 1000.5) % 1) - 0.5)) < 0.012 ? 0.9 : 1;
      const of = (c: 0 | 1 | 2): number => {
        const soil = grass === null ? base[c] * (0.74 + 0.52 * grains) : base[c] * [0.98, 0.88, 0.7][c]! * (0.8 + 0.4 * grains);
        const green = grass === null ? 0 : grass[c] * (1 + ([1.22, 1.06, 1.02][c]! - 1) * toDry) * (0.72 + 0.56 * grains);
        return (green + (soil - green) * track) * lines;
      };
      return [of(0), of(1), of(2)];
    });
    return texture;
  });
}
