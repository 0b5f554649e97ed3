// SPDX-License-Identifier: Apache-2.0
// The rows of points over a triangle: see interop/light_cache.h.
#ifndef UTSURI_LIB_LATTICE
#define UTSURI_LIB_LATTICE

#include "interop/light_cache.h"

/// Points of the rows before row j.
uint lattice_row(LightCacheTriangle lattice, uint j) {
    uint step = j / lattice.rows_per_interval;
    uint before = step * (lattice.intervals + 1u) - (step * step - step) / 2u;
    return lattice.rows_per_interval * before +
           (j - step * lattice.rows_per_interval) * (lattice.intervals - step + 1u);
}

uint lattice_intervals(LightCacheTriangle lattice, uint j) {
    return lattice.intervals - j / lattice.rows_per_interval;
}

/// Barycentric coordinates (b0, b1, b2) of a position along a row and of the row's share of the way to the apex.
vec3 lattice_barycentric(LightCacheTriangle lattice, float along, float towards_apex) {
    vec3 b = vec3((1.0 - along) * (1.0 - towards_apex), along * (1.0 - towards_apex), towards_apex);
    return lattice.apex == 2u ? b : (lattice.apex == 0u ? b.zxy : b.yzx);
}

/// Barycentric coordinates of a point by its number within the triangle.
vec3 lattice_point(LightCacheTriangle lattice, uint index) {
    uint rows = lattice.intervals * lattice.rows_per_interval;
    // The row, by bisection.
    uint j = 0u;
    for (uint span = rows + 1u; span > 1u;) {
        uint half_span = span / 2u;
        if (lattice_row(lattice, j + half_span) <= index) {
            j += half_span;
            span -= half_span;
        } else {
            span = half_span;
        }
    }
    uint intervals = lattice_intervals(lattice, j);
    float along = intervals > 0u ? float(index - lattice_row(lattice, j)) / float(intervals) : 0.0;
    return lattice_barycentric(lattice, along, float(j) / float(rows));
}

/// The points around a position on the triangle, two in each of two rows, and their weights in linear interpolation.
struct LatticeCell {
    uvec4 points;
    vec4 weights;
};

LatticeCell lattice_cell(LightCacheTriangle lattice, vec3 b) {
    b = lattice.apex == 2u ? b : (lattice.apex == 0u ? b.yzx : b.zxy);
    uint rows = lattice.intervals * lattice.rows_per_interval;
    float row = clamp(b.z, 0.0, 1.0) * float(rows);
    uint j = min(uint(row), rows - 1u);
    float base = b.x + b.y;
    float along = base > 0.0 ? clamp(b.y / base, 0.0, 1.0) : 0.0;
    vec2 position = along * vec2(lattice_intervals(lattice, j), lattice_intervals(lattice, j + 1u));
    uvec2 last = uvec2(lattice_intervals(lattice, j), lattice_intervals(lattice, j + 1u));
    uvec2 i = min(uvec2(position), max(last, uvec2(1u)) - 1u);
    vec2 f = position - vec2(i);
    uvec2 first = uvec2(lattice_row(lattice, j), lattice_row(lattice, j + 1u)) + i;
    // The apex is a row of one point.
    uvec2 second = min(first + 1u, first + last);
    float g = row - float(j);
    return LatticeCell(uvec4(first.x, second.x, first.y, second.y),
                       vec4((1.0 - f.x) * (1.0 - g), f.x * (1.0 - g), (1.0 - f.y) * g, f.y * g));
}

#endif
