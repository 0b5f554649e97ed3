// SPDX-License-Identifier: Apache-2.0
// How fast the normals of a polygon turn, for stages that predict errors.

layout(location = 10) DRAWN_FLAT float drawn_curvature;  // radians a metre, least of the edges; on the front, > 0 where convex
