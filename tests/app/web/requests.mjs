// usage: node requests.mjs MODULE.wasm
//
// Checks that no request ends the module: every answer to 20,000 requests, both sensible and malformed, must be JSON.
// Status 0: every answer is, 1: one is not.
import { readFileSync } from "node:fs";
import { loadModule } from "../../../app/web/page/wasm.mjs";

const module = await loadModule(readFileSync(process.argv[2]));
let seed = 1994;
const below = (n) => {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return Math.floor((seed / 2 ** 32) * n);
};
const one = (list) => list[below(list.length)];
const junk = () => Array.from({ length: below(12) }, () => one([..."0123456789.-+xXbBefq_ ,;\n\té\u0000"])).join("");
const number = () => one(["0", "1", "-1", "0.5", "-32768", "32767.99999", "0x80000000", "0xffffffff", "0b1", "1e5",
  "9".repeat(100), "9".repeat(101), `0.${"0".repeat(90)}1`, "-0.0000152587890625", "", junk()]);
const format = () => one(["q16_16", "q8_8", "u0_64", "q1_63", "q32_0", "u0_8", junk()]);
const routine = () => one(["mul", "div", "cossin", "xformvec", "concat", "gouraud", "depth", "texture", junk()]);
const build = () => one(["none", "i386-on", "i386-off", "i8088-on", "i8088-off", "i386-52", "i8088-on-repaired",
  "i8088-off-scanned", "i386", "i8088", "i8088-printed", "byte-i386-loop", "word-i8088-dec-jnz", "i386-loop",
  "i386-dec-jnz-printed", "i8088-loop", junk()]);
// Code that a person may type: instructions of the listings, and others with parts of two.
const texts = Object.entries(module.ask("routines")).flatMap(([name, builds]) => builds.flatMap((each) => {
  const operands = { cossin: "1", gouraud: "1 1 1", depth: "1 1 1", texture: "1 1 1 1 1" }[name] ??
    Array(name === "concat" ? 24 : name === "xformvec" ? 15 : 2).fill("1").join(" ");
  return module.ask("trace", name, each, "none", operands).runs[0].listing.map(({ text }) => text);
}));
const parts = texts.flatMap((text) => text.split(" ").slice(1).join(" ").split(", "));
const typed = () => one([
  () => one(texts), () => `${one(texts).split(" ")[0]} ${one(parts)}, ${one(parts)}`,
  () => `${one(texts).split(" ")[0]} ${one(parts)}`, () => `L${below(3)}: ${one(texts)}`,
  () => `${one(["jmp", "jz", "loop", "call", "ja", "js"])} .L${below(3)}`, () => one(texts), () => one(texts), junk])();
const registers = () => one(["", "", "ax=1 cx=3", "edx=ffffffff bp=50", "sp=1", junk()]);
const edited = () => {
  const [name, with_] = one([["mul", "i386-on"], ["mul", "i8088-on"], ["div", "i8088-off"], ["cossin", "i386"],
    ["gouraud", "byte-i386-loop"], ["depth", "i8088-loop"], ["texture", "i386-loop"]]);
  const operands = { cossin: "300", gouraud: "7 32 1", depth: "2 1 1", texture: "2 1 1 1 1" }[name] ?? "-0.5 1.5";
  return [name, with_, "none", operands, registers(), "L0:", ...Array.from({ length: 1 + below(3) }, typed), "L1:",
    ...Array.from({ length: below(2) }, typed), "L2: ret"];
};
const requests = {
  number: () => [format(), number()],
  operation: () => [one(["add", "sub", "mul", "div", "sqrt", junk()]), format(), number(), number()],
  trace: () => [routine(), build(), build(), Array.from({ length: one([1, 2, 15, 24, 3, 5]) }, number).join(" ")],
  edited,
  state: () => [one(["0", "1", "2", junk()]), one(["0", "5", "99999999999999999999", "-1", junk()])],
};
let ran = 0;
for (let i = 0; i < 20_000; ++i) {
  const name = one(Object.keys(requests));
  const lines = one([true, true, true, false]) ? requests[name]() : [junk()];
  try {
    const { runs } = module.ask(name === "edited" ? "trace" : name, ...lines);
    if (name === "edited" && runs) ran += 1;
    if (name === "edited" && runs) module.ask("state", "0", String(below(runs[0].steps + 1)));
  } catch (error) {
    console.log(`${name} ${JSON.stringify(lines)}: ${error.message}`);
    process.exit(1);
  }
}
// Requests for many cases are answered as text. A malformed one has no answer.
for (let i = 0; i < 2000; ++i) {
  const lines = [[one(["mul", "div", junk()]), format(), one(["0", "6", "7", "-1", junk()])].join(" "), number(), junk()];
  try {
    module.text("answers", lines.join("\n"));
  } catch (error) {
    console.log(`answers ${JSON.stringify(lines)}: ${error.message}`);
    process.exit(1);
  }
}
console.log(`20,000 requests answered; ${ran.toLocaleString("en")} typed programs ran`);
process.exit(ran > 100 ? 0 : 1);
