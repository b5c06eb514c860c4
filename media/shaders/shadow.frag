// SPDX-License-Identifier: BSD-2-Clause
#version 330 core

out vec4 fragment;
void main() { fragment = vec4(1.0); }
