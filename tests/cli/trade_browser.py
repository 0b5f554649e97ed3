#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens a trade.html in headless Chromium and checks its chart: a mark for each run, the picture it shows, the
front, and what the controls and keys do.

Exit codes as report_browser.py.
"""
import argparse
import json
import math
import pathlib
import re
import shutil
import sys
import tempfile

from report_browser import BROWSERS, DATA_BEGIN, SKIPPED, Checks, Page, browse

# Run inside the page: what a reader's actions show.
ACTIONS = """<script>
const results = {};
const marks = () => [...document.querySelectorAll("#chart .mark")];
const markOf = (run) => marks().find((mark) => Number(mark.dataset.run) === run);
const note = (name) => {
    const picture = document.getElementById("picture").src;
    results[name] = {
        run: JSON.parse(document.getElementById("data").textContent).pictures.indexOf(picture),
        shown: marks().filter((mark) => mark.classList.contains("shown")).map((mark) => Number(mark.dataset.run)),
        focused: Number(document.activeElement?.dataset?.run ?? -1),
        stops: marks().filter((mark) => mark.getAttribute("tabindex") === "0").length,
        marks: marks().length,
        command: document.getElementById("run-command").textContent,
        front: [...document.querySelectorAll("#front tbody tr")].map((row) => Number(row.dataset.run)),
        equal: ["equal-time", "equal-error"].map((table) => [...document.querySelectorAll(`#${table} tbody tr`)].map(
            (row) => [...row.children].map((cell, i) => (i === 0 ? cell.textContent : Number(cell.dataset.run ?? -1))))),
        axes: [...document.querySelectorAll("#chart .title")].map((title) => title.textContent),
    };
};
const choose = (id, value) => {
    document.getElementById(id).value = value;
    document.getElementById(id).dispatchEvent(new Event("change"));
};
const press = (key) => document.activeElement.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
function run() {
    if (document.documentElement.dataset.ready !== "true") return setTimeout(run, 20);
    note("start");
    markOf(2).dispatchEvent(new PointerEvent("pointerenter"));
    note("hover");
    markOf(0).focus(); note("focus");
    press("Home"); note("home");
    press("ArrowRight"); note("right");
    press("ArrowLeft"); note("left");
    press("ArrowLeft"); note("left of the first");
    press("End"); note("end");
    press("ArrowUp"); note("up");
    press("ArrowDown"); note("down");
    choose("metric", "flip"); note("flip");
    choose("pixels", "reflective"); note("reflective");
    choose("time", "with_preparation"); note("with preparation");
    document.querySelector("#front tbody tr").click(); note("row");
    [...document.querySelectorAll("#equal-time td[data-run]")].at(-1).click(); note("cell");
    document.querySelector("#methods input").click(); note("without the first method");
    document.documentElement.dataset.results = JSON.stringify(results);
}
run();
</script>"""


def seconds(run):
    return run["frame_seconds"]


def last_within(data):
    """The run in the last filled cell of the table of equal times, as it is shown at the end."""
    rows = data["equal"]["with_preparation"]["reflective"]["flip"]["times"]
    return [run for row in rows for run in row["runs"] if run is not None][-1]


def check_actions(results, data, checks):
    runs = data["runs"]
    count = len(runs)
    by_time = sorted(range(count), key=lambda i: (seconds(runs[i]), i))
    by_error = sorted(range(count), key=lambda i: (runs[i]["errors"]["rel_mse"], seconds(runs[i]), i))
    last = by_time[-1]
    above = by_error[min(by_error.index(last) + 1, count - 1)]
    fronts = data["fronts"]
    back = by_error[max(by_error.index(above) - 1, 0)]
    expected = {"start": fronts["frame"]["all"]["rel_mse"][0], "hover": 2, "focus": 0, "home": by_time[0],
                "right": by_time[1], "left": by_time[0], "left of the first": by_time[0], "end": last,
                "up": above, "down": back, "row": fronts["with_preparation"]["reflective"]["flip"][0],
                "cell": last_within(data)}
    for name, run in expected.items():
        checks.equal(f"after '{name}': the run whose picture is shown", results[name]["run"], run)
        checks.equal(f"after '{name}': marks that are shown", results[name]["shown"], [run])
        checks.equal(f"after '{name}': its command", results[name]["command"], runs[run]["command"])
        checks.equal(f"after '{name}': stops of the tab key", results[name]["stops"], 1)
    for name in ("focus", "home", "right", "left", "end", "up", "down"):
        checks.equal(f"after '{name}': focus", results[name]["focused"], expected[name])
    for name, path in {"start": ("frame", "all", "rel_mse"), "flip": ("frame", "all", "flip"),
                       "reflective": ("frame", "reflective", "flip"),
                       "with preparation": ("with_preparation", "reflective", "flip")}.items():
        checks.equal(f"after '{name}': the front", results[name]["front"], fronts[path[0]][path[1]][path[2]])
        checks.equal(f"after '{name}': marks", results[name]["marks"], count)
        equal = data["equal"][path[0]][path[1]][path[2]]
        checks.equal(f"after '{name}': the tables of equal times and errors", results[name]["equal"],
                     [[[row["name"], *(-1 if run is None else run for run in row["runs"])] for row in equal[table]]
                      for table in ("times", "errors")])
    checks.equal("axes", results["start"]["axes"], ["time of a frame", "relMSE"])
    checks.equal("axes after all", results["with preparation"]["axes"],
                 ["time of preparation and a frame", "FLIP, reflective pixels"])
    first = sum(run["name"] == runs[0]["name"] for run in runs)
    checks.equal("marks without the first method", results["without the first method"]["marks"], count - first)


def check_chart(dom, data, checks):
    """The marks lie where logarithmic axes put them, between the first and the last."""
    number = r"(-?[\d.]+)"
    found = re.findall(rf'<g class="mark[^>]*data-run="(\d+)"[^>]*translate\({number} {number}\)', dom)
    checks.equal("marks", sorted(int(run) for run, _, _ in found), list(range(len(data["runs"]))))
    ends = {}
    for run, x, y in found:
        values = data["runs"][int(run)]
        ends[int(run)] = (seconds(values), float(x), values["errors"]["rel_mse"], float(y))
    fast, slow = min(ends.values()), max(ends.values())
    good, bad = min(ends.values(), key=lambda e: e[2]), max(ends.values(), key=lambda e: e[2])
    for run, (time, x, error, y) in ends.items():
        straight_x = fast[1] + (slow[1] - fast[1]) * log_share(time, fast[0], slow[0])
        straight_y = good[3] + (bad[3] - good[3]) * log_share(error, good[2], bad[2])
        # Places are written to a tenth of a pixel, and so are those of the two ends.
        checks.equal(f"run {run} lies on logarithmic axes ({straight_x - x:.2f}, {straight_y - y:.2f})",
                     abs(straight_x - x) < 0.2 and abs(straight_y - y) < 0.2, True)
    checks.equal("errors grow upwards", bad[3] < good[3], True)


def log_share(value, first, last):
    return math.log(value / first) / math.log(last / first)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("page", type=pathlib.Path)
    options = parser.parse_args()
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        print(f"skipped: none of {', '.join(BROWSERS)} is installed")
        return SKIPPED
    source = options.page.read_text(encoding="utf-8")
    data = json.loads(source.split(DATA_BEGIN, 1)[1].split("</script>", 1)[0])
    checks = Checks()
    dom, log = browse(browser, options.page.resolve(strict=True).as_uri())
    checks.equal("messages on the console", [line for line in log.splitlines() if "CONSOLE" in line], [])
    check_chart(dom, data, checks)
    page = Page(dom)
    checks.equal("command", page.texts.get("command"), data["command"])
    with tempfile.TemporaryDirectory(prefix="utsuri_trade_") as folder:
        copy = pathlib.Path(folder) / "trade.html"
        copy.write_text(source.replace("</body>", ACTIONS + "</body>"), encoding="utf-8")
        dom, _ = browse(browser, copy.as_uri(), "data-results")
    html = next(attributes for tag, attributes, _ in Page(dom).elements if tag == "html")
    check_actions(json.loads(html.get("data-results", "{}")), data, checks)
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main())
