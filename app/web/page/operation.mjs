// Two numbers and an operation: the exact result, and the word that each rule and each build gives.
import { html, nothing } from "../vendor/lit-html.js";
import { formulaPart } from "./formula.mjs";
import { agreement, between, formatsOf, input, keep, kept, operations, problem, select, short } from "./parts.mjs";
import { hashOf } from "./state.mjs";

const traceOf = (build, { op, first, second }) => hashOf(
  { view: "trace", routine: op, build, beside: "none", operands: `0x${first.word} 0x${second.word}` });

const rowOf = (row, answer) => html`
  <tr>
    <th scope="row">${row.name}</th>
    ${row.word ? html`
      <td class="word">${row.word}</td>
      <td class="figure">${short(row.value, 22)}</td>
      <td class="figure">${short(row.units, 12)}</td>`
    : html`<td colspan="3">no result: ${row.ending ?? "divide error"}</td>`}
    <td>${row.wraps ? "wraps" : ""}</td>
    <td>${row.agrees === undefined ? "" : agreement(row.agrees)}</td>
    <td>${row.link ? html`<a href=${traceOf(row.link, answer)}>trace</a>` : ""}</td>
  </tr>`;

const table = (label, rows, answer) => html`
  <div class="scroll" tabindex="0" role="region" aria-label=${label}>
  <table>
    <thead><tr><th scope="col">${label}</th><th scope="col">word</th><th scope="col" class="figure">value</th>
      <th scope="col" class="figure">error in units</th><th scope="col">range</th><th scope="col">parties</th>
      <th scope="col">steps</th></tr></thead>
    <tbody>${rows.map((row) => rowOf(row, answer))}</tbody>
  </table></div>`;

const exactOf = ({ op, exact, fits, negative, first }) =>
  negative ? html`<b>${short(first.value, 60)}</b> is negative, so it has no real root. The type returns 0, or throws
    domain_error if its policy traps.`
    : exact !== undefined ? html`The exact result is <b>${short(exact, 60)}</b>${fits ? "" : ", out of range"}.`
    : op === "sqrt" ? "A root can have endless digits, so the page does not show the exact one."
      : "There is no result: the divisor is 0.";

const placeOf = ({ below, above, between: part }) => html`
  <div class="place">
    <span>${below ? html`0x${below.word}` : ""}</span>
    ${part === undefined ? html`<span></span>` : between(Number(part.replace("…", "")))}
    <span>${above ? html`0x${above.word}` : ""}</span>
  </div>`;

export function operationView(module, state, update) {
  const answer = module.ask("operation", state.op, state.in, state.a, state.b);
  // The last good answer remains, so that nothing moves while a person types.
  if (!answer.error) operationView.last = { ...answer, op: state.op };
  const shown = operationView.last;
  const chooseFormat = (format) => {
    const [a, b] = answer.error ? [state.a, state.b]
      : [kept(state.a, state.keep, answer.first), kept(state.b, state.keep, answer.second)];
    update({ in: format, a, b: state.op === "sqrt" ? state.b : b });
  };
  return html`
    <h2>Two numbers and an operation</h2>
    <div class="choices">
      ${input("First", state.a, (a) => update({ a }))}
      ${select("Operation", state.op, operations, (op) => update({ op }))}
      ${state.op === "sqrt" ? nothing : input("Second", state.b, (b) => update({ b }))}
      ${select("Format", state.in, formatsOf(module), chooseFormat)}
      ${keep(state, update)}
    </div>
    ${problem(answer.error)}
    ${shown ? html`<div class=${answer.error ? "stale" : ""}>
      <p class="exact">${exactOf(shown)}</p>
      ${placeOf(shown)}
      ${table(shown.negative ? "Policy" : "Rounding rule", shown.rules, shown)}
      ${shown.builds.length ? table("Build of FIXED.ASM", shown.builds, shown) : nothing}</div>` : nothing}
    ${formulaPart(module, state, update)}`;
}
