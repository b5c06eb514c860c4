// SPDX-License-Identifier: BSD-2-Clause
#version 330 core
// A line is four corners; each knows its own end, the other end and its side, and moves sideways by half the width.

uniform mat4 view_projection;
uniform vec4 viewport;     // Width and height in pixels.
uniform vec4 width_px;
uniform vec4 line_scale;      // x: pixels of the picture that is drawn for each that is shown.

in vec4 vertex;            // This end, w unused.
in vec3 normal;            // The other end.
in vec2 uv0;               // x: side, -1 or 1; y: 1 at the line's end, 0 at its start.
in vec4 colour;

out vec4 line_colour;
out float side;

void main()
{
    vec4 here = view_projection * vec4(vertex.xyz, 1.0);
    vec4 there = view_projection * vec4(normal, 1.0);
    // An end behind the eye is drawn back to the near side.
    const float kNear = 0.05;
    if (here.w < kNear && there.w > kNear) here = mix(here, there, (kNear - here.w) / (there.w - here.w));
    if (there.w < kNear && here.w > kNear) there = mix(there, here, (kNear - there.w) / (here.w - there.w));
    vec2 a = here.xy / here.w * viewport.xy, b = there.xy / there.w * viewport.xy;
    vec2 along = b - a;
    float long_enough = length(along);
    along = long_enough > 1e-4 ? along / long_enough : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x) * uv0.x * (uv0.y > 0.5 ? -1.0 : 1.0);
    side = uv0.x;
    line_colour = colour;
    here.xy += (across - along * 0.3) * (width_px.x * line_scale.x + 1.0) / viewport.xy * here.w;
    here.z -= 0.0004 * here.w;
    gl_Position = here;
}
