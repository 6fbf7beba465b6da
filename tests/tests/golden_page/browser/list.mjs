// The list: order, search, filters, keys, and the address that holds them.

import assert from "node:assert/strict";

const rows = (shown) => shown.texts(".row .name b");

export default async function run(shown) {
  const { page } = shown;
  await shown.open();
  const all = await rows(shown);
  assert.equal(all.length, 12);
  // What fails comes first, what holds last, what lacks evidence not among it.
  assert.deepEqual(all.slice(0, 5), ["lost-device", "torn", "new-method", "sg-diffuse", "ltc-rectangle"]);
  assert.deepEqual(new Set(all.slice(5, 8)), new Set(["lost-picture", "swapped-picture", "no-picture"]));
  assert.match(await shown.text("#summary .outcome"), /^8 of 12 cases/);

  await shown.press("/");
  await page.keyboard.type("cornell ltc");
  await shown.settle();
  assert.deepEqual(await rows(shown), ["ltc-rectangle"]);
  assert.match(await shown.text("#found"), /^1 of 12 cases/);
  await shown.press("Enter");
  assert.equal(await shown.text("h2"), "ltc-rectanglecornell");
  assert.equal(await page.evaluate(() => document.activeElement.id), "list");
  await shown.click("#clear");
  assert.equal((await rows(shown)).length, 12);
  await page.fill("#search", "no such case");
  await shown.settle();
  assert.equal(await shown.text(".nothing"), "No case is like that.");
  await page.fill("#search", "");

  await page.click("#more summary");
  await shown.settle();
  const filters = [
    ["kind", "plot", ["ggx_distribution"]],
    ["scene", "cornell", ["sg-diffuse", "ltc-rectangle"]],
    ["method", "torn", ["torn"]],
    ["route", "wgsl+naga@lavapipe", ["sg-diffuse", "ggx_distribution"]],
    ["change", "driver", ["ltc-rectangle", "sg-specular"]],
    ["state", "undecided", ["torn", "new-method", "sg-diffuse", "restated"]],
    ["state", "decided", []],
    ["state", "lacking", ["lost-picture", "swapped-picture", "no-picture"]],
  ];
  for (const [name, value, expected] of filters) {
    await page.selectOption(`#filter-${name}`, value);
    await shown.settle();
    assert.deepEqual(await rows(shown), expected, `${name} ${value}`);
    await page.selectOption(`#filter-${name}`, "");
    await shown.settle();
  }
  // A route and a change are of one route.
  await page.selectOption("#filter-route", "native");
  await page.selectOption("#filter-change", "driver");
  await shown.settle();
  assert.deepEqual(await rows(shown), []);
  await shown.click("#clear");

  await shown.click('.chip[data-value="changed"]');
  await shown.click('.chip[data-value="failed"]');
  assert.deepEqual(await rows(shown), ["lost-device", "sg-diffuse"]);
  await shown.click('.chip[data-value="failed"]');
  assert.deepEqual(await rows(shown), ["sg-diffuse"]);
  await shown.click("#clear");
  await shown.click("#lacking");
  assert.equal((await rows(shown)).length, 3);
  await shown.click("#clear");

  for (const [sort, first] of [["listed", "sg-diffuse"], ["name", "ltc-rectangle"], ["share", "sg-diffuse"], ["attention", "lost-device"]]) {
    await page.selectOption("#filter-sort", sort);
    await shown.settle();
    assert.equal((await rows(shown))[0], first, sort);
  }

  const open = () => shown.text("h2");
  await shown.click(".row >> nth=0");
  assert.equal(await open(), "lost-devicespheres");
  await shown.press("j");
  assert.equal(await open(), "tornspheres");
  await shown.press("j", "k", "k", "k");
  assert.equal(await open(), "lost-devicespheres");
  await page.focus("#list");
  await shown.press("End");
  assert.equal(await open(), "ggx_distributionplots");
  await shown.press("ArrowUp");
  assert.equal(await open(), "undefined-edgespheres");
  await shown.press("Home", "ArrowDown", "PageDown", "PageUp", "Home");
  assert.equal(await open(), "lost-devicespheres");
  await shown.press(".");
  assert.equal(await open(), "tornspheres");
  const chosen = page.locator('[role="option"][aria-selected="true"]');
  assert.equal(await chosen.getAttribute("id"), await page.getAttribute("#list", "aria-activedescendant"));
  assert.equal(await chosen.getAttribute("aria-posinset"), "2");

  // The address brings it all back.
  await page.fill("#search", "spheres");
  await page.selectOption("#filter-sort", "name");
  const words = await shown.words();
  assert.equal(words.case, "spheres/torn");
  assert.equal(words["list-search"], "spheres");
  const before = await rows(shown);
  await page.reload();
  await page.waitForSelector(".row");
  await shown.settle();
  assert.deepEqual(await rows(shown), before);
  assert.equal(await page.inputValue("#search"), "spheres");
  assert.equal(await open(), "tornspheres");
  // What an address says wrong is left out.
  await shown.open("#case=spheres%2Ftorn&mode=nonsense&exposure=1e9&zoom=-3&pixel=a,b&layer=%3Cb%3E&cx=NaN");
  assert.equal(await open(), "tornspheres");
  await shown.open("#case=no%2Fsuch");
  assert.match(await shown.status(), /no case of the address/);
  assert.equal(await shown.text("#case-head"), "Choose a case.");
}
