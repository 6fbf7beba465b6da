// The pixel under the pointer: its values in every picture, and their bits.

renderers.pixel = () => {
  const parent = byId("pixel");
  const view = parent && looked(openCase());
  if (!view) return parent?.replaceChildren();
  const { pixel } = state;
  const [width, height] = view.found.item.size;
  if (!pixel || pixel.x >= width || pixel.y >= height) {
    return parent.replaceChildren(make("h3", {}, "Pixel"), make("p", { class: "dim" }, "Point at a picture, or press ", make("kbd", {}, "w"), " for the worst pixel."));
  }
  const head = make("h3", {}, `Pixel ${pixel.x}, ${pixel.y}`, make("small", {}, isPinned ? "held; click it to let go" : "click to hold"));
  parent.replaceChildren(head, pixelTable(view, 3 * (pixel.y * width + pixel.x)));
};

function pixelTable(view, at) {
  const { found, side } = view;
  const truth = slotOf(found, `${side}.truth`);
  const permitted = slotOf(found, `${side}.permitted`);
  const name = view.sides.length > 1 ? { accepted: "accepted truth", fresh: "new truth" }[side] : "truth";
  const rows = [valueRows(name, truth, at, "is-truth"), valueRows("permitted ±", permitted, at, "is-truth")];
  if (side === "fresh" && view.sides.length > 1) rows.push(valueRows("accepted truth", slotOf(found, "accepted.truth"), at, "", { truth, permitted }));
  for (const subject of view.subjects) {
    // It stands at the top already.
    if (side === "fresh" && !subject.route) continue;
    if (subject.route?.verdict === "failed") rows.push(absentRow(subject.id, "failed"));
    else rows.push(valueRows(subject.id, slotOf(found, subject.slot), at, subject === view.subject ? "is-looked" : "", { truth, permitted }));
  }
  const heads = ["R", "G", "B"].map((channel) => make("th", { scope: "col" }, channel));
  return make("table", { class: "values" }, make("thead", {}, make("tr", {}, ...heads)), ...rows);
}

function absentRow(name, why) {
  return make("tbody", {}, titleRow(name), make("tr", {}, make("td", { colspan: 3, class: "absent" }, why)));
}

function titleRow(name) {
  return make("tr", {}, make("th", { scope: "rowgroup", colspan: 3 }, name));
}

/** Rows of a source: decimals, bits, and the share of the bound with the distance in ULP. */
function valueRows(name, slot, at, kind, against) {
  if (slot.status === "loading") return absentRow(name, "loading");
  if (slot.status !== "here") return absentRow(name, "no picture");
  const values = [0, 1, 2].map((channel) => slot.picture.values[at + channel]);
  const line = (kind, texts, classes = []) => make("tr", { class: kind }, ...texts.map((text, channel) => make("td", { class: classes[channel] }, text)));
  const rows = [titleRow(name), line("decimal", values.map(decimal)), line("hex", values.map(hex))];
  if (against?.truth.status === "here" && against.permitted.status === "here") {
    const truths = [0, 1, 2].map((channel) => against.truth.picture.values[at + channel]);
    const shares = values.map((value, channel) => shareOf(truths[channel], against.permitted.picture.values[at + channel], value));
    rows.push(line("share", shares.map(shareText), shares.map(shareClass)));
    rows.push(line("ulp", values.map((value, channel) => ulpText(Number.isNaN(value) ? NaN : place(value) - place(truths[channel])))));
  }
  return make("tbody", { class: kind }, ...rows);
}

function shareText(share) {
  return Number.isNaN(share) ? "no bound" : `share ${brief(share)}`;
}

function shareClass(share) {
  return Number.isNaN(share) ? "unbounded" : share > 1 ? "outside" : "inside";
}

function ulpText(ulps) {
  if (Number.isNaN(ulps)) return "–";
  if (ulps === 0) return "equal";
  const size = Math.abs(ulps);
  const text = size < 1e5 ? String(size) : size.toExponential(0).replace("e+", "e");
  return `${ulps < 0 ? "−" : "+"}${text} ULP`;
}

renderers.inspector = () => {
  const parent = byId("inspector");
  const view = looked(openCase());
  parent.hidden = !view || state.lane !== "image";
  if (parent.hidden) return;
  if (!byId("pixel")) parent.append(make("section", { id: "pixel", "aria-label": "Pixel" }), make("section", { id: "spread", "aria-label": "Shares" }));
  byId("spread").replaceChildren(...spread(view));
};

/** Pixels by the share of the bound that they use, as bars; heights are logarithms, so that one pixel is seen. */
function spread(view) {
  const found = analysis(view, slotsLooked(view));
  const head = make("h3", {}, "Pixels by share of the bound");
  if (!found) return [head, make("p", { class: "dim" }, "There are no pictures to count in.")];
  const bins = binned(found.judgement);
  const [, outside, unbounded] = found.judgement.counts;
  const [width, height, base] = [300, 110, 84];
  const wide = width / bins.length;
  const tallest = Math.log2(1 + Math.max(...bins, 1));
  const bars = bins.map((pixels, at) => {
    if (pixels === 0) return "";
    const tall = Math.max(2, (Math.log2(1 + pixels) / tallest) * (base - 14));
    return draw("g", {}, draw("title", {}, `${count(pixels, "pixel")}: ${binName(at)}`),
      draw("rect", { x: at * wide + 1.5, y: base - tall, width: wide - 3, height: tall, rx: 1.5, class: at === BIN_ENDS.length ? "beyond" : "within" }),
      draw("text", { x: (at + 0.5) * wide, y: base - tall - 3, "text-anchor": "middle" }, shortly(pixels)));
  });
  const label = (x, text) => draw("text", { x, y: base + 13, "text-anchor": "middle" }, text);
  const labels = BIN_ENDS.slice(1).map((end, at) => label((at + 2) * wide, end === 1 ? "1" : `1/${1 / end}`));
  const spoken = bins.map((pixels, at) => (pixels ? `${count(pixels, "pixel")} ${binName(at)}` : "")).filter(Boolean).join("; ");
  const svg = draw("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": spoken },
    draw("line", { x1: 0, x2: width, y1: base, y2: base }), ...bars, label(0.5 * wide, "0"), ...labels);
  const texts = [count(found.judgement.equal, "pixel") + " equal to the bit", `${outside.toLocaleString("en")} outside`, `${unbounded.toLocaleString("en")} without a bound`];
  return [head, svg, make("p", { class: "dim" }, `${texts.join(", ")}. Heights are logarithmic.`)];
}

function binName(at) {
  if (at === 0) return "use none of it";
  return at === BIN_ENDS.length ? "are beyond it" : `use ${brief(BIN_ENDS[at - 1])} to ${brief(BIN_ENDS[at])} of it`;
}

function shortly(n) {
  if (n < 1000) return String(n);
  return n < 1e6 ? `${+(n / 1e3).toPrecision(2)}k` : `${+(n / 1e6).toPrecision(2)}M`;
}
