// X-Sharp on a canvas. The arithmetic can be switched while a scene runs. Every pixel is compared with another
// arithmetic.
import { html } from "../vendor/lit-html.js";
import { select } from "./parts.mjs";

const MINUTES = 30;
// The most moves in one tick while the target is ahead. They take at most a tenth of a second, so the page still
// answers.
const MOVES = 1500;

// The running scene. When a control changes, the page is drawn again; tick() writes the figures of each frame.
const run = {
  opened: "", arithmetic: -1, frame: 0, target: 0, fresh: false, ticking: false, drawn: [], last: 0, owed: 0,
};

// A link opens a scene from its first frame, whatever ran before.
export function reopenScenes() {
  run.opened = "";
}

const part = (name) => document.querySelector(`#stage [data-part="${name}"]`);
const clock = (frame, fps) => {
  const seconds = Math.floor(frame / fps);
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
};

function show(c, scene, name, which) {
  const pixels = new Uint8ClampedArray(c.memory.buffer, c.stage_pixels(which), 4 * scene.width * scene.height);
  part(name).getContext("2d").putImageData(new ImageData(pixels.slice(), scene.width, scene.height), 0, 0);
}

function drawFrame(c, scene, other) {
  const wrong = c.stage_draw();
  show(c, scene, "played", 0);
  show(c, scene, "other", other);
  part("wrong").textContent = wrong.toLocaleString("en");
  part("frame").textContent = run.frame.toLocaleString("en");
  part("time").textContent = clock(run.frame, scene.frames_per_second);
  // The slider shows the target, so that it stays where a person puts it.
  const target = clock(run.target, scene.frames_per_second);
  part("slider").value = run.target;
  part("slider").setAttribute("aria-valuetext", target);
  part("busy").textContent = run.frame < run.target ? `moving to ${target}` : "";
}

// One tick of the screen. Moves towards the target frame, and advances the target with the time if the scene plays.
function tick(now, module, stateNow) {
  const state = stateNow();
  if (state.view !== "scenes" || !document.getElementById("stage")) {
    run.ticking = false;
    return;
  }
  const { scenes } = stagesOf(module);
  const scene = sceneOf(scenes, state);
  const most = MINUTES * 60 * scene.frames_per_second;
  if (state.play === "yes" && run.frame === run.target) {
    // The first tick may have a time before that at which the scene was opened.
    const passed = Math.max(0, now - run.last);
    run.owed = Math.min(4, run.owed + passed * scene.frames_per_second / 1000);
    const whole = Math.floor(run.owed + 0.01);  // a tick may come a little early
    run.owed -= whole;
    run.target = Math.min(most, run.target + whole);
  }
  run.last = now;
  if (run.frame !== run.target || run.fresh) {
    run.frame = module.c.stage_seek(run.target, MOVES);
    run.fresh = false;
    drawFrame(module.c, scene, state.show === "other" ? 1 : 2);
    run.drawn.push(now);
  }
  while (run.drawn.length && run.drawn[0] < now - 1000) run.drawn.shift();
  part("fps").textContent = String(run.drawn.length);
  requestAnimationFrame((next) => tick(next, module, stateNow));
}

let known;
const stagesOf = (module) => known ??= module.ask("stages");
const sceneOf = (scenes, state) => scenes.find((scene) => scene.file === state.scene) ?? scenes[0];
const arithmeticOf = (arithmetics, key) => arithmetics.find((one) => one.key === key) ?? arithmetics[0];
const indexOf = (arithmetics, key) => arithmetics.indexOf(arithmeticOf(arithmetics, key));
const within = (text, count) => Math.min(count - 1, Math.max(0, Number.parseInt(text, 10) || 0));

// Opens the scene, or switches the arithmetic of the running one.
function follow(module, state) {
  const { scenes, arithmetics } = stagesOf(module);
  const opened = [state.scene, state.against].join("\n");
  const played = indexOf(arithmetics, state.arithmetic);
  if (run.opened !== opened) {
    module.c.stage_open(scenes.indexOf(sceneOf(scenes, state)), played, indexOf(arithmetics, state.against));
    run.target = within(state.frame, MINUTES * 60 * sceneOf(scenes, state).frames_per_second + 1);
    run.frame = 0;
  } else if (run.arithmetic !== played) {
    module.c.stage_switch(played);
  }
  Object.assign(run, { opened, arithmetic: played, fresh: true });
}

export function scenesView(module, state, update) {
  const { scenes, arithmetics } = stagesOf(module);
  const scene = sceneOf(scenes, state);
  const choices = arithmetics.map(({ key, name }) => [key, name]);
  const [arithmetic, against] = [state.arithmetic, state.against].map((key) => arithmeticOf(arithmetics, key).key);
  const most = MINUTES * 60 * scene.frames_per_second;
  // A change keeps the frame: the address names the one that the scene moves to.
  const change = (changes) => update({ ...changes, frame: String(run.target) });
  const go = (frame) => {
    run.target = Math.max(0, Math.min(most, Math.round(frame) || 0));
    change({ play: "no" });
  };
  const restart = () => {
    reopenScenes();
    update({ frame: "0" });
  };
  return html`
    <h2>X-Sharp in two arithmetics</h2>
    <p>Switch the arithmetic while the scene runs: the new one continues where the old one stopped. A link, or a switch
      to or from double, computes every frame again. Restart plays from the first frame. White pixels differ from the
      other arithmetic.</p>
    <div class="choices">
      ${select("Scene", scene.file, scenes.map(({ file, name }) => [file, name]),
        (file) => update({ scene: file, frame: "0" }))}
      ${select("Arithmetic", arithmetic, choices, (chosen) => change({ arithmetic: chosen }))}
      ${select("Compared with", against, choices, (chosen) => change({ against: chosen }))}
      ${select("On the right", state.show, [["difference", "pixels that differ"], ["other", "the other arithmetic"]],
        (chosen) => update({ show: chosen }))}
    </div>
    <div id="stage">
      <div class="stepper">
        <button name="play" @click=${() => change({ play: state.play === "yes" ? "no" : "yes" })}>
          ${state.play === "yes" ? "Pause" : "Play"}</button>
        <button name="back" @click=${() => go(run.frame - 1)}>← Frame</button>
        <button name="forward" @click=${() => go(run.frame + 1)}>Frame →</button>
        <button name="restart" @click=${restart}>Restart</button>
        <input type="range" data-part="slider" aria-label="Time, 0 to 30 minutes" min="0" max=${most} step="1"
          @input=${(e) => go(Number(e.target.value))}>
      </div>
      <p class="figures"><span><b data-part="time">0:00</b> of 30:00</span>
        <span>frame <b data-part="frame">0</b></span> <span><b data-part="wrong">0</b> pixels differ</span>
        <span><b data-part="fps">0</b> frames per second</span> <span data-part="busy"></span></p>
      <div class="canvases">
        <canvas data-part="played" width=${scene.width} height=${scene.height} role="img"
          aria-label="The scene"></canvas>
        <canvas data-part="other" width=${scene.width} height=${scene.height} role="img"
          aria-label=${state.show === "other" ? "The scene in the other arithmetic" : "Pixels that differ"}></canvas>
      </div>
    </div>`;
}

export function afterScenes(module, state, stateNow) {
  follow(module, state);
  if (run.ticking) return;
  Object.assign(run, { ticking: true, last: performance.now(), owed: 0, drawn: [] });
  requestAnimationFrame((now) => tick(now, module, stateNow));
}
