// Histograms of errors, and the pixel errors of a divide.

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
  const all = report.accuracy.accuracy.filter((row) => row.cases > 0);
  const operandsOf = (operation) => unique(all.filter((r) => r.operation === operation).map((r) => r.operands));
  const grid = element("div", { class: "multiples" });
  const { box, update } = controls({
    operation: { label: "operation", values: unique(all.map((r) => r.operation)) },
    operands: { label: "operands", values: [] },
  }, ({ operation }, fill) => {
    const operands = fill("operands", operandsOf(operation));
    const plots = all.filter((r) => r.operation === operation && r.operands === operands).map((row) => {
      const { place, render } = chart(`Errors of ${operation}, ${row.variant}`, (width) => histogramPlot(row, width));
      const facts = `largest ${largest(row.max)}, bias ${figure(row.mean)}, rms ${figure(row.rms)} ulp; ` +
        `${percent(row.correct)} correctly rounded`;
      return { node: element("div", {}, element("h3", {}, row.variant), element("p", {}, facts), place), render };
    });
    grid.replaceChildren(...plots.map((p) => p.node));
    plots.forEach((p) => p.render());
  });
  section("errors").append(box, grid, note("Horizontal axis: error in ulp. Vertical axis: share of the results."));
  update();
}

function distancePlot(variants, width) {
  const points = variants.flatMap((v, i) => v.octaves.filter((o) => o.max > 0).map((o) => ({ ...o, i, name: v.variant })));
  const crossings = variants.map((v, i) => ({ x: v.safe_from, i })).filter((v) => v.x > 1);
  return {
    // Points of two builds coincide, so each tip has the values of all builds at its distance.
    points: points.map((p) => ({ x: p.from, y: p.max,
      text: [`${p.name}, ${count(p.from)} to ${count(p.to)}`, `largest ${figure(p.max)} pixels, mean ${figure(p.mean)}`,
        `${percent(p.half_a_pixel)} off by half a pixel or more`,
        ...points.filter((q) => q !== p && q.from === p.from).map((q) => `${q.name}: ${figure(q.max)}`)].join("\n") })),
    options: {
      ...frame(width),
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
        ...variants.map((_, i) => Plot.dot(points.filter((p) => p.i === i), { x: "from", y: "max", r: 4.5,
          ...dotStyle(i), className: "points" })),
      ],
    },
  };
}

function showDistance() {
  const parent = section("distance");
  const { constant, half_width: half, variants } = report.accuracy.pixels;
  section("distance-says").append(` A point is projected to x / z times ${constant}, onto a screen that extends ${half} pixels to each side.`);
  const always = variants.filter((v) => v.safe_from <= 1).map((v) => v.variant);
  const limits = variants.filter((v) => v.safe_from > 1)
    .map((v) => `${v.variant} stays below half a pixel from a distance of ${count(v.safe_from)} on`);
  if (always.length > 0) limits.push(`${always.join(" and ")} always ${always.length > 1 ? "do" : "does"}`);
  parent.append(legend(variants.map((v) => v.variant)));
  figureWithCaption(parent, "Pixel error by distance",
    `${limits.join("; ")}. Each point is the largest error in one octave of distance.`,
    (width) => distancePlot(variants, width)).render();
}
