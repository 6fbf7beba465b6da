// What is looked at, and how; the address holds it, so that it can be sent to others.

/** What the list says of the run, set once it is there: `report`, `routes` (names), `rows`. */
const run = { report: null, routes: [], rows: [] };

const DEFAULTS = {
  item: null,
  lane: "image",
  route: null,
  against: null,
  mode: "single",
  layer: "found",
  exposure: 0,
  gain: 0,
  tone: "clip",
  channel: "rgb",
  zoom: 0,
  cx: null,
  cy: null,
  pixel: null,
  swipe: 0.5,
  onion: 0.5,
  blink: 700,
};

const state = { ...DEFAULTS };

/** Of the row that is open. */
function openRow() {
  return state.item === null ? null : run.rows[state.item];
}

const renderers = {};
/** The order in which parts are drawn: a part may lie in one before it. */
const PARTS = ["summary", "filters", "list", "item", "tools", "zoom", "panes", "inspector", "pixel"];
const due = new Set();

/** Says what is drawn anew, before the next frame. */
function changed(...parts) {
  if (due.size === 0) requestAnimationFrame(renderDue);
  parts.forEach((part) => due.add(part));
  writeAddress();
}

function renderDue() {
  const parts = PARTS.filter((part) => due.has(part));
  due.clear();
  parts.forEach((part) => renderers[part]());
}

/** Sets members of the state, and draws anew what depends on them. */
function set(members) {
  const keys = Object.keys(members).filter((key) => state[key] !== members[key]);
  if (keys.length === 0) return;
  keys.forEach((key) => (state[key] = members[key]));
  const isView = (key) => ["zoom", "cx", "cy"].includes(key);
  if (keys.every((key) => key === "pixel")) changed("panes", "pixel");
  else if (keys.every(isView)) changed("panes", "zoom");
  else if (keys.every((key) => ["swipe", "onion", "blink"].includes(key))) changed("tools", "panes");
  else changed("item", "tools", "panes", "inspector", "pixel");
}

const IN_ADDRESS = ["lane", "route", "against", "mode", "layer", "exposure", "gain", "tone", "channel", "zoom", "cx", "cy", "swipe", "onion", "blink"];
const NUMBERS = new Set(["exposure", "gain", "zoom", "cx", "cy", "swipe", "onion", "blink"]);
const ALLOWED = {
  lane: ["image", "numbers", "kernel", "emitted"],
  mode: ["single", "side", "all", "swipe", "blink", "onion"],
  layer: ["truth", "found", "difference", "share", "flip"],
  tone: TONE_NAMES.map(([name]) => name),
  channel: ["rgb", "r", "g", "b"],
  against: ["accepted", "fresh"],
};
const RANGES = { exposure: [-20, 20], gain: [0, 24], zoom: [0, 128], swipe: [0, 1], onion: [0, 1], blink: [350, 2000] };

function address() {
  const words = new URLSearchParams();
  const row = openRow();
  if (row) words.set("case", nameOf(row));
  for (const key of IN_ADDRESS) {
    const value = state[key];
    if (value !== null && value !== DEFAULTS[key]) words.set(key, NUMBERS.has(key) ? String(+value.toFixed(3)) : value);
  }
  if (state.pixel) words.set("pixel", `${state.pixel.x},${state.pixel.y}`);
  filterWords(words);
  return `#${words}`;
}

let addressTimer = 0;

function writeAddress() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => {
    if (location.hash !== address()) history.replaceState(null, "", address());
  }, 200);
}

/** Takes the state out of the address; what it does not say, or says wrong, is as at the start. */
function readAddress() {
  const words = new URLSearchParams(location.hash.slice(1));
  const found = { ...DEFAULTS };
  for (const key of IN_ADDRESS) {
    if (!words.has(key)) continue;
    const value = NUMBERS.has(key) ? Number(words.get(key)) : words.get(key);
    if (NUMBERS.has(key) && !Number.isFinite(value)) continue;
    if (ALLOWED[key] && !ALLOWED[key].includes(value)) continue;
    found[key] = RANGES[key] ? Math.min(Math.max(value, RANGES[key][0]), RANGES[key][1]) : value;
  }
  const pixel = /^(\d{1,7}),(\d{1,7})$/.exec(words.get("pixel") ?? "");
  if (pixel) found.pixel = { x: Number(pixel[1]), y: Number(pixel[2]) };
  readFilters(words);
  const at = run.rows.findIndex((row) => nameOf(row) === words.get("case"));
  Object.assign(state, found, { item: at < 0 ? null : at });
  return { isNamed: words.has("case"), isFound: at >= 0 };
}

/** A case's name, which its row, its files and decisions have. */
function nameOf(row) {
  return `${row.scene}/${row.method}`;
}

/** What stays from one visit to the next; where the browser keeps nothing, it lasts as long as the page. */
const kept = {
  isKept: true,
  all: new Map(),
  get(name) {
    try {
      return localStorage.getItem(`lobe-golden ${name}`);
    } catch {
      this.isKept = false;
      return this.all.get(name) ?? null;
    }
  },
  set(name, text) {
    this.all.set(name, text);
    try {
      localStorage.setItem(`lobe-golden ${name}`, text);
    } catch {
      this.isKept = false;
    }
  },
};
