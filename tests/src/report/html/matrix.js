// The matrix of kernels and questions: filtered, sorted, walked through by keys.

const view = { filter: "", sort: "listed", figure: "share", onlyFailures: false };
const allColumns = columns();
const allRows = rows(allColumns);

function showMatrix() {
  const words = view.filter.toLowerCase().split(/\s+/).filter(Boolean);
  const left = allRows
    .filter((row) => words.every((word) => row.text.includes(word)) && (!view.onlyFailures || row.isShort))
    .sort(order(view.sort));
  document.getElementById("shown").textContent = `${left.length} of ${count(allRows.length, "kernel")}`;
  const place = document.getElementById("matrix");
  if (left.length === 0) {
    const why = view.onlyFailures && words.length === 0 ? "Nothing falls short." : "No kernel is left by this choice.";
    place.replaceChildren(make("p", {}, why));
    return;
  }
  place.replaceChildren(make("table", { role: "grid", "aria-label": "Kernels and questions" }, head(), body(left)));
  markOpened();
  const first = place.querySelector("[aria-selected=true]") ?? place.querySelector("tbody th");
  first.tabIndex = 0;
}

function order(sort) {
  const figure = (row, id) => {
    const answers = row.cells.get(id);
    if (answers.length === 0) return -2;
    const answer = gravest(answers);
    if (answer.verdict === "not_asked") return -1;
    return answer.verdict === "falls_short" ? 1e300 + share(answer) : shown(answer, view.figure);
  };
  if (sort === "listed") return (a, b) => a.listed - b.listed;
  if (sort === "name") return (a, b) => a.kernel.name.localeCompare(b.kernel.name);
  if (sort === "worst") return (a, b) => b.isShort - a.isShort || compare(b.worst, a.worst) || a.listed - b.listed;
  return (a, b) => compare(figure(b, sort), figure(a, sort)) || a.listed - b.listed;
}

/** Infinities are equal, and their difference is no number. */
function compare(a, b) {
  return a === b ? 0 : a - b;
}

function head() {
  const groups = allColumns.filter((column) => column.isFirst).map((column) => {
    const span = allColumns.filter((other) => other.question === column.question).length;
    return make("th", { class: "question first", colspan: span, scope: "colgroup" }, `${column.question}?`);
  });
  const titles = allColumns.map((column) => {
    const name = [column.question, column.label, column.small].filter(Boolean).join(" ");
    return make("th", { scope: "col", class: column.isFirst ? "first" : undefined, "aria-sort": view.sort === column.id ? "descending" : undefined },
      make("button", { type: "button", title: `Sort by ${name}`, onclick: () => sortBy(column.id) },
        column.label, column.small ? make("small", {}, column.small) : ""));
  });
  const kernel = make("th", { class: "kernel", scope: "col", rowspan: 2 }, "kernel");
  return make("thead", {}, make("tr", {}, kernel, ...groups), make("tr", {}, ...titles));
}

function sortBy(id) {
  view.sort = view.sort === id ? "listed" : id;
  document.getElementById("sort").value = view.sort;
  showMatrix();
}

function body(lines) {
  return make("tbody", {}, ...lines.map((row) => {
    const name = make("th", { scope: "row", tabindex: -1, "data-hash": hashOf(row.kernel.name), title: row.kernel.cite },
      row.kernel.name, make("small", {}, row.kernel.family));
    return make("tr", { class: row.isShort ? "short" : undefined }, name, ...allColumns.map((column) => cell(row, column)));
  }));
}

function cell(row, column) {
  const answers = row.cells.get(column.id);
  const place = column.isFirst ? "first" : "";
  if (answers.length === 0) return make("td", { class: `none ${place}`, tabindex: -1 });
  const answer = gravest(answers);
  const isEqual = answer.question === "agree" && answer.verdict === "holds";
  const element = make("td", {
    class: `${answer.verdict} ${isEqual ? "equal" : ""} ${place}`,
    tabindex: -1,
    "data-hash": hashOf(row.kernel.name, column.id),
    title: `${row.kernel.name}, ${column.id}: ${WORDS[answer.verdict]}${answer.why ? `, ${answer.why}` : ""}`,
  }, brief(answer, view.figure));
  if (answer.verdict === "holds") element.style.setProperty("--share", Math.min(1, shown(answer, view.figure)));
  return element;
}

function hashOf(...parts) {
  return `#${parts.map(encodeURIComponent).join("/")}`;
}

/** Marks the cell that the details are of. */
function markOpened() {
  for (const old of document.querySelectorAll("tbody [aria-selected]")) old.removeAttribute("aria-selected");
  const opened = [...document.querySelectorAll("tbody [data-hash]")].find((cell) => cell.dataset.hash === location.hash);
  opened?.setAttribute("aria-selected", "true");
  return opened;
}

/** Moves the focus from a cell by rows and columns. */
function move(from, down, right) {
  const lines = [...document.querySelectorAll("tbody tr")];
  const line = lines.indexOf(from.parentElement);
  const at = [...from.parentElement.children].indexOf(from);
  const within = (value, n) => Math.max(0, Math.min(n - 1, value));
  const target = lines[within(line + down, lines.length)].children;
  focusCell(from, target[within(at + right, target.length)]);
}

function focusCell(from, to) {
  from.tabIndex = -1;
  to.tabIndex = 0;
  to.focus();
  keepVisible(to);
}

/** The sticky head and first column may hide what the browser thinks is in sight. */
function keepVisible(cell) {
  const place = document.getElementById("matrix");
  const covered = place.querySelector("thead").offsetHeight - (cell.getBoundingClientRect().top - place.getBoundingClientRect().top);
  if (covered > 0) place.scrollTop -= covered;
  if (cell.tagName === "TH") return;
  const name = cell.parentElement.firstElementChild.getBoundingClientRect().right;
  const hidden = name - cell.getBoundingClientRect().left;
  if (hidden > 0) place.scrollLeft -= hidden;
}

function showLegend() {
  const entry = (swatch, text) => make("li", {}, swatch, text);
  const mark = (verdict, text) => make("span", { class: `swatch ${verdict}` }, text);
  document.getElementById("legend").append(
    entry(make("span", { class: "scale", role: "img", "aria-label": "pale to strong" }), "share of what is permitted, 0 to 1"),
    entry(mark("falls_short", "✗"), "falls short"),
    entry(mark("expected_failure", "△"), "expected"),
    entry(mark("not_asked", "–"), "not asked"));
}
