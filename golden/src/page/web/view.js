// Panes: one picture or several, all at the same place and magnification.

const ZOOMS = [1 / 8, 1 / 4, 1 / 2, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128];
const GRID_FROM = 24;
const FRAME_FROM = 4;

/** The panes that there are: `{ figure, canvas, layers, caption }`. */
let panes = [];
/** Which of two blinks. */
let isBlinkOn = false;
let blinkTimer = 0;

/** The layer that is laid over the truth. */
function upper() {
  return state.layer === "truth" ? "found" : state.layer;
}

/** What the panes of a mode show. */
function wantedPanes() {
  const over = upper();
  switch (state.mode) {
    case "side": return [["truth"], [over]];
    case "all": return LAYERS.map(([name]) => [name]);
    case "swipe": case "blink": case "onion": return [["truth", over]];
    default: return [[state.layer]];
  }
}

renderers.panes = () => {
  const parent = byId("panes");
  const view = parent && looked(openCase());
  if (!view) return stopBlinking();
  const slots = slotsLooked(view);
  const wanted = wantedPanes();
  if (panes.length !== wanted.length || !parent.contains(panes[0]?.figure)) buildPanes(parent, wanted.length);
  parent.dataset.mode = state.mode;
  keepBlinking();
  const layers = wanted.map((names) => names.map((name) => layerOf(view, slots, name)));
  const size = layers.flat().find((layer) => layer.size)?.size ?? view.found.item.size;
  panes.forEach((pane, at) => drawPane(pane, wanted[at], layers[at], size, view, slots));
};

function buildPanes(parent, n) {
  panes = Array.from({ length: n }, () => {
    const canvas = make("canvas", { role: "img" });
    const caption = make("figcaption", {});
    const figure = make("figure", { class: "pane" }, canvas, caption);
    listenToPane(canvas);
    return { figure, canvas, caption };
  });
  parent.replaceChildren(...panes.map((pane) => pane.figure));
}

/** Device pixels a pixel of the picture: as chosen, else as large as fits all panes. */
function scaleOf(size) {
  if (state.zoom > 0) return state.zoom;
  const fits = panes.map(({ canvas }) => Math.min(canvas.width / size[0], canvas.height / size[1]));
  const fit = Math.min(...fits);
  if (!(fit > 0)) return 1;
  return fit >= 1 ? Math.floor(fit) : 1 / Math.ceil(1 / fit);
}

/** Where the picture lies in a pane, in device pixels. */
function placed(canvas, size) {
  const scale = scaleOf(size);
  const [cx, cy] = [state.cx ?? size[0] / 2, state.cy ?? size[1] / 2];
  return { scale, x: Math.round(canvas.width / 2 - cx * scale), y: Math.round(canvas.height / 2 - cy * scale) };
}

function fitCanvas(canvas) {
  const box = canvas.getBoundingClientRect();
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [Math.max(1, Math.round(box.width * ratio)), Math.max(1, Math.round(box.height * ratio))];
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
}

function drawPane(pane, names, layers, size, view, slots) {
  panes.forEach(({ canvas }) => fitCanvas(canvas));
  const { canvas } = pane;
  const context = canvas.getContext("2d");
  context.clearRect(0, 0, canvas.width, canvas.height);
  const at = placed(canvas, size);
  canvas.dataset.place = JSON.stringify(at);
  const isTwo = names.length === 2;
  const [low, high] = isTwo ? layers : [layers[0], null];
  const single = state.mode === "blink" && isBlinkOn ? high : low;
  if (isTwo && state.mode !== "blink") drawTwo(context, low, high, at, size);
  else drawLayer(context, single, at, size);
  drawCursor(context, at, size);
  const why = layers.map((layer) => layer.why).filter(Boolean)[0] ?? "";
  pane.figure.dataset.why = why;
  const texts = names.map((name) => paneTitle(name, view));
  const title = state.mode === "blink" ? texts[isBlinkOn ? 1 : 0] : texts.join("  |  ");
  canvas.setAttribute("aria-label", [texts.join(" and "), why].filter(Boolean).join(": "));
  const last = state.mode === "blink" && !isBlinkOn ? names[0] : names.at(-1);
  const caption = [make("b", {}, title), ...(why ? [] : legendOf(view, slots, last))];
  pane.caption.replaceChildren(...caption);
}

function paneTitle(layer, view) {
  if (layer === "truth") return view.side === "fresh" && view.sides.length > 1 ? "New truth" : view.side === "fresh" ? "Truth (not accepted yet)" : "Accepted truth";
  if (layer === "found") return view.subject ? view.subject.id : "No route";
  return LAYER_NAMES[layer];
}

function drawLayer(context, layer, at, size) {
  if (!layer?.canvas) return;
  context.imageSmoothingEnabled = at.scale < 1;
  context.drawImage(layer.canvas, at.x, at.y, Math.round(size[0] * at.scale), Math.round(size[1] * at.scale));
  if (at.scale >= GRID_FROM) drawGrid(context, at, size);
}

function drawTwo(context, low, high, at, size) {
  drawLayer(context, low, at, size);
  context.save();
  if (state.mode === "onion") {
    context.globalAlpha = state.onion;
    drawLayer(context, high, at, size);
  } else {
    const edge = Math.round(state.swipe * context.canvas.width);
    context.beginPath();
    context.rect(edge, 0, context.canvas.width - edge, context.canvas.height);
    context.clip();
    context.clearRect(edge, 0, context.canvas.width - edge, context.canvas.height);
    drawLayer(context, high, at, size);
  }
  context.restore();
  if (state.mode === "swipe") drawDivider(context);
}

function drawDivider(context) {
  const edge = Math.round(state.swipe * context.canvas.width);
  const { height } = context.canvas;
  context.fillStyle = "rgba(0, 0, 0, 0.6)";
  context.fillRect(edge - 2, 0, 4, height);
  context.fillStyle = "#fff";
  context.fillRect(edge - 1, 0, 2, height);
  context.beginPath();
  context.roundRect(edge - 7, height / 2 - 18, 14, 36, 7);
  context.fill();
}

/** Lines between pixels, where they are large. */
function drawGrid(context, at, size) {
  const { width, height } = context.canvas;
  context.fillStyle = "rgba(128, 128, 128, 0.35)";
  const span = (from, n, end) => [Math.max(0, Math.floor(-from / at.scale)), Math.min(n, Math.ceil((end - from) / at.scale))];
  const [left, right] = span(at.x, size[0], width);
  const [top, bottom] = span(at.y, size[1], height);
  for (let x = left; x <= right; x++) context.fillRect(at.x + x * at.scale, at.y + top * at.scale, 1, (bottom - top) * at.scale);
  for (let y = top; y <= bottom; y++) context.fillRect(at.x + left * at.scale, at.y + y * at.scale, (right - left) * at.scale, 1);
}

/** A frame around the pixel that the inspector speaks of, or a cross where pixels are small. */
function drawCursor(context, at, size) {
  const { pixel } = state;
  if (!pixel || pixel.x >= size[0] || pixel.y >= size[1]) return;
  const [x, y, side] = [at.x + pixel.x * at.scale, at.y + pixel.y * at.scale, at.scale];
  for (const [colour, width] of [["#000", 3], ["#fff", 1]]) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    if (side >= FRAME_FROM) context.rect(x - 0.5, y - 0.5, side + 1, side + 1);
    else for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      context.moveTo(x + side / 2 + 5 * dx, y + side / 2 + 5 * dy);
      context.lineTo(x + side / 2 + 14 * dx, y + side / 2 + 14 * dy);
    }
    context.stroke();
  }
}

function keepBlinking() {
  if (state.mode !== "blink") return stopBlinking();
  if (blinkTimer && blinkTimer.every === state.blink) return;
  stopBlinking();
  const turn = () => {
    isBlinkOn = !isBlinkOn;
    changed("panes");
  };
  blinkTimer = { every: state.blink, id: setInterval(turn, state.blink) };
}

function stopBlinking() {
  if (blinkTimer) clearInterval(blinkTimer.id);
  blinkTimer = 0;
  isBlinkOn = false;
}
