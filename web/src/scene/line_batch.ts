// SPDX-License-Identifier: BSD-2-Clause
import { BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, MeshBasicMaterial, ShaderMaterial, Vector2 } from "three";
import type { Rgb } from "./looks";
import type { Vec3 } from "../format/scene";

const VERTEX = /* glsl */ `
attribute vec3 from;
attribute vec3 to;
attribute vec4 ink;
uniform vec2 picture;
uniform float width;
varying vec4 vInk;
varying float vSide;
void main() {
  vec4 a = projectionMatrix * viewMatrix * vec4(from, 1.0), b = projectionMatrix * viewMatrix * vec4(to, 1.0);
  float near = 0.02;
  if (a.w < near && b.w < near) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.w < near) a = mix(a, b, (near - a.w) / (b.w - a.w));
  if (b.w < near) b = mix(b, a, (near - b.w) / (a.w - b.w));
  vec2 way = (b.xy / b.w - a.xy / a.w) * picture;
  vec2 along = length(way) > 1e-4 ? normalize(way) : vec2(1.0, 0.0);
  vec4 at = mix(a, b, position.x);
  vec2 aside = vec2(-along.y, along.x) * position.y + along * (position.x * 2.0 - 1.0) * 0.4;
  at.xy += aside * (width + 1.0) / picture * at.w;
  gl_Position = at;
  vInk = ink;
  vSide = position.y;
}`;
const FRAGMENT = /* glsl */ `
uniform float width;
varying vec4 vInk;
varying float vSide;
void main() {
  float edge = (1.0 - abs(vSide)) * (width + 1.0) * 0.5;
  gl_FragColor = vec4(vInk.rgb, vInk.a * clamp(edge, 0.0, 1.0));
}`;

export type Ink = readonly [number, number, number, number];
export const ink = (color: Rgb, alpha = 1): Ink => [color[0], color[1], color[2], Math.min(Math.max(alpha, 0), 1)];

/** Lines some pixels wide and filled triangles, collected again for each picture. */
export class LineBatch {
  readonly lines: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  readonly fills: Mesh<BufferGeometry, MeshBasicMaterial>;
  private from = new Float32Array(0);
  private to = new Float32Array(0);
  private inks = new Float32Array(0);
  private count = 0;
  private corners: number[] = [];
  private cornerInks: number[] = [];

  constructor(width = 2) {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(Float32Array.from([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.lines = new Mesh(geometry, new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthWrite: false, side: DoubleSide,
      uniforms: { picture: { value: new Vector2(1, 1) }, width: { value: width } },
    }));
    this.fills = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false, side: DoubleSide, toneMapped: false, fog: false }));
    for (const mesh of [this.lines, this.fills]) {
      mesh.frustumCulled = false;
      mesh.renderOrder = 5;
    }
    this.grow(1024);
  }

  begin(): void {
    this.count = 0;
    this.corners = [];
    this.cornerInks = [];
  }

  line(from: Vec3, to: Vec3, color: Ink): void {
    if (this.count * 3 >= this.from.length) this.grow(2 * this.count);
    this.from.set(from, this.count * 3);
    this.to.set(to, this.count * 3);
    this.inks.set(color, this.count * 4);
    this.count += 1;
  }

  fill(a: Vec3, b: Vec3, c: Vec3, color: Ink): void {
    this.corners.push(...a, ...b, ...c);
    for (let i = 0; i < 3; ++i) this.cornerInks.push(...color);
  }

  end(widthPx: number, heightPx: number, pixelRatio: number): void {
    const geometry = this.lines.geometry;
    geometry.instanceCount = this.count;
    for (const name of ["from", "to", "ink"]) (geometry.getAttribute(name) as InstancedBufferAttribute).needsUpdate = true;
    this.lines.material.uniforms["picture"]!.value.set(widthPx / pixelRatio, heightPx / pixelRatio);
    this.lines.visible = this.count > 0;
    this.fills.visible = this.corners.length > 0;
    if (!this.fills.visible) return;
    this.fills.geometry.dispose();
    this.fills.geometry = new BufferGeometry();
    this.fills.geometry.setAttribute("position", new BufferAttribute(Float32Array.from(this.corners), 3));
    this.fills.geometry.setAttribute("color", new BufferAttribute(Float32Array.from(this.cornerInks), 4));
  }

  private grow(size: number): void {
    const geometry = this.lines.geometry, bigger = (old: Float32Array, width: number): Float32Array<ArrayBuffer> => {
      const made = new Float32Array(size * width);
      made.set(old.subarray(0, made.length));
      return made;
    };
    geometry.dispose();
    this.from = bigger(this.from, 3);
    this.to = bigger(this.to, 3);
    this.inks = bigger(this.inks, 4);
    for (const [name, array, width] of [["from", this.from, 3], ["to", this.to, 3], ["ink", this.inks, 4]] as const)
      geometry.setAttribute(name, new InstancedBufferAttribute(array, width).setUsage(DynamicDrawUsage));
  }
}
