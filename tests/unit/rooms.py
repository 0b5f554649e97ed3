# SPDX-License-Identifier: Apache-2.0
"""The rooms of src and shaders, low to high, what each is for and which others it may include.

include_rules.py holds the include lines against this, scripts/draw-rooms draws docs/images/rooms.svg from it. A room may
include itself and what is named here, each of which stands above it: so no include runs up. It names what it includes, and
of the low rooms also what it might.
"""
from collections import namedtuple

Room = namedtuple("Room", "name purpose may_include")

SCENE = ["base", "interop", "geometry", "scene"]
CORE = SCENE + ["gpu", "image", "kernels"]
PICTURES = ["base", "image", "geometry", "scene", "gpu", "interop", "image_io"]
REFLECTION = "renderers/reflection/"


def reflection(*names):
    return [REFLECTION + name for name in names]


BELOW_REFLECTION = CORE + ["renderers/device_scene", "renderers/film"]

SOURCE_ROOMS = [
    Room("base", "errors, checks, files, progress, the host's copy of the sampler", []),
    Room("image", "float images, metrics (MSE to FLIP), error maps; no files", ["base"]),
    Room("geometry", "bounds, BVH build and layout, float64 reference intersection, convex polyhedra", ["base", "interop"]),
    Room("scene", "cameras, materials, lights, textures, instances, Requirements; plain data", ["base", "interop", "geometry"]),
    Room("gpu", "Vulkan: device choice, buffers, kernels, timestamps, dispatch budget; knows nothing of rays",
         ["base", "interop/workgroup.h"]),
    Room("renderers/device_scene", "the scene as devices read it: prepared, uploaded, followed through changes", CORE),
    Room("renderers/film", "sums of samples, the loop over them, what is counted, first hits", CORE + ["renderers/device_scene"]),
    Room("renderers/light", "light that surfaces send out, kept on them, and each light method", BELOW_REFLECTION),
    Room(REFLECTION + "reflectors", "what reflects, and the points that maps are captured from", CORE + ["renderers/device_scene"]),
    Room(REFLECTION + "proxies", "boxes and polyhedra that stand in for the surroundings", CORE + ["renderers/device_scene"]),
    Room(REFLECTION + "maps", "polyhedra of maps, captured when looked up, forgotten when what they see changes",
         BELOW_REFLECTION + ["renderers/light"] + reflection("reflectors", "proxies")),
    Room(REFLECTION + "distances", "distances and radiance about capture points, bounded over blocks",
         BELOW_REFLECTION + ["renderers/light"] + reflection("reflectors", "maps")),
    Room(REFLECTION + "glossy", "maps convolved with glossy lobes",
         BELOW_REFLECTION + ["renderers/light"] + reflection("reflectors", "proxies", "maps")),
    Room(REFLECTION + "raster", "drawing: frames, reflectors, predicted errors", BELOW_REFLECTION + reflection("reflectors")),
    Room(REFLECTION + "planar", "plane mirrors and the views in them", BELOW_REFLECTION + reflection("reflectors", "raster")),
    Room("renderers/methods", "light x reflection: the list of methods, and what renders each",
         BELOW_REFLECTION + ["renderers/light"] + reflection("maps", "distances", "glossy", "raster", "planar")),
    Room("session", "the library's front door: a device, a scene on it, pictures of it",
         CORE + ["renderers/device_scene", "renderers/film", "renderers/light", "renderers/methods"]),
    Room("image_io", "pictures in files: OpenImageIO, nowhere else", ["base", "image", "scene/texture.h"]),
    Room("import/document", "a glTF file: parsed, held against the schema, its buffers read", SCENE),
    Room("import/conversion", "glTF to Scene", SCENE + ["image_io", "import/document"]),
    Room("compare/page", "what the pages and files written have in common", ["base"]),
    Room("compare/comparison", "methods measured against a reference: table, .json, report.html",
         PICTURES + ["compare/page", "renderers/film", "renderers/light", "renderers/methods", "session"]),
    Room("compare/trade", "time against error over settings: sweep, front, table, .json, page",
         PICTURES + ["compare/page", "compare/comparison"]),
    Room("cli", "one file per subcommand, exit codes; no algorithm",
         PICTURES + ["import/conversion", "compare/page", "compare/comparison", "compare/trade", "session", "renderers/film",
                     "renderers/light", "renderers/methods"] + reflection("maps", "distances", "glossy")),
]

KERNELS = "kernels/"


def kernels(*names):
    return [KERNELS + name for name in names]


SHADER_ROOMS = [
    Room("interop", "structs, binding numbers, specialization ids: read by C++ and GLSL; no functions", []),
    Room("lib", "pure functions by concern; no buffers", ["interop"]),
    Room(KERNELS + "scene", "the scene's buffers and what reads them", ["interop", "lib"]),
    Room(KERNELS + "film", "sums of samples: the loop over those of a pixel, drawn ones, what is counted", ["interop", "lib"]),
    Room(KERNELS + "light", "light kept on surfaces: filled, looked up", ["interop", "lib"] + kernels("scene", "film")),
    Room(KERNELS + "trace", "rays from the eye, specular chains", ["interop", "lib"] + kernels("scene", "film", "light")),
    Room(KERNELS + "maps", "reflection maps: looked up, resolved", ["interop", "lib"]),
    Room(KERNELS + "distances", "distances about capture points: measured, bounded, searched",
         ["interop", "lib"] + kernels("scene", "light", "maps")),
    Room(KERNELS + "glossy", "maps of glossy lobes: convolved, looked up", ["interop", "lib"] + kernels("scene", "maps")),
    Room(KERNELS + "reflectors", "polygons of reflectors: reflected, sorted, cut", ["interop", "lib"] + kernels("maps")),
    Room(KERNELS + "raster", "stages that draw a view",
         ["interop", "lib"] + kernels("scene", "light", "maps", "distances", "glossy", "reflectors")),
    Room(KERNELS + "hybrid", "stages that look up or trace, by predicted error",
         ["interop", "lib"] + kernels("trace", "distances", "raster")),
    Room(KERNELS + "planar", "stages that draw mirrored views",
         ["interop", "lib"] + kernels("scene", "raster", "hybrid")),
]
