"use strict";
// Shared code: number formats, tables, controls and charts.

const report = JSON.parse(document.getElementById("data").textContent);

// Four significant digits, so that a chart shows the value of the JSON.
function figure(x) {
  if (x === null || x === undefined) return "none";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e6 || size < 1e-4) return x.toExponential(3).replace("e+", "e");
  return x.toLocaleString("en-US", { maximumSignificantDigits: size >= 1000 ? 7 : 4 });
}
// Truncated, so that an error below 1 is never shown as 1.
const largest = (x) => (x >= 1000 || x < 0.001 ? figure(x) : String(Math.floor(x * 1e5) / 1e5));
const count = (n) => n.toLocaleString("en-US");
const percent = (share) => (share < 1 && share > 0.99995 ? "99.99" : figure(100 * share)) + " %";
const range = ({ min, max }) => (min === max ? figure(min) : `${figure(min)} to ${figure(max)}`);
const dateText = (date) => date.replace("T", " ").replace("Z", " UTC");
const unique = (values) => [...new Set(values)];

// element("p", { class: "quiet" }, "text", node, ...)
function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes ?? {})) made.setAttribute(name, value);
  made.append(...children);
  return made;
}
const section = (id) => document.getElementById(id);
const note = (...children) => element("p", { class: "quiet" }, ...children);

// columns: { title, of: row => text or node, kind: a CSS class of cells }. The first column heads its row.
function table(caption, columns, rows) {
  const cell = (tag, column, attributes, ...children) =>
    element(tag, { ...attributes, ...(column.kind ? { class: column.kind } : {}) }, ...children);
  const head = columns.map((c) => cell("th", c.kind === "number" ? c : {}, { scope: "col" }, c.title));
  const body = rows.map((row) => element("tr", {}, ...columns.map((c, i) =>
    (i === 0 ? cell("th", c, { scope: "row" }, c.of(row)) : cell("td", c, {}, c.of(row))))));
  return element("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": caption },
    element("table", {}, element("caption", {}, caption), element("thead", {}, element("tr", {}, ...head)),
      element("tbody", {}, ...body)));
}

// Select boxes above a chart. choices: { name: { label, values: texts or { value, text } } }. Calls
// changed(chosen, fill) on every change and from update(); fill(name, values) replaces the values of one box and
// returns the chosen one.
function controls(choices, changed) {
  const selects = {};
  const box = element("div", { class: "controls" });
  const fill = (name, values) => {
    const select = selects[name];
    const before = select.value;
    const options = values.map((v) => (v.value === undefined ? { value: v, text: v } : v));
    select.replaceChildren(...options.map((v) => element("option", { value: v.value }, v.text)));
    if (options.some((v) => v.value === before)) select.value = before;
    select.parentNode.hidden = options.length < 2;
    return select.value;
  };
  const update = () => changed(Object.fromEntries(Object.entries(selects).map(([n, s]) => [n, s.value])), fill);
  for (const [name, { label, values }] of Object.entries(choices)) {
    selects[name] = element("select", { name });
    selects[name].addEventListener("change", update);
    box.append(element("label", {}, label, selects[name]));
    fill(name, values);
  }
  return { box, update };
}

const colours = ["var(--c1)", "var(--c2)", "var(--c3)", "var(--c4)", "var(--c5)", "var(--c6)"];
const symbols = ["circle", "square", "triangle", "diamond", "star", "times"];
const symbolPath = { circle: d3.symbolCircle, square: d3.symbolSquare, triangle: d3.symbolTriangle,
  diamond: d3.symbolDiamond2, star: d3.symbolStar, times: d3.symbolTimes };
// A cross has no area to fill.
const dotStyle = (i) => ({ symbol: symbols[i], fill: symbols[i] === "times" ? "none" : colours[i],
  stroke: symbols[i] === "times" ? colours[i] : "var(--paper)" });

// Name i gets colour i and symbol i.
function legend(names) {
  return element("ul", { class: "legend" }, ...names.map((name, i) => {
    const svg = d3.create("svg").attr("viewBox", "-8 -8 16 16").attr("aria-hidden", "true");
    svg.append("path").attr("d", d3.symbol(symbolPath[symbols[i]], 60)())
      .attr("fill", dotStyle(i).fill).attr("stroke", colours[i]);
    return element("li", {}, svg.node(), name);
  }));
}

const isNarrow = (width) => width < 480;
const frame = (width) => ({ height: isNarrow(width) ? 320 : 380, marginLeft: 56, marginRight: 24, marginBottom: 42, marginTop: 28 });
// In ems. The tip is beside its point and has half of a narrow chart.
const tipWidth = (width) => Math.max(8, Math.min(24, (width / 2 - 24) / 12));

// A weak map, so that a chart that is replaced can be collected.
const renderers = new WeakMap();
const renderAll = (maxWidth) => document.querySelectorAll(".chart").forEach((place) => renderers.get(place)?.(maxWidth));
// On paper, charts have its width, so that nothing shrinks, and nothing is folded.
const folded = () => document.querySelectorAll("details:not([open])");
let opened = [];
addEventListener("beforeprint", () => {
  opened = [...folded()];
  for (const details of opened) details.open = true;
  renderAll(680);
});
addEventListener("afterprint", () => {
  for (const details of opened) details.open = false;
  renderAll();
});

// A chart whose values can be read with a mouse, a finger and the arrow keys. draw(width) returns { options: of Plot,
// points: [{ x, y, text }], upright: whether the tip follows x alone }.
function chart(label, draw) {
  const place = element("div", { class: "chart" });
  const readout = element("p", { class: "readout", role: "status" });
  let drawn = 0;
  const render = (maxWidth = Infinity) => {
    const width = Math.min(Math.floor(place.clientWidth), maxWidth);
    if (width === 0) return;
    drawn = width;
    const { options, points, upright } = draw(width);
    const tip = { x: "x", y: "y", title: "text", maxRadius: 60, className: "tip", fontSize: 12, lineHeight: 1.25, lineWidth: tipWidth(width) };
    const shown = Object.assign(Plot.tip(points, (upright ? Plot.pointerX : Plot.pointer)(tip)), { ariaLabel: undefined });
    const svg = Plot.plot({ width, ...options, style: { fontSize: "12px", background: "transparent" },
      marks: [...options.marks, shown] });
    // Plot names its groups, which have no role that may have a name.
    for (const group of svg.querySelectorAll("g[aria-label]")) group.removeAttribute("aria-label");
    addKeys(svg, label, points, readout);
    place.replaceChildren(svg, readout);
  };
  new ResizeObserver(() => { if (Math.floor(place.clientWidth) !== drawn) render(); }).observe(place);
  renderers.set(place, render);
  return { place, render };
}

// Appends a chart with a caption. Call render() when the chart is on the page.
function figureWithCaption(parent, label, text, draw) {
  const { place, render } = chart(label, draw);
  const caption = element("figcaption", {}, text);
  parent.append(element("figure", {}, place, caption));
  return { render, caption };
}

// Arrow keys move from point to point; `readout` tells a screen reader the value.
function addKeys(svg, label, points, readout) {
  svg.setAttribute("tabindex", "0");
  svg.setAttribute("role", "application");
  svg.setAttribute("aria-roledescription", "chart");
  svg.setAttribute("aria-label", `${label}; arrow keys move through its ${points.length} points`);
  // Plot would pin the tip on a click.
  svg.addEventListener("pointerdown", (event) => event.stopImmediatePropagation(), true);
  let at = -1;
  const send = (type, x, y) => svg.dispatchEvent(
    new PointerEvent(type, { clientX: x, clientY: y, pointerType: "mouse", bubbles: true }));
  const go = (to) => {
    if (points.length === 0) return;
    at = Math.max(0, Math.min(points.length - 1, to));
    const { x, y, text } = points[at];
    const spot = new DOMPoint(svg.scale("x").apply(x), svg.scale("y").apply(y)).matrixTransform(svg.getScreenCTM());
    send("pointermove", spot.x, spot.y);
    readout.textContent = text.replaceAll("\n", ", ");
  };
  svg.addEventListener("focus", () => { if (svg.matches(":focus-visible")) go(Math.max(at, 0)); });
  svg.addEventListener("blur", () => { send("pointerleave", 0, 0); readout.textContent = ""; });
  const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, PageDown: 20, PageUp: -20,
    Home: -Infinity, End: Infinity };
  svg.addEventListener("keydown", (event) => {
    if (!(event.key in steps)) return;
    event.preventDefault();
    go(at + steps[event.key]);
  });
}

// A logarithmic scale from power of ten to power of ten, or, for values close together, over 1, 2 and 5 of each
// power. tight: the scale ends at the values themselves.
function logScale(values, label, tight = false) {
  const [least, most] = d3.extent(values.filter((v) => v > 0));
  const powers = d3.range(Math.floor(Math.log10(least)), Math.ceil(Math.log10(most)) + 1);
  const ticks = powers.flatMap((p) => (powers.length <= 3 ? [1, 2, 5] : [1]).map((m) => m * 10 ** p));
  const from = tight ? least : d3.max(ticks.filter((t) => t <= least * (1 + 1e-9)));
  const to = tight ? most : d3.min(ticks.filter((t) => t >= most * (1 - 1e-9)));
  const shown = ticks.filter((t) => t >= from && t <= to);
  const every = Math.ceil(shown.length / 9);
  return { type: "log", label, domain: [from, to], grid: true, ticks: shown.filter((_, i) => i % every === 0),
    tickFormat: (v) => (v >= 1e-4 && v < 1e6 ? String(+v.toPrecision(1)) : v.toExponential(0).replace("e+", "e")) };
}

// Logarithmic if the values differ by more than a factor of 30, else linear.
function scaleFor(values, label, ticks = 6) {
  const positive = values.filter((v) => v > 0);
  return positive.length > 0 && d3.max(positive) / d3.min(positive) > 30 ? logScale(values, label)
    : { type: "linear", label, zero: true, nice: true, ticks, grid: true };
}
