#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the tables and pictures of docs/trade.md from what `utsuri trade` measured.

Usage: trade_document.py DOCUMENT FOLDER...

Each FOLDER is an output folder of `utsuri trade`. In DOCUMENT, what stands between <!-- trade SCENE --> and <!-- end -->
is replaced by that scene's figures, and between <!-- trade summary --> and <!-- end --> by a table of all of them, in the
order of the folders. Pictures go to images/trade beside DOCUMENT.
"""
import argparse
import base64
import json
import pathlib
import re

METRIC = "flip"
TITLE = "FLIP"
PICTURES_A_ROW = 4


def read_page(folder):
    """The values that trade.html carries: trade.json, pictures, and the tables at equal times and errors."""
    page = (folder / "trade.html").read_text(encoding="utf-8")
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)[1])


def scene_name(trade):
    return pathlib.Path(trade["scene"]).stem


def seconds_text(seconds):
    if seconds >= 1.0:
        return f"{seconds:.3g} s"
    return f"{1e3 * seconds:.3g} ms"


def error_text(trade, run):
    least = trade["least_errors_reflective"][METRIC]
    error = run["errors_reflective"][METRIC]
    return ("< " if error <= least else "") + f"{error:.2g}"


def map_size(trade):
    """The size of maps that was asked for: the largest one tried."""
    return max((int(run["options"][3]) for run in trade["runs"]
                if "--map-size" in run["options"] and run["options"][3] != "fit"), default=0)


def plain_runs(trade):
    """Of each method the run with the most samples at the size of maps asked for, one capture point, polygons as modelled
    and the tolerance asked for: by name, in the order of measuring, with its place among the runs."""
    size = map_size(trade)
    plain = {}
    for index, run in enumerate(trade["runs"]):
        options = run["options"]
        fixed = ["--reflection", run["reflection"]]
        if run["reflection"] != "trace":
            fixed += ["--map-size", str(size)]
        if run["reflection"] == "hybrid":
            fixed += ["--tolerance", "1"]
        best = plain.get(run["name"])
        if options == fixed and (best is None or run["settings"]["samples"] > best[1]["settings"]["samples"]):
            plain[run["name"]] = (index, run)
    return plain


def tolerance_rows(trade):
    """Of hybrid, at each tolerance with the maps of plain_runs(): the run with the most samples."""
    of_trace = next(run for _, run in plain_runs(trade).values() if run["reflection"] == "trace")
    runs = {}
    for run in trade["runs"]:
        words = run["options"]
        if words[:5] == ["--reflection", "hybrid", "--map-size", str(map_size(trade)), "--tolerance"] and len(words) == 6:
            runs[float(words[5])] = run
    return [[f"{tolerance:g}", f"{100.0 * run['traced_fraction']:.0f} %", seconds_text(sample_seconds(run)),
             f"{sample_seconds(of_trace) / sample_seconds(run):.1f}", error_text(trade, run)]
            for tolerance, run in sorted(runs.items())]


def sample_seconds(run):
    return run["frame_seconds"] / run["settings"]["samples"]


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def table(head, rows):
    return row(head) + "|" + "---|" * len(head) + "\n" + "".join(map(row, rows)) + "\n"


def short_name(name):
    return "`" + name.split("/")[1] + "`"


def equal_table(trade, kind, head, cell):
    """@param cell text of a run, and what the best one of a column has least"""
    lines = trade["equal"]["frame"]["reflective"][METRIC][kind]
    rows = []
    for line in lines:
        cells = [short_name(line["name"])]
        for column, index in enumerate(line["runs"]):
            if index is None:
                cells.append("-")
                continue
            rivals = [trade["runs"][other["runs"][column]] for other in lines if other["runs"][column] is not None]
            text, value = cell(trade["runs"][index])
            is_best = value <= min(cell(rival)[1] for rival in rivals)
            cells.append(f"**{text}**" if is_best else text)
        rows.append(cells)
    reached = [0] + [column for column in range(1, len(head) + 1) if any(cells[column] != "-" for cells in rows)]
    lines = [[""] + head] + rows
    kept = [[cells[column] for column in reached] for cells in lines]
    return table(kept[0], kept[1:])


def picture_table(trade, document):
    folder = document.parent / "images" / "trade"
    folder.mkdir(parents=True, exist_ok=True)
    cells = []
    for name, (index, run) in plain_runs(trade).items():
        file = folder / f"{scene_name(trade)}_{run['reflection']}.jpg"
        file.write_bytes(base64.b64decode(trade["pictures"][index].split(",", 1)[1]))
        cells.append(f"![{name}]({file.relative_to(document.parent).as_posix()})<br>{short_name(name)}, "
                     f"{error_text(trade, run)}")
    lines = [cells[first:first + PICTURES_A_ROW] for first in range(0, len(cells), PICTURES_A_ROW)]
    return table([" "] * PICTURES_A_ROW, lines)


def scene_section(trade, document):
    pixels = trade["width"] * trade["height"]
    plain = plain_runs(trade)
    samples = max(run["settings"]["samples"] for _, run in plain.values())
    text = (f"{trade['triangles']} triangles, {100.0 * trade['reflective_pixels'] / pixels:.0f} % of the pixels reflective. "
            f"Pictures of {samples} samples, each with its {TITLE} over reflective pixels:\n\n")
    text += picture_table(trade, document)
    equal = trade["equal"]
    text += f"{TITLE} over reflective pixels, at equal times of a frame:\n\n"
    text += equal_table(trade, "times", [seconds_text(seconds) for seconds in equal["seconds"]],
                        lambda run: (error_text(trade, run), run["errors_reflective"][METRIC]))
    text += f"Time of a frame, at equal {TITLE} over reflective pixels:\n\n"
    text += equal_table(trade, "errors", [f"{error:g}" for error in equal["errors"]],
                        lambda run: (seconds_text(run["frame_seconds"]), run["frame_seconds"]))
    text += "`hybrid` at tolerances in pixels:\n\n"
    text += table(["tolerance", "traced", "a sample", "times faster than `trace`", f"{TITLE}, reflective"],
                  tolerance_rows(trade))
    return text


def summary(trades):
    text = ""
    for title, cell in (
            ("Time of one sample of all pixels", lambda trade, run: seconds_text(sample_seconds(run))),
            (f"{TITLE} over reflective pixels", error_text),
            ("relMSE over reflective pixels, less the reference's noise",
             lambda trade, run: f"{run['errors_reflective']['rel_mse']:.2g}")):
        plain = [plain_runs(trade) for trade in trades]
        rows = [[short_name(name)] + [cell(trade, runs[name][1]) if name in runs else "-"
                                      for trade, runs in zip(trades, plain)] for name in plain[0]]
        text += f"{title}:\n\n" + table([""] + [scene_name(trade) for trade in trades], rows)
    return text


def replace_section(text, name, section):
    pattern = re.compile(rf"(<!-- trade {re.escape(name)} -->\n).*?(<!-- end -->)", re.S)
    if not pattern.search(text):
        raise SystemExit(f"the document has no place for '{name}': <!-- trade {name} --> and <!-- end -->")
    return pattern.sub(lambda match: match[1] + section + match[2], text)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("document", type=pathlib.Path)
    parser.add_argument("folders", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()
    trades = [read_page(folder) for folder in arguments.folders]
    text = arguments.document.read_text(encoding="utf-8")
    for trade in trades:
        text = replace_section(text, scene_name(trade), scene_section(trade, arguments.document))
    text = replace_section(text, "summary", summary(trades))
    arguments.document.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
