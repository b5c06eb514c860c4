// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

uniform vec4 width_px;
uniform vec4 line_scale;
in vec4 line_colour;
in float side;
out vec4 fragment;

void main()
{
    float half_width = 0.5 * (width_px.x * line_scale.x + 1.0);
    float cover = clamp((1.0 - abs(side)) * half_width, 0.0, 1.0);
    fragment = vec4(line_colour.rgb, line_colour.a * cover);
}
