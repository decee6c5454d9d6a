"use strict";
// What all charts and tables are made with.

const report = JSON.parse(document.getElementById("data").textContent);

// A figure to four digits, so that what a chart says is what the JSON has.
function figure(x) {
  if (x === null || x === undefined) return "none";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e6 || size < 1e-4) return x.toExponential(3).replace("e+", "e");
  return x.toLocaleString("en-US", { maximumSignificantDigits: size >= 1000 ? 7 : 4 });
}
// Toward zero: what stays below 1 is not to be shown as 1.
const largest = (x) => (x >= 1000 || x < 0.001 ? figure(x) : String(Math.floor(x * 1e5) / 1e5));
const count = (n) => n.toLocaleString("en-US");
const percent = (share) => (share < 1 && share > 0.99995 ? "99.99" : figure(100 * share)) + " %";
const between = (bounds) =>
  bounds.min === bounds.max ? figure(bounds.min) : `${figure(bounds.min)} to ${figure(bounds.max)}`;
const unique = (values) => [...new Set(values)];

// element("p", { class: "quiet" }, "text", node, ...)
function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes ?? {})) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

// columns: { title, of: row => text or node, and number, words or asked: true }; the first heads its row.
function table(caption, columns, rows) {
  const kind = (c) => {
    const name = ["number", "words", "asked"].find((k) => c[k]);
    return name ? { class: name } : {};
  };
  const head = element("tr", {},
    ...columns.map((c) => element("th", { scope: "col", ...(c.number ? { class: "number" } : {}) }, c.title)));
  const body = rows.map((row) => element("tr", {},
    ...columns.map((c, i) => element(i === 0 ? "th" : "td", { ...(i === 0 ? { scope: "row" } : {}), ...kind(c) },
      c.of(row)))));
  return element("div", { class: "scroll", tabindex: "0", role: "group", "aria-label": caption },
    element("table", {}, element("caption", {}, caption), element("thead", {}, head),
      element("tbody", {}, ...body)));
}

// Choices above a chart. choices: { name: { label, values: [{ value, text }] } }. `changed` is called
// with what is chosen, now and whenever that changes. It may return { name: values } to offer others.
function controls(choices, changed) {
  const selects = {};
  const box = element("div", { class: "controls" });
  const fill = (name, values) => {
    const select = selects[name];
    const before = select.value;
    select.replaceChildren(...values.map((v) => element("option", { value: v.value }, v.text)));
    if (values.some((v) => v.value === before)) select.value = before;
    select.parentNode.hidden = values.length < 2;
  };
  const tell = () => changed(Object.fromEntries(Object.entries(selects).map(([n, s]) => [n, s.value])), fill);
  for (const [name, { label, values }] of Object.entries(choices)) {
    selects[name] = element("select", { name });
    selects[name].addEventListener("change", tell);
    box.append(element("label", {}, label, selects[name]));
    fill(name, values);
  }
  return { box, tell };
}

const colours = ["var(--c1)", "var(--c2)", "var(--c3)", "var(--c4)", "var(--c5)", "var(--c6)"];
const symbols = ["circle", "square", "triangle", "diamond", "star", "times"];
const symbolPath = { circle: d3.symbolCircle, square: d3.symbolSquare, triangle: d3.symbolTriangle,
  diamond: d3.symbolDiamond2, star: d3.symbolStar, times: d3.symbolTimes };

// names: in the order of colours and symbols.
function legend(names) {
  return element("ul", { class: "legend" }, ...names.map((name, i) => {
    const svg = d3.create("svg").attr("viewBox", "-8 -8 16 16").attr("aria-hidden", "true");
    svg.append("path").attr("d", d3.symbol(symbolPath[symbols[i]], 60)())
      .attr("fill", symbols[i] === "times" ? "none" : colours[i]).attr("stroke", colours[i]);
    return element("li", {}, svg.node(), name);
  }));
}

// In ems: a tip stands beside its point, and has half of a narrow chart.
const tipWidth = (width) => Math.max(8, Math.min(24, (width / 2 - 24) / 12));

// A chart that says its points to a mouse, a finger and the arrow keys. draw(width) returns
// { options: for Plot, points: [{ x, y, text }], upright: whether the nearest across is the one meant }.
function chart(label, draw) {
  const place = element("div", { class: "chart" });
  const readout = element("p", { class: "readout", role: "status" });
  let drawn = 0;
  const render = (most = Infinity) => {
    const width = Math.min(Math.floor(place.clientWidth), most);
    if (width === 0) return;
    drawn = width;
    const { options, points, upright } = draw(width);
    const svg = Plot.plot({
      width, ...options,
      style: { fontSize: "12px", background: "transparent", ...options.style },
      marks: [...options.marks, Plot.tip(points,
        (upright ? Plot.pointerX : Plot.pointer)({ x: "x", y: "y", title: "text", maxRadius: 60, className: "tip", fontSize: 12, lineHeight: 1.25, lineWidth: tipWidth(width) }))],
    });
    speak(svg, label, points, readout);
    place.replaceChildren(svg, readout);
  };
  new ResizeObserver(() => { if (Math.floor(place.clientWidth) !== drawn) render(); }).observe(place);
  renderers.set(place, render);
  return { place, render };
}

// A change of choice makes new charts: keyed weakly, those that it replaces can be collected.
const renderers = new WeakMap();
const renderAll = (most) => document.querySelectorAll(".chart").forEach((place) => renderers.get(place)?.(most));
// As wide as paper is, so that nothing is shrunk on it.
addEventListener("beforeprint", () => renderAll(680));
addEventListener("afterprint", () => renderAll());

function speak(svg, label, points, readout) {
  svg.setAttribute("tabindex", "0");
  svg.setAttribute("role", "application");
  svg.setAttribute("aria-roledescription", "chart");
  svg.setAttribute("aria-label", `${label}; arrow keys step through its ${points.length} points`);
  // A click would hold the tip where it is.
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

// A figure with what is to be seen in it under it.
function charted(parent, label, says, draw) {
  const { place, render } = chart(label, draw);
  const caption = element("figcaption", {}, says);
  parent.append(element("figure", {}, place, caption));
  return { render, caption };
}

const section = (id) => document.getElementById(id);
// What is not in the data is said, never passed over.
function missing(id, what) {
  section(id).append(element("p", { class: "quiet" }, what));
}

// A logarithmic scale over whole powers of ten, or, where values span little, over 1, 2 and 5 of each.
// tight: no more than the values themselves.
function logScale(values, label, tight = false) {
  const [least, most] = d3.extent(values.filter((v) => v > 0));
  const powers = d3.range(Math.floor(Math.log10(least)), Math.ceil(Math.log10(most)) + 1);
  const few = powers.length <= 3;
  const ticks = powers.flatMap((p) => (few ? [1, 2, 5] : [1]).map((m) => m * 10 ** p));
  const from = tight ? least : d3.max(ticks.filter((t) => t <= least * (1 + 1e-9)));
  const to = tight ? most : d3.min(ticks.filter((t) => t >= most * (1 - 1e-9)));
  const shown = ticks.filter((t) => t >= from && t <= to);
  const every = Math.ceil(shown.length / 9);
  return { type: "log", label, domain: [from, to], grid: true, ticks: shown.filter((_, i) => i % every === 0),
    tickFormat: (v) => (v >= 1e-4 && v < 1e6 ? String(+v.toPrecision(1)) : v.toExponential(0).replace("e+", "e")) };
}

// Logarithmic where values differ by more than this.
const wide = 30;
function scaleFor(values, label, ticks = 6) {
  const positive = values.filter((v) => v > 0);
  return positive.length > 0 && d3.max(positive) / d3.min(positive) > wide ? logScale(values, label)
    : { type: "linear", label, zero: true, nice: true, ticks, grid: true };
}
