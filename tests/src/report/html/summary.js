// The head of the page: what ran, where, and what it came to.

function showSummary() {
  const { tally } = report;
  const [word, outcome] = tally.fall_short > 0
    ? ["falls_short", `✗ ${tally.fall_short} fall short`]
    : tally.hold > 0 ? ["holds", "✓ all holds"] : ["falls_short", "✗ nothing was asked"];
  document.title = `Lobe ${report.command}: ${outcome}`;
  const counts = [
    [tally.hold, "hold"], [tally.fall_short, "fall short"],
    [tally.expected_failures, "expected failures"], [tally.not_asked, "not asked"],
  ];
  const drawn = [...new Set(report.kernels.map((kernel) => kernel.inputs - kernel.listed))];
  const inputs = drawn.length === 1 && drawn[0] > 0 ? `${count(drawn[0], "input")} drawn for each` : "";
  const run = [
    `Lobe ${report.version}`, count(report.kernels.length, "kernel"), inputs,
    report.command === "check" ? `seed ${report.seed}` : "",
    `accuracy model ${report.model ?? "portable"}`,
  ];
  document.getElementById("summary").append(
    make("div", { class: "headline" },
      make("h1", {}, `lobe ${report.command}`),
      make("span", { class: `outcome ${word}` }, outcome),
      make("ul", { class: "tally", "aria-label": "Answers" },
        ...counts.map(([n, what]) => make("li", {}, make("b", {}, n.toLocaleString("en")), ` ${what}`))),
      make("button", { id: "theme", type: "button", title: "Light, dark, or as the system has it", onclick: turnTheme }, "◐ theme")),
    make("p", { class: "run" }, run.filter(Boolean).join(" · ")),
    make("div", { class: "notes" }, routeNotes(), skipNotes(), expectedNotes(), unmappedNotes()));
}

function notes(title, rows, isOpen = false) {
  if (rows.length === 0) return "";
  const body = rows.map(([head, ...cells]) =>
    make("tr", {}, make("th", { scope: "row" }, head), ...cells.map((cell) => make("td", {}, cell))));
  return make("details", { open: isOpen }, make("summary", {}, title), make("div", {}, make("table", {}, make("tbody", {}, ...body))));
}

function routeNotes() {
  const rows = report.routes.map((route) => {
    const driver = Object.keys(report.drivers ?? {}).find((name) => route.endsWith(`@${name}`));
    return [route, driver ? report.drivers[driver] : ""];
  });
  return notes(count(rows.length, "route"), rows);
}

function skipNotes() {
  const rows = report.skipped.map((skipped) => [skipped.route, skipped.what, skipped.mend]);
  return notes(`${count(rows.length, "route")} skipped`, rows, true);
}

function expectedNotes() {
  const rows = report.kernels.flatMap((kernel) => kernel.answers
    .filter((answer) => answer.verdict === "expected_failure")
    .map((answer) => [kernel.name, `${answer.question} ${answer.subject}`.trim(), answer.why]));
  return notes(count(rows.length, "expected failure"), rows);
}

function unmappedNotes() {
  const rows = Object.entries(report.unmapped).map(([name, n]) => [name, count(n, "row")]);
  return notes(`${count(rows.length, "table")} without a kernel`, rows, true);
}

/** As the system has it, then the other, then back. */
function turnTheme() {
  const root = document.documentElement;
  const isDark = matchMedia("(prefers-color-scheme: dark)").matches;
  if (root.dataset.theme) delete root.dataset.theme;
  else root.dataset.theme = isDark ? "light" : "dark";
}
