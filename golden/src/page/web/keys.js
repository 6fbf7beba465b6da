// Keys. One alone each, so that the hand stays where it is; none while something is typed.

const KEYS = {
  j: () => step(1),
  k: () => step(-1),
  "/": () => byId("search").focus(),
  ".": () => nextUndecided(),
  " ": () => flipLayer(),
  d: () => showLayer("difference"),
  h: () => showLayer("share"),
  f: () => showLayer("flip"),
  v: () => turnMode("side"),
  g: () => turnMode("all"),
  s: () => turnMode("swipe"),
  b: () => turnMode("blink"),
  o: () => turnMode("onion"),
  p: () => nextSubject(1),
  P: () => nextSubject(-1),
  x: () => turnAgainst(),
  "+": () => expose(1),
  "=": () => expose(1),
  "-": () => expose(-1),
  e: () => set({ exposure: 0, gain: 0 }),
  t: () => set({ tone: after(TONE_NAMES.map(([name]) => name), state.tone) }),
  c: () => set({ channel: after(ALLOWED.channel, state.channel) }),
  "]": () => zoomBy(1),
  "[": () => zoomBy(-1),
  z: () => fit(),
  w: () => goToWorst(() => 0),
  n: () => goToWorst((rank) => rank + 1),
  N: () => goToWorst((rank) => rank - 1),
  l: () => nextLane(1),
  L: () => nextLane(-1),
  a: () => decide("accept"),
  r: () => decide("reject"),
  u: () => undo(),
  E: () => showExport(),
  "?": () => showHelp(),
  Escape: () => letGo(),
};

function after(all, one) {
  return all[(all.indexOf(one) + 1) % all.length];
}

function flipLayer() {
  set({ layer: state.layer === "truth" ? "found" : "truth", mode: state.mode === "single" ? "single" : state.mode });
}

/** A map; once more, and it is the picture again. */
function showLayer(layer) {
  set({ layer: state.layer === layer ? "found" : layer });
}

function turnMode(mode) {
  set({ mode: state.mode === mode ? "single" : mode });
}

function letGo() {
  isPinned = false;
  if (document.activeElement === byId("search")) byId("list").focus();
  changed("pixel");
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Moves the pixel, where the pictures have the focus. */
function arrowKey(event) {
  const by = ARROWS[event.key];
  if (!by || !event.target.closest?.("#panes")) return false;
  const far = event.shiftKey ? 10 : 1;
  const [width, height] = caseSize();
  const from = state.pixel ?? { x: Math.floor(width / 2), y: Math.floor(height / 2) };
  goTo({ x: from.x + far * by[0], y: from.y + far * by[1] });
  return true;
}

function isTyping(event) {
  const { target } = event;
  if (!(target instanceof HTMLElement)) return false;
  return target.matches("input:not([type=range]), textarea, select") && event.key !== "Escape";
}

function keyDown(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event) || isDialogOpen()) return;
  // A button that has the focus is pressed by the space bar.
  if (event.key === " " && event.target.closest?.("button, summary")) return;
  if (arrowKey(event)) return event.preventDefault();
  if (/^[0-9]$/.test(event.key)) return pickByKey(event.key);
  const run = Object.hasOwn(KEYS, event.key) ? KEYS[event.key] : null;
  if (!run) return;
  event.preventDefault();
  run();
}

function nextSubject(by) {
  const view = looked(openCase());
  if (!view) return;
  const { subjects } = view;
  pickSubject(subjects[(subjects.indexOf(view.subject) + by + subjects.length) % subjects.length]);
}

function pickByKey(key) {
  const view = looked(openCase());
  if (!view) return;
  const subject = view.subjects.find((subject) => subject.key === key);
  if (subject) pickSubject(subject);
  else say(key === "0" ? "There is no new truth beside the accepted one." : `There is no route ${key}.`);
}
