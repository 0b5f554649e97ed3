# SPDX-License-Identifier: Apache-2.0
"""What pictures of gltf_scene.mesh_document() must show, in closed form.

The square has glTF's default material: GGX metal of roughness 1 and reflectance 1. There D = 1/pi and Smith's joint
visibility is 1 / (2 (cos_i + cos_o)), whatever the directions (Walter et al. 2007; Heitz 2014).
"""
import math

EYE, LIGHT, INTENSITY, FIELD = (0.0, 0.0, 3.0), (1.0, 1.0, 3.0), 100.0, 0.9
# Directional albedo of GGX with an alpha of 1 at cosines of 1 and 0.5, between which it only rises (references.md A3.4).
LEAST_ALBEDO, MOST_ALBEDO = 0.306853, 0.450694
# Of the table of albedos, between its entries: see glossy_maps_test.cpp.
TABLE = 5e-3
# Places along an edge of a pixel at which its footprint is looked at.
STEPS = 5


def highlight(x, y):
    """Radiance of the square at (x, y, 0) by the point light."""
    def cosine_and_square(place):
        square = (place[0] - x) ** 2 + (place[1] - y) ** 2 + place[2] ** 2
        return place[2] / math.sqrt(square), square
    cos_o, _ = cosine_and_square(EYE)
    cos_i, square = cosine_and_square(LIGHT)
    return INTENSITY / square * cos_i / (2.0 * math.pi * (cos_i + cos_o))


def footprint(column, row, width, height):
    """Places of the plane z = 0 that a pixel shows, its corners among them."""
    scale = 2.0 * EYE[2] * math.tan(0.5 * FIELD) / height
    shares = [i / (STEPS - 1) for i in range(STEPS)]
    return [((column + i - 0.5 * width) * scale, (0.5 * height - row - j) * scale) for i in shares for j in shares]


def cover(places):
    """Share of the places that the square covers: 0 and 1 hold for the whole pixel, as both are convex."""
    return sum(max(abs(x), abs(y)) <= 1.0 for x, y in places) / len(places)


def lit_bounds(places):
    """Least and most radiance of a pixel by the point light, in darkness."""
    values = [highlight(x, y) for x, y in places]
    # Between places that are a quarter of a pixel apart there is at most a quarter of what they differ by, and rounding.
    slack = (max(values) - min(values)) / (STEPS - 1) + 1e-5 * max(values)
    covered = cover(places)
    if covered == 0.0:
        return 0.0, 0.0
    return (min(values) - slack if covered == 1.0 else 0.0), max(values) + slack


def furnace_bounds(places):
    """Least and most radiance of a pixel in a uniform environment of 1, but for the noise of traced ones."""
    covered = cover(places)
    if covered == 0.0:
        return 1.0, 1.0
    return LEAST_ALBEDO - TABLE, (MOST_ALBEDO + TABLE if covered == 1.0 else 1.0)
