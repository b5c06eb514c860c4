// SPDX-License-Identifier: BSD-2-Clause
#version 330 core
// A figure that is not there: clear in the middle, bright along its outline, with faint bands.
uniform vec4 base_colour;
uniform vec4 camera_place;
in vec3 world_position;
in vec3 world_normal;
out vec4 fragment;

void main()
{
    vec3 view = normalize(camera_place.xyz - world_position);
    float rim = 1.0 - abs(dot(normalize(world_normal), view));
    float band = 0.85 + 0.15 * sin(world_position.y * 40.0);
    float strength = mix(0.42, 1.0, rim * rim) * band;
    fragment = vec4(mix(base_colour.rgb, vec3(1.0), 0.35 * rim * rim), base_colour.a * strength);
}
