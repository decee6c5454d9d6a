// The speed–accuracy chart.

const kinds = { host: ["type", "library", "plain", "floating"], clocks: ["386 listing", "8088 listing"] };
const kindNames = { type: "fixed::number", library: "libraries", plain: "64-bit product or quotient by hand", floating: "floating point" };
const cpus = [["8088", "8088"], ["286", "286"], ["386", "386"], ["486", "486"]];

// All presets that a row stands for: alike has the endings of their names.
function presetsOf(row) {
  const alike = (row.alike ?? "").split(" ").filter((a) => a.startsWith("_"));
  return [row.variant, ...alike.map((a) => "q16_16" + a)];
}
const presetOfListing = (call) => `q16_16_${call.target}${call.rounds ? "" : "_unrounded"}`;

// Vertices stand among the operations: a transform of one has no chain.
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
      // An 8088 takes at least the larger of two times.
      const bus = on.bus?.mean?.max;
      return [{ name: `${call.target === "i386" ? "386" : "8088"} listing, ${call.rounds ? "rounded" : "unrounded"}`,
        kind: call.target === "i386" ? "386 listing" : "8088 listing", alike: presetOfListing(call),
        time: Math.max(on.clocks.mean.min, bus ?? 0), most: Math.max(on.clocks.mean.max, bus ?? 0), tabled: on.clocks.mean, bus,
        error: row[choice.error] }];
    });
}

// Those that are more exact, by a hundredth, than everything as fast or faster: how halves are rounded makes
// less. Where a time is a range, its middle counts.
const noticeable = 0.99;
const middle = (p) => (p.time + p.most) / 2;
function frontierOf(points) {
  let best = Infinity;
  return d3.sort(points, middle, (p) => p.error).filter((p) => p.error < noticeable * best && ((best = p.error), true));
}

// The same without floating point, where that makes another line.
function fixedFrontierOf(points) {
  return points.some((p) => p.kind === "floating") ? frontierOf(points.filter((p) => p.kind !== "floating")) : [];
}

function tradePlot(points, choice, width) {
  const unit = choice.from === "host" ? "ns" : "clocks";
  const frontier = frontierOf(points);
  const ofFixed = fixedFrontierOf(points);
  const narrow = width < 480;
  // What is exact stands on the floor of a logarithmic scale.
  const errors = points.map((p) => p.error);
  const least = d3.min(errors.filter((e) => e > 0)) ?? 1;
  const scale = scaleFor(errors, "↑ error in ulp, less is more exact");
  if (scale.type === "log" && errors.includes(0)) {
    Object.assign(scale, logScale([least / 10, ...errors], scale.label));
    const { tickFormat, domain } = scale;
    scale.tickFormat = (v) => (v <= domain[0] * 1.001 ? "0" : tickFormat(v));
  }
  const height = (p) => (p.error > 0 || scale.type !== "log" ? p.error : scale.domain[0]);
  const says = points.map((p) => ({ x: middle(p), y: height(p),
    text: [p.name, p.alike && p.alike !== p.name ? `like ${p.alike}` : null,
      `${figure(p.time)}${p.most > p.time ? ` to ${figure(p.most)}` : ""} ${unit} a ${choice.operation}`,
      p.bus ? `table ${figure(p.tabled.max)}, bus ${figure(p.bus)} clocks` : null,
      choice.error === "rms" ? `rms error ${figure(p.error)} ulp` : `largest error ${largest(p.error)} ulp`,
      p.rule ? `rounds: ${p.rule}` : null].filter(Boolean).join("\n") }));
  const color = (p) => colours[kinds[choice.from].indexOf(p.kind)] ?? colours[5];
  return {
    points: says,
    options: {
      height: narrow ? 320 : 380, marginLeft: 56, marginRight: narrow ? 20 : 40, marginBottom: 42, marginTop: 28,
      x: scaleFor(points.flatMap((p) => [p.time, p.most]), `${unit} a call, less is faster →`, Math.floor(width / 80)),
      y: scale,
      marks: [
        Plot.line(frontier, { x: middle, y: height, curve: "step-after", stroke: "currentColor",
          strokeDasharray: "4 3", className: "frontier" }),
        Plot.line(ofFixed, { x: middle, y: height, curve: "step-after", stroke: "var(--quiet)", strokeDasharray: "1 4",
          strokeWidth: 2, strokeLinecap: "round", className: "frontier-fixed" }),
        Plot.ruleY(points.filter((p) => p.most > p.time), { x1: "time", x2: "most", y: height, stroke: color }),
        ...kinds[choice.from].map((kind, i) => Plot.dot(points.filter((p) => p.kind === kind), { x: middle, y: height, r: 6,
          symbol: symbols[i], fill: symbols[i] === "times" ? "none" : colours[i], stroke: "var(--paper)",
          className: "points" })),
        // Above where it is exact, so as not to stand on the axis.
        ...[[-14, (p) => p.error === 0], [16, (p) => p.error > 0]].map(([dy, has]) =>
          Plot.text(narrow ? [] : unique([...frontier, ...ofFixed]).filter(has), { x: middle, y: height, text: "name", dy,
            dx: 4, textAnchor: "start", fill: "currentColor", stroke: "var(--paper)", strokeWidth: 4, className: "names" })),
      ],
    },
  };
}

function tradeControls() {
  const option = (value, text) => ({ value, text: text ?? value });
  const from = [option("host", "this machine"), option("clocks", "processors of the time")];
  return {
    from: { label: "speed on", values: from },
    time: { label: "time", values: [] },
    operation: { label: "operation", values: [] },
    operands: { label: "operands", values: [] },
    error: { label: "error", values: [option("rms", "root mean square"), option("max", "largest")] },
  };
}

// What there is to choose, given where the speed is from.
function tradeChoices(choice) {
  const option = (value, text) => ({ value, text: text ?? value });
  if (choice.from === "host") {
    return { time: [option("throughput_ns", "throughput"), option("chain_ns", "dependent chain")],
      operation: unique(hostRows().map((r) => r.operation)).map((o) => option(o)),
      operands: [option("uniform")] };
  }
  return { time: cpus.map(([value, text]) => option(value, text)).reverse(),
    operation: [option("mul"), option("div")],
    operands: unique(report.accuracy.accuracy.filter((r) => r.operation === (choice.operation || "mul"))
      .map((r) => r.operands)).map((o) => option(o)) };
}

function showTrade() {
  const parent = section("trade");
  let choice = {};
  let points = [];
  const { box, tell } = controls(tradeControls(), (chosen, fill) => {
    choice = chosen;
    // The operation decides which operands there are, so it comes first.
    for (const name of ["time", "operation", "operands"]) {
      fill(name, tradeChoices(choice)[name]);
      choice[name] = box.querySelector(`[name=${name}]`).value;
    }
    points = choice.from === "host" ? hostPoints(choice) : clockPoints(choice);
    if (shown) show();
  });
  const names = element("div", {});
  parent.append(box, names);
  const listed = element("details", {});
  let shown = null;
  const show = () => {
    names.replaceChildren(legend(kinds[choice.from].map((kind) => kindNames[kind] ?? kind)));
    shown.render();
    const ofFixed = fixedFrontierOf(points);
    shown.caption.textContent = points.length === 0 ? "Nothing was measured for this choice."
      : `On the line: ${frontierOf(points).map((p) => p.name).join("; ")}.` +
        (ofFixed.length ? ` Of fixed point alone, dotted: ${ofFixed.map((p) => p.name).join("; ")}.` : "");
    const unit = choice.from === "host" ? "ns" : "clocks";
    listed.replaceChildren(element("summary", {}, "The same as a table"),
      table("Speed and accuracy, fastest first", [
        { title: "variant", of: (p) => p.name },
        { title: "kind", of: (p) => kindNames[p.kind] ?? p.kind },
        { title: unit, of: (p) => between({ min: p.time, max: p.most }), number: true },
        ...(points.some((p) => p.bus) ? [
          { title: "by the table", of: (p) => between(p.tabled), number: true },
          { title: "by the bus", of: (p) => figure(p.bus), number: true },
        ] : []),
        { title: "error, ulp", of: (p) => (choice.error === "rms" ? figure : largest)(p.error), number: true },
      ], d3.sort(points, middle)));
  };
  tell();
  shown = charted(parent, "Speed and accuracy", "", (width) => tradePlot(points, choice, width));
  show();
  parent.append(listed);
  const { made, rounds, libraries } = report.host;
  const absent = Object.entries(libraries).filter(([, there]) => !there).map(([name]) => `${name} was not installed and is left out.`);
  parent.append(element("p", { class: "quiet" }, `On this machine: ${made.processor}, ${made.compiler} ${made.flags}, ` +
    `medians of ${count(rounds)} ${rounds === 1 ? "round" : "rounds"}. ${absent.join(" ")}`));
}
