// Values stepped across spans: how their errors grow, and what they cost.

function alongPlot(rows, width) {
  const narrow = width < 480;
  const points = rows.flatMap((row, i) => row.along.filter((p) => p.max > 0).map((p) => ({ ...p, i, row })));
  const bounds = rows.flatMap((row, i) => row.along.filter((p) => p.bound > 0).map((p) => ({ ...p, i })));
  return {
    points: points.map((p) => ({ x: p.pixel, y: p.max,
      text: [`${p.row.rule}, pixel ${p.pixel}`, `off by ${figure(p.max)} ${p.row.unit}s at most, bound ${figure(p.bound)}`,
        ...points.filter((q) => q !== p && q.pixel === p.pixel).map((q) => `${q.row.rule}: ${figure(q.max)}`)].join("\n") })),
    options: {
      height: narrow ? 320 : 380, marginLeft: 56, marginRight: 24, marginBottom: 42, marginTop: 28,
      x: { label: "pixel of the span →", domain: [0, report.stepping.lengths.most - 1], ticks: narrow ? 4 : 8 },
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

function costPlot(rows, kinds, width) {
  const narrow = width < 480;
  return {
    points: rows.map((r) => ({ x: r.ns, y: r.wrong, text: `${r.value}, ${r.rule}\n${figure(r.ns)} ns a pixel\n` +
      `${percent(r.wrong)} of the pixels wrong, by ${count(r.most_off)} ${r.unit}s at most\noff by ${figure(r.last.max)} at the last pixel` })),
    options: {
      height: narrow ? 320 : 380, marginLeft: 56, marginRight: 24, marginBottom: 42, marginTop: 28,
      x: scaleFor(rows.map((r) => r.ns), "nanoseconds a pixel →"),
      y: { ...scaleFor(rows.map((r) => r.wrong), "↑ share of wrong pixels"), tickFormat: (v) => `${figure(100 * v)} %` },
      marks: kinds.map((kind, i) => Plot.dot(rows.filter((r) => r.value === kind), { x: "ns", y: "wrong", r: 5,
        symbol: symbols[i], fill: symbols[i] === "times" ? "none" : colours[i],
        stroke: symbols[i] === "times" ? colours[i] : "var(--paper)", className: "points" })),
    },
  };
}

function showStepping() {
  const parent = section("stepping");
  const { stepping: all, lengths } = report.stepping;
  const place = element("div", {});
  const { box, tell } = controls({
    value: { label: "value", values: unique(all.map((r) => r.value)).map((value) => ({ value, text: value })) },
  }, ({ value }) => {
    const rows = all.filter((r) => r.value === value);
    place.replaceChildren(legend(rows.map((r) => r.rule)));
    const { render } = charted(place, `Errors along a span, ${value}`,
      `The largest error at each place of spans of ${lengths.most} pixels; dashed what it can be at most, as derived. ` +
      `Ends of spans: ${rows[0].ends}.`, (width) => alongPlot(rows, width));
    place.append(table(`${value}, spans of ${lengths.least} to ${lengths.most} pixels`, [
      { title: "stepped", of: (r) => r.rule },
      { title: `largest error, ${rows[0].unit}s`, of: (r) => figure(r.max), number: true },
      { title: "bound", of: (r) => figure(r.bound), number: true },
      { title: "wrong pixels", of: (r) => percent(r.wrong), number: true },
      { title: "wrong bands", of: (r) => percent(r.bands.wrong / r.bands.drawn), number: true },
      { title: "missed", of: (r) => percent(r.missed), number: true },
    ], rows));
    render();
  });
  parent.append(box, place);
  tell();
  const timed = all.filter((r) => r.ns !== null && r.wrong > 0);
  const kinds = unique(timed.map((r) => r.value));
  parent.append(element("h3", {}, "What it costs"), legend(kinds));
  const { render } = charted(parent, "Wrong pixels against time",
    `Spans of 160 pixels, with what they begin with, on ${report.stepping.times.processor}. Texels are held to the exact ` +
    "picture, in perspective but where it says affine.", (width) => costPlot(timed, kinds, width));
  render();
}
