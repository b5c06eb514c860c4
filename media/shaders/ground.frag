// SPDX-License-Identifier: BSD-2-Clause
#version 330 core
#include "scene.glsl"

uniform vec4 base_colour;
uniform vec4 trim_colour;  // Of the grass on it; clear: none grows there.
uniform vec4 finish;

// How much of a pixel a line at every multiple of `step_m` covers, without shimmer in the distance. `pixel_m`: what a
// pixel covers of the ground.
float GridLine(vec2 place, vec2 pixel_m, float step_m, float width_m)
{
    vec2 scaled = place / step_m;
    vec2 blur = pixel_m / step_m;
    vec2 half_width = vec2(0.5 * width_m / step_m);
    vec2 away = abs(fract(scaled - 0.5) - 0.5);
    vec2 line = clamp((half_width + blur - away) / blur, 0.0, 1.0);
    line *= clamp(2.0 * half_width / blur + 0.15, 0.0, 1.0);
    vec2 faded = line * (1.0 - smoothstep(0.25, 0.6, blur));
    return max(faded.x, faded.y);
}

void main()
{
    // Upright faces take the plane that they stand in, so that nothing is smeared down their sides.
    vec3 facing = abs(normalize(world_normal));
    vec2 place = facing.y > 0.55 ? world_position.xz : facing.x > facing.z ? world_position.zy : world_position.xy;
    vec3 broader = texture(paint, place.yx * 0.0061 + 0.11).rgb;
#ifdef LOW_DETAIL
    float grain = 0.45 * broader.g + 0.25 * broader.b + 0.15;
#else
    vec3 fine = texture(paint, place * 0.31).rgb;
    vec3 broad = texture(paint, place * 0.023 + 0.37).rgb;
    float grain = 0.45 * fine.r + 0.30 * broad.g + 0.25 * broader.b;
#endif

    // Pale and darker tiles of ten metres, hardly apart.
    vec2 pixel_m = max(fwidth(place), vec2(1e-5));
    vec2 tile_place = place / 10.0;
    vec2 tile_blur = pixel_m / 10.0;
    vec2 tile = clamp((abs(fract(tile_place * 0.5) - 0.5) - 0.25) / tile_blur, -0.5, 0.5);
    float checker = 4.0 * tile.x * tile.y * (1.0 - smoothstep(0.3, 1.0, max(tile_blur.x, tile_blur.y)));

    vec3 colour = base_colour.rgb * (0.74 + 0.52 * grain) * (1.0 + 0.045 * checker);
    colour = mix(colour, colour * vec3(0.88, 1.02, 0.84), smoothstep(0.42, 0.68, broader.r) * 0.7);

    // Where it is the floor of the world, grass grows, but not on the tracks that people have worn.
    float floor_share = trim_colour.a * step(0.55, facing.y) * (1.0 - smoothstep(0.04, 0.08, abs(world_position.y)));
    float wobble = 1.3 * (broader.g - 0.5);
    float along = abs(place.y - 15.0 - 6.0 * sin(place.x * 0.045) - 2.0 * sin(place.x * 0.13 + 1.3));
    float across = abs(place.x + 19.0 - 5.0 * sin(place.y * 0.05 + 0.7) - 1.5 * sin(place.y * 0.17));
    float track = 1.0 - smoothstep(0.75, 1.35, min(along, across) + wobble);
    float dry = smoothstep(0.45, 0.75, broader.b);
    vec3 grass = mix(trim_colour.rgb, trim_colour.rgb * vec3(1.22, 1.06, 1.02), dry) * (0.72 + 0.56 * grain);
    vec3 soil = base_colour.rgb * vec3(0.98, 0.88, 0.70) * (0.80 + 0.40 * grain);
    colour = mix(colour, mix(grass, soil, track), floor_share);

    float fine_line = GridLine(place, pixel_m, 1.0, 0.03) * 0.20;
    float strong_line = GridLine(place, pixel_m, 10.0, 0.09) * 0.46;
    colour *= 1.0 - max(fine_line, strong_line) * mix(0.55, 0.38, floor_share);

#ifdef LOW_DETAIL
    vec3 light = ShadeDull(ToLinear(colour), normalize(world_normal));
#else
    vec3 light = Shade(ToLinear(colour), normalize(world_normal), 0.05, 1.0);
#endif
    fragment = vec4(ToScreen(light), 1.0);
}
