// Names and texts that mean harm do none, wherever they are shown.

import assert from "node:assert/strict";

export default async function run(shown) {
  const { page } = shown;
  await shown.open();
  assert.equal(await shown.count(".row"), 2);
  const isHarmed = () => page.evaluate(() => "harmed" in window || document.querySelector("img, #item script") !== null || {}.harmed !== undefined);
  for (const lane of ["image", "numbers", "kernel", "emitted"]) {
    await shown.click(`#lane-${lane}`);
    assert.equal(await isHarmed(), false, lane);
  }
  assert.match(await shown.text("#lane"), /<script>window\.harmed = 1<\/script>/);
  await page.click("#more summary");
  await shown.click("#lane-image");
  await shown.press("1", "2", "0", "w");
  await page.selectOption("#filter-scene", { index: 1 });
  await shown.click("#clear");
  await shown.press("a");
  await page.fill("#reason", "\"'><img src=x onerror=window.harmed=1>");
  await shown.press("Enter", "E");
  assert.match(await shown.text("dialog"), /onerror/);
  assert.equal(await isHarmed(), false);
  await shown.press("Escape");
  await shown.click("#run");
  assert.match(await shown.text("dialog"), /<img src=x/);
  await shown.press("Escape", "j");
  assert.equal(await shown.text("h2"), "x../../up");
  assert.match(await shown.text(".problems"), /Not to be seen/);
  assert.equal(await isHarmed(), false);
  // An address that means harm.
  await shown.open(`#${new URLSearchParams({ case: "<img src=x onerror=window.harmed=1>", "list-search": "<script>", route: "<b>", "list-scene": "\"><svg onload=window.harmed=1>" })}`);
  assert.equal(await isHarmed(), false);
  // Scripts within the page do not run, and nothing can be loaded from elsewhere.
  const refused = await page.evaluate(async () => {
    const script = document.createElement("script");
    script.textContent = "window.harmed = 1";
    document.body.append(script);
    const image = new Image();
    const loaded = new Promise((done) => ((image.onload = () => done("loaded")), (image.onerror = () => done("refused"))));
    image.src = "https://example.org/x.png";
    const fetched = await fetch("https://example.org/").then(() => "loaded", () => "refused");
    return [await loaded, fetched, "harmed" in window];
  });
  assert.deepEqual(refused, ["refused", "refused", false]);
  // These were asked for here, not by the page.
  shown.asked = shown.asked.filter((url) => !url.startsWith("https://example.org/"));
  shown.expected.push(/Content Security Policy/, /Fetch API cannot load/);
}
