#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves that every scene in the tree is what its generator makes and is well-formed glTF.

Exit code 0 if so, else 1 with a line for each fault.
"""

import pathlib
import subprocess
import sys
import tempfile

import glb_read

SCENES = pathlib.Path(__file__).resolve().parent
NOT_KEPT = {"million", "random"}      # too large or too many for the tree; made where they are needed


def generate(script, out):
    subprocess.run([sys.executable, str(script), "--out", str(out)], check=True)
    return out.read_bytes()


def check_folder(folder, scratch):
    """Tests one generator and its file. Returns the file's summary and its size in bytes."""
    kept = sorted(folder.glob("*.glb"))
    made = generate(folder / "generate.py", scratch / f"{folder.name}.glb")
    if folder.name in NOT_KEPT:
        glb_read.require(not kept, folder.name, "its .glb is not for the tree; delete it")
    else:
        expected = [folder / f"{folder.name}.glb"]
        glb_read.require(kept == expected, folder.name,
                         f"must hold exactly {folder.name}.glb; run its generate.py")
        glb_read.require(kept[0].read_bytes() == made, kept[0].name,
                         "differs from what generate.py makes; run generate.py and commit the result")
    return glb_read.summarise(made), len(made)


def main():
    faults = []
    folders = sorted(script.parent for script in SCENES.glob("*/generate.py"))
    orphans = [g for g in SCENES.rglob("*.glb") if g.parent not in folders]
    faults += [f"{orphan.relative_to(SCENES)}: has no generate.py beside it" for orphan in orphans]
    print(f"{'scene':16} {'triangles':>10} {'nodes':>6} {'materials':>9} {'bytes':>9}")
    with tempfile.TemporaryDirectory() as scratch:
        for folder in folders:
            try:
                summary, size = check_folder(folder, pathlib.Path(scratch))
            except (glb_read.Fault, OSError, ValueError, subprocess.CalledProcessError) as fault:
                faults.append(f"{folder.name}: {fault}")
                continue
            note = "  (not kept in the tree)" if folder.name in NOT_KEPT else ""
            print(f"{folder.name:16} {summary['triangles']:>10} {summary['nodes']:>6} "
                  f"{summary['materials']:>9} {size:>9}{note}")
    for fault in faults:
        print(f"check scenes: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
