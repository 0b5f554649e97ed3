// SPDX-License-Identifier: Apache-2.0
"use strict";
{
const data = JSON.parse(byId("data").textContent);
const methods = [...new Set(data.runs.map((run) => run.name))];
const hidden = new Set();
const choice = { time: "frame", metric: data.metric, pixels: "all" };
for (const [name, value] of new URLSearchParams(location.hash.slice(1))) {
    if (name in choice) choice[name] = value;
}
let shown = null;

const suffix = () => (choice.pixels === "all" ? "" : "_reflective");
const secondsOf = (run) => run.frame_seconds + (choice.time === "frame" ? 0 : run.prepare_seconds);
const errorOf = (run) => run[`errors${suffix()}`][choice.metric];
const leastError = () => data[`least_errors${suffix()}`][choice.metric] ?? 0;
const isHidden = (run) => errorOf(run) > 0 && errorOf(run) <= leastError();
const errorText = (run) => (isHidden(run) ? "< " : "") + significant(errorOf(run));
// The first two words choose the method, which has a column of its own.
const settingOf = (run) => run.options.slice(2).join(" ");
const settingsText = (run) => `${settingOf(run)} --spp ${run.settings.samples}`.trim();
const colourOf = (method) => `--colour: var(--m${methods.indexOf(method) % markShapes.length})`;

function facts(run) {
    return [["Settings", settingsText(run)], ["Frame", quantity(run.frame_seconds, "seconds")],
            ["Preparation", quantity(run.prepare_seconds, "seconds")],
            ["Compiling", quantity(run.compile_seconds, "seconds")],
            ["Memory", quantity(run.peak_bytes, "bytes")],
            ...Object.entries(data.titles).map(([name, title]) => {
                const value = run[`metrics${suffix()}`][name];
                return [`${title}${name === choice.metric ? ", as measured" : ""}`, value === null ? missing : significant(value)];
            })];
}

function show(index) {
    shown = index;
    const run = data.runs[index];
    byId("picture").src = data.pictures[index];
    byId("picture").alt = `Picture by ${run.name}, ${settingsText(run)}`;
    byId("run-name").textContent = run.name;
    byId("run-facts").replaceChildren(...definitions(facts(run)));
    byId("run-command").textContent = run.command;
    byId("copy-run").textContent = "Copy";
    for (const mark of byId("chart").querySelectorAll(".mark"))
        mark.classList.toggle("shown", Number(mark.dataset.run) === index);
}

const frontRuns = () => data.fronts[choice.time][choice.pixels][choice.metric];

function fillFrontTable() {
    const titles = ["Method", "frame", "preparation", data.titles[choice.metric], "memory", "settings"];
    const head = make("thead", {}, make("tr", {}, ...titles.map((title) =>
        make("th", { scope: "col", className: title === "settings" ? "words" : "" }, title))));
    const rows = frontRuns().map((index) => {
        const run = data.runs[index];
        const row = make("tr", {}, make("th", { scope: "row" }, run.name),
                         make("td", {}, quantity(run.frame_seconds, "seconds")),
                         make("td", {}, quantity(run.prepare_seconds, "seconds")), make("td", {}, errorText(run)),
                         make("td", {}, quantity(run.peak_bytes, "bytes")),
                         make("td", { className: "words" }, settingsText(run)));
        row.dataset.run = index;
        row.addEventListener("click", () => show(index));
        return row;
    });
    byId("front").replaceChildren(head, make("tbody", {}, ...rows));
}

/// `cellText` tells a run's number, `worth` what is least for the best of a column.
function fillEqualTable(table, heads, rows, cellText, worth) {
    const best = heads.map((_, i) => {
        const found = rows.map(({ runs }) => runs[i]).filter((run) => run !== null).map((run) => worth(data.runs[run]));
        return new Set(found).size > 1 ? Math.min(...found) : undefined;
    });
    const head = make("tr", {}, ...["Method", ...heads].map((text) => make("th", { scope: "col" }, text)));
    const cellOf = (run, i) => {
        if (run === null) return make("td", {}, missing);
        const isBest = worth(data.runs[run]) === best[i];
        const cell = make("td", { className: isBest ? "best" : "" }, cellText(data.runs[run]));
        cell.dataset.run = run;
        cell.addEventListener("click", () => show(run));
        return cell;
    };
    const body = rows.map(({ name, runs }) =>
        make("tr", {}, make("th", { scope: "row" }, name), ...runs.map(cellOf)));
    table.replaceChildren(make("thead", {}, head), make("tbody", {}, ...body));
}

function fillEqualTables() {
    const { times, errors } = data.equal[choice.time][choice.pixels][choice.metric];
    const title = data.titles[choice.metric] + (choice.pixels === "all" ? "" : " of reflective pixels");
    const spent = choice.time === "frame" ? "a frame" : "preparation and a frame";
    byId("equal-time-title").textContent = `${title} at equal times of ${spent}`;
    byId("equal-error-title").textContent = `Time of ${spent} at equal ${title}`;
    fillEqualTable(byId("equal-time"), data.equal.seconds.map((seconds) => quantity(seconds, "seconds")), times,
                   errorText, errorOf);
    fillEqualTable(byId("equal-error"), data.equal.errors.map(String), errors,
                   (run) => quantity(secondsOf(run), "seconds"), secondsOf);
}

function fillNoise() {
    const least = leastError();
    const title = data.titles[choice.metric];
    const subtracted = ["mse", "rel_mse"].includes(choice.metric) ? "; what it adds to each run is subtracted" : "";
    byId("noise").textContent = least > 0
        ? `The reference has ${whole(data.reference.settings.samples)} samples per pixel. Its noise hides ${title} below ` +
          `${significant(least)}${subtracted}. Runs that wrong or less are hollow marks and rank alike.`
        : "The reference has no noise here.";
}

function draw() {
    const drawn = data.runs.map((run, index) => ({ run, index }))
        .filter(({ run }) => errorOf(run) !== null && !hidden.has(run.name));
    const points = drawn.map(({ run, index }) => ({
        seconds: secondsOf(run), error: errorOf(run), run: index, method: methods.indexOf(run.name),
        setting: run.options.join(" "), isHidden: isHidden(run),
        label: `${run.name}, ${settingsText(run)}: ${quantity(secondsOf(run), "seconds")}, ` +
               `${data.titles[choice.metric]} ${errorText(run)}`,
    }));
    const position = new Map(points.map((point, i) => [point.run, i]));
    const front = frontRuns().filter((index) => position.has(index)).map((index) => position.get(index));
    const axis = choice.time === "frame" ? "time of a frame" : "time of preparation and a frame";
    const pixels = choice.pixels === "all" ? "" : ", reflective pixels";
    drawChart(byId("chart"), points, front, leastError(), { x: axis, y: data.titles[choice.metric] + pixels }, show);
    fillFrontTable();
    fillEqualTables();
    fillNoise();
    const first = position.has(shown) ? shown : points[front[0] ?? 0]?.run;
    if (first !== undefined) show(first);
}

function addControls() {
    byId("metric").append(...Object.entries(data.titles).map(([value, title]) => make("option", { value }, title)));
    for (const name of Object.keys(choice)) {
        byId(name).value = choice[name];
        byId(name).addEventListener("change", () => {
            choice[name] = byId(name).value;
            draw();
        });
    }
    byId("methods").append(...methods.map((method, index) => {
        const box = make("input", { type: "checkbox", checked: true });
        box.addEventListener("change", () => {
            if (box.checked) hidden.delete(method);
            else hidden.add(method);
            draw();
        });
        const icon = svgElement("svg", { viewBox: "-8 -8 16 16", style: colourOf(method), "aria-hidden": "true" },
                                svgElement("path", { d: markShapes[index % markShapes.length] }));
        return make("label", {}, box, icon, method);
    }));
}

function fillFacts() {
    const { device, reference } = data;
    document.title = `${fileName(data.scene)} – Utsuri trade`;
    byId("scene").textContent = fileName(data.scene);
    byId("summary").textContent = [
        device.name, `${data.width} × ${data.height} pixels`, `${data.runs.length} runs`,
        `reference ${reference.name}, ${whole(reference.settings.samples)} samples`].join(" · ");
    byId("interrupted").hidden = !data.interrupted;
    byId("failed").hidden = data.failed.length === 0;
    byId("failed-list").append(...data.failed.map((f) => make("li", {}, `${f.options.join(" ")}: ${f.message}`)));
    byId("command").textContent = data.command;
    byId("facts").append(...definitions([
        ["Scene", data.scene], ["Triangles", whole(data.triangles)],
        ["Reflective pixels", whole(data.reflective_pixels)],
        ["Scene memory", `${quantity(data.scene_bytes, "bytes")} on the device`],
        ["BVH", quantity(data.build_seconds, "seconds")],
        ["Reference", quantity(reference.frame_seconds, "seconds")],
        ["Device", `${device.name}; ${device.driver}; Vulkan ${device.api}`],
        ["Seed", String(data.seed)], ["Utsuri", data.utsuri]]));
    byId("notes").hidden = data.notes.length === 0;
    byId("note-list").append(...data.notes.map((note) => make("li", {}, note)));
}

fillFacts();
addControls();
draw();
for (const [button, text] of [["copy", "command"], ["copy-run", "run-command"]])
    byId(button).addEventListener("click", () => copyText(byId(button), byId(text)));
document.documentElement.dataset.ready = "true";
}
