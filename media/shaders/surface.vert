// SPDX-License-Identifier: BSD-2-Clause
#version 330 core
#include "place.glsl"

uniform mat4 view_projection;
uniform mat4 shadow_near_matrix;
uniform mat4 shadow_far_matrix;
uniform vec4 paint_trim;

in vec3 normal;
in vec2 uv0;
in vec4 colour;

out vec3 world_position;
out vec3 world_normal;
out vec2 texture_place;
out vec4 paint_values;
out vec4 shadow_place_near;
out vec4 shadow_place_far;
flat out vec3 trim;

void main()
{
    mat3x4 rows = Rows();
    world_position = vec4(vertex.xyz, 1.0) * rows;
    // Normals under uneven scales want the cofactors of the matrix.
    vec3 a = rows[0].xyz, b = rows[1].xyz, c = rows[2].xyz;
    world_normal = vec3(dot(cross(b, c), normal), dot(cross(c, a), normal), dot(cross(a, b), normal));
    texture_place = uv0;
    paint_values = colour;
#ifdef BY_BONES
    trim = uv1.rgb;
#else
    trim = paint_trim.rgb;
#endif
    vec4 lifted = vec4(world_position + normalize(world_normal) * 0.03, 1.0);
    shadow_place_near = shadow_near_matrix * lifted;
    shadow_place_far = shadow_far_matrix * lifted;
    gl_Position = view_projection * vec4(world_position, 1.0);
}
