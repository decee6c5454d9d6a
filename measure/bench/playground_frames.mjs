// usage: node playground_frames.mjs fixproof.wasm
// Times what the playground computes for one frame of each scene: it moves the objects, draws them in an arithmetic and
// in double, and marks the pixels that differ. Each figure is the least mean of 5 runs of 60 frames, in milliseconds.
import { readFileSync } from "node:fs";
import { loadModule } from "../../app/web/page/wasm.mjs";

const RUNS = 5;
const FRAMES = 60;
const ARITHMETICS = ["i386-on", "i8088-on", "q16_16"];

const { c, ask } = await loadModule(readFileSync(process.argv[2]));
const { scenes, arithmetics } = ask("stages");
const indexOf = (key) => arithmetics.findIndex((arithmetic) => arithmetic.key === key);

function timeOf(scene, arithmetic) {
  c.stage_open(scene, indexOf(arithmetic), indexOf("double"));
  let least = Infinity;
  for (let run = 0; run < RUNS; ++run) {
    const start = performance.now();
    for (let frame = 1; frame <= FRAMES; ++frame) {
      c.stage_seek(run * FRAMES + frame, 1);
      c.stage_draw();
    }
    least = Math.min(least, (performance.now() - start) / FRAMES);
  }
  return least;
}

console.log(`| scene | ${ARITHMETICS.join(" | ")} |`);
console.log(`| --- |${" --- |".repeat(ARITHMETICS.length)}`);
scenes.forEach(({ file }, scene) => {
  const times = ARITHMETICS.map((arithmetic) => timeOf(scene, arithmetic).toFixed(1));
  console.log(`| ${file} | ${times.join(" | ")} |`);
});
