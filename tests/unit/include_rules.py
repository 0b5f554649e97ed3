#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""include_rules.py ROOT: holds the include lines of src and shaders against the rooms of rooms.py.

Prints each violation as "file:line: what is wrong"; exit code 1 if there is any, else 0. Also: a room names no room that
it never includes, but for those of LOW_ROOMS; descriptor bindings stand only in shaders/kernels, and no source file is
longer than LONGEST_FILE lines. Before it looks at the tree it proves on planted faults that it can find each kind.
"""
import re
import sys
from pathlib import Path

from rooms import Room, SHADER_ROOMS, SOURCE_ROOMS

LONGEST_FILE = 600
# What these hold is for every room above them, whether it is needed there today or not.
LOW_ROOMS = {"base", "interop", "geometry", "scene", "gpu", "image", "kernels", "lib"}
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


def permission(room, header, rooms):
    """What lets a file of a room include a header of the same tree, or one of `interop` and `kernels`: an entry of the
    room's list or its own name; None if nothing does."""
    if header in room.may_include:
        return header
    target = room_of(header, rooms)
    name = target.name if target else header.split("/")[0]
    return name if name == room.name or name in room.may_include else None


def upward_rooms(rooms):
    """What is wrong with the order of rooms: each may name only what stands before it."""
    known = {"interop", "kernels"}
    problems = []
    for room in rooms:
        problems += [f"{room.name} names {other}, which does not stand before it"
                     for other in room.may_include if other not in known and not other.endswith(".h")]
        known.add(room.name)
    return problems


def unused_permissions(rooms, lines):
    """What rooms name and never include; `lines` are the (path, line) of all their files."""
    used = {room.name: set() for room in rooms}
    for path, line in lines:
        include = INCLUDE.match(line)
        room = room_of(path, rooms)
        if include and include.group(1) and room:
            used[room.name].add(permission(room, include.group(1), rooms))
    return [f"{room.name} names {other}, which it includes nowhere"
            for room in rooms for other in room.may_include if other not in used[room.name] | LOW_ROOMS]


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
    if permission(room, include.group(1), SOURCE_ROOMS) is None:
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
    if permission(room, include.group(1), SHADER_ROOMS) is None:
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
    (source_problem, "import/conversion/gltf.h", '#include "renderers/film/film.h"'),
    (source_problem, "scene/scene.h", '#include "gpu/device.h"'),
    (source_problem, "scene/scene.h", '#include "image/image.h"'),
    (source_problem, "renderers/device_scene/gpu_scene.h", '#include "renderers/film/film.h"'),
    (source_problem, "renderers/light/direct/light_cache.h", '#include "renderers/methods/renderer.h"'),
    (source_problem, "renderers/reflection/maps/map_size.h", '#include "renderers/reflection/raster/reflector_drawer.h"'),
    (source_problem, "renderers/reflection/planar/mirrored_view_drawer.h", '#include "renderers/reflection/maps/map_size.h"'),
    (source_problem, "renderers/methods/renderer.h", '#include "import/conversion/gltf.h"'),
    (source_problem, "renderers/lost.h", '#include "base/file.h"'),
    (source_problem, "compare/comparison/measure.h", '#include "cli/options.h"'),
    (source_problem, "compare/comparison/measure.h", '#include "import/conversion/gltf.h"'),
    (source_problem, "compare/comparison/measure.h", '#include "renderers/reflection/maps/map_size.h"'),
    (source_problem, "cli/options.h", '#include "viewer/window.h"'),
    (source_problem, "compare/comparison/measure.h", "#include <OpenImageIO/imageio.h>"),
    (source_problem, "compare/comparison/measure.h", "#include <tiny_gltf.h>"),
    (source_problem, "cli/options.h", "#include <GLFW/glfw3.h>"),
    (source_problem, "cli/options.h", "#include <vulkan/vulkan_raii.hpp>"),
    (source_problem, "scene/scene.h", "#  include <boost/optional.hpp>"),
    (shader_problem, "lib/film.glsl", '#include "kernels/film/film_bindings.glsl"'),
    (shader_problem, "interop/rays.h", '#include "lib/film.glsl"'),
    (shader_problem, "interop/rays.h", "#include <vector>"),
    (shader_problem, "kernels/film/film_main.glsl", '#include "kernels/trace/specular_chain.glsl"'),
    (shader_problem, "kernels/raster/draw_scene.vert", '#include "kernels/planar/image_push.glsl"'),
    (shader_problem, "kernels/raster/draw_scene.frag", '#include "kernels/hybrid/hybrid_light.glsl"'),
    (shader_problem, "kernels/maps/map_texels.glsl", '#include "kernels/scene/scene_bindings.glsl"'),
    (shader_problem, "lib/film.glsl", "layout(scalar, binding = BINDING_FILM) buffer Film { float x[]; };"),
]
LEGAL = [
    (source_problem, "renderers/device_scene/ray_list.h", '#include "renderers/device_scene/gpu_scene.h"'),
    (source_problem, "renderers/device_scene/ray_list.cpp", '#include "kernels/trace_rays.h"'),
    (source_problem, "image_io/image_io.h", '#include "scene/texture.h"'),
    (source_problem, "cli/main.cpp", '#include "renderers/reflection/maps/map_size.h"'),
    (source_problem, "gpu/device.h", "#include <vulkan/vulkan_raii.hpp>"),
    (source_problem, "base/file.h", "#include <filesystem>"),
    (shader_problem, "kernels/trace/aov.comp", "layout(scalar, binding = BINDING_AOV) buffer Aov { AovPixel aov[]; };"),
    (shader_problem, "kernels/planar/draw_mirrored_hybrid.frag", '#include "kernels/hybrid/hybrid_light.glsl"'),
    (shader_problem, "lib/film.glsl", '#include "interop/frame.h"'),
]
UPWARD = [Room("low", "", ["high"]), Room("high", "", [])]
# The room above needs one room and one header of another, and names a third room in vain.
GENEROUS = [Room("base", "", []), Room("needed", "", []), Room("near", "", ["base"]), Room("spare", "", []),
            Room("above", "", ["base", "needed", "near/one.h", "spare"])]
GENEROUS_LINES = [("above/file.cpp", '#include "needed/file.h"'), ("above/file.h", '#include "near/one.h"'),
                  ("above/file.h", "// as spare/file.h does"), ("near/one.h", "#include <vector>")]


def prove_rules():
    missed = [f"{path}: {line}" for problem, path, line in FAULTS if problem(path, line) is None]
    false_alarms = [f"{path}: {line}" for problem, path, line in LEGAL if problem(path, line) is not None]
    if length_problem(LONGEST_FILE) is not None or length_problem(LONGEST_FILE + 1) is None:
        missed.append("file length")
    if not upward_rooms(UPWARD):
        missed.append("a room that names one above it")
    if unused_permissions(GENEROUS, GENEROUS_LINES) != ["above names spare, which it includes nowhere"]:
        missed.append("a room that names one it never includes")
    for text in missed:
        print(f"include_rules.py: does not find the planted fault in {text}")
    for text in false_alarms:
        print(f"include_rules.py: finds a fault where there is none, in {text}")
    return not missed and not false_alarms


def source_files(folder):
    for path in sorted(folder.rglob("*")):
        if path.is_file() and (path.suffix in SOURCE_SUFFIXES or path.name == "CMakeLists.txt"):
            yield path


def numbered_lines(root, top):
    """The (path below `top`, line number, line) of all that include lines may stand in."""
    for path in source_files(root / top):
        if path.name != "CMakeLists.txt":
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
                yield path.relative_to(root / top).as_posix(), number, line


def check_rooms(root, top, rooms, problem):
    """What is wrong with the rooms of a tree and the lines of its files."""
    lines = list(numbered_lines(root, top))
    if not lines:
        return [f"{root}: no sources below {top}"]
    found = [f"rooms.py: {text}" for text in upward_rooms(rooms)]
    found += [f"rooms.py: {text}" for text in unused_permissions(rooms, [(path, line) for path, _, line in lines])]
    return found + [f"{root / top / path}:{number}: {problem(path, line)}"
                    for path, number, line in lines if problem(path, line)]


def check_lengths(root):
    for top in SOURCE_FOLDERS:
        for path in source_files(root / top):
            text = length_problem(len(path.read_text(encoding="utf-8").splitlines()))
            if text:
                yield f"{path}:1: {text}"


def check_tree(root):
    return (check_rooms(root, "src", SOURCE_ROOMS, source_problem)
            + check_rooms(root, "shaders", SHADER_ROOMS, shader_problem) + list(check_lengths(root)))


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
