// The head of the page and the verification table.

function switchOf(row) {
  if (row.target === "standard") return "-";
  return (row.operation === "div" ? row.div_round : row.mul_round) ? "on" : "off";
}

function resultOf(row) {
  if (row.parties.length < 2) return element("span", { class: "verdict unsure" }, "not compared");
  if (row.mismatches > 0) return element("span", { class: "verdict fails" }, `${count(row.mismatches)} differ`);
  return element("span", { class: "verdict holds" }, "equal");
}

function makerText(maker) {
  const parties = Object.entries(maker.parties).map(([name, identity]) => `${name} (${identity})`);
  return `Made by fixproof ${maker.version}, commit ${maker.commit}, build type ${maker.build_type}, ` +
    `${maker.compiler}, executable with SHA-256 ${maker.executable}. Parties: ${parties.join(", ")}.`;
}

function showVerification() {
  const { verify, made } = report;
  const faults = d3.sum(verify.rows, (row) => row.faults);
  section("verdict").textContent = verify.mismatches > 0
    ? `Parties DIFFER on ${count(verify.mismatches)} of ${count(verify.cases)} cases.`
    : `All parties agree on all ${count(verify.cases)} cases.`;
  section("made").textContent = [dateText(made.date), `fixproof ${made.version}`, made.compiler, `seed ${made.seed}`,
    made.processor].filter(Boolean).join(", ") +
    (made.quick ? ". A quick run (--quick): too few cases to conclude from." : ".");
  const differ = verify.rows.filter((row) => row.mismatches > 0).length;
  const alone = verify.rows.filter((row) => row.parties.length < 2).length;
  const parts = [[verify.rows.length - differ - alone, "equal"], [differ, "with differences"], [alone, "not compared"]]
    .filter(([n]) => n > 0).map(([n, what]) => `${count(n)} ${what}`);
  // What differs is in sight.
  section("verification").append(element("details", differ > 0 ? { open: "" } : {},
    element("summary", {}, `Show all ${count(verify.rows.length)} rows: ${parts.join(", ")}`),
    table("All rows of the verification", [
      { title: "operation", of: (r) => r.operation },
      { title: "target", of: (r) => r.target + (r.chapter === 52 ? ", chapter 52" : r.repaired ? ", repaired" : "") },
      { title: "rounding", of: switchOf },
      { title: "parties, the judged one first", of: (r) => r.parties.join(", ") },
      { title: "cases", of: (r) => count(r.cases), kind: "number" },
      { title: "#DE", of: (r) => count(r.faults), kind: "number" },
      { title: "result", of: resultOf },
    ], verify.rows)),
    note(`${count(verify.cases)} cases, of which ${count(faults)} are divide errors, in ${figure(verify.seconds)} s; ` +
      `level ${verify.level}, seed ${verify.seed}.`),
    ...verify.made_by.map((maker) => note(makerText(maker))));
}
