// Ten thousand cases: only those in sight are elements, and the memory is small.

import assert from "node:assert/strict";

const MOST_HEAP = 500e6;

export default async function run(shown) {
  const { page } = shown;
  const session = await shown.context.newCDPSession(page);
  await session.send("Performance.enable");
  const heap = async () => (await session.send("Performance.getMetrics")).metrics.find((metric) => metric.name === "JSHeapUsedSize").value;
  await shown.open();
  const paint = await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime);
  assert.match(await shown.text("#found"), /^10,000 cases/);
  let most = await heap();
  const isFew = async () => {
    assert.ok((await shown.count(".row")) < 60, "rows out of sight are no elements");
    most = Math.max(most, await heap());
  };
  await isFew();
  await page.focus("#list");
  await shown.press("End");
  assert.equal(await page.getAttribute('.row[aria-selected="true"]', "aria-posinset"), "10000");
  await isFew();
  for (const share of [0.2, 0.7, 0.5]) {
    await page.evaluate((share) => ((list) => (list.scrollTop = share * list.scrollHeight))(document.getElementById("list")), share);
    await shown.settle();
    await isFew();
  }
  await page.fill("#search", "method-17 scene-9");
  await shown.settle();
  assert.match(await shown.text("#found"), /^11 of 10,000 cases/);
  await page.fill("#search", "");
  await shown.click('.chip[data-value="changed"]');
  assert.match(await shown.text("#found"), /^100 of 10,000 cases/);
  for (let at = 0; at < 40; at++) await shown.press("j");
  await isFew();
  assert.ok(most < MOST_HEAP, `${most} bytes`);
  console.log(`first paint after ${Math.round(paint)} ms, at most ${(most / 1e6).toFixed(1)} MB of heap`);
}
