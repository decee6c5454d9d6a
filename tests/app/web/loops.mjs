// usage: node loops.mjs MODULE.wasm FIXPROOF
//
// Compares the module's record of every inner loop with `fixproof trace`, step by step: the instruction, the flags, the
// registers and the pixels that it changes. Status 0: they are the same, 1: they differ.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { loadModule } from "../../../app/web/page/wasm.mjs";

const module = await loadModule(readFileSync(process.argv[2]));
const commands = {
  gouraud: (build) => `gouraud-${build.split("-")[0]}`, depth: () => "depth", texture: () => "texture",
};
const words = {
  gouraud: ["00002000", "00000180"], depth: ["00000300", "ffffff40"],
  texture: ["00000140", "000000c0", "00000280", "00000140"],
};
const pixels = 6;

// Returns the steps that the command prints.
function printed(loop, build) {
  const options = ["--target", build.includes("i8088") ? "i8088" : "i386"];
  options.push("--loop", build.includes("dec-jnz") ? "dec-jnz" : "loop");
  if (build.endsWith("-printed")) options.push("--as-printed");
  const given = ["trace", commands[loop](build), `0000000${pixels}`, ...words[loop], ...options];
  return execFileSync(process.argv[3], given, { encoding: "utf8" }).trimEnd().split("\n").slice(1, -1);
}

// Returns the steps that the module records, as the command prints them.
function recorded(loop, build) {
  const operands = [pixels, ...words[loop].map((word) => `0x${word}`)].join(" ");
  const { error, runs: [run] = [] } = module.ask("trace", loop, build, "none", operands);
  if (error) throw new Error(`${loop} ${build}: ${error}`);
  return Array.from({ length: run.steps }, (_, i) => {
    const { position, flags, registers, memory } = module.ask("state", 0, i + 1);
    const changes = registers.filter((r) => r.changed).map((r) => `${r.name}=${r.value}`);
    for (const cell of memory) if (cell.changed && !cell.depth) changes.push(`[${cell.address}]=${cell.value}`);
    return { position, text: run.listing[position].text, flags: flags.map((f) => f.value).join("  "), changes };
  });
}

// Returns a printed step in the same form. The depth buffer starts at 0500. The command draws over its texture, so a
// texel of the same value is no change there; the register that is stored is compared.
function step(line, loop) {
  const [, position, text, flags, rest] = /^ *(\d+)  (.{30})  (.(?:  .){5}) *(.*)$/.exec(line);
  const changes = rest.split(" ").filter((part) => part && !/^\[05/.test(part) &&
    !(loop === "texture" && part.startsWith("[")));
  return { position: Number(position), text: text.trimEnd(), flags, changes };
}

const routines = module.ask("routines");
let steps = 0;
for (const loop of Object.keys(commands)) {
  for (const build of routines[loop]) {
    const wanted = printed(loop, build).map((line) => step(line, loop));
    const is = recorded(loop, build);
    for (let i = 0; i < Math.max(wanted.length, is.length); ++i) {
      if (loop === "texture" && is[i]) is[i].changes = is[i].changes.filter((part) => !part.startsWith("["));
      if (JSON.stringify(is[i]) !== JSON.stringify(wanted[i])) {
        console.log(`${loop} ${build}, step ${i + 1}: ${JSON.stringify(is[i])}, not ${JSON.stringify(wanted[i])}`);
        process.exit(1);
      }
      ++steps;
    }
  }
}
console.log(`${steps} steps are the same`);
