#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens a report.html in headless Chromium and checks that its script drew the page.

Exit codes: 0 all is well; 1 a check failed; 2 wrong usage; 77 there is no Chromium (SKIP_RETURN_CODE in
ctest).
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser

SKIPPED = 77
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "chrome")
TIMEOUT_SECONDS = 120  # a cold start on two busy cores takes some 20 s
# How long a page may take to be ready, in the browser's own time, which runs ahead of a busy machine's where it waits.
VIRTUAL_MILLISECONDS = (5000, 20000, 80000)
DATA_BEGIN = '<script type="application/json" id="data">'
DIVIDERS = (25, 80)  # percent from the left

# Run inside the page: what a reader's actions change. Events made by a script own no pointer to capture.
ACTIONS = """<script>
Element.prototype.setPointerCapture = () => {};
const act = (id, event) => document.getElementById(id).dispatchEvent(event);
const press = (key, shiftKey = false) => act("divider", new KeyboardEvent("keydown", { key, shiftKey }));
const at = (type, x, y, more = {}) => {
    const box = document.getElementById("stage").getBoundingClientRect();
    const Kind = { click: MouseEvent, wheel: WheelEvent }[type] ?? PointerEvent;
    const place = { clientX: box.left + x * box.width, clientY: box.top + y * box.height };
    act("stage", new Kind(type, { ...place, ...more }));
};
const results = {};
const note = (name) => {
    results[name] = [document.getElementById("divider").getAttribute("aria-valuenow"),
                     document.getElementById("zoom-level").textContent,
                     document.querySelector("#left-side img").style.transform,
                     document.querySelector("#right-side img").style.transform];
};
function run() {
    if (document.documentElement.dataset.ready !== "true") return setTimeout(run, 20);
    press("ArrowRight"); note("arrow");
    press("ArrowLeft", true); note("shift arrow");
    press("End"); note("end");
    press("Home"); note("home");
    at("click", 0.3, 0.5); note("click");
    at("pointerdown", 0.3, 0.5); at("pointermove", 0.7, 0.5); note("drag");
    at("pointerup", 0.7, 0.5); at("pointermove", 0.1, 0.5); note("released");
    at("wheel", 1, 1, { deltaY: -100 }); note("wheel alone");
    at("wheel", 1, 1, { deltaY: -100, ctrlKey: true });
    at("wheel", 1, 1, { deltaY: -100, ctrlKey: true }); note("wheel with ctrl");
    at("pointerdown", 0.5, 0.5); at("pointermove", 0.75, 0.5); note("pan");
    at("pointermove", 5, 5); at("pointerup", 5, 5); note("pan to the edge");
    document.getElementById("zoom-in").click(); note("zoom in");
    document.getElementById("zoom-fit").click(); note("fit");
    for (const deltaY of [-1, -1, 1, 1]) at("wheel", 0, 0, { deltaY, ctrlKey: true });
    note("wheel there and back");
    const choice = document.getElementById("left-choice");
    choice.selectedIndex = choice.length - 1;
    act("left-choice", new Event("change"));
    results.tag = document.getElementById("left-tag").textContent;
    results.name = choice.selectedOptions[0].textContent;
    results.groups = [...choice.querySelectorAll("optgroup")].map((group) => [group.label, group.children.length]);
    results.legends = [];
    for (const group of choice.querySelectorAll("optgroup")) {
        choice.value = group.children[0].value;
        act("left-choice", new Event("change"));
        results.legends.push([...document.querySelectorAll("#legend h3")].map((title) => title.textContent));
    }
    const maps = document.getElementById("map-choice");
    results.maps = [...maps.options].map((option, index) => {
        maps.selectedIndex = index;
        act("map-choice", new Event("change"));
        const inside = (selector) => [...document.querySelectorAll("#pictures " + selector)];
        return { title: option.textContent, images: inside("img:not(.scale)").map((image) => image.src),
                 ticks: [...new Set(inside(".ticks span").map((tick) => tick.textContent))],
                 swatches: [...new Set(inside(".swatches > span").map((swatch) => swatch.textContent))],
                 captions: inside("figcaption").length };
    });
    results.displacement = [...document.querySelectorAll("#displacement tbody tr")].map(
        (row) => [...row.children].map((cell) => cell.textContent));
    document.documentElement.dataset.results = JSON.stringify(results);
}
run();
</script>"""


def view(divider, level, x, y, zoom):
    transform = f"translate({x}%, {y}%) scale({zoom})"
    return [str(divider), level, transform, transform]


# What can be chosen: its name in the page, its key in the data, ticks and swatches of its legend.
PIXEL_TICKS = ["≤ 0.1", "1", "10", "≥ 100 px"]
MAPS = [
    ("FLIP error", "error_map", ["0", "1"], []),
    ("predicted error", "predicted", PIXEL_TICKS, ["no mirror"]),
    ("measured error", "measured", PIXEL_TICKS, ["no mirror"]),
    ("traced pixels", "traced", [], ["traced", "looked up", "no mirror"]),
]
DISPLACEMENTS = "Reflections off their places, in pixels"
LEGENDS = [[], ["FLIP error"], [DISPLACEMENTS], [DISPLACEMENTS], ["Reflections"]]

# Zooming at the corner (1, 1) by z puts the start of the picture at 1 - z sizes of the stage.
RESULTS = {
    "arrow": view(51, "fit", 0, 0, 1), "shift arrow": view(41, "fit", 0, 0, 1),
    "end": view(100, "fit", 0, 0, 1),
    "home": view(0, "fit", 0, 0, 1), "click": view(30, "fit", 0, 0, 1), "drag": view(70, "fit", 0, 0, 1),
    "released": view(70, "fit", 0, 0, 1), "wheel alone": view(70, "fit", 0, 0, 1),
    "wheel with ctrl": view(70, "2×", -100, -100, 2), "pan": view(70, "2×", -75, -100, 2),
    "pan to the edge": view(70, "2×", 0, 0, 2), "zoom in": view(70, "4×", -50, -50, 4),
    "fit": view(70, "fit", 0, 0, 1), "wheel there and back": view(70, "fit", 0, 0, 1),
}


class Page(HTMLParser):
    """The elements of a page, each (tag, attributes, ids around it), and the text of each id."""

    VOID = {"img", "meta", "link", "br", "hr", "input", "col", "source", "wbr"}

    def __init__(self, text):
        super().__init__()
        self.elements = []
        self.texts = {}
        self.open = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.elements.append((tag, attributes, [identity for _, identity in self.open if identity]))
        if tag not in self.VOID:
            self.open.append((tag, attributes.get("id")))

    def handle_endtag(self, tag):
        while self.open and self.open.pop()[0] != tag:
            pass

    def handle_data(self, data):
        for _, identity in self.open:
            if identity:
                self.texts[identity] = self.texts.get(identity, "") + data

    def inside(self, identity, tag):
        return [attributes for name, attributes, ids in self.elements if name == tag and identity in ids]

    def by_id(self, identity):
        return next((a for _, a, _ in self.elements if a.get("id") == identity), {})


class Checks:
    def __init__(self):
        self.failed = 0

    def equal(self, what, actual, expected):
        if actual == expected:
            return
        self.failed += 1
        print(f"{what}: is {actual!r}, expected {expected!r}", file=sys.stderr)


def run_browser(browser, url, milliseconds, *options):
    """What Chromium writes to stdout and to stderr."""
    with tempfile.TemporaryDirectory(prefix="utsuri_report_", ignore_cleanup_errors=True) as profile:
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                   "--disable-background-networking", "--disable-component-update", "--disable-sync",
                   "--disable-extensions", "--enable-logging=stderr", f"--user-data-dir={profile}",
                   f"--virtual-time-budget={milliseconds}", *options, url]
        done = subprocess.run(command, capture_output=True, timeout=TIMEOUT_SECONDS, check=True)
    return done.stdout.decode("utf-8"), done.stderr.decode("utf-8", "replace")


def browse(browser, url, mark="data-ready"):
    """The elements of a page once its root has the attribute `mark`, or the last that came of it, and what Chromium logs."""
    for milliseconds in VIRTUAL_MILLISECONDS:
        dom, log = run_browser(browser, url, milliseconds, "--dump-dom")
        if re.search(rf"<html[^>]*\b{mark}=", dom):
            break
    return dom, log


def check_page(page, data, divider, checks):
    methods = data["methods"]
    count = len(methods)
    shown = f"divider at {divider} %"
    html = next(attributes for tag, attributes, _ in page.elements if tag == "html")
    checks.equal("html data-ready", html.get("data-ready"), "true")
    rows = [row.get("class") for row in page.inside("cost", "tr")]
    checks.equal("method rows in the table of cost", rows.count("method"), count)
    checks.equal("reference rows in the table of cost", rows.count("reference"), 1)
    rows = [row.get("class") for row in page.inside("error", "tr")]
    checks.equal("method rows in the table of errors", rows.count("method"), 2 * count)
    for name in (method["name"] for method in methods):
        checks.equal(f"{name} in the table of cost", name in page.texts.get("cost", ""), True)
    for side in ("left", "right"):
        images = page.inside(f"{side}-side", "img")
        sizes = [(image.get("data-natural-width"), image.get("data-natural-height")) for image in images]
        checks.equal(f"size of the {side} picture", sizes, [(str(data["width"]), str(data["height"]))])
    # A picture for each result, and an error map and a colour scale for each method.
    checks.equal("pictures in the grid", len(page.inside("pictures", "img")), 1 + 3 * count)
    checks.equal("images of the page", len([1 for tag, _, _ in page.elements if tag == "img"]), 3 + 3 * count)
    clip = page.by_id("left-side").get("style", "")
    checks.equal(f"{shown}: the left picture's clip is in {clip!r}",
                 f"inset(0px {100 - divider}% 0px 0px)" in clip, True)
    checks.equal(f"{shown}: aria-valuenow", page.by_id("divider").get("aria-valuenow"), str(divider))
    scene = data["scene"].replace("\\", "/").rstrip("/").rsplit("/", 1)[-1]
    checks.equal("title", page.texts.get("scene"), scene)
    checks.equal("command", page.texts.get("command"), data["command"])


def rounded(results):
    """Transforms in whole percent: an event is placed to a pixel, of which the stage has some hundreds."""
    number = re.compile(r"-?\d+\.\d+(e-?\d+)?")
    return [number.sub(lambda found: f"{round(float(found[0]))}", text) for text in results]


def told_maps(data):
    """The rows of MAPS that a method of the comparison tells, each with the pictures of those that do."""
    methods = data["pictures"]["methods"]
    told = [(row, [pictures[row[1]] for pictures in methods if pictures.get(row[1])]) for row in MAPS]
    return [(row, pictures) for row, pictures in told if pictures]


def check_maps(results, data, checks):
    plain = [data["pictures"]["reference"], *(pictures["image"] for pictures in data["pictures"]["methods"])]
    told = told_maps(data)
    checks.equal("groups of pictures", results["groups"],
                 [["picture", len(plain)], *([row[0], len(pictures)] for row, pictures in told)])
    checks.equal("legends", results["legends"], [LEGENDS[0], *(LEGENDS[1 + MAPS.index(row)] for row, _ in told)])
    checks.equal("choices beneath methods", [shown["title"] for shown in results["maps"]], [row[0] for row, _ in told])
    for shown, ((title, key, ticks, swatches), pictures) in zip(results["maps"], told):
        checks.equal(f"{title}: pictures", sorted(shown["images"]), sorted(plain + pictures))
        checks.equal(f"{title}: ticks", [text.replace("\u202f", " ") for text in shown["ticks"]], ticks)
        checks.equal(f"{title}: swatches", shown["swatches"], swatches)
        checks.equal(f"{title}: captions", shown["captions"], len(plain) + len(pictures))
    names = [method["name"] for method in data["methods"] if "reflection_errors" in method]
    checks.equal("methods in the table of displacements", [row[0] for row in results["displacement"]], names)


def check_actions(browser, source, data, checks):
    with tempfile.TemporaryDirectory(prefix="utsuri_report_") as folder:
        copy = pathlib.Path(folder) / "report.html"
        copy.write_text(source.replace("</body>", ACTIONS + "</body>"), encoding="utf-8")
        dom, _ = browse(browser, copy.as_uri(), "data-results")
    html = next(attributes for tag, attributes, _ in Page(dom).elements if tag == "html")
    results = json.loads(html.get("data-results", "{}"))
    for name, expected in RESULTS.items():
        checks.equal(f"after '{name}'", rounded(results.get(name, [])), expected)
    checks.equal("label of the left picture after a choice", results.get("tag", ""), results.get("name"))
    check_maps(results, data, checks)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report", type=pathlib.Path)
    parser.add_argument("--screenshot", type=pathlib.Path, metavar="FILE", help="save a picture of the page")
    parser.add_argument("--window", default="1400,2200", metavar="W,H",
                        help="size of that picture [%(default)s]")
    parser.add_argument("--address", default="", metavar="HASH", help="for example zoom=4&left=direct/trace")
    parser.add_argument("--dark", action="store_true", help="take that picture in the dark colour scheme")
    options = parser.parse_args()

    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        print(f"skipped: none of {', '.join(BROWSERS)} is installed")
        return SKIPPED
    url = options.report.resolve(strict=True).as_uri()
    source = options.report.read_text(encoding="utf-8")
    data = json.loads(source.split(DATA_BEGIN, 1)[1].split("</script>", 1)[0])

    checks = Checks()
    for divider in DIVIDERS:
        dom, log = browse(browser, f"{url}#divider={divider}")
        check_page(Page(dom), data, divider, checks)
        checks.equal("messages on the console", [line for line in log.splitlines() if "CONSOLE" in line], [])
    check_actions(browser, source, data, checks)
    if options.screenshot:
        scheme = ["--blink-settings=preferredColorScheme=0"] if options.dark else []
        run_browser(browser, f"{url}#{options.address}", VIRTUAL_MILLISECONDS[-1], f"--window-size={options.window}",
                    "--hide-scrollbars", f"--screenshot={options.screenshot.resolve()}", *scheme)
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main())
