// The verdicts on published claims, and the commands.

const verdictKinds = { holds: "holds", "does not hold": "fails" };
const verdictNode = (text) => element("span", { class: `verdict ${verdictKinds[text] ?? "unsure"}` }, text);

function showClaims() {
  const { claims } = report.clocks;
  if (claims.length === 0) return missing("claims", "These scenes have none of the published claims.");
  const cards = claims.map((claim) => element("article", { class: "claim" },
    element("h3", {}, claim.claim),
    element("p", { class: "quiet" }, claim.place),
    element("p", {}, verdictNode(claim.verdict)),
    element("ul", {}, ...claim.figures.map((f) =>
      element("li", {}, `${f.where}: ${between(f.measured)} ${claim.unit} (${f.verdict})`))),
    element("p", { class: "quiet" }, `Measured: ${claim.means.replace(/\.$/, "")}.`)));
  section("claims").append(element("div", { class: "cards" }, ...cards),
    table("Not judged", [
      { title: "claim", of: (c) => c.claim, words: true },
      { title: "printed in", of: (c) => c.place, words: true },
      { title: "reason", of: (c) => c.reason, words: true },
    ], report.clocks.not_judged),
    table("A frame on an 8088: clocks by the table and by the bus, which fetches code meanwhile", [
      { title: "scene", of: (f) => f.scene },
      { title: "rounding", of: (f) => (f.rounds ? "on" : "off") },
      { title: "table", of: (f) => figure(f.table), number: true },
      { title: "bus", of: (f) => figure(f.bus), number: true },
      { title: "limit", of: (f) => f.limit },
    ], report.clocks.frames_8088));
}

function showCommands() {
  section("commands").append(table("Commands, in their order", [
    { title: "command", of: (c) => c.command, asked: true },
    { title: "seconds", of: (c) => figure(c.seconds), number: true },
    { title: "ended", of: (c) => c.date.replace("T", " ").replace("Z", " UTC") },
  ], report.commands));
}
