// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform mat4 world_view_projection;
in vec4 vertex;
out vec3 direction;

void main()
{
    direction = vertex.xyz;
    gl_Position = world_view_projection * vec4(vertex.xyz, 1.0);
}
