// The address of the page holds what it shows, so that a link shows the same.

// In place of a formula: one that fits the operation and the format. An empty box stays empty.
export const SAMPLE = "*";

export const defaults = {
  view: "number",
  text: "0.1", format: "q16_16",
  keep: "value",
  op: "mul", in: "q16_16", a: "0xffffffff", b: "0.5", formula: SAMPLE,
  routine: "mul", build: "i386-on", beside: "i8088-on", operands: "-0.5 1.5", step: "0", breaks: "",
  code: "", registers: "",
  scene: "twelve_cubes", arithmetic: "i8088-on", against: "double", show: "difference", play: "yes", frame: "0",
};

// Returns the state in an address. Missing keys have their defaults, and unknown keys are ignored.
export function stateOf(hash) {
  const given = new URLSearchParams(hash.replace(/^#/, ""));
  const state = { ...defaults };
  for (const [key, value] of given) if (Object.hasOwn(defaults, key)) state[key] = value;
  return state;
}

// Returns the address of a state: the view, and what differs from the defaults.
export function hashOf(state) {
  const kept = Object.entries(state).filter(([key, value]) => key === "view" || value !== defaults[key]);
  return "#" + new URLSearchParams(kept).toString();
}
