// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform sampler2D paint;
in vec2 texture_place;
in vec4 tint;
out vec4 fragment;

void main() { fragment = tint * texture(paint, texture_place); }
