// Verdicts and findings: text with figures from the data.

const verdictKinds = { holds: "holds", "does not hold": "fails" };
const verdictNode = (text) => element("span", { class: `verdict ${verdictKinds[text] ?? "unsure"}` }, text);

function showClaims() {
  const { claims } = report.clocks;
  if (claims.length === 0) return missing("claims", "These scenes have none of the published claims.");
  const cards = claims.map((claim) => element("article", { class: "claim" },
    element("h3", {}, claim.claim),
    element("p", {}, verdictNode(claim.verdict)),
    element("ul", {}, ...claim.figures.map((f) =>
      element("li", {}, `${f.where}: ${between(f.measured)} ${claim.unit} (${f.verdict})`))),
    element("p", { class: "quiet" }, `Measured: ${claim.means.replace(/\.$/, "")}.`)));
  section("claims").append(element("div", { class: "cards" }, ...cards));
}

// Four words a line, a row of a transform; the columns of a trace closer together.
const shortened = (answer) => /^[0-9a-f ]+$/.test(answer)
  ? answer.replace(/((?:\S+ ){3}\S+) /g, "$1\n") : answer.replace(/^ +/gm, "").replace(/ {2,}/g, "  ");

function showFindings() {
  const cards = report.findings.map((finding) => element("article", { class: "finding" },
    element("h3", {}, `${finding.number}. ${finding.title}`),
    element("p", {}, finding.says),
    table(`Asked when this page was made; test ${finding.test}`, [
      { title: "who", of: (c) => c.who },
      { title: "answer", of: (c) => shortened(c.answer), words: true },
      { title: "asked", of: (c) => c.asked, asked: true },
    ], finding.cases)));
  section("findings").append(element("div", { class: "cards" }, ...cards));
}

function showCommands() {
  section("commands").append(table("Commands, in their order", [
    { title: "command", of: (c) => c.command, asked: true },
    { title: "seconds", of: (c) => figure(c.seconds), number: true },
    { title: "ended", of: (c) => c.date.replace("T", " ").replace("Z", " UTC") },
  ], report.commands));
}
