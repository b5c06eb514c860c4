// SPDX-License-Identifier: BSD-2-Clause
#version 330 core
#include "scene.glsl"

uniform vec4 base_colour;
uniform vec4 finish;       // x: gloss, y: glow, z: texture repeats per unit of uv, w: 1 if corners bring their colour.
flat in vec3 trim;         // The colour where paint has none of its own.

void main()
{
    vec4 texel = texture(paint, texture_place * finish.z);
    vec3 normal = normalize(world_normal);
    vec3 albedo = ToLinear(mix(trim, base_colour.rgb * texel.rgb, paint_values.r)) * paint_values.g;
    float light_share = paint_values.g;
    if (finish.w > 0.5) {
        albedo = ToLinear(vec3(texture_place, paint_values.g));
        light_share = 1.0;
    }
    float gloss = clamp(finish.x + paint_values.b, 0.0, 1.0);
    vec3 light = Shade(albedo, normal, gloss, light_share);
    light += albedo * finish.y;
    fragment = vec4(ToScreen(light), base_colour.a * texel.a);
}
