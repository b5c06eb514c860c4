// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform mat4 world_view_projection;
in vec4 vertex;
in vec2 uv0;
in vec4 colour;
out vec2 texture_place;
out vec4 tint;

void main()
{
    texture_place = uv0;
    tint = colour;
    gl_Position = world_view_projection * vec4(vertex.xy, 0.0, 1.0);
}
