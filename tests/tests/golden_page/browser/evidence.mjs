// What is not there, or is something else, is said; no case that lacks evidence is shown as fine.

import assert from "node:assert/strict";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";

const mark = (shown) => shown.page.locator('.row[aria-selected="true"] .mark').innerText();

/** The case is open, says `problem`, and neither its head nor its row says that it is fine. */
async function assertLacks(shown, problem, { isListed = true } = {}) {
  assert.match(await shown.text(".problems"), problem);
  assert.match(await shown.text(".title .verdict"), /lacks evidence|missing|damaged|changed|failed/);
  if (isListed) assert.notEqual(await mark(shown), "✓");
}

export default async function run(shown) {
  const { page } = shown;
  await shown.openCase("lacking/lost-picture");
  await assertLacks(shown, /Not to be seen: spirv@lavapipe: nowhere\.exr is not there/);
  assert.match(await page.getAttribute(".pane", "data-why"), /No picture: nowhere\.exr is not there/);
  assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector(".pane"), "::after").content.includes("No picture")), true);
  assert.deepEqual((await shown.texts(".subjects button")).map((text) => text.replace(/\s+/g, " ").replace("?s", "? s")), ["? spirv@lavapipe , no picture 1"]);
  await shown.press("w");
  assert.match(await shown.status(), /no pictures to look in/);
  await shown.openCase("lacking/no-picture");
  await assertLacks(shown, /the report names no file of it/);
  await shown.openCase("lacking/swapped-picture");
  await assertLacks(shown, /not the picture that was judged/);
  await shown.openCase("spheres/torn");
  await assertLacks(shown, /accepted golden cannot be read/);
  await shown.openCase("spheres/lost-device");
  await assertLacks(shown, /could not run it: the device was lost/);
  await shown.openCase("spheres/new-method");
  assert.match(await shown.text(".lamps"), /Nothing is accepted yet/);
  assert.match(await shown.text("#panes"), /spirv@lavapipe/);
  await shown.openCase("spheres/sg-specular");
  assert.equal(await shown.count(".problems"), 0);
  assert.equal(await mark(shown), "✓");

  // Files of the page that were harmed after it was written.
  const item = Number((await page.getAttribute('.row[aria-selected="true"]', "id")).replace("case-", ""));
  const file = (name) => path.join(shown.folder, "page", "data", String(item), `${name}.js`);
  const route = file("route.1");
  const whole = readFileSync(route, "utf8");
  shown.expected.push(/ERR_FILE_NOT_FOUND/, /SyntaxError/);
  const harms = [
    ["cut short", (text) => text.slice(0, text.length / 2), /damaged/],
    ["of another report", (text) => text.replace(/, '[0-9a-f]{16}', /, ", '0000000000000000', "), /belongs to another report/],
    ["fewer bytes", (text) => text.replace(/"packed":"[^"]{400}/, '"packed":"'), /Not to be seen/],
    ["another size", (text) => text.replace("[128,128]", "[64,64]"), /is damaged/],
    ["not there", null, /is not there/],
  ];
  for (const [what, harm, problem] of harms) {
    if (harm) writeFileSync(route, harm(whole));
    else rmSync(route);
    await shown.openCase("spheres/sg-specular", { route: "spirv@lavapipe" });
    await page.waitForSelector(".problems");
    // What is fine in the list was so when the page was written.
    await assertLacks(shown, problem, { isListed: false });
    assert.match(await page.getAttribute(".pane", "data-why"), /^No picture/, what);
    await shown.press("2");
    writeFileSync(route, whole);
  }
  await shown.openCase("spheres/sg-specular");
  assert.equal(await shown.count(".problems"), 0);

  // What cannot be seen cannot be accepted.
  await shown.openCase("cornell/sg-diffuse");
  const changed = Number((await page.getAttribute('.row[aria-selected="true"]', "id")).replace("case-", ""));
  const fresh = path.join(shown.folder, "page", "data", String(changed), "fresh.truth.js");
  const golden = readFileSync(fresh, "utf8");
  rmSync(fresh);
  await shown.openCase("cornell/sg-diffuse");
  await page.waitForSelector(".problems");
  await shown.press("a");
  assert.match(await shown.status(), /cannot be seen here, so it cannot be accepted/);
  assert.equal(await shown.count("dialog"), 0);
  writeFileSync(fresh, golden);

  // A list that is not there.
  const index = path.join(shown.folder, "page", "data", "index.js");
  const list = readFileSync(index, "utf8");
  rmSync(index);
  await page.goto("about:blank");
  await page.goto(`file://${shown.folder}/index.html`);
  await page.waitForSelector(".problems");
  assert.match(await shown.text("#item"), /The list of cases cannot be shown: page\/data\/index\.js is not there/);
  writeFileSync(index, list);
}
