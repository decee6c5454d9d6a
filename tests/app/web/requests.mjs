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
const requests = {
  number: () => [format(), number()],
  operation: () => [one(["add", "sub", "mul", "div", "sqrt", junk()]), format(), number(), number()],
  trace: () => [routine(), build(), build(), Array.from({ length: one([1, 2, 15, 24, 3, 5]) }, number).join(" ")],
  state: () => [one(["0", "1", "2", junk()]), one(["0", "5", "99999999999999999999", "-1", junk()])],
};
for (let i = 0; i < 20_000; ++i) {
  const name = one(Object.keys(requests));
  const lines = one([true, true, true, false]) ? requests[name]() : [junk()];
  try {
    module.ask(name, ...lines);
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
console.log("20,000 requests answered");
