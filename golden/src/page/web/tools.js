// The tools of the image lane: what is looked at, and how.

const MODES = [
  ["single", "One", "1 picture", "One picture, or one map"],
  ["side", "Pair", "v", "The truth and the other, side by side"],
  ["all", "All", "g", "Both pictures and all maps"],
  ["swipe", "Swipe", "s", "A line that is drawn over the one uncovers the other"],
  ["blink", "Blink", "b", "The one and the other in turn"],
  ["onion", "Onion", "o", "The one shines through the other"],
].map(([value, text, key, title]) => [value, text, value === "single" ? "" : key, title]);

/** Sliders that are there, so that one is not replaced while it is drawn: `{ input, output, read }`. */
let sliders = [];

renderers.tools = () => {
  const parent = byId("tools");
  const view = parent && looked(openCase());
  if (!view) return;
  const { mode, layer, tone, channel } = state;
  const missing = view.subjects.filter((subject) => view.found.slots.get(subject.slot)?.status === "missing").length;
  const key = JSON.stringify([view.found.index, missing, view.subject?.id, view.side, mode, layer, tone, channel]);
  if (parent.dataset.key === key) return sliders.forEach(readSlider);
  parent.dataset.key = key;
  sliders = [];
  refill(parent,
    make("div", { class: "bar" }, subjectChips(view), againstChoice(view)),
    make("div", { class: "bar" },
      segments("Layer", LAYERS, layer, (layer) => set({ layer })),
      segments("Arrangement", MODES, mode, (mode) => set({ mode }))),
    make("div", { class: "bar" }, modeSlider(), ...lookTools(), zoomTools(), make("span", { class: "room" }), worstTools()));
};

function subjectChips(view) {
  const isLacking = ({ slot }) => view.found.pictures[slot] || view.found.slots.get(slot)?.status === "missing";
  const verdict = (subject) => (isLacking(subject) && subject.route?.verdict !== "failed" ? "lacking" : (subject.route?.verdict ?? "fresh"));
  const mark = (subject) => ({ inside: "✓", outside: "✗", indeterminate: "◌", failed: "!", lacking: "?", fresh: "≠" })[verdict(subject)] ?? "?";
  const words = (subject) => {
    if (verdict(subject) === "lacking") return "no picture";
    const { route } = subject;
    return route ? `${route.verdict}${route.change === "same" ? "" : `, ${route.change}`}` : "the truth as it is now";
  };
  return make("div", { class: "segments subjects", role: "group", "aria-label": "Routes" }, view.subjects.map((subject) => {
    const chip = button("", { "aria-pressed": String(subject === view.subject), "data-value": subject.id, class: verdict(subject), title: `${subject.id}: ${words(subject)}`, onclick: () => pickSubject(subject) });
    chip.append(make("span", { class: "sign", "aria-hidden": "true" }, mark(subject)), subject.id, make("span", { class: "unseen" }, `, ${words(subject)}`), subject.key ? make("kbd", { "aria-hidden": "true" }, subject.key) : "");
    return chip;
  }));
}

function pickSubject(subject) {
  if (subject) set({ route: subject.id, layer: state.layer === "truth" ? "found" : state.layer });
}

function againstChoice(view) {
  if (view.sides.length < 2) return "";
  const choices = [["accepted", "accepted truth", "", ""], ["fresh", "new truth", "x", ""]];
  const group = segments("Against", choices, view.side, (against) => set({ against }));
  return make("div", { class: "field" }, make("span", {}, "against"), group);
}

/** Looks at routes against the other truth. */
function turnAgainst() {
  const view = looked(openCase());
  if (!view || view.sides.length < 2) return say("There is one truth only.");
  if (view.subject?.slot === "fresh.truth") return say("The new truth is held against the accepted one.");
  set({ against: view.side === "accepted" ? "fresh" : "accepted" });
}

/** A slider for a member of the state; `text` says its value. */
function slider(label, id, [min, max, step], text) {
  const input = make("input", { id, type: "range", min, max, step, "aria-label": label, oninput: (event) => set({ [id]: Number(event.target.value) }) });
  const output = make("output", { for: id });
  const one = { input, output, read: () => [state[id], text(state[id])] };
  sliders.push(one);
  readSlider(one);
  return make("label", { class: "field" }, make("span", {}, label), input, output);
}

function readSlider({ input, output, read }) {
  const [value, text] = read();
  input.value = String(value);
  input.setAttribute("aria-valuetext", text);
  output.textContent = text;
}

const partText = (value) => `${Math.round(100 * value)} %`;
const stopsText = (value) => `${value > 0 ? "+" : value < 0 ? "−" : ""}${Math.abs(value)} EV`;

function modeSlider() {
  switch (state.mode) {
    case "swipe": return slider("Line", "swipe", [0, 1, 0.01], partText);
    case "onion": return slider("Upper", "onion", [0, 1, 0.05], partText);
    case "blink": return slider("Every", "blink", [350, 2000, 50], (value) => `${value} ms`);
    default: return "";
  }
}

function lookTools() {
  const isSingle = state.mode === "single";
  if (isSingle && (state.layer === "flip" || state.layer === "share")) return [channelChoice()];
  if (isSingle && state.layer === "difference") return [slider("Gain", "gain", [0, 24, 1], (value) => `× 2^${value}`), channelChoice()];
  const exposure = slider("Exposure", "exposure", [-10, 10, 0.5], stopsText);
  return [exposure, choice("Tone", TONE_NAMES, state.tone, (tone) => set({ tone }), { id: "tone" }), channelChoice()];
}

function channelChoice() {
  return choice("Channel", [["rgb", "RGB"], ["r", "R"], ["g", "G"], ["b", "B"]], state.channel, (channel) => set({ channel }), { id: "channel" });
}

/** Exposure of pictures; of the difference map, its gain. */
function expose(by) {
  if (state.layer === "difference" && state.mode !== "all") return set({ gain: Math.min(Math.max(state.gain + by, 0), 24) });
  set({ exposure: Math.min(Math.max(state.exposure + by / 2, -20), 20) });
}

function zoomTools() {
  const choices = [["0", "fit"], ...ZOOMS.map((zoom) => [String(zoom), zoom < 1 ? `1 : ${1 / zoom}` : `${zoom} : 1`])];
  return choice("Zoom", choices, String(state.zoom), (zoom) => (Number(zoom) ? zoomTo(Number(zoom)) : fit()), { id: "zoom" });
}

renderers.zoom = () => {
  const zoom = byId("zoom");
  if (zoom) zoom.value = String(state.zoom);
};

function worstTools() {
  return make("div", { class: "segments", role: "group", "aria-label": "Worst pixels" },
    button("Worst", { "data-value": "worst", title: "The pixel that uses the largest share of its bound", onclick: () => goToWorst(() => 0) }, "w"),
    button("Next", { "data-value": "next", title: "The next worst", onclick: () => goToWorst((rank) => rank + 1) }, "n"),
    button("Back", { "data-value": "back", title: "The one before", onclick: () => goToWorst((rank) => rank - 1) }, "N"));
}
