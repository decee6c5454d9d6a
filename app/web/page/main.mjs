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
const place = document.getElementById("view");

// A person who asks for less motion starts the scenes by hand.
const still = matchMedia("(prefers-reduced-motion: reduce)").matches ? { play: "no" } : {};
const read = (hash) => ({ ...stateOf(hash), ...still });

let address = location.hash;
let state = read(address);
let module;
let writing;

function draw() {
  if (!Object.hasOwn(views, state.view)) state.view = defaults.view;
  for (const link of document.querySelectorAll("#views a")) {
    const { view } = stateOf(new URL(link.href).hash);
    link.href = hashOf({ ...state, view });
    link.setAttribute("aria-current", view === state.view ? "page" : "false");
  }
  const [view, after] = views[state.view];
  render(view(module, state, update), place);
  after?.(module, state, () => state);
  document.documentElement.dataset.drawn = state.view;
}

// A view changes the state, never the page itself. The address follows after a pause: Safari refuses more than 100
// changes of it in 30 seconds, and a slider makes more.
function update(changes) {
  state = { ...state, ...changes };
  clearTimeout(writing);
  writing = setTimeout(write, 200);
  draw();
}

function write() {
  if (location.hash !== address) return;  // a link was followed in between
  history.replaceState(null, "", hashOf(state));
  address = location.hash;
}

function say(problem) {
  const text = document.createElement("p");
  text.setAttribute("role", "alert");
  text.textContent = problem;
  place.replaceChildren(text);
}

addEventListener("hashchange", () => {
  address = location.hash;
  state = read(address);
  reopenScenes();
  draw();
  scrollTo(0, 0);
});

try {
  module = await embeddedModule();
  place.replaceChildren();
  draw();
  performance.mark("started");
  addEventListener("error", ({ message }) => say(`The module stopped: ${message}. Load the page again.`));
} catch ({ message }) {
  say(`The module did not start: ${message}. Use a current browser that allows WebAssembly.`);
}
