// Two numbers and an operation: the exact result, and the word that each rule and each build gives.
import { html, nothing } from "../vendor/lit-html.js";
import { agreement, between, input, operations, problem, select, short } from "./parts.mjs";
import { hashOf } from "./state.mjs";

const rowOf = (row, state) => html`
  <tr>
    <th scope="row">${row.name}</th>
    ${row.word ? html`
      <td class="word">${row.word}</td>
      <td class="figure">${short(row.value, 22)}</td>
      <td class="figure">${short(row.units, 12)}</td>`
    : html`<td colspan="3">no result: divide error</td>`}
    <td>${row.wraps ? "wraps" : ""}</td>
    <td>${agreement(row.agrees)}</td>
    <td>${row.link ? html`<a href=${hashOf({ view: "trace", routine: state.op, build: row.link, beside: "none",
      operands: `${state.a} ${state.b}` })}>trace</a>` : ""}</td>
  </tr>`;

const table = (label, rows, state) => html`
  <div class="scroll" tabindex="0" role="region" aria-label=${label}>
  <table>
    <thead><tr><th scope="col">${label}</th><th scope="col">word</th><th scope="col" class="figure">value</th>
      <th scope="col" class="figure">error in units</th><th scope="col">range</th><th scope="col">parties</th><th scope="col">steps</th></tr></thead>
    <tbody>${rows.map((row) => rowOf(row, state))}</tbody>
  </table></div>`;

const resultOf = (answer) => html`
  <p class="exact">${answer.exact === undefined ? "There is no exact result to show: it is a root, or the divisor is 0." :
    html`The exact result is <b>${short(answer.exact, 60)}</b>${answer.fits ? "" : ", out of range"}.`}</p>
  <div class="place">
    <span>${answer.below ? html`0x${answer.below.word}` : ""}</span>
    ${answer.between === undefined ? html`<span></span>` : between(Number(answer.between.replace("…", "")))}
    <span>${answer.above ? html`0x${answer.above.word}` : ""}</span>
  </div>`;

export function operationView(module, state, update) {
  const answer = module.ask("operation", state.op, state.in, state.a, state.b);
  if (!answer.error) operationView.last = answer;
  const shown = answer.error ? operationView.last : answer;
  const formats = module.ask("number", "q16_16", "0").rows.map((row) => [row.name, row.name]);
  return html`
    <h2>Two numbers and an operation</h2>
    <div class="choices">
      ${input("First", state.a, (a) => update({ a }))}
      ${select("Operation", state.op, operations, (op) => update({ op }))}
      ${input("Second", state.b, (b) => update({ b }))}
      ${select("Format", state.in, formats, (format) => update({ in: format }))}
    </div>
    ${problem(answer.error)}
    ${shown ? html`
      ${resultOf(shown)}
      ${table("Rounding rule", shown.rules, state)}
      ${shown.builds.length ? table("Build of FIXED.ASM", shown.builds, state) : nothing}` : nothing}`;
}
