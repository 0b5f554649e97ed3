// SPDX-License-Identifier: Apache-2.0
"use strict";
// What the scripts of all pages share.

const byId = (id) => document.getElementById(id);

/// An element with properties (or attributes, where there is no such property) and children. Names from the
/// data reach the page only as text, never as markup.
function make(tag, properties = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(properties)) {
        if (value === undefined) continue;
        if (name in element) element[name] = value;
        else element.setAttribute(name, value);
    }
    element.append(...children.filter((child) => child !== undefined));
    return element;
}

const definitions = (pairs) => pairs.flatMap(([term, text]) => [make("dt", {}, term), make("dd", {}, text)]);

const missing = "–";
const thinSpace = "\u202f";
const units = {
    seconds: [[1, "s"], [1e-3, "ms"], [1e-6, "µs"]],
    bytes: [[2 ** 30, "GiB"], [2 ** 20, "MiB"], [2 ** 10, "KiB"], [1, "B"]],
    count: [[1e9, "billion"], [1e6, "million"], [1e3, "thousand"], [1, ""]],
    percent: [[0.01, "%"]],
    one: [[1, ""]],
};
const grouped = (text) => text.replace(/\B(?=(\d{3})+(?!\d))/g, thinSpace);
const whole = (value) => grouped(Math.round(value).toString());
const exponentOf = (value) => Math.floor(Math.log10(Math.abs(value)));
const isWhole = (kind, size) => size === 1 && kind !== "seconds";
const chooseUnit = (kind, largest) =>
    (largest === 0 ? units[kind][0] : units[kind].find(([size]) => largest >= size) ?? units[kind].at(-1));

/// Three significant digits; powers of ten where zeros would hide the size.
function significant(value) {
    if (value === 0) return "0";
    const exponent = exponentOf(value);
    if (exponent < -3 || exponent > 5) {
        const [mantissa, power] = value.toExponential(2).split("e");
        const raised = [...power.replace("+", "")].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c])).join("");
        return `${mantissa}${thinSpace}×${thinSpace}10${raised}`;
    }
    return exponent > 1 ? whole(value) : value.toFixed(2 - exponent);
}

function quantity(value, kind) {
    if (value === null) return missing;
    const [size, name] = chooseUnit(kind, Math.abs(value));
    return `${isWhole(kind, size) ? whole(value) : significant(value / size)} ${name}`.trim();
}

/// One unit and one number of decimals for a column, so that its numbers compare at a glance.
function columnFormat(kind, values) {
    const present = values.filter((value) => value !== null && value !== 0).map(Math.abs);
    const [size, name] = chooseUnit(kind, Math.max(0, ...present));
    const exponents = present.map((value) => exponentOf(value / size));
    const wanted = 2 - Math.min(2, ...exponents);
    const decimals = isWhole(kind, size) ? 0 : Math.min(wanted, 3);
    const digits = (value) => {
        const text = decimals > 0 ? value.toFixed(decimals) : whole(value);
        return value !== 0 && Number(text) === 0 ? significant(value) : text;
    };
    return { unit: name, format: (value) => (value === 0 ? "0" : digits(value / size)) };
}

const fileName = (path) => path.split(/[\\/]/).filter(Boolean).at(-1) ?? path;

/// Puts an element's text on the clipboard and says so on the button.
async function copyText(button, element) {
    try {
        await navigator.clipboard.writeText(element.textContent);
        button.textContent = "Copied";
    } catch {
        // Without permission the text is selected, ready for the reader's own copy command.
        getSelection().selectAllChildren(element);
    }
}
