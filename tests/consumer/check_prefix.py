#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks an installed package: usage PREFIX SOURCE_DIR BUILD_DIR. Exit code 1 with a line for each fault."""
import os
import pathlib
import subprocess
import sys

HEADERS = ("base/error.h", "base/version.h", "geometry/bvh.h", "gpu/device.h", "interop/scene.h",
           "scene/scene.h", "renderers/film/film.h", "renderers/methods/ray_tracer.h", "session/session.h",
           "compare/comparison/run_comparison.h")


def faults(prefix, source, build):
    configuration = next(prefix.glob("lib*/**/utsuriConfig.cmake"), None)
    if configuration is None:
        yield f"{prefix}: holds no utsuriConfig.cmake"
        return
    # Packages are moved, so no file of the package may name the folders it was built in or installed to.
    for file in configuration.parent.glob("*.cmake"):
        for place in (source, build, prefix):
            if str(place) in file.read_text(encoding="utf-8"):
                yield f"{file}: names {place}"
    for header in HEADERS:
        if not (prefix / "include/utsuri" / header).is_file():
            yield f"{prefix}: holds no include/utsuri/{header}"
    for header in prefix.glob("include/**/*"):
        if header.is_file() and header.suffix != ".h":
            yield f"{header}: is no header"
    program = prefix / "bin/utsuri"
    if not os.access(program, os.X_OK):
        yield f"{program}: is no program"
    else:
        version = subprocess.run([program, "--version"], capture_output=True, text=True, check=False,
                                 timeout=60)
        if version.returncode != 0 or not version.stdout.startswith("utsuri "):
            yield f"{program}: --version says {version.stdout!r} and exits with {version.returncode}"


def main():
    found = list(faults(*map(pathlib.Path, sys.argv[1:4])))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
