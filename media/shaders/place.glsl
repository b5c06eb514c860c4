// SPDX-License-Identifier: BSD-2-Clause
// Where a vertex stands in the world: of one thing by its matrix, of many things at once by a matrix of each, or of a
// body by its bones.

in vec4 vertex;

#if defined(BY_BONES)
uniform sampler2D bones;  // For each bone three rows of the matrix that takes a vertex into the world, 1024 in a line.
in vec4 blendIndices;     // Of the vertex: two bones and the share of the first, all in 255ths.
in vec4 uv1;              // Of the body: the colour of its trim, and the place of its first row.

vec4 RowOf(float bone, int row)
{
    int at = int(uv1.w + 0.5) + 3 * int(bone * 255.0 + 0.5) + row;
    return texelFetch(bones, ivec2(at & 1023, at >> 10), 0);
}

mat3x4 Rows()
{
    float share = blendIndices.z;
    mat3x4 rows = mat3x4(RowOf(blendIndices.x, 0), RowOf(blendIndices.x, 1), RowOf(blendIndices.x, 2));
    if (share < 1.0) {
        mat3x4 other = mat3x4(RowOf(blendIndices.y, 0), RowOf(blendIndices.y, 1), RowOf(blendIndices.y, 2));
        rows = rows * share + other * (1.0 - share);
    }
    return rows;
}
#elif defined(BY_THING)
in vec4 uv1;  // Three rows of the thing's matrix.
in vec4 uv2;
in vec4 uv3;

mat3x4 Rows() { return mat3x4(uv1, uv2, uv3); }
#else
uniform mat4 world;

mat3x4 Rows()
{
    mat4 turned = transpose(world);
    return mat3x4(turned[0], turned[1], turned[2]);
}
#endif
