// usage: node digest.mjs MODULE.wasm FIXPROOF
//
// Checks that the module gives the same words as the native command, for 10,000 cases of each operation in each format.
// Prints a digest of all words. Status 0: they are equal, 1: they are not.
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { loadModule } from "../../../app/web/page/wasm.mjs";

const [moduleFile, fixproof] = process.argv.slice(2);
const CASES = 10_000;
const OPERATIONS = { add: 2, sub: 2, mul: 2, div: 2, sqrt: 1 };

// xorshift64*, so that every machine has the same operands.
let seed = 1994n;
function random() {
  seed ^= seed >> 12n;
  seed ^= (seed << 25n) & 0xffffffffffffffffn;
  seed ^= seed >> 27n;
  return (seed * 0x2545f4914f6cdd1dn) & 0xffffffffffffffffn;
}

// Returns words of every magnitude, and the ends of the range.
function word(bits) {
  const value = random();
  const edges = [0n, 1n, ~0n, 1n << BigInt(bits - 1), (1n << BigInt(bits - 1)) - 1n];
  const chosen = value % 8n === 0n ? edges[Number((value >> 3n) % 5n)] : value >> ((value >> 8n) % BigInt(bits));
  return BigInt.asUintN(bits, value % 3n === 0n ? -chosen : chosen).toString(16).padStart(bits / 4, "0");
}

const module = await loadModule(readFileSync(moduleFile));
const formats = module.ask("number", "q16_16", "0").rows;
const digest = createHash("sha256");
let cases = 0;
let wrong = 0;
for (const { name, bits } of formats) {
  for (const [operation, operands] of Object.entries(OPERATIONS)) {
    const lines = Array.from({ length: CASES }, () =>
      Array.from({ length: operands }, () => word(bits)).join(" "));
    const native = execFileSync(fixproof, ["eval", operation, "--format", name],
      { input: lines.join("\n") + "\n", encoding: "utf8", maxBuffer: 1 << 26 });
    const ours = module.text("answers", [`${operation} ${name}`, ...lines].join("\n"));
    digest.update(ours);
    cases += CASES;
    if (ours === native) continue;
    const [a, b] = [ours.split("\n"), native.split("\n")];
    const at = b.findIndex((line, i) => line !== a[i]);
    console.log(`${operation} ${name} ${lines[at]}: ${a[at]}, the command says ${b[at]}`);
    wrong += 1;
  }
}
console.log(`${cases.toLocaleString("en")} cases in ${formats.length} formats, SHA-256 ${digest.digest("hex")}`);
process.exit(wrong ? 1 : 0);
