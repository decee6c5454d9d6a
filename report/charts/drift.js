// What becomes of turning bodies.

// Rows that answer one question each.
const driftGroups = [
  { value: "builds", text: "the four builds",
    has: (c) => c.without === "nothing" && c.restore_every === 0 && !c.from_scratch },
  { value: "held", text: "held back",
    has: (c) => c.restore_every > 0 || c.from_scratch || (c.name === "386 on") },
  { value: "sources", text: "386, rounded: what each source of error does",
    has: (c) => c.multiply === "386 on" && c.restore_every === 0 && !c.from_scratch },
];

function driftPlot(cases, choice, width) {
  const { frames_a_point: step, frames_a_second: rate, thresholds } = report.drift;
  const narrow = width < 480;
  const edges = choice.what === "length";
  const shown = edges ? 100 : 1;
  const points = cases.flatMap((c, i) => c.series[choice.what]
    .map((v, at) => ({ name: c.name, i, x: (at * step) / rate / 60, y: v * shown }))
    .filter((p) => p.y > 0 && Number.isFinite(p.y)));
  // Below a millionth nothing is told apart.
  const least = Math.max(1e-6, d3.min(points, (p) => p.y) ?? 1e-6);
  const lines = edges ? [100 * thresholds.some, 100 * thresholds.much] : [thresholds.pixels];
  return {
    points: points.filter((p) => p.y >= least).map((p) => ({ x: p.x, y: p.y,
      text: `${p.name}\nafter ${figure(p.x)} min\n${edges ? `edges ${figure(p.y)} % wrong` : `${figure(p.y)} pixels off`}` })),
    options: {
      height: narrow ? 320 : 380, marginLeft: 56, marginRight: 24, marginBottom: 42, marginTop: 28,
      x: { label: `minutes at ${rate} frames a second →`, grid: true, ticks: Math.floor(width / 80) },
      y: logScale([least, d3.max(points, (p) => p.y) ?? 1, ...lines],
        edges ? "↑ worst edge, % too long or short" : "↑ worst corner, pixels off"),
      marks: [
        Plot.ruleY(lines, { stroke: "currentColor", strokeDasharray: "5 3", className: "thresholds" }),
        Plot.text(lines, { frameAnchor: "right", y: (v) => v, text: (v) => (edges ? `${figure(v)} %` : `${figure(v)} pixel`),
          dy: -8, textAnchor: "end", fill: "currentColor", stroke: "var(--paper)", strokeWidth: 4 }),
        Plot.line(points, { x: "x", y: "y", z: "name", stroke: (p) => colours[p.i % colours.length], strokeWidth: 1.75,
          clip: true, className: "lines" }),
        // Marks along the way tell lines apart without their colours.
        ...cases.map((c, i) => Plot.dot(points.filter((p, at) => p.i === i && p.y >= least && at % 24 === 4 * i),
          { x: "x", y: "y", r: 4, symbol: symbols[i % symbols.length], fill: colours[i % colours.length],
            stroke: colours[i % colours.length] })),
      ],
    },
  };
}

function showDrift() {
  const parent = section("drift");
  const { scene, frames, frames_a_second: rate, cases } = report.drift;
  section("drift-says").textContent = `Every object of ${scene} turns by one small step a frame, each appended to the ` +
    `last, for ${count(frames)} frames: ${figure(frames / rate / 60)} min at ${rate} a second. Curves show the worst of any object.`;
  const before = section("drift-says").nextElementSibling;
  let chosen = [];
  let choice = {};
  let shown = null;
  const names = element("div", {});
  const { box, tell } = controls({
    group: { label: "show", values: driftGroups.map(({ value, text }) => ({ value, text })) },
    what: { label: "what", values: [{ value: "length", text: "lengths of edges" }, { value: "pixels", text: "pixels on the screen" }] },
  }, (now) => {
    choice = now;
    chosen = cases.filter(driftGroups.find((g) => g.value === now.group).has);
    names.replaceChildren(legend(chosen.map((c) => c.name)));
    if (shown) show();
  });
  const holder = element("div", {});
  before.before(box, names, holder);
  const show = () => {
    shown.render();
    const first = chosen.map((c) => {
      const frame = choice.what === "length" ? c.first.some : c.first.pixel;
      return `${c.name} ${frame === null ? "never" : `after ${figure(frame / rate)} s`}`;
    });
    shown.caption.textContent = (choice.what === "length" ? "An edge is 2 % wrong: " : "A corner is a pixel off: ") +
      first.join("; ") + ".";
  };
  tell();
  shown = charted(holder, "Drift over time", "", (width) => driftPlot(chosen, choice, width));
  show();
}
