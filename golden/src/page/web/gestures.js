// The pointer and the wheel on panes; zoom and pan for all of them at once.

const DRAG_FROM = 4;
const GRIP = 12;

/** Whether the pixel stays where it is while the pointer moves. */
let isPinned = false;
let drag = null;

function caseSize() {
  return openCase()?.item?.size ?? [1, 1];
}

/** The position of the pointer in device pixels of a canvas. */
function pointerIn(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return { x: ((event.clientX - box.left) / box.width) * canvas.width, y: ((event.clientY - box.top) / box.height) * canvas.height };
}

/** The place in the picture under a position in a canvas. */
function placeUnder(canvas, { x, y }) {
  const at = placed(canvas, caseSize());
  return { x: (x - at.x) / at.scale, y: (y - at.y) / at.scale };
}

function pixelUnder(canvas, event) {
  const place = placeUnder(canvas, pointerIn(canvas, event));
  const [x, y] = [Math.floor(place.x), Math.floor(place.y)];
  const [width, height] = caseSize();
  return x >= 0 && y >= 0 && x < width && y < height ? { x, y } : null;
}

function listenToPane(canvas) {
  canvas.addEventListener("pointerdown", (event) => startDrag(canvas, event));
  canvas.addEventListener("pointermove", (event) => (drag ? keepDragging(canvas, event) : hover(canvas, event)));
  canvas.addEventListener("pointerup", (event) => endDrag(canvas, event));
  canvas.addEventListener("pointercancel", () => (drag = null));
  canvas.addEventListener("dblclick", () => fit());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomBy(event.deltaY < 0 ? 1 : -1, canvas, pointerIn(canvas, event));
  }, { passive: false });
}

function hover(canvas, event) {
  if (isPinned) return;
  const pixel = pixelUnder(canvas, event);
  if (pixel) setPixel(pixel);
}

function setPixel(pixel) {
  if (state.pixel?.x === pixel?.x && state.pixel?.y === pixel?.y) return;
  set({ pixel });
}

function startDrag(canvas, event) {
  if (event.button !== 0) return;
  const at = pointerIn(canvas, event);
  const isSwipe = state.mode === "swipe" && Math.abs(at.x - state.swipe * canvas.width) <= GRIP * (window.devicePixelRatio || 1);
  const [width, height] = caseSize();
  drag = { at, isSwipe, isMoved: false, cx: state.cx ?? width / 2, cy: state.cy ?? height / 2 };
  canvas.setPointerCapture(event.pointerId);
}

function keepDragging(canvas, event) {
  const at = pointerIn(canvas, event);
  const [dx, dy] = [at.x - drag.at.x, at.y - drag.at.y];
  drag.isMoved ||= Math.hypot(dx, dy) > DRAG_FROM;
  if (!drag.isMoved) return;
  if (drag.isSwipe) return set({ swipe: Math.min(Math.max(at.x / canvas.width, 0), 1) });
  const { scale } = placed(canvas, caseSize());
  moveTo(drag.cx - dx / scale, drag.cy - dy / scale);
}

function endDrag(canvas, event) {
  if (drag && !drag.isMoved) pin(pixelUnder(canvas, event));
  drag = null;
}

/** Holds a pixel fast, or lets go of it if it was held. */
function pin(pixel) {
  if (!pixel) return;
  const isSame = isPinned && state.pixel?.x === pixel.x && state.pixel?.y === pixel.y;
  isPinned = !isSame;
  setPixel(pixel);
  changed("pixel");
}

/** Puts a place of the picture in the middle of all panes. */
function moveTo(cx, cy) {
  const [width, height] = caseSize();
  set({ cx: Math.min(Math.max(cx, 0), width), cy: Math.min(Math.max(cy, 0), height) });
}

function fit() {
  set({ zoom: 0, cx: null, cy: null });
}

/** The next magnification, about a position in a canvas, or about the middle. */
function zoomBy(by, canvas = panes[0]?.canvas, about = null) {
  if (!canvas) return;
  const size = caseSize();
  const { scale } = placed(canvas, size);
  const next = by > 0 ? ZOOMS.find((zoom) => zoom > scale) : ZOOMS.findLast((zoom) => zoom < scale);
  if (next) zoomTo(next, canvas, about);
}

function zoomTo(zoom, canvas = panes[0]?.canvas, about = null) {
  const point = about ?? { x: canvas.width / 2, y: canvas.height / 2 };
  const place = about ? placeUnder(canvas, point) : { x: state.cx ?? caseSize()[0] / 2, y: state.cy ?? caseSize()[1] / 2 };
  state.zoom = zoom;
  // That place stays under the pointer.
  const cx = place.x - (point.x - canvas.width / 2) / zoom;
  const cy = place.y - (point.y - canvas.height / 2) / zoom;
  moveTo(cx, cy);
  changed("panes", "zoom");
}

/** Goes to a pixel, and scrolls the panes if it is out of sight. */
function goTo(pixel) {
  const [width, height] = caseSize();
  const next = { x: Math.min(Math.max(pixel.x, 0), width - 1), y: Math.min(Math.max(pixel.y, 0), height - 1) };
  isPinned = true;
  setPixel(next);
  const canvas = panes[0]?.canvas;
  if (canvas && !isInSight(canvas, next)) moveTo(next.x + 0.5, next.y + 0.5);
  changed("pixel");
}

function isInSight(canvas, pixel) {
  const at = placed(canvas, caseSize());
  const inside = (from, n, end) => from + n * at.scale >= 0 && from + (n + 1) * at.scale <= end;
  return inside(at.x, pixel.x, canvas.width) && inside(at.y, pixel.y, canvas.height);
}

/** How far down the list of the worst pixels somebody is, by what is looked at. */
const ranks = new Map();

/** Goes to the pixel so far down that list. */
function goToWorst(choose) {
  const view = looked(openCase());
  const found = view && analysis(view, slotsLooked(view));
  if (!found) return say("There are no pictures to look in.");
  const order = orderOf(found);
  if (order.length === 0) return say("No pixel differs.");
  const key = keyOf(view);
  const rank = Math.min(Math.max(choose(ranks.get(key) ?? -1), 0), order.length - 1);
  ranks.set(key, rank);
  const [width] = caseSize();
  goTo({ x: order[rank] % width, y: Math.floor(order[rank] / width) });
  say(`${rank === 0 ? "The worst pixel" : `Worst pixel ${rank + 1}`} of ${order.length.toLocaleString("en")} that differ`);
}
