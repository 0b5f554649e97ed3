// SPDX-License-Identifier: Apache-2.0
"use strict";
{
const data = JSON.parse(document.getElementById("data").textContent);
const results = [data.reference, ...data.methods];
// ---- tables ----
const secondsPerSample = (r) => (r.settings.samples > 0 ? r.frame_seconds / r.settings.samples : null);

/// `best` says which end of a column is good: "least", "most" or undefined.
const costColumns = [
    { title: "samples", kind: "one", value: (r) => r.settings.samples, hint: "of every pixel" },
    { title: "prepare", kind: "seconds", value: (r) => r.prepare_seconds, best: "least",
      hint: "capturing maps and the like, once, before the first frame; compiling excluded" },
    { title: "compile", kind: "seconds", value: (r) => r.compile_seconds,
      hint: "compiling pipelines, once; little if the driver has met them before, so nobody wins here" },
    { title: "frame", kind: "seconds", value: (r) => r.frame_seconds, best: "least",
      hint: "wall time of all samples together" },
    { title: "per sample", kind: "seconds", value: secondsPerSample, best: "least",
      hint: "the same for one sample of every pixel: what a frame costs in motion" },
    { title: "device", kind: "seconds", value: (r) => r.gpu_seconds, best: "least",
      hint: "of the frame time, by the device's own clock" },
    { title: "memory", kind: "bytes", value: (r) => r.peak_bytes, best: "least",
      hint: "most device memory at a time, the scene included" },
    { title: "rays", kind: "count", value: (r) => r.rays,
      hint: "queries of the scene during the frame, shadow rays included" },
    { title: "traced", kind: "percent", value: (r) => r.traced_fraction,
      hint: "of the reflections looked up, those that followed a ray" },
    { title: "truncated", kind: "percent", value: (r) => r.truncated_fraction,
      hint: "of the reflections looked up, those cut at the depth bound" },
    { title: "non-finite", kind: "one", value: (r) => r.nonfinite, bad: (value) => value > 0,
      hint: "samples that were not finite numbers and were left out" },
];
const fixed = (digits) => (value) => value.toFixed(digits);
const errorColumns = [
    { title: "FLIP", key: "flip", best: "least", format: fixed(4) },
    { title: "relMSE", key: "rel_mse", best: "least", format: significant },
    { title: "MAPE", unit: "%", key: "mape", best: "least", format: (value) => significant(100 * value) },
    { title: "MSE", key: "mse", best: "least", format: significant },
    { title: "PSNR", unit: "dB", key: "psnr", best: "most", format: fixed(2) },
    { title: "SSIM", key: "ssim", best: "most", format: fixed(4) },
    { title: "p99.9", key: "p999", best: "least", format: significant },
    { title: "max", key: "max", best: "least", format: significant },
];

/// The winner of a column; undefined if there is nothing to win.
function bestOf(column, values) {
    const present = values.filter((value) => value !== null);
    if (column.best === undefined || new Set(present).size < 2) return undefined;
    return column.best === "most" ? Math.max(...present) : Math.min(...present);
}

function headRow(columns, first) {
    const unit = (c) => (c.unit ? make("span", { className: "unit" }, c.unit) : undefined);
    const cells = columns.map((c) => make("th", { scope: "col" }, c.title, unit(c)));
    return make("thead", {}, make("tr", {}, make("th", { scope: "col" }, first), ...cells));
}

function cell(column, value, best) {
    const classes = [value !== null && value === best ? "best" : "", column.bad?.(value) ? "bad" : ""];
    return make("td", { className: classes.join(" ").trim() }, value === null ? missing
        : value === Infinity ? "∞" : column.format(value));
}

const rowHead = (text) => make("th", { scope: "row" }, text);

function fillCostTable() {
    const columns = costColumns.map((c) => ({ ...c, ...columnFormat(c.kind, results.map(c.value)) }));
    const best = columns.map((c) => bestOf(c, data.methods.map(c.value)));
    const rows = results.map((result, index) => make("tr",
        { className: index === 0 ? "reference" : "method" },
        rowHead(index === 0 ? "reference" : result.name),
        ...columns.map((c, i) => cell(c, c.value(result), index === 0 ? undefined : best[i]))));
    byId("cost").append(headRow(columns, "Method"), make("tbody", {}, ...rows));
    byId("cost-notes").append(
        make("li", {}, `Highlighted: the best method of a column. The reference is ${data.reference.name}${data.kept_light ? ", lit from the light kept on surfaces" : ""}.`));
    byId("cost-legend").append(...definitions(costColumns.map((c) => [c.title, c.hint])));
}

/// Equal pictures have an infinite PSNR, which JSON cannot hold.
function metric(metrics, key) {
    return key === "psnr" && metrics.psnr === null && metrics.pixels > 0 ? Infinity : metrics[key];
}

/// As kReferenceShare in reference.h: above this share of an error the reference's own noise makes it uncertain.
const referenceShare = 0.1;
const noiseIsKnown = data.reference.noise_mse !== null;
const withinNoise = (mse) => noiseIsKnown && mse !== null && data.reference.noise_mse > referenceShare * mse;

function errorGroup(title, key, markNoise) {
    const metricsOf = (c) => data.methods.map((method) => metric(method[key], c.key));
    const best = errorColumns.map((c) => bestOf(c, metricsOf(c)));
    const rows = data.methods.map((method) => {
        const cells = errorColumns.map((c, i) => cell(c, metric(method[key], c.key), best[i]));
        const mse = errorColumns.findIndex((c) => c.key === "mse");
        if (markNoise && withinNoise(method[key].mse)) cells[mse].append(make("small", {}, "noise"));
        return make("tr", { className: "method" }, rowHead(method.name), ...cells);
    });
    const head = make("th", { scope: "rowgroup", colSpan: errorColumns.length + 1 }, title);
    return make("tbody", {}, make("tr", { className: "group" }, head), ...rows);
}

function noiseRow() {
    const relative = data.reference.noise;
    const text = noiseIsKnown
        ? `Its own noise: MSE ${significant(data.reference.noise_mse)}, a standard error of ` +
          `${significant(100 * relative)}${thinSpace}% of the mean.`
        : "Its own noise was not estimated; that takes an even number of samples.";
    return make("tr", { className: "reference" }, rowHead("reference"),
                make("td", { className: "prose", colSpan: errorColumns.length }, make("div", {}, text)));
}

function fillErrorTable() {
    const frame = data.width * data.height;
    const reflective = data.reflective_pixels;
    const share = `${significant(100 * reflective / frame)}${thinSpace}%`;
    const table = byId("error");
    table.append(headRow(errorColumns, "Method"), make("tbody", {}, noiseRow()));
    if (data.methods.length === 0) return;
    const reflectiveTitle = `Reflective pixels, ${whole(reflective)} (${share} of the frame)`;
    table.append(errorGroup(`Whole frame, ${whole(frame)} pixels`, "metrics", true),
                 errorGroup(reflectiveTitle, "metrics_reflective", false));
    const notes = ["Highlighted: the best method of a column."];
    if (data.methods.some((m) => withinNoise(m.metrics.mse))) {
        notes.push("“noise”: more than a tenth of this MSE is the reference's own. A longer --reference-time or a " +
                   "larger --reference-spp tells more.");
    }
    if (reflective === 0) {
        notes.push(`${missing} no reflective pixel in this view, so there is nothing to measure.`);
    }
    for (const { name, metrics } of data.methods.filter((m) => m.metrics.nonfinite > 0)) {
        notes.push(`${name}: ${whole(metrics.nonfinite)} pixels are not finite and are left out.`);
    }
    byId("error-notes").append(...notes.map((note) => make("li", {}, note)));
}

const displacementColumns = [
    { title: "predicted", unit: "median, px", best: "least", value: (e) => e.predicted.median },
    { title: "predicted", unit: "p95, px", best: "least", value: (e) => e.predicted.p95 },
    { title: "measured", unit: "median, px", best: "least", value: (e) => e.measured.median },
    { title: "measured", unit: "p95, px", best: "least", value: (e) => e.measured.p95 },
    { title: "exceeded", unit: "% of pixels", format: significant, value: (e) => 100 * e.exceeded },
    { title: "found in", unit: "s", format: significant, value: (e) => e.seconds },
];

function fillDisplacementTable() {
    const told = data.methods.filter((method) => method.reflection_errors !== undefined);
    byId("displacement-section").hidden = told.length === 0;
    if (told.length === 0) return;
    const columns = displacementColumns.map((c) => ({ format: displacementText, ...c }));
    const best = columns.map((c) => bestOf(c, told.map((m) => c.value(m.reflection_errors))));
    const rows = told.map((method) => make("tr", { className: "method" }, rowHead(method.name),
        ...columns.map((c, i) => cell(c, c.value(method.reflection_errors), best[i]))));
    byId("displacement").append(headRow(columns, "Method"), make("tbody", {}, ...rows));
    const notes = [
        `Of the ${whole(told[0].reflection_errors.pixels)} pixels that show a mirror at their centre. p95: 95 of 100 ` +
            `are off by no more; ${missing} more than can be told.`,
        "Exceeded: pixels that are off by more than predicted.",
        "Found in: the time that predicting and measuring took, apart from all times above."];
    const others = data.methods.filter((method) => method.reflection_errors === undefined).map(({ name }) => name);
    if (others.length > 0) notes.push(`Tells no prediction: ${others.join(", ")}.`);
    byId("displacement-notes").append(...notes.map((note) => make("li", {}, note)));
}

// ---- pictures ----
const maps = reportMaps(data).map((map) => ({
    ...map, results: data.methods.filter((result, index) => map.has(result) && data.pictures.methods[index][map.key]),
})).filter((map) => map.results.length > 0);
const picturesOf = (result) => data.pictures.methods[data.methods.indexOf(result)];
const isReference = (result) => result === data.reference;
const imageOf = (result) => (isReference(result) ? data.pictures.reference : picturesOf(result).image);
const nameOf = (result) => (isReference(result) ? "reference" : result.name);

function mapFigure(result, map) {
    if (!map.results.includes(result)) {
        return make("figure", { className: "none" }, `Tells no ${map.title}.`);
    }
    const alt = `Map: ${map.title} of ${result.name}`;
    return make("figure", {}, make("img", { src: picturesOf(result)[map.key], alt }), ...map.legend.make(),
                make("figcaption", {}, map.caption(result)));
}

function card(result, map) {
    const time = `${quantity(result.frame_seconds, "seconds")}, ${whole(result.settings.samples)} samples`;
    const parts = [make("h3", {}, nameOf(result))];
    if (imageOf(result)) {
        parts.push(make("figure", {}, make("img", { src: imageOf(result), alt: `Picture by ${nameOf(result)}` }),
                        make("figcaption", {}, time)));
    }
    if (map && !isReference(result)) parts.push(mapFigure(result, map));
    return make("article", {}, ...parts);
}

function fillPictures() {
    const choice = byId("map-choice");
    byId("map-controls").hidden = maps.length < 2;
    choice.append(...maps.map((map) => new Option(map.title)));
    const fill = () => {
        const map = maps[choice.selectedIndex];
        byId("map-lead").textContent = map?.lead ?? "";
        byId("pictures").replaceChildren(...results.map((result) => card(result, map)));
    };
    choice.addEventListener("change", fill);
    fill();
}

// ---- facts ----
function fillFacts() {
    const { reference, device } = data;
    document.title = `${fileName(data.scene)} – Utsuri comparison`;
    byId("scene").textContent = fileName(data.scene);
    const methodSamples = [...new Set(data.methods.map((m) => m.settings.samples))].join(" or ");
    byId("summary").textContent = [
        device.name, `${data.width} × ${data.height} pixels`,
        ...(methodSamples ? [`${methodSamples} samples a pixel`] : []),
        `reference ${whole(reference.settings.samples)} samples`,
        `specular chains of at most ${data.specular_depth} reflections`, `${data.light} light${data.kept_light ? ", kept on surfaces in all pictures" : ""}`].join(" · ");
    byId("interrupted").hidden = !data.interrupted;
    byId("failed").hidden = data.failed.length === 0;
    byId("failed-list").append(...data.failed.map((f) => make("li", {}, `${f.name}: ${f.message}`)));
    byId("command").textContent = data.command;
    const facts = [
        ["Scene", data.scene], ["Triangles", whole(data.triangles)],
        ["Scene memory", `${quantity(data.scene_bytes, "bytes")} on the device`],
        ["Import", quantity(data.import_seconds, "seconds")],
        ["BVH", quantity(data.build_seconds, "seconds")],
        ["Device", `${device.name}; ${device.driver}; Vulkan ${device.api}`],
        ["Exposure of the pictures", `${significant(data.exposure).replace("-", "−")} stops`],
        ["Seed", String(data.seed)], ["Utsuri", data.utsuri]];
    byId("facts").append(...definitions(facts));
    byId("notes").hidden = data.notes.length === 0;
    byId("note-list").append(...data.notes.map((note) => make("li", {}, note)));
}

function viewerPictures() {
    const shown = results.filter(imageOf).map((result) => ({
        name: nameOf(result), image: imageOf(result), alt: `Picture by ${nameOf(result)}`, group: "picture",
        isApproximate: !isReference(result) && result.reflection !== "trace",
    }));
    return [...shown, ...maps.flatMap((map) => map.results.map((result) => ({
        name: `${map.of} ${result.name}`, image: picturesOf(result)[map.key], group: map.title,
        alt: `Map: ${map.title} of ${result.name}`, legend: map.legend,
    })))];
}

fillFacts();
fillPictures();
fillCostTable();
fillErrorTable();
fillDisplacementTable();
byId("copy").addEventListener("click", () => copyText(byId("copy"), byId("command")));
startViewer(viewerPictures(), data.width, data.height)
    .then(() => { document.documentElement.dataset.ready = "true"; });
}
