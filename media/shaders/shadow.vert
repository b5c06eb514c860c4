// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform mat4 world_view_projection;
in vec4 vertex;

void main() { gl_Position = world_view_projection * vec4(vertex.xyz, 1.0); }
