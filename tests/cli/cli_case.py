# SPDX-License-Identifier: Apache-2.0
"""Base of the tests that run the program.

UTSURI_PROGRAM names the program and UTSURI_SCENES the folder of scenes. With UTSURI_VALIDATION=1 the program
exits with 4 on any message of the Vulkan validation layer, so every run here is a validation test, too.
"""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

SUCCESS, DIFFERENCE, USAGE, INPUT, DEVICE, INTERRUPTED = 0, 1, 2, 3, 4, 130

# A run takes a few seconds at most; sanitizers and busy machines slow it down by some 20 times.
TIMEOUT_SECONDS = 240

# What a crash or an escaped exception leaves behind.
CRASH_WORDS = ("terminate called", "internal error", "check failed", "Sanitizer", "runtime error",
               "Segmentation", "core dumped", "std::", "Traceback")

SMALL = ("--size", "16x12")


def environment_path(name):
    """The file or folder that an environment variable names."""
    if name not in os.environ:
        raise SystemExit(f"set {name}: see the top of {__file__}")
    path = pathlib.Path(os.environ[name]).resolve()
    if not path.exists():
        raise SystemExit(f"{name} is '{path}', which does not exist")
    return path


def cheap_compare(samples=2, reference_samples=4):
    """Options that make a comparison cheap; maps of 16 texels are enough for every code path."""
    return ("--size", "64x48", "--spp", str(samples), "--reference-spp", str(reference_samples),
            "--map-size", "16", "--map-spp", "1", "--light-spp", "2")


class CliCase(unittest.TestCase):
    """Gives each test a scratch folder, and ways to run the program and to judge how it ended."""

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="utsuri_cli_")
        self.addCleanup(holder.cleanup)
        self.scratch = pathlib.Path(holder.name)
        self.program = environment_path("UTSURI_PROGRAM")
        self.scenes = environment_path("UTSURI_SCENES")

    def scene(self, name):
        return self.scenes / name / f"{name}.glb"

    def reflections(self):
        """All names that --reflection takes, as the program's help has them."""
        text = " ".join(self.succeed("render", "--help").stdout.split())
        listed = re.search(r" How reflections are found: (.*?) --", text).group(1)
        return re.sub(r" \(.*?\)", "", listed).split(", ")

    def run_program(self, *arguments, environment=None):
        """The finished process. It works in the scratch folder, so relative paths land there."""
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True,
                              check=False, cwd=self.scratch, timeout=TIMEOUT_SECONDS,
                              env={**os.environ, **(environment or {})})

    def succeed(self, *arguments, code=SUCCESS, environment=None):
        done = self.run_program(*arguments, environment=environment)
        self.assert_exit(done, code)
        return done

    def json_of(self, *arguments, code=SUCCESS):
        """What a subcommand writes with --json -, which leaves standard output to machines."""
        return json.loads(self.succeed(*arguments, "--json", "-", code=code).stdout)

    def fail_with(self, code, words, *arguments, environment=None):
        """Runs a command that must fail with `code`, name each of `words`, and leave no file behind."""
        before = self.files()
        done = self.run_program(*arguments, environment=environment)
        self.assert_exit(done, code)
        for word in words:
            self.assertIn(str(word), done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.files(), before)
        return done

    def assert_exit(self, done, code):
        told = f"{' '.join(map(str, done.args))}\nstdout: {done.stdout}\nstderr: {done.stderr}"
        self.assertEqual(done.returncode, code, told)
        for word in CRASH_WORDS:
            self.assertNotIn(word, done.stderr, told)

    def load(self, path):
        return json.loads((self.scratch / path).read_text(encoding="utf-8"))

    def files(self):
        """All that lies in the scratch folder, folders too."""
        return sorted(str(path.relative_to(self.scratch)) for path in self.scratch.rglob("*"))

    def assert_no_partial_files(self):
        self.assertEqual([name for name in self.files() if re.search(r"\.partial|write-probe", name)], [])
