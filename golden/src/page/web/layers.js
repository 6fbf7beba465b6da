// What can be laid over one another: pictures, and maps of how they differ.

const LAYERS = [
  ["truth", "Truth", "", "The true value (space flips)"],
  ["found", "Found", "", "What the route returned (space flips)"],
  ["difference", "Difference", "d", "Difference, by sign"],
  ["share", "Bound share", "h", "Share of what is permitted"],
  ["flip", "FLIP", "f", "What somebody sees who flips between the two"],
];
const LAYER_NAMES = Object.fromEntries(LAYERS.map(([name, text]) => [name, text]));

const MOST_KEPT = 16;
const drawn = new Map();
const analyses = new Map();

/** Of a map with a few members: the member, made if it is not there. */
function keptOr(map, most, key, made) {
  if (!map.has(key)) {
    map.set(key, made());
    if (map.size > most) map.delete(map.keys().next().value);
  }
  return map.get(key);
}

function keyOf(view) {
  return `${view.found.index} ${view.side} ${view.subject?.id} ${state.channel}`;
}

/** Judgement, differences and their scale; `null` until the pictures are there. */
function analysis(view, slots) {
  const { truth, permitted, found } = slots;
  if ([truth, permitted, found].some((slot) => slot.status !== "here")) return null;
  return keptOr(analyses, 3, keyOf(view), () => {
    const [t, p, f] = [truth, permitted, found].map((slot) => slot.picture.values);
    const difference = differences(t, f, state.channel);
    return { judgement: judged(t, p, f, state.channel), difference, furthest: furthest(difference), order: null };
  });
}

/** Pixels that differ, the worst first. */
function orderOf(found) {
  found.order ??= worstFirst(found.judgement, found.difference);
  return found.order;
}

/** A layer as a canvas: `{ canvas }`, or `{ why }` in its place. */
function layerOf(view, slots, layer) {
  const needed = { truth: ["truth"], found: ["found"], difference: ["truth", "found"], share: ["truth", "permitted", "found"], flip: ["flip"] }[layer];
  const lacking = needed.map((name) => slots[name]).find((slot) => slot.status !== "here");
  if (lacking) return { why: lacking.status === "loading" ? "Loading" : whyMissing(layer, view, lacking) };
  const size = slots[needed[0]].picture.size;
  if (needed.some((name) => String(slots[name].picture.size) !== String(size))) return { why: "The pictures are of different sizes" };
  const look = { exposure: state.exposure, tone: state.tone, channel: state.channel };
  const key = `${keyOf(view)} ${layer} ${layer === "difference" ? state.gain : JSON.stringify(look)}`;
  return { canvas: keptOr(drawn, MOST_KEPT, key, () => paintLayer(view, slots, layer, look)), size };
}

function whyMissing(layer, view, slot) {
  if (layer === "flip" && view.subject?.route && view.side !== view.sides[0]) return "FLIP was computed against the new truth only";
  if (layer === "flip") return "No FLIP map was computed";
  return `No picture: ${slot.why || "there is none"}`;
}

function paintLayer(view, slots, layer, look) {
  if (layer === "truth" || layer === "found") return shown(slots[layer].picture, look);
  if (layer === "flip") return shownHeat(slots.flip.picture);
  const size = slots.truth.picture.size;
  if (layer === "share") return shownShares(size, analysis(view, slots).judgement);
  const difference = differences(slots.truth.picture.values, slots.found.picture.values, state.channel);
  return shownDifference(size, difference, differenceScale(furthest(difference)));
}

/** The difference at the end of the colours. */
function differenceScale(most) {
  return (most || 1) / 2 ** state.gain;
}

/** What the colours of a layer mean. */
function legendOf(view, slots, layer) {
  if (layer === "share") {
    return [gradient("within", "0", "1"), swatch("beyond", "beyond"), swatch("hatch", "no bound")];
  }
  if (layer === "flip") return [gradient("heat", "0", "1")];
  if (layer === "difference") {
    const found = analysis(view, slots);
    const scale = found ? brief(differenceScale(found.furthest)) : "";
    return [gradient("signed", `−${scale}`, `+${scale}`), swatch("absurd", "NaN")];
  }
  const isAbsurd = slots[layer].picture?.values.some((value) => !Number.isFinite(value));
  const absurd = isAbsurd ? [swatch("absurd", "NaN, ∞")] : [];
  if (state.tone !== "stops") return absurd;
  return [gradient("heat", `2^${-FALSE_STOPS - state.exposure}`, `2^${FALSE_STOPS - state.exposure}`), ...absurd];
}

function gradient(kind, low, high) {
  return make("span", { class: "legend" }, low, make("span", { class: `gradient ${kind}` }), high);
}

function swatch(kind, text) {
  return make("span", { class: "legend" }, make("span", { class: `swatch ${kind}` }), text);
}
