// The chart of speed and accuracy.

const kinds = { host: ["type", "library", "plain", "floating"], clocks: ["386 listing", "8088 listing"] };
const kindNames = { type: "fixproof::number", library: "libraries", plain: "64-bit product or quotient in C++", floating: "floating point" };
const cpus = ["486", "386", "286", "8088"];

// All presets that return what a row returns: `alike` has the suffixes of their names.
function presetsOf(row) {
  const alike = (row.alike ?? "").split(" ").filter((a) => a.startsWith("_"));
  return [row.variant, ...alike.map((a) => "q16_16" + a)];
}
const presetOfListing = (call) => `q16_16_${call.target}${call.rounds ? "" : "_unrounded"}`;

// The transform of a vertex counts as an operation, without a dependent chain.
const hostRows = () => [...report.host.host,
  ...report.host.vertices.map((row) => ({ ...row, operation: "vertex", throughput_ns: row.ns, chain_ns: null }))];

function hostPoints(choice) {
  return hostRows()
    .filter((row) => row.operation === choice.operation && row[choice.time] && row.accuracy)
    .map((row) => ({ name: row.contender, kind: row.kind, alike: row.alike, rule: row.rounding,
      time: row[choice.time].median, most: row[choice.time].median, error: row.accuracy[choice.error] }));
}

function clockPoints(choice) {
  const errors = report.accuracy.accuracy
    .filter((row) => row.operation === choice.operation && row.operands === choice.operands);
  return report.clocks.clocks
    .filter((call) => call.routine === choice.operation && call.chapter === 54)
    .flatMap((call) => {
      const on = call.processors.find((p) => p.cpu === choice.time);
      const row = errors.find((r) => presetsOf(r).includes(presetOfListing(call)));
      if (!on?.clocks.mean || !row) return [];
      // An 8088 takes at least the larger of table and bus time.
      const bus = on.bus?.mean?.max;
      return [{ name: `${call.target === "i386" ? "386" : "8088"} listing, ${call.rounds ? "rounded" : "unrounded"}`,
        kind: call.target === "i386" ? "386 listing" : "8088 listing", alike: presetOfListing(call),
        time: Math.max(on.clocks.mean.min, bus ?? 0), most: Math.max(on.clocks.mean.max, bus ?? 0), tabled: on.clocks.mean, bus,
        error: row[choice.error] }];
    });
}

// The points that are at least one percent more accurate than every faster point. Rules that differ only in how they
// round halves differ by less. A time that is a range counts as its middle.
const noticeable = 0.99;
const middle = (p) => (p.time + p.most) / 2;
function frontierOf(points) {
  let best = Infinity;
  return d3.sort(points, middle, (p) => p.error).filter((p) => p.error < noticeable * best && ((best = p.error), true));
}

// The same without floating point; empty if that is the same line.
function fixedFrontierOf(points) {
  return points.some((p) => p.kind === "floating") ? frontierOf(points.filter((p) => p.kind !== "floating")) : [];
}

// Finds a place for the label of each point, beside it and in nobody's way. Lengths are in pixels.
function placeLabels(spots, width) {
  const boxes = spots.map(({ x, y }) => [x - 7, y - 7, x + 7, y + 7]);
  const meets = (a) => boxes.some((b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]);
  return spots.map(({ x, y, text, lined }) => {
    const w = 6.6 * text.length;
    // A line goes through some points, from left to right.
    const beside = lined ? [[6, -14], [-6 - w, -14], [6, 14], [-6 - w, 14]] : [];
    const places = [...beside, ...[16, 30, 44, 58].flatMap((far) => [[far - 6, 0], [-far + 6 - w, 0], [-w / 2, -far], [-w / 2, far],
      [far / 2, -far], [far / 2, far], [-far / 2 - w, -far], [-far / 2 - w, far]])];
    const boxOf = ([dx, dy]) => [x + dx, y + dy - 7, x + dx + w, y + dy + 7];
    const inside = ([left, , right]) => left > 20 && right < width;
    const place = places.find((p) => inside(boxOf(p)) && !meets(boxOf(p))) ?? places[0];
    boxes.push(boxOf(place));
    return place;
  });
}

function tradePlot(unsorted, choice, width) {
  const points = d3.sort(unsorted, middle);
  const unit = choice.from === "host" ? "ns" : "clocks";
  const frontier = frontierOf(points);
  const ofFixed = fixedFrontierOf(points);
  const narrow = isNarrow(width);
  // A logarithmic scale has no place for 0, so exact points are at its lower end.
  const errors = points.map((p) => p.error);
  const least = d3.min(errors.filter((e) => e > 0)) ?? 1;
  const scale = scaleFor(errors, "↑ error in ulp");
  if (scale.type === "log" && errors.includes(0)) {
    Object.assign(scale, logScale([least / 10, ...errors], scale.label));
    const { tickFormat, domain } = scale;
    scale.tickFormat = (v) => (v <= domain[0] * 1.001 ? "0" : tickFormat(v));
  }
  const height = (p) => (p.error > 0 || scale.type !== "log" ? p.error : scale.domain[0]);
  const says = points.map((p) => ({ x: middle(p), y: height(p),
    text: [p.name, p.alike && p.alike !== p.name ? `like ${p.alike}` : null,
      `${figure(p.time)}${p.most > p.time ? ` to ${figure(p.most)}` : ""} ${unit} per ${choice.operation}`,
      p.bus ? `table ${figure(p.tabled.max)}, bus ${figure(p.bus)} clocks` : null,
      choice.error === "rms" ? `rms error ${figure(p.error)} ulp` : `largest error ${largest(p.error)} ulp`,
      p.rule ? `rounding: ${p.rule}` : null].filter(Boolean).join("\n") }));
  const named = narrow ? [] : unique([...frontier, ...ofFixed]);
  const labels = points.map((p, i) => (named.includes(p) ? `${i + 1} ${p.name}` : String(i + 1)));
  const color = (p) => colours[kinds[choice.from].indexOf(p.kind)] ?? colours[5];
  const axes = {
    ...frame(width), marginRight: narrow ? 20 : 40,
    x: scaleFor(points.flatMap((p) => [p.time, p.most]), `${unit} per call →`, Math.floor(width / 80)),
    y: scale,
  };
  const [toX, toY] = ["x", "y"].map((axis) =>
    Plot.plot({ width, ...axes, marks: [Plot.dot(points, { x: middle, y: height })] }).scale(axis));
  const places = points.length === 0 ? [] : placeLabels(points.map((p, i) =>
    ({ x: toX.apply(middle(p)), y: toY.apply(height(p)), text: labels[i],
      lined: p.most > p.time || named.includes(p) })), width);
  return {
    points: says,
    options: {
      ...axes,
      marks: [
        Plot.line(frontier, { x: middle, y: height, curve: "step-after", stroke: "currentColor",
          strokeDasharray: "4 3", className: "frontier" }),
        Plot.line(ofFixed, { x: middle, y: height, curve: "step-after", stroke: "var(--quiet)", strokeDasharray: "1 4",
          strokeWidth: 2, strokeLinecap: "round", className: "frontier-fixed" }),
        Plot.ruleY(points.filter((p) => p.most > p.time), { x1: "time", x2: "most", y: height, stroke: color }),
        ...kinds[choice.from].map((kind, i) => Plot.dot(points.filter((p) => p.kind === kind), { x: middle, y: height, r: 6,
          ...dotStyle(i), className: "points" })),
        ...points.map((p, i) => Plot.text([p], { x: middle, y: height, text: () => labels[i], dx: places[i][0],
          dy: places[i][1], textAnchor: "start", fill: "currentColor", stroke: "var(--paper)", strokeWidth: 4,
          className: "names" })),
      ],
    },
  };
}

// The values to choose from, which depend on the processors.
function tradeChoices({ from, operation }) {
  if (from === "host") {
    return { time: [{ value: "throughput_ns", text: "throughput" }, { value: "chain_ns", text: "latency (dependent chain)" }],
      operation: unique(hostRows().map((r) => r.operation)), operands: ["uniform"] };
  }
  const rows = report.accuracy.accuracy.filter((r) => r.operation === (operation || "mul"));
  return { time: cpus, operation: ["mul", "div"], operands: unique(rows.map((r) => r.operands)) };
}

function showTrade() {
  const parent = section("trade");
  const names = element("div", {});
  const numbered = element("ol", { class: "numbered" });
  const holder = element("div", {});
  const listed = element("details", {});
  let choice = {};
  let points = [];
  const { box, update } = controls({
    from: { label: "processor", values: [{ value: "host", text: "this machine" }, { value: "clocks", text: "8088 to 486" }] },
    time: { label: "time", values: [] },
    operation: { label: "operation", values: [] },
    operands: { label: "operands", values: [] },
    error: { label: "error", values: [{ value: "rms", text: "root mean square" }, { value: "max", text: "largest" }] },
  }, (chosen, fill) => {
    choice = chosen;
    // In this order, because the operation decides which operands there are.
    for (const name of ["time", "operation", "operands"]) choice[name] = fill(name, tradeChoices(choice)[name]);
    const host = choice.from === "host";
    points = host ? hostPoints(choice) : clockPoints(choice);
    names.replaceChildren(legend(kinds[choice.from].map((kind) => kindNames[kind] ?? kind)));
    shown.render();
    const ofFixed = fixedFrontierOf(points);
    shown.caption.textContent = points.length === 0 ? "There are no measurements for this choice."
      : `On the line: ${frontierOf(points).map((p) => p.name).join("; ")}.` +
        (ofFixed.length ? ` Fixed point alone, dotted: ${ofFixed.map((p) => p.name).join("; ")}.` : "");
    numbered.replaceChildren(...d3.sort(points, middle).map((p) => element("li", {}, p.name)));
    listed.replaceChildren(element("summary", {}, "Show as a table"),
      table("Speed and accuracy, fastest first", [
        { title: "variant", of: (p) => p.name },
        { title: "kind", of: (p) => kindNames[p.kind] ?? p.kind },
        { title: host ? "ns" : "clocks", of: (p) => range({ min: p.time, max: p.most }), kind: "number" },
        ...(points.some((p) => p.bus) ? [
          { title: "by the table", of: (p) => range(p.tabled), kind: "number" },
          { title: "by the bus", of: (p) => figure(p.bus), kind: "number" },
        ] : []),
        { title: "error, ulp", of: (p) => (choice.error === "rms" ? figure : largest)(p.error), kind: "number" },
      ], d3.sort(points, middle)));
  });
  const shown = figureWithCaption(holder, "Speed and accuracy", "", (width) => tradePlot(points, choice, width));
  const { made, rounds, libraries } = report.host;
  const missing = Object.entries(libraries).filter(([, built]) => !built).map(([name]) => `${name} was not installed.`);
  parent.append(box, names, holder, numbered, listed, note(`This machine: ${made.processor}, ${made.compiler} ${made.flags}, ` +
    `medians of ${count(rounds)} ${rounds === 1 ? "round" : "rounds"}. ${missing.join(" ")}`));
  update();
}
