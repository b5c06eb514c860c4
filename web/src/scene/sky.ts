// SPDX-License-Identifier: BSD-2-Clause
import { BackSide, Color, LinearFilter, Mesh, MeshBasicMaterial, RepeatWrapping, SphereGeometry, SRGBColorSpace, type DataTexture } from "three";
import type { Rgb } from "./looks";
import { fractal2, latticeValue } from "./noise";
import { paintLater } from "./painter";

interface SkyStyle { zenith: Rgb; horizon: Rgb; cloudLight: Rgb; cloudDark: Rgb; below: Rgb; cover: number; stars: number }

const USUAL: SkyStyle = { zenith: [0.24, 0.44, 0.72], horizon: [0.8, 0.86, 0.9], cloudLight: [1, 0.99, 0.97], cloudDark: [0.62, 0.67, 0.73], below: [0.55, 0.62, 0.6], cover: 0.5, stars: 0 };
const SKIES: Readonly<Record<string, SkyStyle>> = {
  ThickCloudsWater: USUAL,
  CloudyLightRays: { zenith: [0.3, 0.45, 0.66], horizon: [0.88, 0.86, 0.8], cloudLight: [1, 0.97, 0.9], cloudDark: [0.5, 0.54, 0.6], below: [0.5, 0.55, 0.52], cover: 0.68, stars: 0 },
  TropicalSunnyDay: { zenith: [0.1, 0.4, 0.8], horizon: [0.72, 0.88, 0.95], cloudLight: [1, 1, 1], cloudDark: [0.78, 0.84, 0.9], below: [0.5, 0.65, 0.66], cover: 0.27, stars: 0 },
  SunSet: { zenith: [0.2, 0.22, 0.44], horizon: [0.98, 0.6, 0.34], cloudLight: [1, 0.72, 0.5], cloudDark: [0.38, 0.26, 0.36], below: [0.4, 0.3, 0.3], cover: 0.46, stars: 0 },
  DarkStormy: { zenith: [0.18, 0.21, 0.26], horizon: [0.44, 0.47, 0.5], cloudLight: [0.58, 0.6, 0.62], cloudDark: [0.2, 0.22, 0.26], below: [0.25, 0.28, 0.3], cover: 0.85, stars: 0 },
  FullMoon: { zenith: [0.02, 0.03, 0.09], horizon: [0.12, 0.16, 0.26], cloudLight: [0.3, 0.34, 0.44], cloudDark: [0.08, 0.1, 0.16], below: [0.06, 0.08, 0.12], cover: 0.34, stars: 1 },
};
const WIDTH = 640, HEIGHT = 320, FEW_ROWS = 64;

const mix = (a: Rgb, b: Rgb, t: number): Rgb => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
function smooth(low: number, high: number, value: number): number {
  const t = Math.min(Math.max((value - low) / (high - low), 0), 1);
  return t * t * (3 - 2 * t);
}

function above(style: SkyStyle, x: number, y: number, z: number): Rgb {
  let air = mix(style.horizon, style.zenith, y ** 0.52);
  if (style.stars > 0) {
    const star = latticeValue(Math.floor(x * 160), Math.floor(y * 160), Math.floor(z * 160), 77);
    if (star > 0.9975) air = mix(air, [1, 1, 1], (star - 0.9975) / 0.0025);
  }
  if (style.cover <= 0) return air;
  const far = 1.55 / (y + 0.14), cx = x * far, cy = z * far, bend = fractal2(cx * 1.7 + 5, cy * 1.7, 3, 201) - 0.5;
  const density = (px: number, py: number): number => fractal2(px + 0.9 * bend, py - 0.9 * bend, 5, 7);
  const here = density(cx, cy), edge = 0.7 - 0.42 * style.cover, cover = smooth(edge, edge + 0.2, here);
  if (cover <= 0) return air;
  const shade = Math.min(Math.max(0.5 + 3.2 * (here - density(cx + 0.16, cy - 0.12)) + 0.9 * (edge + 0.16 - here), 0), 1);
  return mix(air, mix(style.horizon, mix(style.cloudDark, style.cloudLight, shade), smooth(-0.02, 0.22, y)), cover * smooth(0, 0.07, y));
}

function toneAt(style: SkyStyle, row: number, column: number, rows: number, columns: number): Rgb {
  const tilt = Math.PI * ((row + 0.5) / rows - 0.5), y = Math.sin(tilt), wide = Math.cos(tilt), angle = (2 * Math.PI * column) / columns;
  return y >= 0 ? above(style, wide * Math.sin(angle), y, wide * Math.cos(angle)) : mix(style.horizon, style.below, smooth(0, 0.2, -y));
}

function paintRow(style: SkyStyle, row: number, rows: number, columns: number, into: Uint8Array): void {
  for (let column = 0; column < columns; ++column) {
    const tone = toneAt(style, row, column, rows, columns), at = 4 * column;
    for (let c = 0; c < 3; ++c) into[at + c] = tone[c]! * 255;
    into[at + 3] = 255;
  }
}

/** A clear sky; clouds and stars are painted later. */
function picture(style: SkyStyle): DataTexture {
  const clear = new Uint8Array(4 * FEW_ROWS), air: SkyStyle = { ...style, cover: 0, stars: 0 };
  for (let row = 0; row < FEW_ROWS; ++row) paintRow(air, row, FEW_ROWS, 1, clear.subarray(4 * row, 4 * row + 4));
  const texture = paintLater(clear, FEW_ROWS, { width: WIDTH, height: HEIGHT, row: (row, pixels) => paintRow(style, row, HEIGHT, WIDTH, pixels) });
  texture.wrapS = RepeatWrapping;
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.colorSpace = SRGBColorSpace;
  texture.needsUpdate = true;
  return texture;
}

/** A sphere around the camera with a named sky, and the colour of its haze. */
export class Sky {
  readonly mesh: Mesh<SphereGeometry, MeshBasicMaterial>;
  readonly haze = new Color();
  private shown: string | null = null;

  constructor() {
    this.mesh = new Mesh(new SphereGeometry(1, 32, 16), new MeshBasicMaterial({ side: BackSide, fog: false, depthWrite: false, toneMapped: false }));
    // Drawn after all solid objects, so that hidden pixels cost nothing.
    this.mesh.renderOrder = 2;
    this.mesh.frustumCulled = false;
    this.mesh.scale.setScalar(900);
  }

  show(name: string): void {
    if (name === this.shown) return;
    this.shown = name;
    const key = name.replace(/SkyBox$/, ""), style = name === "" ? { ...USUAL, cover: 0 } : Object.hasOwn(SKIES, key) ? SKIES[key]! : USUAL;
    this.mesh.material.map?.dispose();
    this.mesh.material.map = picture(style);
    this.mesh.material.needsUpdate = true;
    this.haze.setRGB(style.horizon[0], style.horizon[1], style.horizon[2], SRGBColorSpace);
  }
}
