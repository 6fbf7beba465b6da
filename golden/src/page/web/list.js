// The list of cases. Only the rows that are in sight are elements.

const ROW_HEIGHT = 46;
const BEYOND_SIGHT = 6;

/** Marks that are told apart by form, not by colour alone. */
const MARKS = { failed: "!", damaged: "!", missing: "+", changed: "≠", falls_short: "✗", restated: "≈", holds: "✓" };

renderers.list = () => {
  const list = byId("list");
  const rows = byId("rows");
  rows.style.height = `${shownRows.length * ROW_HEIGHT}px`;
  const first = Math.max(0, Math.floor(list.scrollTop / ROW_HEIGHT) - BEYOND_SIGHT);
  const last = Math.min(shownRows.length, Math.ceil((list.scrollTop + list.clientHeight) / ROW_HEIGHT) + BEYOND_SIGHT);
  const options = [];
  for (let at = first; at < last; at++) options.push(rowOf(shownRows[at], at));
  rows.replaceChildren(...options);
  const isOpen = state.item !== null && options.some((option) => option.id === `case-${state.item}`);
  if (isOpen) list.setAttribute("aria-activedescendant", `case-${state.item}`);
  else list.removeAttribute("aria-activedescendant");
  if (shownRows.length === 0) {
    rows.replaceChildren(make("p", { class: "nothing" }, run.rows.length ? "No case is like that." : "The report has no cases."));
  }
};

function rowOf(index, at) {
  const row = run.rows[index];
  const decided = decisions.get(nameOf(row));
  const verdict = row.is_lacking && isPassing(row) ? "lacking" : row.verdict;
  const words = VERDICT_WORDS[row.verdict] + (row.is_lacking ? ", lacks evidence" : "");
  const option = make("div", {
    id: `case-${index}`, role: "option", class: "row", "aria-selected": String(index === state.item), "aria-setsize": shownRows.length, "aria-posinset": at + 1,
    onclick: () => openItem(index),
  },
    make("span", { class: `mark ${verdict}`, title: words, "aria-label": words, role: "img" }, row.is_lacking && isPassing(row) ? "?" : (MARKS[row.verdict] ?? "?")),
    make("span", { class: "name" }, make("b", {}, row.method), make("small", {}, row.scene)),
    make("span", { class: "figure" },
      decided ? make("span", { class: `decided ${decided.action}` }, decided.action === "accept" ? "accepted" : "rejected") : "",
      make("small", { title: "largest share of the bound" }, row.worst === null ? "" : brief(share(row)))));
  option.style.transform = `translateY(${at * ROW_HEIGHT}px)`;
  return option;
}

function isPassing(row) {
  return row.verdict === "holds" || row.verdict === "restated";
}

/** Opens a case; what was chosen of the last one stays, where there is such a thing. */
function openItem(index, { isKept = false } = {}) {
  if (!isKept) Object.assign(state, { pixel: null, cx: null, cy: null, zoom: 0 });
  state.item = index;
  ranks.clear();
  reveal(index);
  changed("list", "item", "tools", "panes", "inspector", "pixel");
}

/** Scrolls the list so that a case is in sight. */
function reveal(index) {
  const at = shownRows.indexOf(index);
  const list = byId("list");
  if (at < 0) return;
  const [top, bottom] = [at * ROW_HEIGHT, (at + 1) * ROW_HEIGHT];
  if (top < list.scrollTop) list.scrollTop = top;
  else if (bottom > list.scrollTop + list.clientHeight) list.scrollTop = bottom - list.clientHeight;
}

/** Opens the case so many places further on. */
function step(by) {
  if (shownRows.length === 0) return;
  const at = shownRows.indexOf(state.item);
  const next = at < 0 ? 0 : Math.min(Math.max(at + by, 0), shownRows.length - 1);
  if (shownRows[next] !== state.item) openItem(shownRows[next]);
}

/** Keys of the list itself. */
function listKey(event) {
  const page = Math.max(1, Math.floor(byId("list").clientHeight / ROW_HEIGHT) - 1);
  const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity };
  if (!(event.key in steps)) return;
  event.preventDefault();
  const by = steps[event.key];
  step(Number.isFinite(by) ? by : Math.sign(by) * shownRows.length);
}

function listen() {
  byId("list").addEventListener("keydown", listKey);
  byId("list").addEventListener("scroll", () => changed("list"), { passive: true });
  new ResizeObserver(() => changed("list")).observe(byId("list"));
}
