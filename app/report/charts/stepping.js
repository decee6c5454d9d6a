// Errors of values stepped across a span, and their cost.

function alongPlot(rows, width) {
  const points = rows.flatMap((row, i) => row.along.filter((p) => p.max > 0).map((p) => ({ ...p, i, row })));
  const bounds = rows.flatMap((row, i) => row.along.filter((p) => p.bound > 0).map((p) => ({ ...p, i })));
  return {
    points: points.map((p) => ({ x: p.pixel, y: p.max,
      text: [`${p.row.rule}, pixel ${p.pixel}`, `off by at most ${figure(p.max)} ${p.row.unit}s, bound ${figure(p.bound)}`,
        ...points.filter((q) => q !== p && q.pixel === p.pixel).map((q) => `${q.row.rule}: ${figure(q.max)}`)].join("\n") })),
    options: {
      ...frame(width),
      x: { label: "pixel of the span →", domain: [0, report.stepping.lengths.most - 1], ticks: isNarrow(width) ? 4 : 8 },
      y: scaleFor([...points.map((p) => p.max), ...bounds.map((p) => p.bound)], `↑ error in ${rows[0].unit}s`),
      marks: [
        Plot.line(bounds, { x: "pixel", y: "bound", z: "i", stroke: (p) => colours[p.i], strokeDasharray: "3 3",
          className: "bounds" }),
        Plot.line(points, { x: "pixel", y: "max", z: "i", stroke: (p) => colours[p.i], className: "lines" }),
        ...rows.map((_, i) => Plot.dot(points.filter((p) => p.i === i), { x: "pixel", y: "max", r: 4,
          symbol: symbols[i], fill: colours[i], stroke: "var(--paper)", className: "points" })),
      ],
    },
  };
}

function costPlot(rows, values, width) {
  return {
    points: rows.map((r) => ({ x: r.ns, y: r.wrong, text: `${r.value}, ${r.rule}\n${figure(r.ns)} ns per pixel\n` +
      `${percent(r.wrong)} of the pixels wrong, by at most ${count(r.most_off)} ${r.unit}s\noff by ${figure(r.last.max)} at the last pixel` })),
    options: {
      ...frame(width),
      x: scaleFor(rows.map((r) => r.ns), "nanoseconds per pixel →"),
      y: { ...scaleFor(rows.map((r) => r.wrong), "↑ share of wrong pixels"), tickFormat: (v) => `${figure(100 * v)} %` },
      marks: values.map((value, i) => Plot.dot(rows.filter((r) => r.value === value), { x: "ns", y: "wrong", r: 5,
        ...dotStyle(i), className: "points" })),
    },
  };
}

function showStepping() {
  const parent = section("stepping");
  const { stepping: all, lengths, times } = report.stepping;
  const place = element("div", {});
  const { box, update } = controls({ value: { label: "value", values: unique(all.map((r) => r.value)) } }, ({ value }) => {
    const rows = all.filter((r) => r.value === value);
    place.replaceChildren(legend(rows.map((r) => r.rule)));
    const { render } = figureWithCaption(place, `Errors along a span, ${value}`,
      `The largest error at each pixel of spans of ${lengths.most} pixels. Dashed lines are the derived bounds. ` +
      `Ends of spans: ${rows[0].ends}.`, (width) => alongPlot(rows, width));
    place.append(table(`${value}, spans of ${lengths.least} to ${lengths.most} pixels`, [
      { title: "rule", of: (r) => r.rule },
      { title: `largest error, ${rows[0].unit}s`, of: (r) => figure(r.max), kind: "number" },
      { title: "bound", of: (r) => figure(r.bound), kind: "number" },
      { title: "wrong pixels", of: (r) => percent(r.wrong), kind: "number" },
      { title: "wrong bands", of: (r) => percent(r.bands.wrong / r.bands.drawn), kind: "number" },
      { title: "missed", of: (r) => percent(r.missed), kind: "number" },
    ], rows));
    render();
  });
  parent.append(box, place);
  update();
  const timed = all.filter((r) => r.ns !== null && r.wrong > 0);
  const values = unique(timed.map((r) => r.value));
  parent.append(element("h3", {}, "Cost"), legend(values));
  figureWithCaption(parent, "Wrong pixels by time",
    `Spans of 160 pixels including their setup, on ${times.processor}. Texels are compared with the exact picture in ` +
    "perspective, unless the rule is affine.", (width) => costPlot(timed, values, width)).render();
}
