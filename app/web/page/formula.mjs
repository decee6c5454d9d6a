// A formula in C on two words, judged: which rounding rule it follows, and the first case in which it does not.
import { html, nothing } from "../vendor/lit-html.js";
import { formatRows, input, operations, problem } from "./parts.mjs";
import { SAMPLE } from "./state.mjs";

// From the operators that bind least to those that bind most.
const LEVELS = [["||"], ["&&"], ["|"], ["^"], ["&"], ["==", "!="], ["<", ">", "<=", ">="], ["<<", ">>"], ["+", "-"],
  ["*", "/", "%"]];
const MOST_SHIFTED = 255n;
const TOKEN = new RegExp([/\s+/, /0x[\da-f']+(?=[ul]*\b)|\d[\d']*(?=[ul]*\b)/, /\(\s*(?:u?int(?:8|16|32|64)_t|int|long long)\s*\)/,
  /[a-z_]\w*/, /<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^~!<>?:()]/].map(({ source }) => `(${source})`).join("|"), "iy");

// What has no value in C: a division by zero, or a shift by a count that no word has.
class NoResult extends Error {}
class WrongFormula extends Error {}

function tokensOf(text) {
  const tokens = [];
  for (let at = 0; at < text.length;) {
    TOKEN.lastIndex = at;
    const [all, space, number, cast, name, sign] = TOKEN.exec(text) ?? [];
    if (all === undefined) throw new WrongFormula(`what is “${text[at]}”?`);
    at = TOKEN.lastIndex;
    if (number) at += /^[ul]*/i.exec(text.slice(at))[0].length;
    if (!space) tokens.push({ all, number, cast, name, sign });
  }
  return tokens;
}

const divided = (a, b) => {
  if (b === 0n) throw new NoResult();
  return a / b;
};
const shifted = (a, by) => {
  if (by < 0n || by > MOST_SHIFTED) throw new NoResult();
  return a << by;
};
const COMPUTE = {
  "|": (a, b) => a | b, "^": (a, b) => a ^ b, "&": (a, b) => a & b, "==": (a, b) => BigInt(a === b),
  "!=": (a, b) => BigInt(a !== b), "<": (a, b) => BigInt(a < b), ">": (a, b) => BigInt(a > b),
  "<=": (a, b) => BigInt(a <= b), ">=": (a, b) => BigInt(a >= b), "<<": shifted,
  ">>": (a, by) => a >> (shifted(1n, by) && by), "+": (a, b) => a + b, "-": (a, b) => a - b, "*": (a, b) => a * b,
  "/": divided, "%": (a, b) => a - divided(a, b) * b,
};
const UNARY = { "-": (a) => -a, "+": (a) => a, "~": (a) => ~a, "!": (a) => BigInt(a === 0n) };

function cut(cast) {
  const [, unsigned, bits] = /(u?)int(\d+)_t/i.exec(cast) ?? [null, "", cast.includes("long") ? 64 : 32];
  return unsigned ? (a) => BigInt.asUintN(Number(bits), a) : (a) => BigInt.asIntN(Number(bits), a);
}

// Returns a function of a and b. Integers have as many bits as they need; only a cast cuts them.
export function formulaOf(text) {
  const tokens = tokensOf(text.replace(/^\s*return\b/, "").replace(/;\s*$/, ""));
  const next = (sign) => tokens[0]?.sign === sign && tokens.shift();
  const need = (sign) => next(sign) || wrong(`“${sign}”`);
  const wrong = (wanted) => {
    throw new WrongFormula(`${tokens[0] ? `“${tokens[0].all}” stands` : "it ends"} where ${wanted} should be`);
  };
  const primary = () => {
    const { number, cast, name, sign } = tokens[0] ?? {};
    if (number) {
      const digits = tokens.shift().all.replaceAll("'", "");
      const value = BigInt(/^0\d/.test(digits) ? `0o${digits}` : digits);
      return () => value;
    }
    if (cast) {
      tokens.shift();
      const [to, of] = [cut(cast), primary()];
      return (a, b) => to(of(a, b));
    }
    if (Object.hasOwn(UNARY, sign ?? "")) {
      const [change, of] = [UNARY[tokens.shift().sign], primary()];
      return (a, b) => change(of(a, b));
    }
    if (name === "a" || name === "b") return tokens.shift().all === "a" ? (a) => a : (_, b) => b;
    if (!next("(")) wrong("a, b or a number");
    const inner = choice();
    need(")");
    return inner;
  };
  const level = (at) => {
    if (at === LEVELS.length) return primary();
    let left = level(at + 1);
    while (LEVELS[at].includes(tokens[0]?.sign)) {
      const { sign } = tokens.shift();
      const [one, other] = [left, level(at + 1)];
      if (sign === "&&") left = (a, b) => BigInt(one(a, b) && other(a, b) ? 1 : 0);
      else if (sign === "||") left = (a, b) => BigInt(one(a, b) || other(a, b) ? 1 : 0);
      else left = (a, b) => COMPUTE[sign](one(a, b), other(a, b));
    }
    return left;
  };
  const choice = () => {
    const test = level(0);
    if (!next("?")) return test;
    const yes = choice();
    need(":");
    const no = choice();
    return (a, b) => test(a, b) ? yes(a, b) : no(a, b);
  };
  const whole = choice();
  if (tokens.length) wrong("an operator");
  return whole;
}

const wordIn = (bits, units) => BigInt.asUintN(bits, units).toString(16).padStart(bits / 4, "0");

// Returns pairs of units: every pair of a lattice of ends, powers and their neighbours, then numbers of every magnitude.
function casesOf({ bits, fraction, signed }) {
  const cutTo = (units) => signed ? BigInt.asIntN(bits, units) : BigInt.asUintN(bits, units);
  const one = 1n << BigInt(fraction);
  const end = 1n << BigInt(bits - 1);
  const marks = [0n, one / 2n, one, 3n * one / 2n, -one / 2n, -one, end, end / 2n, one << BigInt((bits - fraction) >> 1)];
  const lattice = [...new Set(marks.flatMap((mark) => [mark - 1n, mark, mark + 1n]).map(cutTo))];
  const cases = lattice.flatMap((a) => lattice.map((b) => [a, b]));
  // xorshift64*: every visitor has the same cases.
  let seed = 1994n;
  const random = () => {
    seed ^= seed >> 12n;
    seed = BigInt.asUintN(64, seed ^ seed << 25n);
    seed ^= seed >> 27n;
    const value = BigInt.asUintN(64, seed * 0x2545f4914f6cdd1dn);
    return cutTo(BigInt.asIntN(64, value) >> (value >> 8n) % BigInt(bits) + BigInt(64 - bits));
  };
  for (let i = 0; i < 2000; ++i) cases.push([random(), random()]);
  return cases;
}

let judged = { key: "" };
function judge(module, op, format, text) {
  const key = [op, format.name, text].join("\n");
  if (judged.key === key) return judged;
  judged = { key };
  let formula;
  try {
    formula = formulaOf(text);
  } catch (error) {
    judged.error = `The formula: ${error instanceof WrongFormula ? error.message : "a number is wrong"}.`;
    return judged;
  }
  const cases = casesOf(format);
  const lines = cases.map((pair) => pair.map((units) => wordIn(format.bits, units)).join(" "));
  const said = cases.map(([a, b]) => {
    try {
      return wordIn(format.bits, formula(a, b));
    } catch {
      return "DE";
    }
  });
  const names = module.ask("operation", op, format.name, "0", "0").rules.map(({ name }) => name);
  const answers = (rule) => module.text("answers", [`${op} ${format.name} ${rule}`, ...lines].join("\n")).split("\n");
  const saturated = answers(names.length);
  const words = names.map((_, rule) => answers(rule));
  // The first rule, saturating, differs from the first rule where the result is out of range.
  const inside = lines.map((_, i) => i).filter((i) => saturated[i] === words[0][i]);
  const outside = lines.length - inside.length;
  const rows = names.map((name, rule) => {
    const wrong = inside.filter((i) => said[i] !== words[rule][i]);
    const first = wrong[0];
    return { name, agrees: inside.length - wrong.length, wraps: said.every((word, i) => word === words[rule][i]),
      first: first === undefined ? null : { operands: lines[first].split(" "), said: said[first], word: words[rule][first] } };
  });
  const saturates = lines.every((_, i) => saturated[i] === words[0][i] || said[i] === saturated[i]);
  return Object.assign(judged, { rows, inside: inside.length, outside, saturates });
}

const figure = (count) => count.toLocaleString("en");

function verdictOf({ rows, inside, outside, saturates }) {
  const all = rows.filter(({ first }) => !first);
  if (!all.length) {
    const [best] = [...rows].sort((x, y) => y.agrees - x.agrees);
    return html`<b>It follows no rule.</b> The nearest is ${best.name}, with ${figure(best.agrees)} of the
      ${figure(inside)} cases in range.`;
  }
  const names = all.length === rows.length ? "every rule" : all.map(({ name }) => name).join(", ");
  const range = !outside ? "" : all.some(({ wraps }) => wraps) ? " Out of range, it wraps." : saturates
    ? " Out of range, it saturates." : " Out of range, it neither wraps nor saturates.";
  return html`<b>It follows ${names}</b> on all ${figure(inside)} cases in range.${range}`;
}

const valueOf = (word) => word === "DE" ? "no result" : `0x${word}`;

const rowOf = ({ name, agrees, first }, inside, update) => html`<tr>
  <th scope="row">${name}</th>
  <td class="figure ${first ? "" : "agrees"}">${figure(agrees)} of ${figure(inside)}</td>
  ${first ? html`
    <td><button class="plain word" title="Show this case above" @click=${() =>
      update({ a: `0x${first.operands[0]}`, b: `0x${first.operands[1]}` })}>0x${first.operands[0]} 0x${
      first.operands[1]}</button></td><td class="word">${valueOf(first.said)}</td><td class="word">${
      valueOf(first.word)}</td>` : html`<td colspan="3">none</td>`}</tr>`;

// Returns a formula that is right by some rule.
function sampleOf(op, { fraction }) {
  const half = fraction ? `0x${(1n << BigInt(fraction - 1)).toString(16)}` : "0";
  return { add: "a + b", sub: "a - b", mul: `(a * b + ${half}) >> ${fraction}`, div: `(a << ${fraction}) / b` }[op];
}

export function formulaPart(module, state, update) {
  const format = formatRows(module).find(({ name }) => name === state.in);
  const sign = operations.find(([key]) => key === state.op)?.[1];
  if (!format || !sign || state.op === "sqrt") return nothing;
  const text = state.formula === SAMPLE ? sampleOf(state.op, format) : state.formula;
  const { error, rows, ...found } = judge(module, state.op, format, text);
  return html`
    <h3>Your formula for a ${sign} b</h3>
    <p>Type C on the words a and b of ${format.name}. Integers have as many bits as they need, >> rounds down, / rounds
      toward zero, and casts such as (int32_t) cut. The result is cut to the word.</p>
    <div class="choices formula">${input("Formula", text, (formula) => update({ formula }))}</div>
    ${problem(error)}
    ${error ? nothing : html`<p class="verdict" role="status">${verdictOf({ rows, ...found })}</p>
    <div class="scroll" tabindex="0" role="region" aria-label="The formula and every rule"><table>
      <thead><tr><th scope="col">rounding rule</th><th scope="col" class="figure">agrees</th>
        <th scope="col">first case that differs</th><th scope="col">formula</th><th scope="col">rule</th></tr></thead>
      <tbody>${rows.map((row) => rowOf(row, found.inside, update))}</tbody></table></div>`}`;
}
