// A picture of a million pixels: the panes, the worst of its pixels, and the wheel.

import assert from "node:assert/strict";

export default async function run(shown) {
  const { page } = shown;
  await shown.openCase("large/sg-diffuse", { mode: "all" });
  assert.equal(await shown.count('.pane[data-why=""]'), 5);
  const { scale } = await shown.screen(0, 512, 512);
  assert.ok(scale < 1 && Number.isInteger(1 / scale), `a whole number of pixels in each of the screen: ${scale}`);
  await shown.press("1", "w", "n");
  assert.match(await shown.status(), /^Worst pixel 2 of [\d,]+ that differ/);
  await shown.press("g");
  const spot = await shown.screen(0, 700, 300);
  await page.mouse.move(spot.x, spot.y);
  for (let at = 0; at < 6; at++) await page.mouse.wheel(0, -100);
  await shown.settle();
  const after = await shown.screen(0, 700, 300);
  assert.ok(after.scale >= 4);
  assert.ok(Math.hypot(after.x - spot.x, after.y - spot.y) <= 2 * after.scale, "the pixel under the pointer stays there");
}
