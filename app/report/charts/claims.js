// The verdicts on published claims, and the commands.

const verdictClasses = { holds: "holds", "does not hold": "fails" };

function showClaims() {
  const { claims, not_judged: notJudged, frames_8088: frames } = report.clocks;
  if (claims.length === 0) {
    section("claims").append(note("No published claim is about these scenes."));
    return;
  }
  const cards = claims.map((claim) => element("article", { class: "claim" },
    element("h3", {}, claim.claim),
    note(claim.place),
    element("p", {}, element("span", { class: `verdict ${verdictClasses[claim.verdict] ?? "unsure"}` }, claim.verdict)),
    element("ul", {}, ...claim.figures.map((f) =>
      element("li", {}, `${f.where}: ${range(f.measured)} ${claim.unit} (${f.verdict})`))),
    note(`Measured: ${claim.means.replace(/\.$/, "")}.`)));
  section("claims").append(element("div", { class: "cards" }, ...cards),
    table("Claims that are not judged", [
      { title: "claim", of: (c) => c.claim, kind: "prose" },
      { title: "printed in", of: (c) => c.place, kind: "prose" },
      { title: "reason", of: (c) => c.reason, kind: "prose" },
    ], notJudged),
    table("Clocks of a frame on an 8088, by Intel's table and by the bus, which fetches code at the same time", [
      { title: "scene", of: (f) => f.scene },
      { title: "rounding", of: (f) => (f.rounds ? "on" : "off") },
      { title: "table", of: (f) => figure(f.table), kind: "number" },
      { title: "bus", of: (f) => figure(f.bus), kind: "number" },
      { title: "limit", of: (f) => f.limit },
    ], frames));
}

function showCommands() {
  section("commands").append(table("Commands, in order", [
    { title: "command", of: (c) => c.command, kind: "command" },
    { title: "seconds", of: (c) => figure(c.seconds), kind: "number" },
    { title: "finished", of: (c) => dateText(c.date) },
  ], report.commands));
}
