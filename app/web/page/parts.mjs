// Parts that several views share.
import { html, nothing } from "../vendor/lit-html.js";

export const operations = [["add", "+"], ["sub", "−"], ["mul", "×"], ["div", "÷"], ["sqrt", "√"]];

let formats;
// Returns the named formats as rows of a number, and as options of a select.
export const formatRows = (module) => formats ??= module.ask("number", "q16_16", "0").rows;
export const formatsOf = (module) => formatRows(module).map(({ name }) => [name, name]);

// The property `selected` changes the choice even after a person chose; the attribute would not.
export const select = (label, value, options, choose) => html`
  <label class="choice"><span>${label}</span>
    <select name=${label} @change=${(e) => choose(e.target.value)}>
      ${options.map(([key, name]) => html`<option value=${key} .selected=${key === value}>${name}</option>`)}
    </select>
  </label>`;

export const input = (label, value, change, short = false) => html`
  <label class="choice ${short ? "short" : ""}"><span>${label}</span>
    <input name=${label} .value=${value} spellcheck="false" autocomplete="off" autocapitalize="off" maxlength="400"
      @input=${(e) => change(e.target.value)}>
  </label>`;

// What a change of the format keeps.
export const keep = (state, update) => select("A new format keeps", state.keep, [["value", "the value"],
  ["bits", "the bits"]], (chosen) => update({ keep: chosen }));

// Tells whether a text is a word and not a decimal number.
export const isWord = (text) => /^\s*[-+\u2212]?0[xb]/i.test(text);

// Returns the text of a number for another format: words become decimal, or decimal numbers words.
export const kept = (text, what, { word, value }) =>
  what === "bits" ? (isWord(text) ? text : `0x${word}`) : isWord(text) ? value : text;

// A figure, shortened for the table. Its title has all digits.
export const short = (text, digits = 14) => text === undefined ? nothing :
  text.length <= digits ? text : html`<span title=${text}>${text.slice(0, digits - 1)}…</span>`;

export const agreement = (agrees) => agrees
  ? html`<span class="agrees" title="The type, the oracle and, where there is one, the model agree.">agree</span>`
  : html`<strong class="differs">differ</strong>`;

// Copies a text and says so. Where a page may not copy, such as over plain HTTP, it shows the text to copy by hand.
async function copy(text, button) {
  const said = button.parentElement.querySelector("[role=status]");
  try {
    await navigator.clipboard.writeText(text);
    said.textContent = `Copied: ${text}`;
  } catch {
    prompt("Copy this text:", text);
  }
}

// Buttons that copy: for each, its label and a function that returns the text.
export const copies = (...texts) => html`<p class="copies">${texts.map(([label, text]) => html`
  <button @click=${(e) => copy(text(), e.target)}>Copy ${label}</button>`)} <span role="status"></span></p>`;

export const problem = (text) => html`<p class="problem" role="status">${text ?? ""}</p>`;

// A picture of where the exact result lies between two words.
export const between = (part) => html`
  <svg class="between" viewBox="0 0 400 24" aria-hidden="true">
    <path d="M8 12H392M8 5V19M200 9V15M392 5V19"></path>
    <circle cx=${8 + 384 * part} cy="12" r="6"></circle>
  </svg>`;
