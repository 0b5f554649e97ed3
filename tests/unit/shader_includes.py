#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""shader_includes.py GLSLANG ROOT: every .glsl file of shaders compiles when it is the first that a kernel includes.

So no file has to be included after another. Prints what does not, with the compiler's first error; exit code 1 if
anything does not. Functions that a kernel defines for a file are declared in it, and stay unresolved here.
"""
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# A file may be for some stages only. Vertex stages say so before they include anything.
STAGES = {"comp": "", "frag": "", "vert": "#define VERTEX_STAGE\n"}
UNRESOLVED = "No function definition (body) found"


def kernel_that_includes(name, prefix):
    return (f"#version 460\n#extension GL_GOOGLE_include_directive : require\n{prefix}"
            f'#include "{name}"\nvoid main() {{}}\n')


def error_of(glslang, root, name, stage, folder):
    """The first error of compiling a file alone in a stage, or None."""
    source = Path(folder) / (name.replace("/", "_") + "." + stage)
    source.write_text(kernel_that_includes(name, STAGES[stage]), encoding="utf-8")
    result = subprocess.run([glslang, "-V", "--target-env", "vulkan1.3", f"-I{root / 'shaders'}", "-o",
                             str(source) + ".spv", str(source)], capture_output=True, text=True)
    errors = [line for line in result.stdout.splitlines()
              if line.startswith("ERROR") and UNRESOLVED not in line and "compilation" not in line]
    return errors[0] if result.returncode != 0 and errors else None


def problem_of(glslang, root, path, folder):
    name = path.relative_to(root / "shaders").as_posix()
    errors = [error_of(glslang, root, name, stage, folder) for stage in STAGES]
    return None if None in errors else f"{name}: {errors[0]}"


def check(glslang, root):
    files = sorted((root / "shaders").rglob("*.glsl"))
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor() as pool:
        problems = [p for p in pool.map(lambda path: problem_of(glslang, root, path, folder), files) if p]
    return problems if files else [f"{root}: no .glsl below shaders"]


def finds_what_is_missing(glslang):
    """Whether a file that needs another one is found."""
    with tempfile.TemporaryDirectory() as folder:
        lone = Path(folder) / "shaders" / "lib" / "lone.glsl"
        lone.parent.mkdir(parents=True)
        lone.write_text("Surface needs_another_file();\n", encoding="utf-8")
        return len(check(glslang, Path(folder))) == 1


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 2
    if not finds_what_is_missing(sys.argv[1]):
        print("shader_includes.py: does not find the planted fault")
        return 1
    problems = check(sys.argv[1], Path(sys.argv[2]))
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
