#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C during long work: exit code 130, with what was finished saved; a second one kills. The work is followed
by the progress line, which the program shows on a terminal, so that no test has to guess how long a machine
takes."""
import os
import re
import select
import signal
import subprocess
import sys
import time
import unittest

import compare_test
import picture_file
from cli_case import CRASH_WORDS, INTERRUPTED, SMALL, TIMEOUT_SECONDS, CliCase

HOURS = str(2**24)  # samples that take hours
ENDLESS_MAPS = ("--map-size", "512", "--map-spp", "65536")
ERASE_LINE = "\r\033[K"


@unittest.skipIf(sys.platform == "win32", "there is no Ctrl-C to send to a child")
class Interrupt(CliCase):
    def interrupt(self, stage, *arguments):
        """Sends SIGINT as soon as the terminal shows `stage`, a pattern. Returns all that it showed."""
        terminal, end = os.openpty()
        self.addCleanup(os.close, terminal)
        process = subprocess.Popen([self.program, *map(str, arguments)], stdout=subprocess.DEVNULL,
                                   stderr=end, cwd=self.scratch)
        os.close(end)
        self.addCleanup(process.kill)
        shown, sent, last = "", False, time.monotonic() + TIMEOUT_SECONDS
        while time.monotonic() < last:
            if not select.select([terminal], [], [], 1.0)[0]:
                continue
            try:
                shown += os.read(terminal, 65536).decode("utf-8", "replace")
            except OSError:  # the program has closed its end
                break
            if not sent and re.search(stage, shown):
                process.send_signal(signal.SIGINT)
                sent = True
        self.assertTrue(sent, f"never showed {stage}:\n{shown}")
        code = process.wait(timeout=TIMEOUT_SECONDS)
        self.assertEqual(code, INTERRUPTED, shown)
        for word in CRASH_WORDS:
            self.assertNotIn(word, shown)
        self.assert_no_partial_files()
        return shown

    def test_render_keeps_its_samples(self):
        shown = self.interrupt(r"direct/trace: \d+ %, \S+ /s, .* left", "render", self.scene("cornell"),
                               "-o", "picture.exr", "--json", "result.json", *SMALL, "--spp", HOURS)
        values = self.load("result.json")
        self.assertTrue(1 <= values["samples"] < int(HOURS))
        width, height, _, texts = picture_file.read_exr_header(self.scratch / "picture.exr")
        self.assertEqual((width, height), (16, 12))
        self.assertEqual(texts["utsuri:samples"], str(values["samples"]))
        # As many whole samples as it says: the same picture comes from asking for that number.
        self.succeed("render", self.scene("cornell"), "-o", "again.exr", *SMALL, "--spp", values["samples"])
        self.assertEqual(self.json_of("diff", "again.exr", "picture.exr")["metrics"]["max"], 0.0)
        self.assertNotIn("%", shown.rsplit(ERASE_LINE, 1)[1])

    def test_second_one_ends_work_that_does_not_stop(self):
        # Opening a pipe that nobody reads takes forever: work that comes to no place where it may stop.
        os.mkfifo(self.scratch / "result.json")
        process = subprocess.Popen([self.program, "render", self.scene("cornell"), "-o", "picture.exr", "--json",
                                    "result.json", *SMALL, "--spp", "1"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=self.scratch)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        last = time.monotonic() + TIMEOUT_SECONDS
        while not (self.scratch / "picture.exr").exists():  # the result is written after the picture
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), last)
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        with self.assertRaises(subprocess.TimeoutExpired, msg="one is a request"):
            process.wait(timeout=1.0)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=TIMEOUT_SECONDS), -signal.SIGINT)

    def test_render_with_time_and_png(self):
        self.interrupt(r"direct/trace: \d+ %", "render", self.scene("cornell"), "-o", "picture.png", *SMALL,
                       "--time", "500min")
        picture_file.read_png(self.scratch / "picture.png")

    def test_render_without_a_sample_leaves_nothing(self):
        self.interrupt("preparing", "render", self.scene("office-lambert"), "-o", "picture.exr", *SMALL,
                       *ENDLESS_MAPS, "--reflection", "polygon-map")
        self.assertEqual(self.files(), [])

    def test_compare_keeps_finished_methods(self):
        self.interrupt("direct/polygon-map, capturing maps", "compare", self.scene("office-lambert"), "-o", "report",
                       *SMALL, "--spp", "2", "--reference-spp", "2", *ENDLESS_MAPS)
        values = self.load("report/compare.json")
        self.assertTrue(values["interrupted"])
        self.assertEqual([result["name"] for result in values["methods"]], ["direct/trace"])
        present = {path.name for path in (self.scratch / "report").iterdir()}
        self.assertEqual(present, compare_test.named_files(values))

    def test_compare_keeps_a_part_of_the_reference(self):
        self.interrupt(r"reference direct/trace, \d+ samples per pixel: \d+ %", "compare",
                       self.scene("cornell"), "-o", "report", *SMALL, "--reference-spp", HOURS)
        values = self.load("report/compare.json")
        self.assertTrue(values["interrupted"])
        self.assertEqual(values["methods"], [])
        self.assertTrue(1 <= values["reference"]["settings"]["samples"] < int(HOURS))
        present = {path.name for path in (self.scratch / "report").iterdir()}
        self.assertEqual(present, compare_test.named_files(values))

    def test_trade_keeps_finished_runs(self):
        self.interrupt(r"2 of \d+: --reflection polygon-map --map-size 128, preparing", "trade",
                       self.scene("office-lambert"), "-o", "out", *SMALL, "--methods", "trace,polygon-map",
                       "--most-spp", "2", "--reference-spp", "2", *ENDLESS_MAPS)
        values = self.load("out/trade.json")
        self.assertTrue(values["interrupted"])
        self.assertEqual([run["settings"]["samples"] for run in values["runs"]], [1, 2])
        self.assertEqual({run["name"] for run in values["runs"]}, {"direct/trace"})
        self.assertTrue((self.scratch / "out/trade.html").is_file())

    def test_trade_without_a_reference_leaves_nothing(self):
        self.interrupt(r"reference direct/trace, \d+ samples per pixel: \d+ %", "trade", self.scene("cornell"),
                       "-o", "out", *SMALL, "--reference-spp", HOURS)
        self.assertEqual(self.files(), ["out"])


if __name__ == "__main__":
    unittest.main()
