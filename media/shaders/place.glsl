// SPDX-License-Identifier: BSD-2-Clause
// Where a vertex stands in the world: of one thing by its matrix, of many things at once by a matrix of each, or of a
// body by its bones.

in vec4 vertex;

#if defined(BY_BONES)
uniform sampler2D bones;  // For each bone three rows of the matrix that takes a vertex into the world, 1024 in a line.
in vec4 blendIndices;     // Of the vertex: four bones, in 255ths.
in vec4 blendWeights;     // Their shares; bones after the last one have the share 0.
in vec4 uv1;              // Of the body: the colour of its trim, and the place of its first row.

vec4 RowOf(float bone, int row)
{
    int at = int(uv1.w + 0.5) + 3 * int(bone * 255.0 + 0.5) + row;
    return texelFetch(bones, ivec2(at & 1023, at >> 10), 0);
}

mat3x4 RowsOf(float bone) { return mat3x4(RowOf(bone, 0), RowOf(bone, 1), RowOf(bone, 2)); }

mat3x4 Rows()
{
    mat3x4 rows = RowsOf(blendIndices.x) * blendWeights.x;
    if (blendWeights.y > 0.0) rows += RowsOf(blendIndices.y) * blendWeights.y;
    if (blendWeights.z > 0.0) rows += RowsOf(blendIndices.z) * blendWeights.z;
    if (blendWeights.w > 0.0) rows += RowsOf(blendIndices.w) * blendWeights.w;
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
