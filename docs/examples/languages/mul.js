// A 16.16 multiply in JavaScript that rounds down: reads cases, writes results.
// Numbers hold 53 bits and products have 64, so integers of any size are needed.
const mul = (a, b) => BigInt.asIntN(32, (a * b) >> 16n);
const word = (text) => BigInt.asIntN(32, BigInt(`0x${text}`));
const hex = (value) => BigInt.asUintN(32, value).toString(16).padStart(8, "0");

const lines = require("fs").readFileSync(0, "utf8").trimEnd().split("\n");
const results = lines.map((line) => hex(mul(...line.split(" ").map(word))) + "\n");
process.stdout.write(results.join(""));
