// Pictures: layers, arrangements, exposure, tone, channels, zoom and pan, all by keys and by the pointer.

import assert from "node:assert/strict";

const PLACE = [60, 50];
const pressed = (shown, group) => shown.page.locator(`[aria-label="${group}"] [aria-pressed="true"]`).getAttribute("data-value");
const mean = ([a, b]) => a.map((x, c) => (x + b[c]) / 2);
const isNear = (a, b, by = 2) => a.every((x, c) => Math.abs(x - b[c]) <= by);

export default async function run(shown) {
  const { page } = shown;
  await shown.openCase("cornell/ltc-rectangle");
  assert.equal(await pressed(shown, "Routes"), "hlsl+dxc@swiftshader", "the route that is worst off is looked at first");
  await layers(shown);
  await arrangements(shown);
  await looks(shown);
  await zooms(shown);
  await subjects(shown);
}

async function layers(shown) {
  const { page } = shown;
  const colours = {};
  for (const [layer, key] of [["truth", " "], ["found", " "], ["difference", "d"], ["share", "h"], ["flip", "f"]]) {
    await shown.press(key);
    assert.equal(await pressed(shown, "Layer"), layer, key);
    colours[layer] = await shown.colour(0, ...PLACE);
    await shown.click(`[aria-label="Layer"] [data-value="${layer}"]`);
    assert.deepEqual(await shown.colour(0, ...PLACE), colours[layer], layer);
  }
  // Beyond the bound is red, inside is green to yellow, and a difference of either sign has its own colour.
  await shown.press("h");
  const [red, green] = [await shown.colour(0, 62, 62), await shown.colour(0, 10, 10)];
  assert.ok(red[0] > 2 * red[1] && red[0] > 2 * red[2], `beyond: ${red}`);
  assert.ok(green[1] > green[2] && green[1] >= 90, `inside: ${green}`);
  assert.match(await shown.text("figcaption"), /Bound share\s*0\s*1\s*beyond\s*no bound/);
  // The truth's colour is what sRGB makes of its value.
  await shown.press(" ");
  await page.mouse.move(0, 0);
  await shown.press("w");
  const held = (await shown.words()).pixel.split(",").map(Number);
  const value = Number((await shown.texts(".values tbody:first-of-type .decimal td"))[0]);
  const srgb = value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055;
  await shown.press(" ", " ");
  const [red8] = await shown.colour(0, ...held);
  assert.ok(Math.abs(red8 - 255 * srgb) <= 1.01, `${red8} is not ${255 * srgb}`);
  await shown.press("d", "d");
  assert.equal(await pressed(shown, "Layer"), "found", "a map's key twice is the picture again");
}

async function arrangements(shown) {
  const { page } = shown;
  await shown.press("d");
  const over = await shown.colour(0, 62, 62);
  await shown.press(" ", " ", "d");
  for (const [mode, key, panes] of [["side", "v", 2], ["all", "g", 5], ["swipe", "s", 1], ["blink", "b", 1], ["onion", "o", 1]]) {
    await shown.press(key);
    assert.equal(await pressed(shown, "Arrangement"), mode);
    assert.equal(await shown.count(".pane"), panes, mode);
    await shown.press(key);
    assert.equal(await pressed(shown, "Arrangement"), "single");
    await shown.click(`[aria-label="Arrangement"] [data-value="${mode}"]`);
    assert.equal(await shown.count(".pane"), panes, mode);
  }
  await shown.press("v");
  const truth = await shown.colour(0, 62, 62);
  assert.deepEqual(await shown.colour(1, 62, 62), over);
  assert.notDeepEqual(truth, over);

  // Left of the line is the truth, right of it the other.
  await shown.press("s");
  await page.locator("#swipe").fill("0.3");
  await shown.settle();
  assert.deepEqual(await shown.colour(0, 62, 62), over);
  await page.locator("#swipe").fill("0.9");
  await shown.settle();
  assert.deepEqual(await shown.colour(0, 62, 62), truth);
  assert.equal(await shown.text("#tools output"), "90 %");
  const box = await page.locator("#panes canvas").boundingBox();
  await page.mouse.move(box.x + 0.9 * box.width, box.y + 30);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.2 * box.width, box.y + 40, { steps: 5 });
  await page.mouse.up();
  await shown.settle();
  assert.deepEqual(await shown.colour(0, 62, 62), over);
  assert.ok(Math.abs(Number((await shown.words()).swipe) - 0.2) < 0.01);
  await page.locator("#swipe").focus();
  await shown.press("ArrowRight");
  assert.ok(Math.abs(Number((await shown.words()).swipe) - 0.21) < 0.01, "arrow keys move the line");
  await page.evaluate(() => document.activeElement.blur());

  await shown.press("o");
  for (const [upper, expected] of [["0", truth], ["1", over], ["0.5", mean([truth, over])]]) {
    await page.locator("#onion").fill(upper);
    await shown.settle();
    const found = await shown.colour(0, 62, 62);
    assert.ok(isNear(found, expected), `${upper}: ${found} is not ${expected}`);
  }
  await shown.press("b");
  await page.locator("#blink").fill("350");
  await shown.settle();
  const seen = new Set();
  for (let at = 0; at < 40 && seen.size < 2; at++) {
    seen.add(String(await shown.colour(0, 62, 62)));
    await page.waitForTimeout(50);
  }
  assert.deepEqual(seen, new Set([String(truth), String(over)]));
  assert.equal(await page.getAttribute("#blink", "min"), "350", "never more than three flashes a second");
  await shown.press("b", "d");
}

async function looks(shown) {
  const { page } = shown;
  const plain = await shown.colour(0, ...PLACE);
  await shown.press("+", "+");
  assert.equal(await shown.text("#tools output"), "+1 EV");
  const brighter = await shown.colour(0, ...PLACE);
  assert.ok(brighter[2] > plain[2]);
  await shown.press("-", "-", "-", "-");
  assert.ok((await shown.colour(0, ...PLACE))[2] < plain[2]);
  await shown.press("e");
  assert.deepEqual(await shown.colour(0, ...PLACE), plain);
  await page.locator("#exposure").fill("1");
  await shown.settle();
  assert.deepEqual(await shown.colour(0, ...PLACE), brighter);
  await shown.press("e");
  const tones = new Set();
  for (const tone of ["clip", "reinhard", "aces", "stops"]) {
    assert.equal(await page.inputValue("#tone"), tone);
    tones.add(String(await shown.colour(0, ...PLACE)));
    await shown.press("t");
  }
  assert.equal(tones.size, 4, "each tone map shows another colour");
  await page.selectOption("#tone", "reinhard");
  await shown.settle();
  assert.equal((await shown.words()).tone, "reinhard");
  await page.selectOption("#tone", "clip");
  for (const [at, channel] of ["rgb", "r", "g", "b"].entries()) {
    assert.equal(await page.inputValue("#channel"), channel);
    const found = await shown.colour(0, ...PLACE);
    if (channel !== "rgb") assert.deepEqual(found, Array(3).fill(plain[at - 1]), channel);
    await shown.press("c");
  }
  await page.selectOption("#channel", "g");
  await shown.settle();
  assert.equal((await shown.words()).channel, "g");
  await page.selectOption("#channel", "rgb");
  // A difference map's gain.
  await shown.press("d");
  const dim = await shown.colour(0, 10, 10);
  await shown.press("+", "+", "+");
  assert.equal(await shown.text("#tools output"), "× 2^3");
  assert.notDeepEqual(await shown.colour(0, 10, 10), dim);
  await page.locator("#gain").fill("0");
  await shown.settle();
  assert.deepEqual(await shown.colour(0, 10, 10), dim);
  await shown.press("d");
}

async function zooms(shown) {
  const { page } = shown;
  await shown.press("v");
  await page.mouse.move(0, 0);
  const [left, right] = [await shown.screen(0, 64, 64), await shown.screen(1, 64, 64)];
  assert.equal(left.scale, Math.floor(left.scale), "a whole number of screen pixels each");
  const spot = await shown.screen(1, 30, 40);
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.wheel(0, -100);
  await page.mouse.wheel(0, -100);
  await shown.settle();
  const after = await shown.screen(1, 30, 40);
  assert.ok(after.scale > spot.scale);
  assert.ok(Math.hypot(after.x - spot.x, after.y - spot.y) <= after.scale, "the pixel under the pointer stays there");
  const other = await shown.screen(0, 30, 40);
  assert.equal(other.scale, after.scale, "panes are linked");
  assert.ok(Math.abs(other.y - after.y) < 1);
  // Panning moves both.
  await page.mouse.down();
  await page.mouse.move(spot.x + 50, spot.y - 30, { steps: 4 });
  await page.mouse.up();
  await shown.settle();
  const moved = await shown.screen(0, 30, 40);
  assert.ok(Math.abs(moved.x - other.x - 50) <= 1 && Math.abs(moved.y - other.y + 30) <= 1, JSON.stringify([moved, other]));
  await page.mouse.dblclick(spot.x, spot.y);
  await shown.settle();
  assert.equal((await shown.screen(0, 64, 64)).scale, left.scale);
  await shown.press("]", "]");
  assert.ok((await shown.screen(0, 64, 64)).scale > left.scale);
  await shown.press("[", "z");
  assert.equal((await shown.screen(1, 64, 64)).x, right.x);
  await page.selectOption("#zoom", "16");
  await shown.settle();
  assert.equal((await shown.screen(0, 64, 64)).scale, 16);
  assert.equal((await shown.words()).zoom, "16");
  await page.reload();
  await page.waitForSelector(".pane");
  await shown.settle();
  assert.equal((await shown.screen(0, 64, 64)).scale, 16);
  assert.equal(await page.inputValue("#zoom"), "16");
  await page.selectOption("#zoom", "0");
  await shown.press("v");
}

async function subjects(shown) {
  const { page } = shown;
  for (const [key, route] of [["1", "native"], ["2", "spirv@lavapipe"], ["3", "hlsl+dxc@swiftshader"]]) {
    await shown.press(key);
    assert.equal(await pressed(shown, "Routes"), route);
    assert.match(await shown.text("figcaption b"), new RegExp(route.replace("+", "\\+")));
  }
  await shown.press("p");
  assert.equal(await pressed(shown, "Routes"), "native");
  await shown.press("P", "P");
  assert.equal(await pressed(shown, "Routes"), "spirv@lavapipe");
  await shown.click('[aria-label="Routes"] [data-value="native"]');
  assert.equal((await shown.words()).route, "native");
  await shown.press("9");
  assert.match(await shown.status(), /no route 9/);
  await shown.press("0");
  assert.match(await shown.status(), /no new truth/);
  await shown.press("x");
  assert.match(await shown.status(), /one truth only/);

  await shown.openCase("cornell/sg-diffuse");
  assert.equal(await pressed(shown, "Routes"), "new truth", "where the truth is another, it is looked at first");
  await shown.press("2");
  assert.equal(await pressed(shown, "Against"), "fresh", "as the report judged");
  const before = await shown.text("#spread p");
  await shown.press("x");
  assert.equal(await pressed(shown, "Against"), "accepted");
  assert.notEqual(await shown.text("#spread p"), before);
  await shown.press("f");
  assert.match(await page.getAttribute(".pane", "data-why"), /against the new truth only/);
  await shown.press("f");
  await shown.click('[aria-label="Against"] [data-value="fresh"]');
  assert.equal(await shown.text("#spread p"), before);
  await shown.press("0", "x");
  assert.match(await shown.status(), /against the accepted one/);
}
