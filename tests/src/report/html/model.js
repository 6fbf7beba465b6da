// The report as a matrix: its columns, and of each kernel and column the answers that stand there.

const report = JSON.parse(document.getElementById("report").textContent);

const QUESTIONS = ["correct", "robust", "conformant", "agree"];
const WORDS = {
  falls_short: "falls short",
  expected_failure: "expected failure",
  holds: "holds",
  not_asked: "not asked",
};
// The gravest first: a cell of several answers shows the gravest.
const GRAVITY = Object.keys(WORDS);

/** A number of the report; those that JSON has no words for are strings there. */
function number(value) {
  const strings = { inf: Infinity, "-inf": -Infinity, nan: NaN };
  return typeof value === "string" ? strings[value] : value;
}

/** Where an answer stands: a column for each question, and for each route that it is asked of. */
function columnOf(answer) {
  const { question, subject } = answer;
  if (question === "correct") return { id: question, question, label: "tables, truth" };
  if (question === "conformant") {
    const [road, driver] = subject.split("@");
    return { id: `${question} ${subject}`, question, label: road, small: driver, route: subject };
  }
  const label = subject.replace(/^\d+ routes /, "");
  return { id: `${question} ${label}`.trim(), question, label: label || "bound" };
}

/** All columns, question by question; routes in the order in which they ran. */
function columns() {
  const found = new Map();
  for (const kernel of report.kernels) {
    for (const answer of kernel.answers) {
      const column = columnOf(answer);
      if (!found.has(column.id)) found.set(column.id, column);
    }
  }
  const rank = (list, value) => (list.includes(value) ? list.indexOf(value) : list.length);
  const all = [...found.values()];
  all.sort((a, b) => rank(QUESTIONS, a.question) - rank(QUESTIONS, b.question)
    || (a.route && b.route ? rank(report.routes, a.route) - rank(report.routes, b.route) : 0));
  all.forEach((column, at) => (column.isFirst = at === 0 || all[at - 1].question !== column.question));
  return all;
}

/** The gravest of some answers, and of those the one with the largest share. */
function gravest(answers) {
  const order = (a, b) => GRAVITY.indexOf(a.verdict) - GRAVITY.indexOf(b.verdict) || share(b) - share(a);
  return [...answers].sort(order)[0];
}

/** The largest share of what is permitted; NaN never is, so it comes before all. */
function share(answer) {
  const value = number(answer.share);
  return Number.isNaN(value) ? Infinity : value;
}

/** The rows of the matrix. */
function rows(columns) {
  return report.kernels.map((kernel, listed) => {
    const cells = new Map(columns.map((column) => [column.id, []]));
    for (const answer of kernel.answers) cells.get(columnOf(answer).id).push(answer);
    const asked = kernel.answers.filter((answer) => answer.verdict !== "not_asked");
    const isShort = asked.some((answer) => answer.verdict === "falls_short");
    const worst = Math.max(0, ...asked.map(share));
    const text = [kernel.name, kernel.family, kernel.cite, ...kernel.answers.map((answer) => answer.why ?? "")];
    return { kernel, listed, cells, isShort, worst, text: text.join("\n").toLowerCase() };
  });
}

/**
 * The figure that cells show: the largest share, or within what a part of the rows stays, where that is known.
 * What falls short does so at its largest share.
 */
function shown(answer, figure) {
  const isPart = answer.verdict !== "falls_short" && figure in (answer.distribution ?? {});
  return isPart ? number(answer.distribution[figure]) : share(answer);
}

/** What a cell says in a few characters. */
function brief(answer, wanted = "share") {
  if (answer.verdict === "not_asked") return "–";
  const isEquality = answer.question === "agree";
  const figure = isEquality || !answer.worst ? "" : short(shown(answer, wanted));
  if (answer.verdict === "falls_short") return `✗ ${figure}`.trim();
  if (answer.verdict === "expected_failure") return `△ ${figure}`.trim();
  return isEquality ? "=" : figure || "✓";
}

/** A figure to two digits. */
function short(value) {
  if (value === 0) return "0";
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "∞");
  const size = Math.abs(value);
  if (size >= 1000) return value.toExponential(0).replace("e+", "e");
  if (size >= 10) return value.toFixed(0);
  if (size >= 0.995) return value.toFixed(1);
  return size < 0.005 ? "<.01" : value.toFixed(2).replace(/^(-?)0\./, "$1.");
}

/** A figure to four digits. */
function precise(value) {
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "∞");
  const size = Math.abs(value);
  return size === 0 || (size >= 1e-3 && size < 1e6) ? String(+value.toPrecision(4)) : value.toExponential(3);
}

/** The value of a hexadecimal float, as far as a double holds it. */
function fromHex(text) {
  const parts = /^(-?)0x([0-9a-f]+)\.?([0-9a-f]*)p([+-]?\d+)$/i.exec(text);
  if (!parts) return number(text);
  const [, sign, whole, fraction, power] = parts;
  const digits = parseInt(whole + fraction, 16) * 2 ** (Number(power) - 4 * fraction.length);
  return sign ? -digits : digits;
}

/** Scalars of an argument by name, as `lobe.axis[1]`. */
function scalars(value, path = "") {
  if (Array.isArray(value)) return value.flatMap((part, at) => scalars(part, `${path}[${at}]`));
  if (value !== null && typeof value === "object") {
    return Object.entries(value).flatMap(([name, part]) => scalars(part, path ? `${path}.${name}` : name));
  }
  return [[path, value]];
}
