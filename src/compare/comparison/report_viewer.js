// SPDX-License-Identifier: Apache-2.0
"use strict";

/// Two of `pictures`, each {name, image, alt, isApproximate, group, legend}, under one divider, zoomed and moved
/// together. They are chosen by group; those with a `legend`, {title, make}, show what it makes.
/// `width` and `height` are theirs in pixels. The address may say how to start, for example
/// #divider=25&zoom=4&left=reference
/// @return a promise that is kept once both pictures can be seen
function startViewer(pictures, width, height) {
    const maxZoom = 32;
    const widestScale = 2;  // small pictures are not blown up further than this
    const tallest = 0.85;   // of the window, so that the whole picture is seen at once
    const byId = (id) => document.getElementById(id);
    const stage = byId("stage");
    const divider = byId("divider");
    const sides = ["left", "right"].map((name) => ({
        name, choice: byId(`${name}-choice`), frame: byId(`${name}-side`), tag: byId(`${name}-tag`),
        image: document.createElement("img"),
    }));
    // The divider is in percent; x and y are where the pictures start, in sizes of the stage.
    const view = { divider: 50, zoom: 1, x: 0, y: 0 };
    const clamp = (value, least, most) => Math.min(Math.max(value, least), most);

    function draw() {
        view.divider = clamp(view.divider, 0, 100);
        view.zoom = clamp(view.zoom, 1, maxZoom);
        view.x = clamp(view.x, 1 - view.zoom, 0);
        view.y = clamp(view.y, 1 - view.zoom, 0);
        const percent = Math.round(view.divider);
        divider.style.left = `${view.divider}%`;
        divider.setAttribute("aria-valuenow", percent);
        divider.setAttribute("aria-valuetext", `${percent} % ${sides[0].tag.textContent}`);
        byId("left-side").style.clipPath = `inset(0 ${100 - view.divider}% 0 0)`;
        stage.classList.toggle("zoomed", view.zoom > 1);
        byId("zoom-level").textContent = view.zoom > 1 ? `${Number(view.zoom.toPrecision(2))}×` : "fit";
        for (const { image } of sides) {
            image.style.transform = `translate(${100 * view.x}%, ${100 * view.y}%) scale(${view.zoom})`;
        }
    }

    /// Keeps the point at fractions (x, y) of the stage where it is.
    function zoomBy(factor, x = 0.5, y = 0.5) {
        // Six digits, so that steps of the square root of two come back to exactly 1.
        const zoom = clamp(Number((view.zoom * factor).toPrecision(6)), 1, maxZoom);
        view.x = x - (x - view.x) * zoom / view.zoom;
        view.y = y - (y - view.y) * zoom / view.zoom;
        view.zoom = zoom;
        draw();
    }

    async function show(side) {
        const picture = pictures[side.choice.selectedIndex];
        side.tag.textContent = picture.name;
        side.image.alt = picture.alt;
        side.image.src = picture.image;
        showLegends();
        await side.image.decode();
        side.image.dataset.naturalWidth = side.image.naturalWidth;
        side.image.dataset.naturalHeight = side.image.naturalHeight;
        draw();
    }

    /// Each legend once, in the order of the sides.
    function showLegends() {
        const legends = new Set(sides.map(({ choice }) => pictures[choice.selectedIndex].legend).filter(Boolean));
        byId("legend").replaceChildren(...[...legends].map(({ title, make: makeParts }) =>
            make("div", {}, make("h3", {}, title), ...makeParts())));
    }

    function position(event) {
        const box = stage.getBoundingClientRect();
        return { x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height };
    }

    function moveDivider(event) {
        view.divider = 100 * position(event).x;
        draw();
    }

    let drag = null;
    stage.addEventListener("pointerdown", (event) => {
        if (event.button !== 0) return;
        drag = { pans: view.zoom > 1 && !divider.contains(event.target), ...position(event) };
        stage.setPointerCapture(event.pointerId);
    });
    stage.addEventListener("pointermove", (event) => {
        if (drag === null) return;
        if (!drag.pans) return moveDivider(event);
        const { x, y } = position(event);
        view.x += x - drag.x;
        view.y += y - drag.y;
        drag = { pans: true, x, y };
        draw();
    });
    for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, () => { drag = null; });
    stage.addEventListener("click", (event) => { if (view.zoom === 1) moveDivider(event); });
    stage.addEventListener("dragstart", (event) => event.preventDefault());
    stage.addEventListener("wheel", (event) => {
        if (!event.ctrlKey && !event.metaKey) return;  // the page scrolls
        event.preventDefault();
        const { x, y } = position(event);
        zoomBy(2 ** (-Math.sign(event.deltaY) / 2), x, y);
    }, { passive: false });

    divider.addEventListener("keydown", (event) => {
        const step = event.shiftKey ? 10 : 1;
        const moves = { ArrowLeft: -step, ArrowDown: -step, ArrowRight: step, ArrowUp: step,
                        PageDown: -10, PageUp: 10, Home: -100, End: 100 };
        const zooms = { "+": 2, "=": 2, "-": 0.5, "0": 1 / maxZoom };
        if (event.key in moves) view.divider += moves[event.key];
        else if (event.key in zooms) zoomBy(zooms[event.key]);
        else return;
        event.preventDefault();
        draw();
    });
    byId("zoom-in").addEventListener("click", () => zoomBy(2));
    byId("zoom-out").addEventListener("click", () => zoomBy(0.5));
    byId("zoom-fit").addEventListener("click", () => zoomBy(1 / maxZoom));

    function readAddress() {
        const wanted = new URLSearchParams(location.hash.slice(1));
        view.divider = Number.parseFloat(wanted.get("divider") ?? view.divider) || 0;
        for (const { name, choice } of sides) {
            const index = pictures.findIndex((picture) => picture.name === wanted.get(name));
            if (index >= 0) choice.selectedIndex = index;
        }
        zoomBy((Number.parseFloat(wanted.get("zoom")) || view.zoom) / view.zoom);
        return Promise.all(sides.map(show));
    }

    stage.style.aspectRatio = `${width} / ${height}`;
    byId("viewer").style.maxWidth = `min(${widestScale * width}px, ${100 * tallest * width / height}vh)`;
    for (const side of sides) {
        for (const group of new Set(pictures.map((picture) => picture.group))) {
            const options = pictures.filter((picture) => picture.group === group).map(({ name }) => new Option(name));
            side.choice.append(make("optgroup", { label: group }, ...options));
        }
        side.choice.addEventListener("change", () => show(side));
        side.frame.append(side.image);
    }
    // The first picture is the reference; the most telling other one is the first that does not trace, too.
    const telling = pictures.findIndex((picture, index) => index > 0 && picture.isApproximate);
    sides[1].choice.selectedIndex = telling > 0 ? telling : Math.min(1, pictures.length - 1);
    window.addEventListener("hashchange", readAddress);
    return readAddress();
}
