// Which cases the list shows, and in which order.

const NO_FILTER = { search: "", verdicts: "", kind: "", scene: "", method: "", route: "", change: "", state: "", sort: "attention" };
const filter = { ...NO_FILTER };

const VERDICTS = ["failed", "damaged", "missing", "changed", "falls_short", "restated", "holds"];
const VERDICT_WORDS = {
  failed: "failed", damaged: "damaged", missing: "missing", changed: "changed", falls_short: "falls short", restated: "restated", holds: "holds",
};
const CHANGES = ["mathematics", "emission", "driver", "unexplained", "new", "same"];
const SORTS = [["attention", "what asks for a look"], ["listed", "as listed"], ["name", "by name"], ["share", "largest share"]];
const STATES = [["", "any"], ["undecided", "to decide"], ["decided", "decided"], ["lacking", "lacking evidence"]];

/** Indices of the rows that are shown, in order. */
let shownRows = [];

function share(row) {
  return row.worst === null ? -1 : number(row.worst);
}

/** Whether a row's case passes, and there is evidence of it. */
function isFine(row) {
  return (row.verdict === "holds" || row.verdict === "restated") && !row.is_lacking;
}

function matches(row, words) {
  const is = (wanted, value) => wanted === "" || wanted === value;
  if (!is(filter.kind, row.kind) || !is(filter.scene, row.scene) || !is(filter.method, row.method)) return false;
  if (filter.verdicts && !filter.verdicts.split(" ").includes(row.verdict)) return false;
  if (filter.route || filter.change) {
    const isOne = ([route, , change]) => is(filter.route, run.routes[route]) && is(filter.change, change);
    if (!row.routes.some(isOne)) return false;
  }
  if (filter.state === "lacking" && !row.is_lacking) return false;
  if (filter.state === "decided" && !decisions.has(nameOf(row))) return false;
  if (filter.state === "undecided" && (!isPending(row) || decisions.has(nameOf(row)))) return false;
  return words.every((word) => row.text.includes(word));
}

const ORDERS = {
  attention: (a, b) => isFine(a) - isFine(b) || VERDICTS.indexOf(a.verdict) - VERDICTS.indexOf(b.verdict) || share(b) - share(a) || 0,
  listed: () => 0,
  name: (a, b) => (nameOf(a) < nameOf(b) ? -1 : 1),
  share: (a, b) => share(b) - share(a) || 0,
};

/** Looks again which rows are shown. */
function refilter() {
  const words = filter.search.toLowerCase().split(/\s+/).filter(Boolean);
  const order = ORDERS[filter.sort] ?? ORDERS.attention;
  const all = [];
  run.rows.forEach((row, at) => matches(row, words) && all.push(at));
  shownRows = all.sort((a, b) => order(run.rows[a], run.rows[b]) || a - b);
}

function setFilter(members) {
  Object.assign(filter, members);
  refilter();
  byId("list").scrollTop = 0;
  changed("summary", "filters", "list");
}

/** Puts the filters into the words of an address. */
function filterWords(words) {
  for (const key of Object.keys(NO_FILTER)) if (filter[key] !== NO_FILTER[key]) words.set(`list-${key}`, filter[key]);
}

function readFilters(words) {
  for (const key of Object.keys(NO_FILTER)) filter[key] = words.get(`list-${key}`) ?? NO_FILTER[key];
}

/** Names beyond which nobody looks through a list; the search finds them. */
const MOST_CHOICES = 400;

/** Names that rows have, sorted, to choose from; a name of the address that none has can be seen, and taken back. */
function choicesOf(key, names) {
  const all = [...new Set(names)].sort().slice(0, MOST_CHOICES);
  if (filter[key] && !all.includes(filter[key])) all.push(filter[key]);
  return [["", "any"], ...all.map((name) => [name, name])];
}

renderers.filters = () => {
  const parent = byId("filters");
  if (!byId("search")) parent.append(...searchBox());
  if (document.activeElement !== byId("search")) byId("search").value = filter.search;
  const set = Object.keys(NO_FILTER).filter((key) => !["search", "sort", "verdicts"].includes(key) && filter[key] !== "");
  const isOpen = byId("more").open;
  const pick = (key, label, choices) => choice(label, choices, filter[key], (value) => setFilter({ [key]: value }), { id: `filter-${key}` });
  refill(byId("picks"), ...(!isOpen ? [] : [
    pick("kind", "Kind", choicesOf("kind", run.rows.map((row) => row.kind))),
    pick("scene", "Scene", choicesOf("scene", run.rows.map((row) => row.scene))),
    pick("method", "Method", choicesOf("method", run.rows.map((row) => row.method))),
    pick("route", "Route", choicesOf("route", run.routes)),
    pick("change", "Change", [["", "any"], ...CHANGES.map((name) => [name, name])]),
    pick("state", "Only", STATES)]));
  byId("more").firstChild.textContent = set.length ? `Filters (${set.length})` : "Filters";
  const isFiltered = set.length || filter.verdicts || filter.search;
  refill(byId("found"),
    make("span", {}, shownRows.length === run.rows.length ? count(shownRows.length, "case") : `${shownRows.length.toLocaleString("en")} of ${count(run.rows.length, "case")}`),
    isFiltered ? button("clear", { id: "clear", onclick: () => setFilter({ ...NO_FILTER, sort: filter.sort }) }) : "",
    choice("Sort", SORTS, filter.sort, (sort) => setFilter({ sort }), { id: "filter-sort" }));
};

function searchBox() {
  const search = make("input", {
    id: "search", type: "search", placeholder: "Search cases", "aria-label": "Search cases", "aria-keyshortcuts": "/", autocomplete: "off", spellcheck: "false",
    oninput: (event) => setFilter({ search: event.target.value }),
    onkeydown: (event) => {
      if (event.key === "Enter" || event.key === "ArrowDown") {
        event.preventDefault();
        byId("list").focus();
        if (shownRows.length && !shownRows.includes(state.item)) openItem(shownRows[0]);
      }
    },
  });
  return [
    make("div", { class: "search" }, search, make("kbd", { "aria-hidden": "true" }, "/")),
    make("details", { id: "more", ontoggle: () => changed("filters") }, make("summary", {}, "Filters"), make("div", { id: "picks", "aria-label": "Filters", role: "group" })),
    make("div", { id: "found" }),
  ];
}
