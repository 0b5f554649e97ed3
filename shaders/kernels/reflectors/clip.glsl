// SPDX-License-Identifier: Apache-2.0
// Cutting a triangle of reflection vectors along the boundaries between the faces of a convex polyhedron of maps. All of
// it happens in unnormalised vectors, where a triangle is flat and a boundary is a plane through the origin.
//
// A face i is given by m_i = n_i / h_i: the ray along d leaves the polyhedron through the face where dot(m_i, d) is
// largest. The corners of the pieces are named by what they are the meeting of, and their coordinates follow from the
// name alone: a corner of the triangle, an edge of it and the boundary of two faces, or the directions where three
// faces meet. Pieces that share a corner, in one triangle or in two neighbours, so agree on it to the bit.
#ifndef UTSURI_KERNELS_REFLECTORS_CLIP
#define UTSURI_KERNELS_REFLECTORS_CLIP

#include "kernels/maps/map_faces.glsl"
#include "lib/numeric.glsl"

/// A triangle to be cut: its corners' positions decide the direction in which an edge is cut.
struct ReflectedTriangle {
    vec3 positions[3];
    vec3 reflections[3];
};

const uint NO_FACE = 0xffu;

/// Names: bits 0-7 and 8-15 and 16-23 are the faces that meet, in ascending order, NO_FACE where there are fewer; bits
/// 24-25 are the corner, or the edge from that corner to the next.
uint corner_name(uint corner) {
    return (corner << 24) | 0xffffffu;
}

uint edge_name(uint edge, uint i, uint j) {
    return (edge << 24) | (NO_FACE << 16) | (max(i, j) << 8) | min(i, j);
}

uint meeting_name(uint i, uint j, uint k) {
    uint least = min(i, min(j, k));
    uint largest = max(i, max(j, k));
    uint middle = i + j + k - least - largest;
    return (largest << 16) | (middle << 8) | least;
}

bool is_before(vec3 a, vec3 b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// How a named corner follows from the triangle's: on an edge by its ends and the share of the way from the one to the
/// other, the same for both triangles that share the edge; else by barycentric coordinates.
struct PieceCornerWeights {
    bool is_on_edge;
    uint from;
    uint to;
    float share;
    vec3 barycentric;
};

PieceCornerWeights edge_weights(ReflectedTriangle triangle, uint edge, uint i, uint j) {
    uint from = edge;
    uint to = (edge + 1u) % 3u;
    if (is_before(triangle.positions[to], triangle.positions[from])) {
        from = to;
        to = edge;
    }
    vec3 m = map_faces[i].outward - map_faces[j].outward;
    float a = dot(m, triangle.reflections[from]);
    float b = dot(m, triangle.reflections[to]);
    float share = a == b ? 0.0 : clamp(a / (a - b), 0.0, 1.0);
    vec3 barycentric = vec3(0.0);
    barycentric[from] = 1.0 - share;
    barycentric[to] = share;
    return PieceCornerWeights(true, from, to, share, barycentric);
}

/// Where the triangle's vectors point at the direction in which three faces meet.
vec3 meeting_barycentric(ReflectedTriangle triangle, uint i, uint j, uint k) {
    vec3 ij = map_faces[i].outward - map_faces[j].outward;
    vec3 ik = map_faces[i].outward - map_faces[k].outward;
    vec3 p = vec3(dot(ij, triangle.reflections[0]), dot(ij, triangle.reflections[1]), dot(ij, triangle.reflections[2]));
    vec3 q = vec3(dot(ik, triangle.reflections[0]), dot(ik, triangle.reflections[1]), dot(ik, triangle.reflections[2]));
    // Only ratios matter; the scale keeps the products in range.
    vec3 both = cross(p * power_of_two_reciprocal(max(max_component(abs(p)), 1e-38)),
                      q * power_of_two_reciprocal(max(max_component(abs(q)), 1e-38)));
    float sum = both.x + both.y + both.z;
    vec3 b = sum != 0.0 ? clamp(both / sum, 0.0, 1.0) : vec3(1.0);
    return b / (b.x + b.y + b.z);
}

PieceCornerWeights corner_weights(ReflectedTriangle triangle, uint name) {
    uint i = name & 0xffu;
    uint j = (name >> 8) & 0xffu;
    uint k = (name >> 16) & 0xffu;
    if (i == NO_FACE) {
        vec3 b = vec3(0.0);
        b[name >> 24] = 1.0;
        return PieceCornerWeights(false, 0u, 0u, 0.0, b);
    }
    if (k == NO_FACE) return edge_weights(triangle, name >> 24, i, j);
    return PieceCornerWeights(false, 0u, 0u, 0.0, meeting_barycentric(triangle, i, j, k));
}

/// A value at a corner of a piece, given at the triangle's corners.
vec3 at_piece_corner(PieceCornerWeights weights, vec3 values[3]) {
    if (weights.is_on_edge) return values[weights.from] + weights.share * (values[weights.to] - values[weights.from]);
    vec3 b = weights.barycentric;
    return b.x * values[0] + b.y * values[1] + b.z * values[2];
}

/// Corners that a triangle cut to one face can have: each other face adds one at most.
const uint MOST_PIECE_CORNERS = 3u + MAP_MOST_FACES;

/// The part of the triangle that one face shows, a convex polygon: the names of its corners, their vectors, and what the
/// side from each corner to the next lies on: an edge of the triangle (0 to 2), or 3 + the face beyond it. Not a struct
/// that functions hand on, because copies of it would cost more than the cutting.
uint part_count;
uint part_names[MOST_PIECE_CORNERS];
vec3 part_reflections[MOST_PIECE_CORNERS];
uint part_sides[MOST_PIECE_CORNERS];

void set_part(uint corner, uint name, vec3 reflection, uint side) {
    part_names[corner] = name;
    part_reflections[corner] = reflection;
    part_sides[corner] = side;
}

/// What a new corner is where the side `side` of the part of `face` is cut by the boundary to face j.
uint cut_name(uint side, uint face, uint j) {
    return side < 3u ? edge_name(side, face, j) : meeting_name(face, side - 3u, j);
}

void reverse_part(uint begin, uint end) {
    for (; begin + 1u < end; ++begin) {
        --end;
        uint name = part_names[begin];
        vec3 reflection = part_reflections[begin];
        uint side = part_sides[begin];
        set_part(begin, part_names[end], part_reflections[end], part_sides[end]);
        set_part(end, name, reflection, side);
    }
}

/// Makes corner `start` the first.
void rotate_part(uint start) {
    if (start == 0u) return;
    reverse_part(0u, start);
    reverse_part(start, part_count);
    reverse_part(0u, part_count);
}

/// Cuts the part along one boundary (Sutherland and Hodgman 1974). A line leaves a convex polygon once and enters it once:
/// the corners in between go, two new ones come. Where more than three faces meet, rounding can put a corner that is on
/// several boundaries on the wrong side of one; the corner farthest outside tells which corners go, and such a one stays.
void cut_part(ReflectedTriangle triangle, uint face, uint j) {
    vec3 towards = map_faces[face].outward - map_faces[j].outward;
    bool keeps_boundary = face < j;  // a vector on it belongs to the face of lower number
    uint outside = 0u;
    uint farthest = 0u;
    float least = INFINITY;
    for (uint c = 0u; c < part_count; ++c) {
        float advantage = dot(towards, part_reflections[c]);
        if (advantage < 0.0 || (advantage == 0.0 && !keeps_boundary)) outside |= 1u << c;
        if (advantage < least) {
            least = advantage;
            farthest = c;
        }
    }
    if (outside == 0u) return;
    // The last corner kept before the gap, and the last corner in the gap.
    uint last = farthest;
    uint gone = 1u;
    do {
        last = last > 0u ? last - 1u : part_count - 1u;
    } while ((outside >> last & 1u) != 0u && ++gone < part_count);
    uint end = farthest;
    for (uint next = (end + 1u) % part_count; gone < part_count && (outside >> next & 1u) != 0u; ++gone) {
        end = next;
        next = (next + 1u) % part_count;
    }
    if (gone >= part_count) {
        part_count = 0u;
        return;
    }
    // Leaving, the polygon goes on along the boundary; coming back, along the side it was on.
    uint leaving = cut_name(part_sides[last], face, j);
    uint side = part_sides[end];
    uint returning = cut_name(side, face, j);
    vec3 leaving_reflection = at_piece_corner(corner_weights(triangle, leaving), triangle.reflections);
    vec3 returning_reflection = at_piece_corner(corner_weights(triangle, returning), triangle.reflections);
    // Turned so that the gap is at the end.
    uint kept = part_count - gone;
    rotate_part((end + 1u) % part_count);
    set_part(kept, leaving, leaving_reflection, 3u + j);
    set_part(kept + 1u, returning, returning_reflection, side);
    part_count = kept + 2u;
}

/// Whether all corners lie beyond one boundary of a face, so that none of the triangle is left there.
bool misses_face(ReflectedTriangle triangle, uint face, uint faces) {
    for (uint j = 0u; j < faces; ++j) {
        vec3 towards = map_faces[face].outward - map_faces[j].outward;
        if (j != face && max_component(vec3(dot(towards, triangle.reflections[0]), dot(towards, triangle.reflections[1]),
                                            dot(towards, triangle.reflections[2]))) < 0.0) {
            return true;
        }
    }
    return false;
}

/// A bit for each face that a part of the triangle may lie on.
uint faces_met(ReflectedTriangle triangle, uint faces) {
    uint met = 0u;
    for (uint face = 0u; face < faces; ++face) met |= misses_face(triangle, face, faces) ? 0u : 1u << face;
    return met;
}

void cut_to_face(ReflectedTriangle triangle, uint face, uint faces) {
    part_count = 3u;
    for (uint corner = 0u; corner < 3u; ++corner) {
        set_part(corner, corner_name(corner), triangle.reflections[corner], corner);
    }
    for (uint j = 0u; j < faces && part_count > 2u; ++j) {
        if (j != face) cut_part(triangle, face, j);
    }
}

#endif
