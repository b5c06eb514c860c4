// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform mat4 view_projection;
in vec4 vertex;
in vec4 colour;
out vec4 fill_colour;

void main()
{
    fill_colour = colour;
    gl_Position = view_projection * vec4(vertex.xyz, 1.0);
    gl_Position.z -= 0.0002 * gl_Position.w;
}
