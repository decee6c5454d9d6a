// Histograms of errors, and the pixels that a divide costs.

function histogramPlot(row, width) {
  const { span, counts } = row.histogram;
  const step = (2 * span) / counts.length;
  const bars = counts.map((n, i) => ({ from: -span + i * step, to: -span + (i + 1) * step, share: n / row.cases, n }));
  return {
    upright: true,
    points: bars.map((b) => ({ x: (b.from + b.to) / 2, y: b.share,
      text: `${figure(b.from)} to ${figure(b.to)} ulp\n${count(b.n)} of ${count(row.cases)} results\n${percent(b.share)}` })),
    options: {
      height: 130, marginLeft: 46, marginRight: 12, marginTop: 12, marginBottom: 28,
      x: { domain: [-span, span], label: null, ticks: 4, tickFormat: (v) => (Math.abs(v) >= 1e4 ? v.toExponential(0) : String(v)) },
      y: { label: null, ticks: 3, tickFormat: (v) => `${figure(100 * v)} %`, domain: [0, Math.max(0.01, d3.max(bars, (b) => b.share))], grid: true },
      marks: [
        Plot.rectY(bars, { x1: "from", x2: "to", y: "share", fill: colours[0], inset: 0.5, className: "bars" }),
        Plot.ruleX([0], { stroke: "currentColor", strokeDasharray: "2 3" }),
        Plot.ruleY([0]),
      ],
    },
  };
}

function showErrors() {
  const parent = section("errors");
  const all = report.accuracy.accuracy.filter((row) => row.cases > 0);
  const option = (value) => ({ value, text: value });
  const grid = element("div", { class: "multiples" });
  const { box, tell } = controls({
    operation: { label: "operation", values: unique(all.map((r) => r.operation)).map(option) },
    operands: { label: "operands", values: unique(all.map((r) => r.operands)).map(option) },
  }, (choice, fill) => {
    fill("operands", unique(all.filter((r) => r.operation === choice.operation).map((r) => r.operands)).map(option));
    const operands = box.querySelector("[name=operands]").value;
    const rows = all.filter((r) => r.operation === choice.operation && r.operands === operands);
    const plots = rows.map((row) => {
      const { place, render } = chart(`Errors of ${row.operation}, ${row.variant}`, (width) => histogramPlot(row, width));
      const facts = element("p", {}, `largest ${largest(row.max)}, bias ${figure(row.mean)}, rms ${figure(row.rms)} ulp; ` +
        `${percent(row.correct)} correctly rounded`);
      return { node: element("div", {}, element("h3", {}, row.variant), facts, place), render };
    });
    grid.replaceChildren(...plots.map((p) => p.node));
    plots.forEach((p) => p.render());
  });
  parent.append(box, grid);
  tell();
  parent.append(element("p", { class: "quiet" }, "Horizontal: error in ulp. Vertical: share of the results."));
}

function distancePlot(variants, width) {
  const narrow = width < 480;
  const points = variants.flatMap((v, i) => v.octaves.filter((o) => o.max > 0).map((o) => ({ ...o, i, name: v.variant })));
  const crossings = variants.map((v, i) => ({ x: v.safe_from, i, name: v.variant })).filter((v) => v.x > 1);
  return {
    // Points of two builds fall on one another: each says what all have at its distance.
    points: points.map((p) => ({ x: p.from, y: p.max,
      text: [`${p.name}, ${count(p.from)} to ${count(p.to)}`, `largest ${figure(p.max)} pixels, mean ${figure(p.mean)}`,
        `${percent(p.half_a_pixel)} half a pixel off or more`,
        ...points.filter((q) => q !== p && q.from === p.from).map((q) => `${q.name}: ${figure(q.max)}`)].join("\n") })),
    options: {
      height: narrow ? 320 : 380, marginLeft: 56, marginRight: 24, marginBottom: 42, marginTop: 28,
      x: logScale(points.map((p) => p.from), "distance of the point →", true),
      y: logScale(points.map((p) => p.max), "↑ largest error in pixels"),
      marks: [
        Plot.ruleY([0.5], { stroke: "currentColor", strokeDasharray: "5 3", className: "half" }),
        Plot.text([0.5], { x: d3.max(points, (p) => p.from), y: (v) => v, text: () => "half a pixel", dy: -8,
          textAnchor: "end", fill: "currentColor" }),
        Plot.ruleX(crossings, { x: "x", stroke: (c) => colours[c.i], strokeDasharray: "2 3", className: "crossing" }),
        Plot.text(crossings.slice(0, 1), { x: "x", frameAnchor: "top", text: (c) => count(c.x), dx: 4, dy: 4, textAnchor: "start",
          fill: "currentColor" }),
        Plot.line(points, { x: "from", y: "max", z: "name", stroke: (p) => colours[p.i], className: "lines" }),
        ...variants.map((v, i) => Plot.dot(points.filter((p) => p.i === i), { x: "from", y: "max", r: 4.5,
          symbol: symbols[i], fill: colours[i], stroke: "var(--paper)", className: "points" })),
      ],
    },
  };
}

function showDistance() {
  const parent = section("distance");
  const { constant, half_width: half, variants } = report.accuracy.pixels;
  section("distance-says").append(` Points are x over z, times ${constant}, on a page that reaches ${half} pixels to each side.`);
  parent.append(legend(variants.map((v) => v.variant)));
  const crossed = variants.filter((v) => v.safe_from > 1)
    .map((v) => `${v.variant} stays under half a pixel from a distance of ${count(v.safe_from)} on`);
  const always = variants.filter((v) => v.safe_from <= 1).map((v) => v.variant);
  const { render } = charted(parent, "Pixel error against distance",
    [...crossed, always.length ? `${always.join(" and ")} always ${always.length > 1 ? "do" : "does"}` : ""]
      .filter(Boolean).join("; ") + ". Each point is the largest error in an octave of distance.",
    (width) => distancePlot(variants, width));
  render();
}
