// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform mat4 world_view_projection;
in vec4 vertex;
out vec3 direction;

void main()
{
    direction = vertex.xyz;
    // As far away as can be: drawn after what is in front of it, so that only what shows is painted.
    gl_Position = (world_view_projection * vec4(vertex.xyz, 1.0)).xyww;
}
