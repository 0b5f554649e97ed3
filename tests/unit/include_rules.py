#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""include_rules.py ROOT: holds the include lines of src and shaders against the rooms of rooms.py.

Prints each violation as "file:line: what is wrong"; exit code 1 if there is any, else 0. Also: descriptor bindings
stand only in shaders/kernels, and no source file is longer than LONGEST_FILE lines. Before it looks at the tree it
proves on planted faults that it can find each kind.
"""
import re
import sys
from pathlib import Path

from rooms import Room, SHADER_ROOMS, SOURCE_ROOMS

LONGEST_FILE = 600
SOURCE_SUFFIXES = {".h", ".cpp", ".comp", ".vert", ".frag", ".glsl", ".py", ".cmake"}
SOURCE_FOLDERS = ["src", "shaders", "tests", "benchmarks", "scenes", "cmake", "scripts"]

# Libraries beyond the standard one, and the folders that may see them; every folder may see those of ANYWHERE.
ANYWHERE = {"glm", "fmt"}
LIBRARIES = {
    "vulkan": {"gpu", "renderers", "session"},
    "OpenImageIO": {"image_io"},
    "tiny_gltf.h": {"import"},
    "nlohmann": {"import", "compare", "cli"},
    "CLI": {"cli"},
    "GLFW": {"viewer"},
    "imgui.h": {"viewer"},
}
SYSTEM_HEADERS = {"unistd.h", "io.h"}  # is the terminal one, on POSIX and on Windows: cli only

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')
BINDING = re.compile(r"\blayout\s*\([^)]*\bbinding\b")


def room_of(path, rooms):
    """The innermost room that a path is in, or None."""
    inside = [room for room in rooms if path.startswith(room.name + "/")]
    return max(inside, key=lambda room: len(room.name), default=None)


def may_include(room, header, rooms):
    """Whether a file of a room may include a header of the same tree, or one of `interop` and `kernels`."""
    if header in room.may_include:
        return True
    target = room_of(header, rooms)
    name = target.name if target else header.split("/")[0]
    return name == room.name or name in room.may_include


def upward_rooms(rooms):
    """What is wrong with the order of rooms: each may name only what stands before it."""
    known = {"interop", "kernels"}
    problems = []
    for room in rooms:
        problems += [f"{room.name} names {other}, which does not stand before it"
                     for other in room.may_include if other not in known and not other.endswith(".h")]
        known.add(room.name)
    return problems


def library_problem(folder, header):
    top = folder.split("/")[0]
    library = header.split("/")[0]
    if library in ANYWHERE:
        return None
    if library in LIBRARIES:
        return None if top in LIBRARIES[library] else f"<{header}> is for {', '.join(sorted(LIBRARIES[library]))} only"
    if header in SYSTEM_HEADERS:
        return None if top == "cli" else f"<{header}> is for cli only"
    if "/" in header or header.endswith(".h"):
        return f"<{header}> is of no library that the project knows; add it to include_rules.py with its folder"
    return None


def source_problem(path, line):
    """What is wrong with a line of src/`path`, or None."""
    include = INCLUDE.match(line)
    if not include:
        return None
    room = room_of(path, SOURCE_ROOMS)
    if room is None:
        return "is in no room of rooms.py"
    if include.group(2):
        return library_problem(room.name, include.group(2))
    if not may_include(room, include.group(1), SOURCE_ROOMS):
        return f"{room.name} may not include {include.group(1)}"
    return None


def shader_problem(path, line):
    """What is wrong with a line of shaders/`path`, or None."""
    if not path.startswith("kernels/") and BINDING.search(line):
        return "bindings are declared in shaders/kernels only"
    include = INCLUDE.match(line)
    if not include:
        return None
    room = room_of(path, SHADER_ROOMS)
    if room is None:
        return "is in no room of rooms.py"
    if include.group(2):
        # The C++ side of the prelude.
        is_prelude = path == "interop/prelude.h" and (include.group(2) == "cstdint" or include.group(2)[:4] == "glm/")
        return None if is_prelude else f"shaders may not include <{include.group(2)}>"
    if not may_include(room, include.group(1), SHADER_ROOMS):
        return f"shaders/{room.name} may not include {include.group(1)}"
    return None


def length_problem(lines):
    return f"{lines} lines, at most {LONGEST_FILE} are allowed" if lines > LONGEST_FILE else None


FAULTS = [
    (source_problem, "base/file.h", '#include "scene/scene.h"'),
    (source_problem, "base/file.h", "#include <vulkan/vulkan.h>"),
    (source_problem, "geometry/bvh.h", '#include "scene/scene.h"'),
    (source_problem, "gpu/buffer.h", '#include "interop/rays.h"'),
    (source_problem, "image/image.h", '#include "image_io/image_io.h"'),
    (source_problem, "image_io/image_io.h", '#include "scene/scene.h"'),
    (source_problem, "import/gltf.h", '#include "renderers/film/film.h"'),
    (source_problem, "scene/scene.h", '#include "gpu/device.h"'),
    (source_problem, "scene/scene.h", '#include "image/image.h"'),
    (source_problem, "renderers/scene/gpu_scene.h", '#include "renderers/film/film.h"'),
    (source_problem, "renderers/light/direct/light_cache.h", '#include "renderers/methods/renderer.h"'),
    (source_problem, "renderers/reflection/maps/map_size.h", '#include "renderers/reflection/raster/reflector_drawer.h"'),
    (source_problem, "renderers/reflection/planar/image_drawer.h", '#include "renderers/reflection/maps/map_size.h"'),
    (source_problem, "renderers/methods/renderer.h", '#include "import/gltf.h"'),
    (source_problem, "renderers/lost.h", '#include "base/file.h"'),
    (source_problem, "compare/measure.h", '#include "cli/options.h"'),
    (source_problem, "compare/measure.h", '#include "import/gltf.h"'),
    (source_problem, "cli/options.h", '#include "viewer/window.h"'),
    (source_problem, "compare/measure.h", "#include <OpenImageIO/imageio.h>"),
    (source_problem, "compare/measure.h", "#include <tiny_gltf.h>"),
    (source_problem, "cli/options.h", "#include <GLFW/glfw3.h>"),
    (source_problem, "cli/options.h", "#include <vulkan/vulkan_raii.hpp>"),
    (source_problem, "scene/scene.h", "#  include <boost/optional.hpp>"),
    (shader_problem, "lib/film.glsl", '#include "kernels/film/film_bindings.glsl"'),
    (shader_problem, "interop/rays.h", '#include "lib/film.glsl"'),
    (shader_problem, "interop/rays.h", "#include <vector>"),
    (shader_problem, "kernels/film/film_main.glsl", '#include "kernels/trace/specular_chain.glsl"'),
    (shader_problem, "kernels/raster/draw_scene.vert", '#include "kernels/planar/image_push.glsl"'),
    (shader_problem, "kernels/raster/draw_scene.frag", '#include "kernels/hybrid/hybrid_light.glsl"'),
    (shader_problem, "lib/film.glsl", "layout(scalar, binding = BINDING_FILM) buffer Film { float x[]; };"),
]
LEGAL = [
    (source_problem, "renderers/scene/ray_list.h", '#include "renderers/scene/gpu_scene.h"'),
    (source_problem, "renderers/scene/ray_list.cpp", '#include "kernels/trace_rays.h"'),
    (source_problem, "image_io/image_io.h", '#include "scene/texture.h"'),
    (source_problem, "cli/main.cpp", '#include "renderers/reflection/reflectors/reflectors.h"'),
    (source_problem, "gpu/device.h", "#include <vulkan/vulkan_raii.hpp>"),
    (source_problem, "base/file.h", "#include <filesystem>"),
    (shader_problem, "kernels/trace/aov.comp", "layout(scalar, binding = BINDING_AOV) buffer Aov { AovPixel aov[]; };"),
    (shader_problem, "kernels/planar/draw_image_hybrid.frag", '#include "kernels/hybrid/hybrid_light.glsl"'),
    (shader_problem, "lib/film.glsl", '#include "interop/frame.h"'),
]
UPWARD = [Room("low", "", ["high"]), Room("high", "", [])]


def prove_rules():
    missed = [f"{path}: {line}" for problem, path, line in FAULTS if problem(path, line) is None]
    false_alarms = [f"{path}: {line}" for problem, path, line in LEGAL if problem(path, line) is not None]
    if length_problem(LONGEST_FILE) is not None or length_problem(LONGEST_FILE + 1) is None:
        missed.append("file length")
    if not upward_rooms(UPWARD):
        missed.append("a room that names one above it")
    for text in missed:
        print(f"include_rules.py: does not find the planted fault in {text}")
    for text in false_alarms:
        print(f"include_rules.py: finds a fault where there is none, in {text}")
    return not missed and not false_alarms


def source_files(folder):
    for path in sorted(folder.rglob("*")):
        if path.is_file() and (path.suffix in SOURCE_SUFFIXES or path.name == "CMakeLists.txt"):
            yield path


def check_tree(root):
    violations = [f"rooms.py: {problem}" for problem in upward_rooms(SOURCE_ROOMS) + upward_rooms(SHADER_ROOMS)]
    lines_seen = 0
    for top in SOURCE_FOLDERS:
        for path in source_files(root / top):
            lines = path.read_text(encoding="utf-8").splitlines()
            too_long = length_problem(len(lines))
            if too_long:
                violations.append(f"{path}:1: {too_long}")
            problem = {"src": source_problem, "shaders": shader_problem}.get(top)
            if problem is None or path.name == "CMakeLists.txt":
                continue
            for number, line in enumerate(lines, start=1):
                lines_seen += 1
                text = problem(path.relative_to(root / top).as_posix(), line)
                if text:
                    violations.append(f"{path}:{number}: {text}")
    if lines_seen == 0:
        violations.append(f"{root}: no sources below src and shaders")
    return violations


def main():
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    if not prove_rules():
        return 1
    violations = check_tree(Path(sys.argv[1]))
    for violation in violations:
        print(violation)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
