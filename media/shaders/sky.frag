// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform vec4 sun_direction;
uniform vec4 sun_colour;
uniform mat4 sky_turn;
uniform samplerCube sky;

in vec3 direction;
out vec4 fragment;

void main()
{
    vec3 towards = normalize(direction);
    vec3 colour = texture(sky, mat3(sky_turn) * towards * vec3(1.0, 1.0, -1.0)).rgb;
    // The sun, its glow through the clouds, and its glitter on the water.
    vec3 mirrored = vec3(towards.x, abs(towards.y), towards.z);
    float near = max(dot(mirrored, sun_direction.xyz), 0.0);
    vec3 tone = sun_colour.rgb / max(max(sun_colour.r, max(sun_colour.g, sun_colour.b)), 1e-3);
#ifdef LOW_DETAIL
    float near4 = near * near * near * near, near12 = near4 * near4 * near4;
    float glow = 0.34 * near12 + 0.38 * near12 * near12 * near12 * near12 + 2.0 * smoothstep(0.9993, 0.9997, near);
#else
    float glow = 0.34 * pow(near, 14.0) + 0.38 * pow(near, 160.0) + 2.0 * smoothstep(0.9993, 0.9997, near);
#endif
    float strength = min(1.0, dot(sun_colour.rgb, vec3(0.4)));
    if (towards.y < 0.0) glow = 0.5 * pow(near, 40.0);
    fragment = vec4(colour + tone * glow * strength * (1.0 - 0.5 * colour), 1.0);
}
