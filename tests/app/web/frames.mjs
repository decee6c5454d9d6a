// usage: node frames.mjs MODULE.wasm FIXPROOF SCENES
//
// Checks that the module draws the same frames as the native command, which reads the scenes itself: 120 frames of each
// scene in each arithmetic. Status 0: they are equal, 1: they are not.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { loadModule } from "../../../app/web/page/wasm.mjs";

const [moduleFile, fixproof, scenesFolder] = process.argv.slice(2);
const FRAMES = 120;
// In the order of the module's arithmetics.
const ROUNDED = [["on", "on"], ["on", "off"], ["off", "on"], ["off", "off"]];
const builds = ["i386", "i8088"].flatMap((target) => ROUNDED.map(([mul, div]) =>
  ["--arith", "type", "--target", target, "--mul-round", mul, "--div-round", div]));
const options = [...builds, [...builds[4], "--repaired"], ["--arith", "type", "--target", "standard"],
  ["--arith", "type", "--target", "saturating"], ["--arith", "double"]];

const { c, ask } = await loadModule(readFileSync(moduleFile));
const { scenes, arithmetics } = ask("stages");
if (arithmetics.length !== options.length) throw new Error(`${arithmetics.length} arithmetics, not ${options.length}`);
const folder = mkdtempSync(join(tmpdir(), "frames-"));
process.on("exit", () => rmSync(folder, { recursive: true }));
let wrong = 0;
let compared = 0;
scenes.forEach((scene, index) => {
  options.forEach((given, arithmetic) => {
    const file = join(folder, "digests.txt");
    execFileSync(fixproof, ["render", join(scenesFolder, `${scene.file}.json`), "--frames", String(FRAMES), ...given,
      "--digests", file], { stdio: "ignore" });
    const native = readFileSync(file, "utf8").trim().split("\n");
    const ours = [];
    c.stage_open(index, arithmetic, arithmetic);
    for (let frame = 0; frame < FRAMES; ++frame) {
      c.stage_seek(frame, 1);
      if (c.stage_draw() !== 0) throw new Error(`${scene.file}: two sides in one arithmetic differ`);
      const indices = new Uint8Array(c.memory.buffer, c.stage_indices(), scene.width * scene.height);
      const digest = createHash("sha256").update(indices).digest("hex").slice(0, 16);
      if (ours.at(-1) !== digest) ours.push(digest);
    }
    compared += ours.length;
    const at = native.findIndex((digest, i) => digest !== ours[i]);
    if (at < 0 && native.length === ours.length) return;
    console.log(`${scene.file}, ${arithmetics[arithmetic].name}: picture ${at} differs; ` +
      `the module draws ${ours.length}, the command ${native.length}`);
    wrong += 1;
  });
});
const pictures = compared.toLocaleString("en");
console.log(`${pictures} pictures of ${scenes.length} scenes in ${arithmetics.length} arithmetics`);
process.exit(wrong ? 1 : 0);
