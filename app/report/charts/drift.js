// The drift of rotating bodies.

// Each group of cases answers one question.
const driftGroups = {
  builds: { text: "the four builds",
    has: (c) => c.without === "nothing" && c.restore_every === 0 && !c.from_scratch },
  held: { text: "with remedies", has: (c) => c.restore_every > 0 || c.from_scratch || c.name === "386 on" },
  sources: { text: "386, rounded, without one source of error",
    has: (c) => c.multiply === "386 on" && c.restore_every === 0 && !c.from_scratch },
};

function driftPlot(cases, what, width) {
  const { frames_a_point: step, frames_a_second: rate, thresholds } = report.drift;
  const edges = what === "length";
  const unit = edges ? 100 : 1;  // lengths are shown in percent
  const points = cases.flatMap((c, i) => c.series[what]
    .map((v, at) => ({ name: c.name, i, x: (at * step) / rate / 60, y: v * unit }))
    .filter((p) => p.y > 0 && Number.isFinite(p.y)));
  const least = Math.max(1e-6, d3.min(points, (p) => p.y) ?? 1e-6);
  const lines = edges ? [100 * thresholds.some, 100 * thresholds.much] : [thresholds.pixels];
  return {
    points: points.filter((p) => p.y >= least).map((p) => ({ x: p.x, y: p.y,
      text: `${p.name}\nafter ${figure(p.x)} min\n${edges ? `edge length off by ${figure(p.y)} %` : `off by ${figure(p.y)} pixels`}` })),
    options: {
      ...frame(width),
      x: { label: `minutes at ${rate} frames per second →`, grid: true, ticks: Math.floor(width / 80) },
      y: logScale([least, d3.max(points, (p) => p.y) ?? 1, ...lines],
        edges ? "↑ worst error of an edge length, %" : "↑ worst error of a corner, pixels"),
      marks: [
        Plot.ruleY(lines, { stroke: "currentColor", strokeDasharray: "5 3", className: "thresholds" }),
        Plot.text(lines, { frameAnchor: "right", y: (v) => v, text: (v) => (edges ? `${figure(v)} %` : `${figure(v)} pixel`),
          dy: -8, textAnchor: "end", fill: "currentColor", stroke: "var(--paper)", strokeWidth: 4 }),
        Plot.line(points, { x: "x", y: "y", z: "name", stroke: (p) => colours[p.i % colours.length], strokeWidth: 1.75,
          clip: true, className: "lines" }),
        // Symbols tell the lines apart without colour.
        ...cases.map((c, i) => Plot.dot(points.filter((p, at) => p.i === i && p.y >= least && at % 24 === 4 * i),
          { x: "x", y: "y", r: 4, symbol: symbols[i % symbols.length], fill: colours[i % colours.length],
            stroke: colours[i % colours.length] })),
      ],
    },
  };
}

function showDrift() {
  const { scene, frames, frames_a_second: rate, cases } = report.drift;
  const text = section("drift-says");
  text.textContent = `Every object of ${scene} turns by one small step per frame for ${count(frames)} frames, ` +
    `${figure(frames / rate / 60)} min at ${rate} frames per second. Each step is appended to the last. The curves show the ` +
    "worst object.";
  const names = element("div", {});
  const holder = element("div", {});
  let chosen = [];
  let what = "length";
  const { box, update } = controls({
    group: { label: "show", values: Object.entries(driftGroups).map(([value, group]) => ({ value, text: group.text })) },
    what: { label: "error", values: [{ value: "length", text: "edge lengths" }, { value: "pixels", text: "pixels on the screen" }] },
  }, (choice) => {
    what = choice.what;
    chosen = cases.filter(driftGroups[choice.group].has);
    names.replaceChildren(legend(chosen.map((c) => c.name)));
    shown.render();
    const times = chosen.map((c) => {
      const first = what === "length" ? c.first.some : c.first.pixel;
      return `${c.name} ${first === null ? "never" : `after ${figure(first / rate)} s`}`;
    });
    shown.caption.textContent = (what === "length" ? "An edge length is off by 2 %: " : "A corner is off by one pixel: ") +
      times.join("; ") + ".";
  });
  const shown = figureWithCaption(holder, "Drift over time", "", (width) => driftPlot(chosen, what, width));
  text.after(box, names, holder);
  update();
}
