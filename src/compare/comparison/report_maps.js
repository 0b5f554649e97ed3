// SPDX-License-Identifier: Apache-2.0
"use strict";

/// Places are told to a hundredth of a pixel at best.
const displacementText = (value) => (value > 0 && value < 0.01 ? "< 0.01" : significant(value));

/// What a report can show of each method beside its picture: error maps, and how far off reflections are. Each
/// {key, title, of, lead, has, caption, legend}: `key` is the picture's under "pictures" in `data`, `of` what its
/// name begins with, `lead` what it is, `has` whether a method's result tells it. A legend is {title, make}; equal
/// ones are one object.
function reportMaps(data) {
    const { colours } = data.pictures;
    const percent = (share) => `${significant(100 * share)}${thinSpace}%`;
    const pixels = (value) => (value === null ? "unknown" : `${displacementText(value)}${thinSpace}px`);
    const spread = ({ median, p95 }) => `median ${pixels(median)}, 95${thinSpace}% within ${pixels(p95)}`;

    function scaleOf(image, alt, ticks) {
        const marks = ticks.map(({ share, text }) => {
            const mark = make("span", {}, text);
            mark.style.left = `${100 * share}%`;
            return mark;
        });
        return [make("img", { className: "scale", src: image, alt }),
                make("div", { className: "ticks", ariaHidden: "true" }, ...marks)];
    }

    function swatch(colour, text) {
        const box = make("span", { className: "swatch" });
        box.style.background = colour;
        return make("span", {}, box, text);
    }
    const swatches = (...pairs) =>
        make("div", { className: "swatches" }, ...pairs.map(([colour, text]) => swatch(colour, text)));

    const flip = {
        title: "FLIP error",
        make: () => scaleOf(data.pictures.error_scale, "Colours of the errors from 0 to 1",
                            [{ share: 0, text: "0" }, { share: 1, text: "1" }]),
    };

    function displacementParts() {
        const { image, least, most } = data.pictures.displacement_scale;
        const ticks = [];
        for (let power = Math.round(Math.log10(least)); power <= Math.round(Math.log10(most)); ++power) {
            const value = 10 ** power;
            const number = Number(value.toPrecision(1));
            const text = value <= least ? `≤ ${number}` : value >= most ? `≥ ${number}${thinSpace}px` : `${number}`;
            const share = Math.log(value / least) / Math.log(most / least);
            ticks.push({ share, text });
        }
        return [...scaleOf(image, `Colours of displacements from ${least} to ${most} pixels`, ticks),
                swatches([colours.left_out, "no mirror"])];
    }
    const displacement = { title: "Reflections off their places, in pixels", make: displacementParts };

    const traced = {
        title: "Reflections",
        make: () => [swatches([colours.traced, "traced"], [colours.looked_up, "looked up"],
                              [colours.left_out, "no mirror"])],
    };

    return [
        { key: "error_map", title: "FLIP error", of: "FLIP error of", has: () => true, legend: flip,
          lead: "Beneath each method is its FLIP error: what an observer notices who flips between the method and the " +
                "reference, 0 nothing, 1 the most there is.",
          caption: ({ metrics: { flip: mean } }) =>
              (mean === null ? "FLIP not measured" : `FLIP ${mean.toFixed(4)} on average`) },
        { key: "predicted", title: "predicted error", of: "Predicted error of", legend: displacement,
          lead: "By how many pixels what mirrors show is off its place, at most, as each method predicts without " +
                "following rays.",
          has: (result) => result.reflection_errors !== undefined,
          caption: ({ reflection_errors: errors }) => spread(errors.predicted) },
        { key: "measured", title: "measured error", of: "Measured error of", legend: displacement,
          lead: "By how many pixels what mirrors show is off its place, as rays measure it.",
          has: (result) => result.reflection_errors !== undefined,
          caption: ({ reflection_errors: errors }) => spread(errors.measured) },
        { key: "traced", title: "traced pixels", of: "Traced pixels of", legend: traced,
          lead: "Which reflections are traced, since maps are predicted to be off by more than the tolerance.",
          has: (result) => result.reflection_errors?.traced !== undefined,
          caption: ({ reflection_errors: { pixels: seen, traced: { pixels: followed } } }) =>
              (seen > 0 ? `${percent(followed / seen)} of the mirror pixels traced` : "no mirror is seen") },
    ];
}
