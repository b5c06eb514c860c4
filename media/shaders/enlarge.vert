// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform mat4 world_view_projection;  // Turns it over for pictures that are drawn into textures.
in vec4 vertex;
in vec2 uv0;
out vec2 texture_place;

void main()
{
    texture_place = uv0;
    gl_Position = world_view_projection * vec4(vertex.xy, 0.0, 1.0);
}
