// SPDX-License-Identifier: BSD-2-Clause
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Points, ShaderMaterial } from "three";
import type { Vec3 } from "../format/scene";
import type { Rgb } from "./looks";

const VERTEX = /* glsl */ `
attribute vec3 ink;
uniform float size;
varying vec3 vInk;
void main() {
  gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
  gl_PointSize = size;
  vInk = ink;
}`;
const FRAGMENT = /* glsl */ `
uniform float size;
varying vec3 vInk;
void main() {
  float away = length(gl_PointCoord - 0.5) * size, rim = 0.5 * size - 1.0;
  float alpha = clamp(rim + 0.5 - away, 0.0, 1.0);
  if (alpha <= 0.0) discard;
  gl_FragColor = vec4(mix(vInk, vec3(0.05, 0.07, 0.1), smoothstep(0.25 * size, 0.25 * size + 1.0, away)), alpha);
}`;
const SIZE_PX = 11;

/** Dots over the heads of agents without space for a name, in one draw call. */
export class Dots {
  readonly points = new Points(new BufferGeometry(), new ShaderMaterial({
    vertexShader: VERTEX, fragmentShader: FRAGMENT, transparent: true, depthTest: false, depthWrite: false, uniforms: { size: { value: SIZE_PX } },
  }));
  private room = 0;

  constructor() {
    this.points.frustumCulled = false;
    this.points.renderOrder = 6;
  }

  show(dots: readonly { place: Vec3; color: Rgb }[], pixelRatio: number): void {
    const { geometry } = this.points;
    this.points.visible = dots.length > 0;
    this.points.material.uniforms["size"]!.value = SIZE_PX * pixelRatio;
    if (dots.length === 0) return;
    if (dots.length > this.room) {
      geometry.dispose();
      this.room = 2 * dots.length;
      for (const name of ["position", "ink"]) geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * this.room), 3).setUsage(DynamicDrawUsage));
    }
    const places = geometry.getAttribute("position") as BufferAttribute, inks = geometry.getAttribute("ink") as BufferAttribute;
    dots.forEach(({ place, color }, i) => {
      places.setXYZ(i, ...place);
      inks.setXYZ(i, ...color);
    });
    places.needsUpdate = inks.needsUpdate = true;
    geometry.setDrawRange(0, dots.length);
  }
}
