// How two texts differ, line by line.

/** Edits beyond which texts count as different altogether. */
const MOST_EDITS = 1500;
const CONTEXT = 3;

/**
 * Lines of both texts in order, each `{ kind: " " | "-" | "+", text, before, after }` with its numbers, from 1.
 * E. W. Myers, "An O(ND) Difference Algorithm and Its Variations", 1986.
 */
function lineDiff(before, after) {
  const [a, b] = [linesOf(before), linesOf(after)];
  let head = 0;
  while (head < a.length && head < b.length && a[head] === b[head]) head++;
  let tail = 0;
  while (tail < a.length - head && tail < b.length - head && a.at(-1 - tail) === b.at(-1 - tail)) tail++;
  const middle = edits(a.slice(head, a.length - tail), b.slice(head, b.length - tail));
  const kinds = [...Array(head).fill(" "), ...middle, ...Array(tail).fill(" ")];
  let [x, y] = [0, 0];
  return kinds.map((kind) => {
    const text = kind === "+" ? b[y] : a[x];
    if (kind !== "+") x++;
    if (kind !== "-") y++;
    return { kind, text, before: kind === "+" ? null : x, after: kind === "-" ? null : y };
  });
}

function linesOf(text) {
  if (text === "") return [];
  return text.replace(/\n$/, "").split("\n");
}

/** The kinds of lines that turn `a` into `b`. */
function edits(a, b) {
  const trace = furthestPaths(a, b);
  if (!trace) return [...Array(a.length).fill("-"), ...Array(b.length).fill("+")];
  const kinds = [];
  let [x, y] = [a.length, b.length];
  for (let d = trace.length - 1; d >= 0; d--) {
    const reached = trace[d];
    const k = x - y;
    const isDown = k === -d || (k !== d && reachedOn(reached, d, k - 1) < reachedOn(reached, d, k + 1));
    const from = isDown ? k + 1 : k - 1;
    const startX = d === 0 ? 0 : reachedOn(reached, d, from);
    const startY = startX - from;
    while (d > 0 ? x > startX && y > startY : x > 0 && y > 0) {
      kinds.push(" ");
      x--;
      y--;
    }
    if (d === 0) break;
    kinds.push(isDown ? "+" : "-");
    [x, y] = [startX, startY];
  }
  return kinds.reverse();
}

/** The value of a diagonal in what was reached before edit `d`. */
function reachedOn(reached, d, k) {
  return reached[k + d] ?? -1;
}

/** How far each diagonal reaches before each number of edits; `null` where there are too many. */
function furthestPaths(a, b) {
  const most = Math.min(a.length + b.length, MOST_EDITS);
  const reach = new Map([[1, 0]]);
  const trace = [];
  for (let d = 0; d <= most; d++) {
    trace.push(Array.from({ length: 2 * d + 1 }, (_, at) => reach.get(at - d) ?? -1));
    for (let k = -d; k <= d; k += 2) {
      const isDown = k === -d || (k !== d && (reach.get(k - 1) ?? -1) < (reach.get(k + 1) ?? -1));
      let x = isDown ? reach.get(k + 1) : reach.get(k - 1) + 1;
      while (x < a.length && x - k < b.length && a[x] === b[x - k]) x++;
      reach.set(k, x);
      if (x >= a.length && x - k >= b.length) return trace;
    }
  }
  return null;
}

/** Lines as they are shown: changes with what surrounds them, and numbers of lines that are left out. */
function hunks(lines) {
  const isNear = new Uint8Array(lines.length);
  lines.forEach((line, at) => {
    if (line.kind === " ") return;
    isNear.fill(1, Math.max(0, at - CONTEXT), Math.min(lines.length, at + CONTEXT + 1));
  });
  const parts = [];
  lines.forEach((line, at) => {
    const last = parts.at(-1);
    if (last && last.isShown === Boolean(isNear[at])) last.lines.push(line);
    else parts.push({ isShown: Boolean(isNear[at]), lines: [line] });
  });
  return parts;
}

/** What two lines begin and end with, so that the rest can be marked. */
function marked(text, other) {
  let head = 0;
  while (head < text.length && head < other.length && text[head] === other[head]) head++;
  let tail = 0;
  while (tail < text.length - head && tail < other.length - head && text.at(-1 - tail) === other.at(-1 - tail)) tail++;
  return [text.slice(0, head), text.slice(head, text.length - tail), text.slice(text.length - tail)];
}
