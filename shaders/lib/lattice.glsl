// SPDX-License-Identifier: Apache-2.0
// The lattice of points over a triangle: see interop/light_cache.h. Rows of constant j, one after the other.
#ifndef UTSURI_LIB_LATTICE
#define UTSURI_LIB_LATTICE

/// Points of rows 0 to j - 1.
uint lattice_row(uint edge, uint j) {
    return j * (edge + 1u) - (j * j - j) / 2u;
}

/// Number (i, j) of a point within its triangle.
uvec2 lattice_point(uint edge, uint index) {
    // Root of lattice_row(edge, j) = index; float32 may miss the row by one, where the counts are large.
    float a = float(edge) + 1.5;
    uint j = uint(max(a - sqrt(max(a * a - 2.0 * float(index), 0.0)), 0.0));
    while (j > 0u && lattice_row(edge, j) > index) --j;
    while (lattice_row(edge, j + 1u) <= index) ++j;
    return uvec2(index - lattice_row(edge, j), j);
}

/// The three points around a position on the triangle, and their weights in linear interpolation.
struct LatticeCell {
    uvec3 points;
    vec3 weights;
};

LatticeCell lattice_cell(uint edge, float b1, float b2) {
    vec2 position = clamp(vec2(b1, b2), 0.0, 1.0) * float(edge);
    uint i = min(uint(position.x), edge - 1u);
    uint j = min(uint(position.y), edge - 1u - i);
    vec2 f = position - vec2(i, j);
    uint near = lattice_row(edge, j) + i;
    uint far = near + edge + 1u - j;  // (i, j + 1)
    // The cell's upper half, but for the last of a row, which has none.
    if (f.x + f.y > 1.0 && i + j + 1u < edge) return LatticeCell(uvec3(near + 1u, far, far + 1u), vec3(1.0 - f.y, 1.0 - f.x, f.x + f.y - 1.0));
    return LatticeCell(uvec3(near, near + 1u, far), vec3(1.0 - f.x - f.y, f.x, f.y));
}

#endif
