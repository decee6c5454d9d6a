// What the page shows is in its address, so that a link shows the same.

export const defaults = {
  view: "number",
  text: "0.1", format: "q16_16",
  op: "mul", in: "q16_16", a: "0xffffffff", b: "0.5",
  routine: "mul", build: "i386-on", beside: "i8088-on", operands: "-0.5 1.5", step: "0",
  scene: "twelve_cubes", arithmetic: "4", against: "11", show: "difference", play: "yes", frame: "0",
};

// Values that are missing or unknown are the defaults.
export function stateOf(hash) {
  const given = new URLSearchParams(hash.replace(/^#/, ""));
  const state = { ...defaults };
  for (const [key, value] of given) if (key in defaults) state[key] = value;
  return state;
}

// Only what differs from the defaults, and the view.
export function hashOf(state) {
  const kept = Object.entries(state).filter(([key, value]) => key === "view" || value !== defaults[key]);
  return "#" + new URLSearchParams(kept).toString();
}
