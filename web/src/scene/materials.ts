// SPDX-License-Identifier: BSD-2-Clause
import { BufferAttribute, BufferGeometry, Color, MeshLambertMaterial, MeshStandardMaterial, SRGBColorSpace, type DataArrayTexture, type Material, type WebGLProgramParametersWithUniforms } from "three";
import { lookOf, type Look, type Rgb } from "./looks";
import type { ShapeMesh } from "./shape_library";
import { grainTexture, paintLayers, paintTexture, plainTexture, sampleCoarsely } from "./paint";

/** Worlds with a square plain of this size have hills, woods and a fence around it. */
export const PLAIN_SIDE_M = 200;

export function linear(color: Rgb): Rgb {
  const made = new Color().setRGB(color[0], color[1], color[2], SRGBColorSpace);
  return [made.r, made.g, made.b];
}

/** A mesh's geometry in the two colours of a look: vertices with a tint get the second colour. */
export function geometryOf(mesh: ShapeMesh, look: Look, shared?: BufferGeometry): BufferGeometry {
  const geometry = new BufferGeometry();
  const count = mesh.count, colors = new Float32Array(count * 3), gloss = new Float32Array(count);
  const base = linear(look.base), trim = linear(look.trim ?? look.base);
  for (let i = 0; i < count; ++i) {
    const tint = mesh.paint[3 * i]!, light = mesh.paint[3 * i + 1]!;
    if (look.paint === "corners") {
      colors.set(linear([mesh.uvs[2 * i]!, mesh.uvs[2 * i + 1]!, light]), 3 * i);
      continue;
    }
    for (let c = 0; c < 3; ++c) colors[3 * i + c] = (trim[c]! + (base[c]! - trim[c]!) * tint) * light;
    gloss[i] = mesh.paint[3 * i + 2]!;
  }
  if (shared !== undefined) {
    for (const [name, attribute] of Object.entries(shared.attributes)) geometry.setAttribute(name, attribute);
    geometry.setIndex(shared.index);
  } else {
    geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(mesh.normals, 3));
    geometry.setAttribute("uv", new BufferAttribute(mesh.uvs.map((value) => value * look.repeats), 2));
    geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  }
  geometry.setAttribute("color", new BufferAttribute(colors, 3));
  geometry.setAttribute("gloss", new BufferAttribute(gloss, 1));
  geometry.computeBoundingSphere();
  return geometry;
}

/** Vertices may be glossier than their material: visors, metal. */
function addGloss(shader: WebGLProgramParametersWithUniforms): void {
  shader.vertexShader = shader.vertexShader
    .replace("#include <common>", "#include <common>\nattribute float gloss;\nvarying float vGloss;")
    .replace("#include <begin_vertex>", "#include <begin_vertex>\nvGloss = gloss;");
  shader.fragmentShader = shader.fragmentShader
    .replace("#include <common>", "#include <common>\nvarying float vGloss;")
    .replace("#include <roughnessmap_fragment>", "#include <roughnessmap_fragment>\nroughnessFactor = clamp(roughnessFactor - 0.62 * vGloss, 0.16, 1.0);");
}

/**
 * Colours of instances: base colour and roughness, second colour and glow, layer of the paint and its repetitions. A corner
 * has a mix of the two colours, a factor of the colour, and gloss.
 */
const INKS = /* glsl */ `
attribute vec3 paint;
attribute vec4 baseInk;
attribute vec4 trimInk;
attribute vec2 paintInk;
varying vec4 vInk;
varying vec2 vPaintUv;
flat varying vec4 vGlowLayer;
`;
const INKS_FOR_CORNER = /* glsl */ `
vInk = vec4(mix(trimInk.rgb, baseInk.rgb, paint.x) * paint.y, baseInk.a - 0.62 * paint.z);
vPaintUv = uv * paintInk.y;
vGlowLayer = vec4(baseInk.rgb * trimInk.a, paintInk.x);
`;
const INKS_FOR_PIXEL = /* glsl */ `
diffuseColor.rgb *= vInk.rgb;
if (vGlowLayer.a >= 0.0) diffuseColor.rgb *= texture(paints, vec3(vPaintUv, vGlowLayer.a)).rgb;
`;

function addInks(shader: WebGLProgramParametersWithUniforms, paints: DataArrayTexture): void {
  shader.uniforms["paints"] = { value: paints };
  shader.vertexShader = shader.vertexShader.replace("#include <common>", `#include <common>\n${INKS}`).replace("#include <begin_vertex>", `#include <begin_vertex>\n${INKS_FOR_CORNER}`);
  shader.fragmentShader = shader.fragmentShader
    .replace("#include <common>", "#include <common>\nuniform mediump sampler2DArray paints;\nvarying vec4 vInk;\nvarying vec2 vPaintUv;\nflat varying vec4 vGlowLayer;")
    .replace("#include <color_fragment>", INKS_FOR_PIXEL)
    .replace("#include <roughnessmap_fragment>", "float roughnessFactor = clamp(vInk.a, 0.16, 1.0);")
    .replace("#include <emissivemap_fragment>", "totalEmissiveRadiance += vGlowLayer.rgb;");
}

/** Grass, soil, worn tracks, pale and dark tiles, and lines every metre and every ten metres: as in the window. */
const GROUND_COLOUR = /* glsl */ `
vec3 facing = abs(normalize(vWorldNormal));
vec2 place = facing.y > 0.55 ? vWorldPlace.xz : facing.x > facing.z ? vWorldPlace.zy : vWorldPlace.xy;
vec3 broader = texture2D(grain, place.yx * 0.0061 + 0.11).rgb;
float grains = 0.45 * texture2D(grain, place * 0.31).r + 0.30 * texture2D(grain, place * 0.023 + 0.37).g + 0.25 * broader.b;
vec2 pixel = max(fwidth(place), vec2(1e-5));
vec2 tiles = clamp((abs(fract(place * 0.05) - 0.5) - 0.25) / (pixel * 0.1), -0.5, 0.5);
float checker = 4.0 * tiles.x * tiles.y * (1.0 - smoothstep(3.0, 10.0, max(pixel.x, pixel.y)));
vec3 ground = baseColour * (0.74 + 0.52 * grains) * (1.0 + 0.045 * checker);
ground = mix(ground, ground * vec3(0.88, 1.02, 0.84), smoothstep(0.42, 0.68, broader.r) * 0.7);
float isFloor = growth * step(0.55, facing.y) * (1.0 - smoothstep(0.04, 0.08, abs(vWorldPlace.y)));
float along = abs(place.y - 15.0 - 6.0 * sin(place.x * 0.045) - 2.0 * sin(place.x * 0.13 + 1.3));
float across = abs(place.x + 19.0 - 5.0 * sin(place.y * 0.05 + 0.7) - 1.5 * sin(place.y * 0.17));
float track = 1.0 - smoothstep(0.75, 1.35, min(along, across) + 1.3 * (broader.g - 0.5));
vec3 grass = mix(grassColour, grassColour * vec3(1.22, 1.06, 1.02), smoothstep(0.45, 0.75, broader.b)) * (0.72 + 0.56 * grains);
vec3 soil = baseColour * vec3(0.98, 0.88, 0.70) * (0.80 + 0.40 * grains);
ground = mix(ground, mix(grass, soil, track), isFloor);
float lines = max(gridLine(place, pixel, 1.0, 0.03) * 0.20, gridLine(place, pixel, 10.0, 0.09) * 0.46);
ground *= 1.0 - lines * mix(0.55, 0.38, isFloor);
diffuseColor.rgb = pow(ground, vec3(2.2));
`;
const GROUND_COMMON = /* glsl */ `
varying vec3 vWorldPlace;
varying vec3 vWorldNormal;
uniform sampler2D grain;
uniform vec3 baseColour;
uniform vec3 grassColour;
uniform float growth;
float gridLine(vec2 place, vec2 pixel, float step_m, float width_m) {
  vec2 blur = pixel / step_m, half_width = vec2(0.5 * width_m / step_m), away = abs(fract(place / step_m - 0.5) - 0.5);
  vec2 line = clamp((half_width + blur - away) / blur, 0.0, 1.0) * clamp(2.0 * half_width / blur + 0.15, 0.0, 1.0);
  vec2 faded = line * (1.0 - smoothstep(0.25, 0.6, blur));
  return max(faded.x, faded.y);
}
`;

function addGround(shader: WebGLProgramParametersWithUniforms, look: Look): void {
  Object.assign(shader.uniforms, {
    grain: { value: grainTexture() }, baseColour: { value: [...look.base] }, grassColour: { value: [...(look.trim ?? [0, 0, 0])] }, growth: { value: look.trim === null ? 0 : 1 },
  });
  shader.vertexShader = shader.vertexShader
    .replace("#include <common>", "#include <common>\nvarying vec3 vWorldPlace;\nvarying vec3 vWorldNormal;")
    .replace("#include <begin_vertex>", `#include <begin_vertex>
vec4 placed = vec4(position, 1.0);
vec3 faced = normal;
#ifdef USE_INSTANCING
placed = instanceMatrix * placed;
faced = mat3(instanceMatrix) * faced;
#endif
vWorldPlace = (modelMatrix * placed).xyz;
vWorldNormal = normalize(mat3(modelMatrix) * faced);`);
  shader.fragmentShader = shader.fragmentShader
    .replace("#include <common>", `#include <common>\n${GROUND_COMMON}`)
    .replace("#include <color_fragment>", GROUND_COLOUR);
}

/** The ground as a single texture: cheaper to draw, but coarser. */
function addPlain(shader: WebGLProgramParametersWithUniforms, look: Look): void {
  shader.uniforms["plain"] = { value: sampleCoarsely(plainTexture(look.base, look.trim, PLAIN_SIDE_M)) };
  shader.vertexShader = shader.vertexShader
    .replace("#include <common>", "#include <common>\nvarying vec2 vOnPlain;")
    .replace("#include <begin_vertex>", `#include <begin_vertex>
vec4 placed = vec4(position, 1.0);
#ifdef USE_INSTANCING
placed = instanceMatrix * placed;
#endif
vOnPlain = (modelMatrix * placed).xz / ${PLAIN_SIDE_M.toFixed(1)} + 0.5;`);
  shader.fragmentShader = shader.fragmentShader
    .replace("#include <common>", "#include <common>\nvarying vec2 vOnPlain;\nuniform sampler2D plain;")
    .replace("#include <color_fragment>", "diffuseColor.rgb = texture2D(plain, vOnPlain).rgb;");
}

/** The materials of looks. Each is created once. */
export class Materials {
  private readonly made = new Map<string, Material>();
  /** Uses cheaper light, because the processor draws. */
  isSlow = false;

  named(name: string): Material {
    return this.of(name, lookOf(name));
  }

  /** The material of instances that have their own colours. */
  inked(opacity: number): Material {
    const name = `inked|${opacity}`, known = this.made.get(name);
    if (known !== undefined) return known;
    const settings = { transparent: opacity < 1, opacity, depthWrite: opacity >= 1 }, paints = this.isSlow ? sampleCoarsely(paintLayers()) : paintLayers();
    const material = this.isSlow ? new MeshLambertMaterial(settings) : new MeshStandardMaterial({ ...settings, metalness: 0 });
    material.onBeforeCompile = (shader) => addInks(shader, paints);
    material.customProgramCacheKey = () => "inked";
    this.made.set(name, material);
    return material;
  }

  of(name: string, look: Look): Material {
    const known = this.made.get(name);
    if (known !== undefined) return known;
    const texture = paintTexture(look.paint);
    if (texture !== null && this.isSlow) sampleCoarsely(texture);
    const common = {
      vertexColors: look.paint !== "ground", map: texture, transparent: look.opacity < 1, opacity: look.opacity, depthWrite: look.opacity >= 1,
    };
    let material: MeshLambertMaterial | MeshStandardMaterial;
    if (this.isSlow || look.paint === "ground") {
      material = new MeshLambertMaterial(common);
    } else {
      material = new MeshStandardMaterial({ ...common, roughness: Math.min(1, Math.max(0.2, 0.95 - 0.75 * look.gloss)), metalness: 0 });
      material.onBeforeCompile = addGloss;
    }
    if (look.glow > 0) {
      material.emissive = new Color().setRGB(look.base[0], look.base[1], look.base[2], SRGBColorSpace);
      material.emissiveIntensity = 0.5 * look.glow;
    }
    if (look.paint === "ground" && this.isSlow) {
      material.onBeforeCompile = (shader) => addPlain(shader, look);
      material.customProgramCacheKey = () => "plain";
    } else if (look.paint === "ground") {
      material.onBeforeCompile = (shader) => addGround(shader, look);
      material.customProgramCacheKey = () => "ground";
    }
    this.made.set(name, material);
    return material;
  }

  dispose(): void {
    for (const material of this.made.values()) material.dispose();
    this.made.clear();
  }
}
