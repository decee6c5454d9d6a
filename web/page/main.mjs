// Starts the module and draws the view that the address names.
import { render } from "../vendor/lit-html.js";
import { casesView } from "./cases.mjs";
import { numberView } from "./number.mjs";
import { operationView } from "./operation.mjs";
import { afterScenes, reopenScenes, scenesView } from "./scenes.mjs";
import { defaults, hashOf, stateOf } from "./state.mjs";
import { afterTrace, traceView } from "./trace.mjs";
import { embeddedModule } from "./wasm.mjs";

// For each view: the function that draws it, and one that runs once it is drawn.
const views = {
  number: [numberView],
  operation: [operationView],
  trace: [traceView, afterTrace],
  scenes: [scenesView, afterScenes],
  cases: [casesView],
};

let state = stateOf(location.hash);
// A person who asks for less motion starts the scenes by hand.
if (matchMedia("(prefers-reduced-motion: reduce)").matches) state.play = "no";
let module;

function draw() {
  if (!(state.view in views)) state.view = defaults.view;
  for (const link of document.querySelectorAll("#views a")) {
    const { view } = stateOf(new URL(link.href).hash);
    link.href = hashOf({ ...state, view });
    link.setAttribute("aria-current", view === state.view ? "page" : "false");
  }
  const [view, after] = views[state.view];
  render(view(module, state, update), document.getElementById("view"));
  after?.(module, state, () => state);
  document.documentElement.dataset.drawn = state.view;
}

// A view changes the state, never the page itself.
function update(changes) {
  state = { ...state, ...changes };
  history.replaceState(null, "", hashOf(state));
  draw();
}

// If the module ends at a throw, the page says so.
function broken(error) {
  document.getElementById("view").textContent = `The module stopped: ${error.message}. Load the page again.`;
}

addEventListener("hashchange", () => {
  state = stateOf(location.hash);
  reopenScenes();
  draw();
  scrollTo(0, 0);
});
addEventListener("error", (event) => broken(event.error ?? event));

try {
  module = await embeddedModule();
  document.getElementById("view").replaceChildren();
  draw();
  performance.mark("started");
} catch (error) {
  broken(error);
}
