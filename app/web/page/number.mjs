// One number: its bits, and its value in every format.
import { html, nothing } from "../vendor/lit-html.js";
import { agreement, formatsOf, input, keep, kept, problem, select, short } from "./parts.mjs";
import { defaults } from "./state.mjs";

function flipped(row, bit) {
  const word = BigInt("0x" + row.word) ^ (1n << BigInt(bit));
  return "0x" + word.toString(16).padStart(row.bits / 4, "0");
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
  const word = BigInt("0x" + row.word);
  const button = (bit) => {
    const on = (word >> BigInt(bit)) & 1n;
    const kind = row.signed && bit === row.bits - 1 ? "sign" : bit >= row.fraction ? "whole" : "part";
    return html`<button class=${kind} aria-pressed=${on ? "true" : "false"} title="bit ${bit}"
      aria-label="bit ${bit}, ${on}" @click=${() => update({ text: flipped(row, bit) })}>${on}</button>`;
  };
  const places = Array.from({ length: row.bits }, (_, i) => row.bits - 1 - i);
  const bytes = Array.from({ length: row.bits / 8 }, (_, i) => places.slice(8 * i, 8 * i + 8));
  return html`<div class="bits" role="group" aria-label="Bits of the word; arrow keys move" @keydown=${moveFocus}>
    ${bytes.map((bits) => html`<span class="byte">${bits.map(button)}</span>`)}</div>`;
}

const rowOf = (row) => html`
  <tr class=${row.fits ? "" : "outside"}>
    <th scope="row">${row.name}</th>
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

function answerOf({ exact, rows }, state, update) {
  const named = (format) => rows.find(({ name }) => name === format);
  const row = named(state.format) ?? named(defaults.format);
  return html`
    <p class="exact">The number is exactly <b>${short(exact, 60)}</b>.
      ${row.fits ? html`In ${row.name} it is 0x${row.word}, ${short(row.value, 30)}.`
      : html`It is out of the range of ${row.name}.`}</p>
    ${row.fits ? bitsOf(row, update) : nothing}
    <div class="scroll" tabindex="0" role="region" aria-label="The number in every format">
    <table>
      <thead><tr>
        <th scope="col">format</th><th scope="col">word</th><th scope="col" class="figure">value</th>
        <th scope="col" class="figure">error</th><th scope="col" class="figure">in units</th>
        <th scope="col" class="figure">next below</th><th scope="col" class="figure">next above</th>
        <th scope="col">parties</th></tr></thead>
      <tbody>${rows.map(rowOf)}</tbody>
    </table></div>`;
}

export function numberView(module, state, update) {
  const answer = module.ask("number", state.format, state.text);
  // The last good answer remains, so that nothing moves while a person types.
  if (!answer.error) numberView.last = answer;
  const chooseFormat = (format) => {
    const row = answer.rows?.find(({ name }) => name === state.format);
    const text = row?.fits ? kept(state.text, state.keep, { word: row.word, value: answer.exact }) : state.text;
    update({ format, text });
  };
  return html`
    <h2>One number in every format</h2>
    <p>Type a decimal number such as 1.5 or -2e3, or a word of the chosen format: 0x and hexadecimal digits, or 0b and
      bits. Each format
      takes the nearest number, and halves round up.</p>
    <div class="choices">
      ${input("Number", state.text, (text) => update({ text }))}
      ${select("Format of words", state.format, formatsOf(module), chooseFormat)}
      ${keep(state, update)}
    </div>
    ${problem(answer.error)}
    ${numberView.last ? html`<div class=${answer.error ? "stale" : ""}>${answerOf(numberView.last, state, update)}</div>`
      : nothing}`;
}
