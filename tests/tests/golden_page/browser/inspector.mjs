// The inspector: the worst pixels, values and bits, and the keys that move the pixel.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";

/** What the report says, which the page was written from. */
function reportOf(shown) {
  return JSON.parse(readFileSync(path.join(shown.folder, "report.json"), "utf8"));
}

const bits = (value) => Buffer.from(new Uint8Array(new Float32Array([value]).buffer)).reverse().toString("hex");

export default async function run(shown) {
  const { page } = shown;
  const { items } = reportOf(shown);
  const item = items.find((item) => item.method === "ltc-rectangle");
  const route = item.routes.at(-1);
  await shown.openCase("cornell/ltc-rectangle");
  assert.match(await shown.text("#pixel"), /press\s+w/);

  await shown.press("w");
  assert.match(await shown.text("#pixel h3"), new RegExp(`^Pixel ${route.worst.x}, ${route.worst.y}`));
  assert.match(await shown.status(), /^The worst pixel of/);
  const looked = async (line) => shown.texts(`.values .is-looked .${line} td`);
  const channel = "RGB".indexOf(route.worst.channel);
  assert.equal((await looked("hex"))[channel], bits(route.worst.found));
  assert.equal(Math.fround(Number((await looked("decimal"))[channel])), Math.fround(route.worst.found));
  assert.equal((await looked("share"))[channel], `share ${Number(route.worst.share.toPrecision(3))}`);
  const truth = await shown.texts(".values tbody >> nth=0 >> .hex td");
  assert.equal(truth[channel], bits(route.worst.truth));
  const permitted = await shown.texts(".values tbody >> nth=1 >> .hex td");
  assert.equal(permitted[channel], bits(route.worst.permitted));
  // A source for the truth, what is permitted, and each route.
  assert.deepEqual(await shown.texts(".values tbody th"), ["truth", "permitted ±", ...item.routes.map((route) => route.route)]);

  // Counts are the report's.
  const { inside, outside, indeterminate, equal } = route.pixels;
  const spread = await shown.text("#spread p");
  assert.equal(spread, `${equal} pixel${equal === 1 ? "" : "s"} equal to the bit, ${outside} outside, ${indeterminate} without a bound. Heights are logarithmic.`);
  assert.equal(inside + outside + indeterminate, 128 * 128);

  // The next ones use less and less.
  const shares = [];
  for (let at = 0; at < 5; at++) {
    const found = (await looked("share")).map((text) => Number(text.replace("share ", "")));
    shares.push(Math.max(...found));
    await shown.press("n");
  }
  assert.deepEqual(shares, [...shares].sort((a, b) => b - a));
  assert.match(await shown.status(), /^Worst pixel 6 of/);
  await shown.press("N");
  assert.match(await shown.status(), /^Worst pixel 5 of/);
  await shown.click('[aria-label="Worst pixels"] [data-value="next"]');
  await shown.click('[aria-label="Worst pixels"] [data-value="back"]');
  assert.match(await shown.status(), /^Worst pixel 5 of/);
  await shown.click('[aria-label="Worst pixels"] [data-value="worst"]');
  assert.match(await shown.text("#pixel h3"), new RegExp(`^Pixel ${route.worst.x}, ${route.worst.y}`));

  await pointer(shown);
  await indeterminates(shown, items);
  await shown.openCase("spheres/sg-specular", { route: "native" });
  await shown.press("w");
  assert.match(await shown.status(), /No pixel differs/);
}

async function pointer(shown) {
  const { page } = shown;
  const at = async () => (await shown.text("#pixel h3")).split("\n")[0].match(/^Pixel (\d+), (\d+)/).slice(1).map(Number);
  await shown.press("Escape");
  const spot = await shown.screen(0, 20, 33);
  await page.mouse.move(spot.x, spot.y);
  await shown.settle();
  assert.deepEqual(await at(), [20, 33]);
  await page.mouse.click(spot.x, spot.y);
  await page.mouse.move(spot.x + 60, spot.y + 60);
  await shown.settle();
  assert.deepEqual(await at(), [20, 33], "a click holds the pixel");
  await shown.press("Escape");
  await page.mouse.move(spot.x + 1, spot.y);
  const next = await shown.screen(0, 21, 33);
  await page.mouse.move(next.x, next.y);
  await shown.settle();
  assert.deepEqual(await at(), [21, 33], "Escape lets go of it");
  await page.focus("#panes");
  await shown.press("ArrowRight", "ArrowDown", "Shift+ArrowLeft", "Shift+ArrowUp");
  assert.deepEqual(await at(), [12, 24]);
  await shown.press("Shift+ArrowLeft", "Shift+ArrowLeft");
  assert.deepEqual(await at(), [0, 24], "the edge is the end");
  assert.equal((await shown.words()).pixel, "0,24");
}

async function indeterminates(shown, items) {
  const item = items.find((item) => item.method === "undefined-edge");
  await shown.openCase("spheres/undefined-edge", { pixel: "120,10", layer: "share" });
  assert.deepEqual(await shown.texts(".values .is-looked .share td"), Array(3).fill("no bound"));
  assert.equal(Number((await shown.text("#spread p")).match(/([\d,]+) without/)[1].replace(",", "")), item.routes[0].pixels.indeterminate);
  const [r, g, b] = await shown.colour(0, 119, 20);
  assert.ok(Math.abs(r - g) < 8 && Math.abs(g - b) < 8, "where nothing is promised it is grey");
  assert.notDeepEqual(await shown.colour(0, 119, 20), await shown.colour(0, 121, 20), "and hatched");
}
