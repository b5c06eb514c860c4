// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform mat4 world;
uniform mat4 view_projection;
uniform mat4 shadow_near_matrix;
uniform mat4 shadow_far_matrix;

in vec4 vertex;
in vec3 normal;
in vec2 uv0;
in vec4 colour;

out vec3 world_position;
out vec3 world_normal;
out vec2 texture_place;
out vec4 paint_values;
out vec4 shadow_place_near;
out vec4 shadow_place_far;

void main()
{
    vec4 place = world * vec4(vertex.xyz, 1.0);
    // Normals under uneven scales want the cofactors of the matrix.
    mat3 m = mat3(world);
    mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    world_position = place.xyz;
    world_normal = cofactors * normal;
    texture_place = uv0;
    paint_values = colour;
    vec4 lifted = vec4(place.xyz + normalize(world_normal) * 0.03, 1.0);
    shadow_place_near = shadow_near_matrix * lifted;
    shadow_place_far = shadow_far_matrix * lifted;
    gl_Position = view_projection * place;
}
