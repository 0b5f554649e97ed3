// SPDX-License-Identifier: Apache-2.0
"use strict";

/// A shape for each method, so that colour is not all that tells them apart: paths about the origin.
const markShapes = [
    "M-5 0A5 5 0 1 0 5 0A5 5 0 1 0-5 0Z", "M-4.5-4.5H4.5V4.5H-4.5Z", "M0-6L5.5 4.5H-5.5Z", "M0-6.2L6.2 0L0 6.2L-6.2 0Z",
    "M0 6L5.5-4.5H-5.5Z", "M-6-2H-2V-6H2V-2H6V2H2V6H-2V2H-6Z",
    "M-5.5-3.2L0-6.4L5.5-3.2V3.2L0 6.4L-5.5 3.2Z", "M-6 0L-1.8-1.8L0-6L1.8-1.8L6 0L1.8 1.8L0 6L-1.8 1.8Z",
];

function svgElement(tag, attributes = {}, ...children) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
}

/// A logarithmic scale that holds all of `values`, which are positive, from pixel `from` to pixel `to`.
function logScale(values, from, to) {
    const margin = 0.08;  // of a decade
    const first = Math.log10(Math.min(...values)) - margin;
    const last = Math.log10(Math.max(...values)) + margin;
    const at = (value) => from + (to - from) * (Math.log10(value) - first) / (last - first);
    const ticks = [];
    for (let decade = Math.floor(first); decade <= last; ++decade) {
        const steps = last - first < 2.5 ? [1, 2, 5] : [1];
        ticks.push(...steps.map((step) => step * 10 ** decade));
    }
    return { at, ticks: ticks.filter((tick) => Math.log10(tick) >= first && Math.log10(tick) <= last) };
}

/// Draws points {seconds, error, run, method, setting, isHidden, label} into `svg` and joins those of a
/// setting. `front` are indices of points, ascending in time; `least` is where the noise begins, 0 for none.
/// `onShow` is called with the run of the mark that is pointed at or focused.
function drawChart(svg, points, front, least, titles, onShow) {
    const box = { left: 78, right: 745, top: 18, bottom: 440 };
    svg.replaceChildren();
    if (points.length === 0) {
        svg.append(svgElement("text", { x: 380, y: 240, "text-anchor": "middle" }, "There is no such pixel."));
        return [];
    }
    // An error of 0 has no place on a logarithmic axis: it is shown at the lower edge.
    const errors = points.map((p) => p.error).filter((error) => error > 0);
    const floor = least > 0 ? least : errors.length > 0 ? Math.min(...errors) / 2 : 1;
    const x = logScale(points.map((p) => p.seconds), box.left, box.right);
    const y = logScale([...errors, floor], box.bottom, box.top);
    const place = (p) => [x.at(p.seconds), p.error > 0 ? y.at(p.error) : box.bottom];
    drawAxes(svg, box, x, y, titles);
    if (least > 0) {
        const top = y.at(least);
        svg.append(svgElement("rect", { class: "noise", x: box.left, y: top, width: box.right - box.left,
                                        height: box.bottom - top }));
    }
    drawLines(svg, box, points, front, place);
    const marks = points.map((p) => drawMark(p, place(p)));
    svg.append(...marks);
    followMarks(marks, points, onShow);
    return marks;
}

function drawAxes(svg, box, x, y, titles) {
    for (const tick of x.ticks) {
        const at = x.at(tick);
        svg.append(svgElement("line", { class: "gridline", x1: at, x2: at, y1: box.top, y2: box.bottom }),
                   svgElement("text", { x: at, y: box.bottom + 20, "text-anchor": "middle" }, tickText(tick, "seconds")));
    }
    for (const tick of y.ticks) {
        const at = y.at(tick);
        svg.append(svgElement("line", { class: "gridline", x1: box.left, x2: box.right, y1: at, y2: at }),
                   svgElement("text", { x: box.left - 8, y: at + 4, "text-anchor": "end" }, tickText(tick, "one")));
    }
    const middle = (box.top + box.bottom) / 2;
    svg.append(svgElement("text", { class: "title", x: (box.left + box.right) / 2, y: box.bottom + 46,
                                    "text-anchor": "middle" }, titles.x),
               svgElement("text", { class: "title", x: 0, y: 0, "text-anchor": "middle",
                                    transform: `translate(20 ${middle}) rotate(-90)` }, titles.y));
}

/// 1, 2 or 5 of a unit, without the zeros of measured numbers.
function tickText(value, kind) {
    if (kind === "one") return value >= 1e-3 && value < 1e4 ? String(Number(value.toPrecision(1))) : value.toExponential(0);
    const [size, name] = chooseUnit(kind, value * (1 + 1e-9));
    return `${Number((value / size).toPrecision(1))}${thinSpace}${name}`;
}

function drawLines(svg, box, points, front, place) {
    const line = (list) => list.map(([px, py], i) => `${i ? "L" : "M"}${px.toFixed(1)} ${py.toFixed(1)}`).join("");
    for (const setting of new Set(points.map((p) => p.setting))) {
        const own = points.filter((p) => p.setting === setting);
        svg.append(svgElement("path", { class: "setting", d: line(own.map(place)),
                                        style: `--colour: var(--m${own[0].method % markShapes.length})` }));
    }
    const steps = [];
    for (const index of front) {
        const [px, py] = place(points[index]);
        if (steps.length > 0) steps.push([px, steps.at(-1)[1]]);
        steps.push([px, py]);
    }
    if (steps.length > 0) steps.push([box.right, steps.at(-1)[1]]);
    svg.append(svgElement("path", { class: "front", d: line(steps) }));
}

function drawMark(point, [px, py]) {
    const shape = point.method % markShapes.length;
    return svgElement("g", { class: `mark${point.isHidden ? " hidden-in-noise" : ""}`, role: "img", tabindex: -1,
                             "aria-label": point.label, "data-run": point.run, style: `--colour: var(--m${shape})`,
                             transform: `translate(${px.toFixed(1)} ${py.toFixed(1)})` },
                      svgElement("circle", { r: 10 }), svgElement("path", { d: markShapes[shape] }));
}

/// One stop of the tab key for all marks; the arrow keys move among them by time and by error.
function followMarks(marks, points, onShow) {
    const orders = ["seconds", "error"].map((by) => points.map((_, i) => i).sort((a, b) =>
        points[a][by] - points[b][by] || points[a].seconds - points[b].seconds || a - b));
    const moves = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [1, 1], ArrowDown: [1, -1] };
    const step = (index, key) => {
        if (key === "Home") return orders[0][0];
        if (key === "End") return orders[0].at(-1);
        const [order, direction] = moves[key];
        return orders[order][orders[order].indexOf(index) + direction] ?? index;
    };
    marks[orders[0][0]].setAttribute("tabindex", 0);
    marks.forEach((mark, index) => {
        mark.addEventListener("pointerenter", () => onShow(points[index].run));
        mark.addEventListener("click", () => mark.focus());
        mark.addEventListener("focus", () => {
            for (const other of marks) other.setAttribute("tabindex", other === mark ? 0 : -1);
            onShow(points[index].run);
        });
        mark.addEventListener("keydown", (event) => {
            if (!(event.key in moves) && event.key !== "Home" && event.key !== "End") return;
            event.preventDefault();
            marks[step(index, event.key)].focus();
        });
    });
}
