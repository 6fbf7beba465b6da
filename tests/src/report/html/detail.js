// The details of a cell, or of a kernel: verdict, figures, spread, worst row, commands.

/** Shows what the address names: `#KERNEL/COLUMN`, or `#KERNEL` for all of its answers. */
function showDetail() {
  const panel = document.getElementById("detail");
  const [name, id] = location.hash.slice(1).split("/").map(decoded);
  const row = allRows.find((row) => row.kernel.name === name);
  panel.hidden = !row;
  const cell = markOpened();
  if (!row) return;
  const column = allColumns.find((column) => column.id === id);
  panel.replaceChildren(title(row.kernel, column), ...(column ? ofCell(row, column) : ofKernel(row)));
  panel.scrollTop = 0;
  cell?.scrollIntoView({ block: "nearest", inline: "nearest" });
  if (cell) keepVisible(cell);
}

function decoded(part) {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}

function title(kernel, column) {
  const about = [kernel.family, kernel.cite, kernel.inputs ? count(kernel.inputs, "row") : "", kernel.listed ? `${kernel.listed} of them listed` : ""];
  return make("div", { class: "bar" },
    make("h2", {}, kernel.name, make("small", {}, about.filter(Boolean).join(" · ")), column ? make("small", {}, column.id) : ""),
    make("button", { type: "button", title: "Close (Escape)", onclick: close }, "✕"));
}

function close() {
  const opened = markOpened();
  history.pushState(null, "", location.pathname + location.search);
  showDetail();
  opened?.focus();
}

function ofCell(row, column) {
  return row.cells.get(column.id).map((answer) => ofAnswer(row.kernel, answer, column));
}

function ofKernel(row) {
  const line = (column) => row.cells.get(column.id).map((answer) =>
    make("li", {}, make("button", { type: "button", class: answer.verdict, onclick: () => (location.hash = hashOf(row.kernel.name, column.id)) },
      { holds: "✓", falls_short: "✗", expected_failure: "△", not_asked: "–" }[answer.verdict],
      make("span", {}, `${answer.question} ${answer.subject}`),
      make("span", { class: "number" }, brief(answer).replace(/^[✓✗△–=] ?/, "")))));
  return [
    make("section", {}, make("h3", {}, "Answers"), make("ul", { class: "answers" }, ...allColumns.flatMap(line))),
    ...searched(row.kernel),
    ...others(row.kernel),
  ];
}

function ofAnswer(kernel, answer, column) {
  const subject = column.question === "correct" && answer.subject ? make("h3", {}, answer.subject) : "";
  return make("section", {}, subject,
    make("p", { class: `verdict ${answer.verdict}` }, WORDS[answer.verdict]),
    answer.why ? make("p", { class: "why" }, answer.why) : "",
    figures(answer), spread(answer), worst(answer),
    make("h3", {}, "Run it again"), ...commands(kernel, answer, column).map(command));
}

const PERMITTED = { robust: "budget", conformant: "bound" };

function figures(answer) {
  const isBare = !answer.worst || answer.question === "agree";
  const all = [
    ["rows", answer.cases.toLocaleString("en")],
    ["without a bound", answer.indeterminate.toLocaleString("en")],
    ["ambiguous", answer.ambiguous.toLocaleString("en")],
    ...(isBare ? [] : [
      [`share of the ${PERMITTED[answer.question] ?? "permitted"}`, precise(number(answer.share))],
      ["largest error", precise(number(answer.absolute))],
      ["relative", precise(number(answer.relative))],
      ["in ULP", precise(number(answer.ulp))],
    ]),
  ];
  return make("dl", { class: "figures" }, ...all.map(([name, value]) => make("div", {}, make("dt", {}, name), make("dd", {}, value))));
}

/** Rows by the share of the bound that they use, as bars; heights are logarithms, so that one row is seen. */
function spread(answer) {
  const found = answer.distribution;
  if (!found) return "";
  const [width, height, base, gap] = [560, 132, 104, 3];
  const [ends, last] = [report.bin_ends, report.bin_ends.length];
  const wide = width / (last + 1);
  const tallest = Math.log2(1 + Math.max(...found.counts));
  const bars = found.counts.map((rows, at) => {
    if (rows === 0) return "";
    const tall = Math.max(2, (Math.log2(1 + rows) / tallest) * (base - 14));
    const bar = { x: at * wide + gap / 2, y: base - tall, width: wide - gap, height: tall, rx: 1.5 };
    return draw("g", {}, draw("title", {}, `${count(rows, "row")}: ${binName(at)}`),
      draw("rect", { ...bar, class: at === last ? "beyond" : "rows" }),
      draw("text", { x: (at + 0.5) * wide, y: base - tall - 3, "text-anchor": "middle" }, brieflyCounted(rows)));
  });
  const label = (at, text) => draw("text", { x: at * wide, y: base + 13, "text-anchor": "middle" }, text);
  const labels = ends.map((end, at) => (Number.isInteger(1 / end) ? label(at + 1, end === 1 ? "1" : `1/${1 / end}`) : ""));
  const limit = draw("line", { class: "mark", x1: last * wide, x2: last * wide, y1: 4, y2: base });
  const spoken = found.counts.map((rows, at) => (rows ? `${rows} rows ${binName(at)}` : "")).filter(Boolean).join("; ");
  const svg = draw("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": spoken },
    draw("line", { x1: 0, x2: width, y1: base, y2: base }), limit, ...bars, label(0.5, "0"), ...labels,
    draw("text", { x: width / 2, y: height - 2, "text-anchor": "middle" }, "share of the bound"));
  const told = [["Half", found.median], ["99 %", found.p99], ["99.9 %", found.p999]];
  return make("figure", {}, make("h3", {}, "How rows use the bound"), svg,
    make("figcaption", {}, `${told.map(([part, value]) => `${part} within ${precise(number(value))}`).join(", ")}. `,
      `${count(found.rows, "row")}, each by its worst scalar; heights are logarithmic.`));
}

function binName(at) {
  const ends = report.bin_ends;
  if (at === 0) return "none of the bound";
  return at === ends.length ? "beyond the bound" : `${precise(ends[at - 1])} to ${precise(ends[at])} of the bound`;
}

function brieflyCounted(n) {
  if (n < 1000) return String(n);
  return n < 1e6 ? `${+(n / 1e3).toPrecision(2)}k` : `${+(n / 1e6).toPrecision(2)}M`;
}

function worst(answer) {
  const found = answer.worst;
  if (!found) return "";
  const values = [["found", found.found], ["wanted", found.wanted], ["permitted ±", found.permitted]];
  const line = (name, text, value) => make("tr", {}, make("th", { scope: "row" }, name), make("td", {}, text), make("td", {}, value));
  const given = scalars(found.args).map(([path, value]) =>
    line(path, String(value), typeof value === "string" && value.startsWith("0x", value.startsWith("-") ? 1 : 0) ? precise(fromHex(value)) : ""));
  const place = found.leaf ? ` at ${found.leaf}` : "";
  return make("div", {},
    make("h3", {}, answer.question === "agree" ? "First difference" : `Worst row${place}`),
    make("table", { class: "values" }, make("tbody", {}, ...values.map(([name, value]) => line(name, String(number(value)), "")), ...given)));
}

function command([what, text]) {
  const copy = async (event) => {
    const button = event.currentTarget;
    button.textContent = (await copied(text, button.previousElementSibling)) ? "copied" : "press Ctrl C";
    setTimeout(() => (button.textContent = "copy"), 1500);
  };
  return make("div", { class: "command" }, make("p", {}, what), make("pre", {}, text), make("button", { type: "button", onclick: copy }, "copy"));
}

/** Where the clipboard is closed to the page, the text is selected instead. */
async function copied(text, place) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    getSelection().selectAllChildren(place);
    return false;
  }
}

const AIMS = { bound: "bound, of the budget or the value", error: "error, of the bound", difference: "between routes, in ULP" };

function searched(kernel) {
  if (!kernel.search) return [];
  const lines = kernel.search.finds.map((find) => {
    const [drawn, found] = [number(find.drawn), number(find.found)];
    const text = found > drawn ? `${precise(drawn)} drawn, ${precise(found)} found` : `${precise(drawn)} drawn, nothing worse found`;
    return make("div", {}, make("p", {}, `${AIMS[find.aim] ?? find.aim}: ${text}`),
      ...(found > drawn ? [command(["", `echo ${quoted(JSON.stringify(find.args))} | lobe eval ${quoted(kernel.name)} --args -`])] : []));
  });
  return [make("section", {}, make("h3", {}, `Search, ${count(kernel.search.rows, "row")} near the worst`), ...lines)];
}

const SHOWN = ["name", "family", "cite", "inputs", "listed", "answers", "search"];

/** What else a report says of a kernel. */
function others(kernel) {
  return Object.entries(kernel).filter(([name, value]) => !SHOWN.includes(name) && value !== null).map(([name, value]) => {
    const lines = scalars(value).map(([path, scalar]) => make("tr", {}, make("th", { scope: "row" }, path), make("td", {}, String(scalar))));
    return make("section", {}, make("h3", {}, name), make("table", { class: "values" }, make("tbody", {}, ...lines)));
  });
}
