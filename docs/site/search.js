// Finds the parts of pages that have every word of the search. parts.js has them: place, page, heading, text.
"use strict";
const MOST = 30;
const box = document.getElementById("search");
const found = document.getElementById("found");
const top_ = document.body.dataset.top;

// A word counts more in a heading than in the text below it.
function scoreOf([, page, heading, text], words) {
  let score = 0;
  for (const word of words) {
    const at = [heading, page, text].findIndex((where) => where.toLowerCase().includes(word));
    if (at < 0) return 0;
    score += [9, 4, 1][at];
  }
  return score;
}

function around(text, word) {
  const at = Math.max(0, text.toLowerCase().indexOf(word) - 60);
  return (at ? "…" : "") + text.slice(at, at + 200) + (at + 200 < text.length ? "…" : "");
}

function itemOf([place, page, heading, text], words) {
  const item = document.createElement("li");
  const link = document.createElement("a");
  link.href = `${top_}/${place}`;
  link.textContent = page === heading ? page : `${page}: ${heading}`;
  const excerpt = document.createElement("p");
  excerpt.textContent = around(text, words.find((word) => text.toLowerCase().includes(word)) ?? "");
  item.append(link, excerpt);
  return item;
}

function search() {
  const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
  const hits = words.length ? parts.map((part) => [scoreOf(part, words), part]).filter(([score]) => score) : [];
  hits.sort(([a], [b]) => b - a);
  found.replaceChildren(...hits.slice(0, MOST).map(([, part]) => itemOf(part, words)));
  if (words.length && !hits.length) found.textContent = "No page has all of these words.";
  found.hidden = !words.length;
  document.getElementById("text").hidden = words.length > 0;
}

box.addEventListener("input", search);
// A result on this page is an anchor: the text must show again.
found.addEventListener("click", (event) => {
  if (!event.target.closest("a")) return;
  box.value = "";
  search();
});
addEventListener("keydown", (event) => {
  if (event.key !== "/" || event.target.matches("input")) return;
  event.preventDefault();
  box.focus();
});
