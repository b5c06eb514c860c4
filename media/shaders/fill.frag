// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

in vec4 fill_colour;
out vec4 fragment;

void main() { fragment = fill_colour; }
