// A routine or an inner loop, instruction by instruction, forward and backward. Two builds step together.
import { html, nothing } from "../vendor/lit-html.js";
import { input, problem, select, short } from "./parts.mjs";

const routineNames = [["mul", "FixedMul"], ["div", "FixedDiv"], ["cossin", "CosSin"], ["xformvec", "XformVec"],
  ["concat", "ConcatXforms"], ["gouraud", "Gouraud shading"], ["depth", "Depth test"], ["texture", "Texture"]];

const identity = "1 0 0 0  0 1 0 0  0 0 1 0";
const sampleOperands = {
  mul: "-0.5 1.5", div: "2 3", cossin: "300", xformvec: "0.5 0.5 0.5 0  0 -1 0 0  0 0 0 5  1 2 3",
  concat: `${identity}  ${identity}`, gouraud: "7 32 1.5", depth: "4 1 0.5", texture: "4 1 1 0 0",
};

const row = (name) => [name, 4];
const rows = ["row 1", "row 2", "row 3"];
const numbers = "Numbers are in 16.16.";
const transform = "Each row has the factors of x, y and z and then a shift, in 16.16.";
const stepped = "Intensities, depths and steps are in 24.8; a step is for one pixel.";
// The operands: for each box, its label and how many numbers it holds; then their unit.
const operandsOf = {
  mul: [[["First factor", 1], ["Second factor", 1]], numbers],
  div: [[["Dividend", 1], ["Divisor", 1]], numbers],
  cossin: [[["Angle in tenths of a degree", 1]], "300 is 30 degrees."],
  xformvec: [[...rows.map((name) => row(`Transform, ${name}`)), ["Point x y z", 3]], transform],
  concat: [[...rows.map((name) => row(`First, ${name}`)), ...rows.map((name) => row(`Second, ${name}`))], transform],
  gouraud: [[["Pixels", 1], ["Intensity", 1], ["Step", 1]], stepped],
  depth: [[["Pixels", 1], ["Depth", 1], ["Step", 1]], stepped],
  texture: [[["Pixels", 1], ["Column", 1], ["Column step", 1], ["Row", 1], ["Row step", 1]],
    "Columns, rows and steps are in 24.8; a step is for one pixel."],
};

// Returns the text of each box. Boxes that a person typed into are between semicolons.
function boxesOf(boxes, operands) {
  if (operands.includes(";")) return boxes.map((_, i) => operands.split(";")[i] ?? "");
  const parts = numbersIn(operands);
  return boxes.map(([, count], i) => i + 1 < boxes.length ? parts.splice(0, count).join(" ") : parts.join(" "));
}

const buildName = (name) => name.replace(/i(?=\d)/, "").replace("-on", ", rounded").replace("-off", ", not rounded")
  .replace("-52", ", chapter 52").replace("-repaired", ", repaired").replace("-scanned", ", as scanned")
  .replace("-printed", ", as printed").replace("byte-", "bytes, ").replace("word-", "words, ")
  .replace("-loop", ", LOOP").replace("-dec-jnz", ", DEC and JNZ");

const numbersIn = (text) => text.split(/[\s,;]+/).filter(Boolean);

// Says which box has too many or too few numbers.
function wrongCount(boxes, texts) {
  const at = boxes.findIndex(([, count], i) => numbersIn(texts[i]).length !== count);
  if (at < 0) return undefined;
  const [label, count] = boxes[at];
  return `${label}: type ${count} ${count === 1 ? "number" : "numbers"}, not ${numbersIn(texts[at]).length}.`;
}

// The last recorded trace. A change of the routine, a build, the operands or the code records it again.
let recorded = { key: "", answer: null };
function recording(module, state, wrong) {
  const request = [state.routine, state.build, state.beside, state.operands, state.registers, state.code];
  const key = request.join("\n");
  if (recorded.key === key) return recorded;
  const answer = wrong ? { error: wrong } : module.ask("trace", ...request);
  recorded = { key, error: answer.error, answer: answer.error ? recorded.answer : answer };
  return recorded;
}

const lastStep = (answer) => Math.max(...answer.runs.map((run) => run.steps));

// Returns the step that the address names: a number, or the first at which the builds differ.
function stepOf(answer, step) {
  const wanted = step === "differs" ? answer.differs : Number.parseInt(step, 10) || 0;
  return Math.max(0, Math.min(lastStep(answer), wanted));
}

// Breakpoints are pairs of a run and an instruction, such as `0.3`; the address separates them by `_`.
const breaksOf = (state) => new Set(state.breaks.split("_").filter(Boolean));

function toggled(state, key) {
  const breaks = breaksOf(state);
  if (!breaks.delete(key)) breaks.add(key);
  return { breaks: [...breaks].join("_") };
}

// Returns the next step, forward or back, at which a run executes an instruction with a breakpoint, or the last one.
function runOn(answer, breaks, step, by) {
  const end = by > 0 ? lastStep(answer) : 0;
  const hit = (at) => answer.runs.some(({ positions }, run) => at < positions.length && breaks.has(`${run}.${positions[at]}`));
  for (let at = step + by; at !== end && (end - at) * by > 0; at += by) if (hit(at)) return at;
  return end;
}

// A row sets or removes a breakpoint. Tab skips its button, because the key B does the same for the current one.
const instruction = (run, now, i, { text, label }, stopsHere, toggle) => {
  const current = now.step > 0 && i === now.position;
  const stops = !run.returns && i === run.stopped && now.step === run.steps;
  return html`<li class="${current ? "current" : ""} ${stops ? "stops" : ""}"
    aria-current=${current ? "step" : "false"} @click=${toggle}>
    <button class="plain break" tabindex="-1" aria-pressed=${stopsHere ? "true" : "false"}
      aria-label="Breakpoint at ${i}">${stopsHere ? "●" : "○"}</button>
    <span class="label">${label ?? ""}</span><span>${i.toString().padStart(3)}  ${text}</span></li>`;
};

const changing = ({ name, value, changed }) =>
  html`<div class=${changed ? "changed" : ""}><dt>${name}</dt><dd>${value}</dd></div>`;

const cell = ({ address, value, changed, sp, depth }, loop) =>
  html`<span class="${changed ? "changed" : ""} ${sp ? "sp" : ""} ${depth ? "depth" : ""}"
    title=${sp ? "top of the stack" : depth ? "depth" : loop ? "pixel" : ""}>${address} ${value}</span>`;

const returned = ({ word, value }) => html`<span class="code">${word}</span> (${short(value, 24)}) `;

function runView(run, now, breaks, toggle, edited) {
  const name = buildName(run.name) + (edited ? ", edited" : "");
  const memory = `${run.loop ? "Pixels and depths" : "Stack and operands in memory"}, ${name}`;
  const ending = !run.returns ? html`<strong>${run.ending}</strong>`
    : run.result.length ? html`Returns ${run.result.map(returned)}` : run.ending;
  return html`<article class="run">
    <h3>${name}</h3>
    <ol class="listing code" tabindex="0" aria-label="Listing, ${name}">
      ${run.listing.map((row, i) => instruction(run, now, i, row, breaks(i), () => toggle(i)))}</ol>
    <p class="code">step ${now.step} of ${run.steps}, ${now.clocks} clocks</p>
    <dl class="registers code">${now.registers.map(changing)}</dl>
    <dl class="flags code">${now.flags.map(changing)}</dl>
    <div class="memory code" tabindex="0" role="region" aria-label=${memory}>
      ${now.memory.map((each) => cell(each, run.loop))}</div>
    <p class="ending">${now.step === run.steps ? ending : ""}</p>
  </article>`;
}

const codeOf = ({ listing }) =>
  listing.map(({ text, label }) => (label ? `${label}:\n` : "") + `    ${text}`).join("\n");

// The code of the first build, to change. The second build stays as it is, so that both can be compared.
const editor = (state, run, update) => html`
  <details class="editor" ?open=${state.code !== "" || state.registers !== ""}>
    <summary>Edit the code and the registers of the first build</summary>
    <label class="choice"><span>Instructions, as in the listing, with labels before a colon</span>
      <textarea name="Code" rows="14" spellcheck="false" autocomplete="off" autocapitalize="off" .value=${
        state.code || codeOf(run)} @input=${(e) => update({ code: e.target.value, step: "0" })}></textarea></label>
    <div class="choices">
      ${input("Registers on entry, such as cx=1234 ebx=ffff8000", state.registers,
        (registers) => update({ registers, step: "0" }))}
      <button name="undoedits" ?disabled=${state.code === "" && state.registers === ""}
        @click=${() => update({ ...unedited, step: "0" })}>As printed</button>
    </div>
  </details>`;
const unedited = { code: "", registers: "" };

function stepKeys(event, go, toggle) {
  if (event.key === "b") toggle();
  const move = { ArrowLeft: -1, ArrowRight: 1, PageUp: -10, PageDown: 10, Home: -1e6, End: 1e6 }[event.key];
  if (!move || event.target.tagName === "INPUT") return;
  event.preventDefault();
  go(move);
}

export function traceView(module, state, update) {
  const known = Object.hasOwn(operandsOf, state.routine);
  const builds = known ? module.ask("routines")[state.routine] : [];
  const named = builds.map((name) => [name, buildName(name)]);
  const chooseRoutine = (routine) => {
    const of = module.ask("routines")[routine];
    update({ routine, operands: sampleOperands[routine], build: of[0], beside: "none", ...fresh });
  };
  const [boxes, unit] = known ? operandsOf[state.routine] : [[], ""];
  const texts = boxesOf(boxes, state.operands);
  const { error, answer } = recording(module, state, wrongCount(boxes, texts));
  const type = (i, text) => {
    texts[i] = text.replaceAll(";", " ");
    update({ operands: texts.join(";"), step: "0" });
  };
  const step = answer ? stepOf(answer, state.step) : 0;
  const go = (by) => update({ step: String(Math.max(0, Math.min(lastStep(answer), step + by))) });
  const fresh = { step: "0", breaks: "", ...unedited };
  const breaks = breaksOf(state);
  const toggle = (run, i) => update(toggled(state, `${run}.${i}`));
  const toggleHere = () => step > 0 && toggle(0, answer.runs[0].positions[Math.min(step, answer.runs[0].steps)]);
  const toBreak = (by) => update({ step: String(runOn(answer, breaks, step, by)) });
  return html`
    <h2>A routine, instruction by instruction</h2>
    <div class="choices">
      ${select("Routine", state.routine, routineNames, chooseRoutine)}
      ${select("Build", state.build, named, (build) => update({ build, ...fresh }))}
      ${select("Beside", state.beside, [["none", "nothing"], ...named], (beside) => update({ beside, step: "0", breaks: "" }))}
    </div>
    <div class="choices operands">
      ${boxes.map(([label, count], i) => input(label, texts[i], (text) => type(i, text), count === 1))}
    </div>
    <p class="unit">${unit}</p>
    ${problem(error)}
    ${answer ? html`<div class=${error ? "stale" : ""}>
      <div class="stepper" role="group" aria-label="Steps; arrow keys go back and forward, B sets a breakpoint"
        @keydown=${(e) => stepKeys(e, go, toggleHere)}>
        <button name="start" @click=${() => go(-1e6)}>Start</button>
        <button name="back" @click=${() => go(-1)}>← Back</button>
        <button name="forward" @click=${() => go(1)}>Forward →</button>
        <button name="end" @click=${() => go(1e6)}>End</button>
        <button name="differs" ?disabled=${answer.differs === 0}
          @click=${() => update({ step: "differs" })}>First difference</button>
        <button name="runback" ?disabled=${!breaks.size} @click=${() => toBreak(-1)}>◂ Run back</button>
        <button name="run" ?disabled=${!breaks.size} @click=${() => toBreak(1)}>Run ▸</button>
        <input type="range" aria-label="Step" min="0" max=${lastStep(answer)} .value=${String(step)}
          @input=${(e) => update({ step: e.target.value })}>
      </div>
      <div class="runs">${answer.runs.map((run, i) => runView(run, module.ask("state", i, step),
        (at) => breaks.has(`${i}.${at}`), (at) => toggle(i, at), i === 0 && state.code !== ""))}</div>
      ${editor(state, answer.runs[0], update)}</div>` : nothing}`;
}

// Scrolls the listing, but not the page, to keep the current instruction in sight.
export function afterTrace() {
  for (const list of document.querySelectorAll(".listing")) {
    const row = list.querySelector(".stops") ?? list.querySelector(".current");
    if (!row) list.scrollTop = 0;
    else if (row.offsetTop < list.scrollTop || row.offsetTop + row.offsetHeight > list.scrollTop + list.clientHeight) {
      list.scrollTop = row.offsetTop - list.clientHeight / 2;
    }
  }
}
