// SPDX-License-Identifier: BSD-2-Clause
#version 330 core
#include "place.glsl"

uniform mat4 view_projection;

void main() { gl_Position = view_projection * vec4(vec4(vertex.xyz, 1.0) * Rows(), 1.0); }
