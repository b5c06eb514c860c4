// SPDX-License-Identifier: BSD-2-Clause
#version 330 core
// Shows a picture in another size.

uniform sampler2D picture;
in vec2 texture_place;
out vec4 fragment;

void main() { fragment = texture(picture, texture_place); }
