// One number: its bits, and its value in every format.
import { html, nothing } from "../vendor/lit-html.js";
import { agreement, copies, formatsOf, input, isWord, keep, kept, problem, select, short } from "./parts.mjs";
import { defaults, hashOf } from "./state.mjs";

const wordOf = (row) => BigInt("0x" + row.word);
const typed = (row, word) => "0x" + BigInt.asUintN(row.bits, word).toString(16).padStart(row.bits / 4, "0");

// Returns the number one unit higher or lower, as a word where the text is one.
const stepped = (row, text, by) => isWord(text) ? typed(row, wordOf(row) + BigInt(by)) : by < 0 ? row.below : row.above;

// Returns the word as a line of C++.
function lineOf(row) {
  const units = row.signed ? BigInt.asIntN(row.bits, wordOf(row)) : wordOf(row);
  // C++ has no literal of this number: the minus sign is an operator.
  const raw = units === -(2n ** 63n) ? "INT64_MIN" : row.signed ? units : `0x${row.word}`;
  return `constexpr auto x = fixproof::${row.name}::from_raw(${raw});  // ${row.value}`;
}

// Up and Down go to the next word above and below.
function stepKeys(event, step) {
  const by = { ArrowUp: 1, ArrowDown: -1 }[event.key];
  if (!by || event.target.tagName === "SELECT") return;
  event.preventDefault();
  step(by);
}

// Arrow keys move from bit to bit.
function moveFocus(event) {
  const step = { ArrowLeft: -1, ArrowRight: 1, Home: -64, End: 64 }[event.key];
  if (!step) return;
  const bits = [...event.currentTarget.querySelectorAll("button")];
  const at = bits.indexOf(document.activeElement) + step;
  bits[Math.max(0, Math.min(bits.length - 1, at))].focus();
  event.preventDefault();
}

function bitsOf(row, update) {
  const word = wordOf(row);
  const top = row.bits - 1;
  const fields = { sign: "sign", whole: "integer", part: "fraction" };
  const kindOf = (bit) => row.signed && bit === top ? "sign" : bit >= row.fraction ? "whole" : "part";
  const button = (bit) => {
    const on = (word >> BigInt(bit)) & 1n;
    const kind = kindOf(bit);
    const power = bit - row.fraction;
    const sign = kind === "sign" ? "−" : "";
    const field = bit === top || kindOf(bit + 1) !== kind ? fields[kind] : nothing;
    return html`<span class="bit"><small class="field" aria-hidden="true">${field}</small>
      <button class=${kind} aria-pressed=${on ? "true" : "false"} title="bit ${bit}: ${sign}2^${power} = ${sign}${2 ** power}"
        aria-label="bit ${bit}, ${fields[kind]}, ${sign}2 to the power ${power}"
        @click=${() => update({ text: typed(row, word ^ (1n << BigInt(bit))) })}>${on}</button>
      <small aria-hidden="true">${sign}2<sup>${power < 0 ? "−" : ""}${Math.abs(power)}</sup></small></span>`;
  };
  const places = Array.from({ length: row.bits }, (_, i) => row.bits - 1 - i);
  const bytes = Array.from({ length: row.bits / 8 }, (_, i) => places.slice(8 * i, 8 * i + 8));
  return html`<div class="bits" role="group" aria-label="Bits of the word; Left and Right move, Up and Down step" @keydown=${moveFocus}>
    ${bytes.map((bits) => html`<span class="byte">${bits.map(button)}</span>`)}</div>`;
}

// A row chooses its format. Tab skips its button, because the list of formats does the same.
const rowOf = (row, chosen, choose) => html`
  <tr class="${row.fits ? "" : "outside"} ${chosen ? "chosen" : ""}" @click=${choose}>
    <th scope="row"><button class="plain" tabindex="-1" aria-pressed=${chosen ? "true" : "false"}>${row.name}</button></th>
    ${row.fits ? html`
      <td class="word">${row.word}</td>
      <td class="figure">${short(row.value, 22)}</td>
      <td class="figure">${short(row.error)}</td>
      <td class="figure">${short(row.units, 9)}</td>
      <td class="figure">${short(row.below, 16)}</td>
      <td class="figure">${short(row.above, 16)}</td>`
    : html`<td colspan="6">out of range: ${row.range}</td>`}
    <td>${agreement(row.agrees)}</td>
  </tr>`;

function answerOf({ exact, rows }, state, update, choose, step) {
  const named = (format) => rows.find(({ name }) => name === format);
  const row = named(state.format) ?? named(defaults.format);
  return html`
    <p class="exact">The number is exactly <b>${short(exact, 60)}</b>.
      ${row.fits ? html`In ${row.name} it is 0x${row.word}, ${short(row.value, 30)}.`
      : html`It is out of the range of ${row.name}.`}</p>
    ${row.fits ? html`<div @keydown=${(e) => stepKeys(e, step)}>${bitsOf(row, update)}</div>
    <div class="choices">
      <button name="below" ?disabled=${!row.below} @click=${() => step(-1)}>− one unit</button>
      <button name="above" ?disabled=${!row.above} @click=${() => step(1)}>+ one unit</button>
      ${copies(["word", () => `0x${row.word}`], ["link", () => new URL(hashOf(state), location).href],
        ["C++", () => lineOf(row)])}
    </div>` : nothing}
    <div class="scroll" tabindex="0" role="region" aria-label="The number in every format">
    <table>
      <thead><tr>
        <th scope="col">format</th><th scope="col">word</th><th scope="col" class="figure">value</th>
        <th scope="col" class="figure">error</th><th scope="col" class="figure">in units</th>
        <th scope="col" class="figure">next below</th><th scope="col" class="figure">next above</th>
        <th scope="col">parties</th></tr></thead>
      <tbody>${rows.map((each) => rowOf(each, each === row, () => choose(each.name)))}</tbody>
    </table></div>`;
}

export function numberView(module, state, update) {
  const answer = module.ask("number", state.format, state.text);
  // The last good answer remains, so that nothing moves while a person types.
  if (!answer.error) numberView.last = answer;
  const row = answer.rows?.find(({ name }) => name === state.format);
  const step = (by) => {
    if (by < 0 ? row?.below : row?.above) update({ text: stepped(row, state.text, by) });
  };
  const chooseFormat = (format) => {
    const text = row?.fits ? kept(state.text, state.keep, { word: row.word, value: answer.exact }) : state.text;
    update({ format, text });
  };
  return html`
    <h2>One number in every format</h2>
    <p>Type a decimal number such as 1.5 or -2e3, or a word of the chosen format: 0x and hexadecimal digits, or 0b and
      bits. Each format
      takes the nearest number, and halves round up.</p>
    <div class="choices" @keydown=${(e) => stepKeys(e, step)}>
      ${input("Number", state.text, (text) => update({ text }))}
      ${select("Format of words", state.format, formatsOf(module), chooseFormat)}
      ${keep(state, update)}
    </div>
    ${problem(answer.error)}
    ${numberView.last ? html`<div class=${answer.error ? "stale" : ""}>${
      answerOf(numberView.last, state, update, chooseFormat, step)}</div>` : nothing}`;
}
