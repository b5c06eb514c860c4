// SPDX-License-Identifier: BSD-2-Clause
#version 330 core
#include "scene.glsl"

uniform vec4 base_colour;
uniform vec4 finish;       // x: gloss, y: glow, z: texture repeats per unit of uv, w: spare.
flat in vec3 trim;         // The colour where paint has none of its own.

void main()
{
    vec4 texel = texture(paint, texture_place * finish.z);
    vec3 normal = normalize(world_normal);
    vec3 albedo = ToLinear(mix(trim, base_colour.rgb * texel.rgb, paint_values.r)) * paint_values.g;
    float gloss = clamp(finish.x + paint_values.b, 0.0, 1.0);
    vec3 light = Shade(albedo, normal, gloss, paint_values.g);
    light += albedo * finish.y;
    fragment = vec4(ToScreen(light), base_colour.a * texel.a);
}
