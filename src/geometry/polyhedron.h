// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interop/reflection.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace utsuri {

/// A convex polyhedron about a capture point: the intersection of half spaces dot(plane.normal, x) <=
/// distance.
struct Polyhedron {
    struct Plane {
        glm::dvec3 normal;      ///< unit
        double distance = 1.0;  ///< > 0
    };

    std::string name;
    std::vector<Plane> planes;
};

/// The cube, in the order of interop::CUBE_FACES.
Polyhedron cube();

/// A Platonic solid by name: tetrahedron, cube, octahedron, dodecahedron or icosahedron.
/// @throws UsageError that lists the names
Polyhedron platonic_solid(std::string_view name);

/// Planes from a text file: four numbers a line, normal x, y, z (any length) and distance; # begins a
/// comment.
/// @throws InputError that names the line if it is malformed, or the file if the planes do not bound a
/// polyhedron about the origin that every plane touches, or are more than interop::MAP_MOST_FACES
Polyhedron read_polyhedron(const std::filesystem::path& path);

/// The picture of a face: its point (x, y) in [-1, 1]^2 lies at centre + x right + y up on the face's plane.
struct FacePicture {
    glm::dvec3 centre;
    glm::dvec3 right;
    glm::dvec3 up;
};

/// The smallest rectangle that holds a face, along the axes where the face allows.
FacePicture face_picture(const Polyhedron& polyhedron, std::size_t face);

/// A face as the device addresses it.
interop::MapFace map_face(const Polyhedron& polyhedron, std::size_t face);

/// Corners of a face in order around it; empty if the plane does not touch the polyhedron, or if the face has
/// no bounds.
std::vector<glm::dvec3> face_corners(const Polyhedron& polyhedron, std::size_t face);

/// The first plane that bounds no face: the planes leave its side open, it does not touch what they enclose,
/// or it is there twice. None if all bound one: then they enclose the origin.
std::optional<std::size_t> plane_without_face(const Polyhedron& polyhedron);

}  // namespace utsuri
