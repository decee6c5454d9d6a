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
const undoButton = document.getElementById("undo");
const redoButton = document.getElementById("redo");

// A person who asks for less motion starts the scenes by hand.
const still = matchMedia("(prefers-reduced-motion: reduce)").matches ? { play: "no" } : {};
const read = (hash) => ({ ...stateOf(hash), ...still });

let address = location.hash;
let state = read(address);
let module;
let writing;
// What the page showed before, and what it showed before a person undid it. Quick changes of one control are one step.
const MOST_STEPS = 500;
let past = [];
let future = [];
let last = { keys: "", time: 0 };

function draw() {
  if (!Object.hasOwn(views, state.view)) state.view = defaults.view;
  for (const link of document.querySelectorAll("#views a")) {
    const { view } = stateOf(new URL(link.href).hash);
    link.href = hashOf({ ...state, view });
    link.setAttribute("aria-current", view === state.view ? "page" : "false");
  }
  undoButton.disabled = !past.length;
  redoButton.disabled = !future.length;
  const [view, after] = views[state.view];
  render(view(module, state, update), place);
  after?.(module, state, () => state);
  document.documentElement.dataset.drawn = state.view;
}

// A view changes the state, never the page itself. The address follows after a pause: Safari refuses more than 100
// changes of it in 30 seconds, and a slider makes more.
function update(changes) {
  remember(Object.keys(changes).join());
  go({ ...state, ...changes });
}

function remember(keys) {
  const time = performance.now();
  if (keys !== last.keys || time - last.time > 700) past = [...past.slice(-MOST_STEPS), state];
  last = { keys, time };
  future = [];
}

// Moves a state from one list to the other.
function travel(from, to) {
  if (!from.length) return;
  to.push(state);
  last = { keys: "", time: 0 };
  reopenScenes();
  go(from.pop());
}
const undo = () => travel(past, future);
const redo = () => travel(future, past);

function go(next) {
  state = next;
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
  document.documentElement.dataset.drawn ??= "";  // shows the rest of the page
}

undoButton.addEventListener("click", undo);
redoButton.addEventListener("click", redo);
addEventListener("keydown", (event) => {
  const key = event.key.toLowerCase();
  // In a box, the browser undoes what was typed.
  if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.matches("input:not([type=range]), textarea")) return;
  if (key !== "z" && key !== "y") return;
  event.preventDefault();
  (key === "y" || event.shiftKey ? redo : undo)();
});

addEventListener("hashchange", () => {
  remember("address");
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
