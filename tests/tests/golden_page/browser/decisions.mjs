// Decisions: made by keys and by the pointer, taken back, kept, exported. The file is left in the folder as `decisions.json`.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { copyFileSync, readFileSync } from "node:fs";
import path from "node:path";

const pending = (shown) => shown.text("#export");

async function reason(shown, text) {
  await shown.page.fill("#reason", text);
  await shown.press("Enter");
}

export default async function run(shown) {
  const { page } = shown;
  await shown.openCase("spheres/torn", { "list-sort": "attention" });
  await shown.press("a");
  assert.equal(await shown.text("dialog h2"), "Accept spheres/torn");
  assert.equal(await page.evaluate(() => document.activeElement.id), "reason");
  await shown.press("Enter");
  assert.equal(await shown.text("#reason-note"), "A decision needs a reason.");
  assert.equal(await page.getAttribute("#reason", "aria-invalid"), "true");
  await page.keyboard.type("new picture; jkwru are letters here");
  await shown.press("Escape");
  assert.equal(await shown.count("dialog"), 0);
  assert.match(await pending(shown), /^No decisions/);
  await shown.click("#accept");
  await reason(shown, "written anew after the disk broke");
  // The next one that waits is open.
  assert.equal(await shown.text("h2"), "new-methodspheres");
  assert.match(await pending(shown), /^1 decision/);
  assert.match(await shown.text(".row:has-text('torn')"), /accepted/);

  await shown.press("r");
  assert.equal(await shown.text("dialog h2"), "Reject spheres/new-method");
  await page.fill("#reason", "the light leaks");
  await shown.click("#reason-take");
  assert.equal(await shown.text("h2"), "sg-diffusecornell");
  await shown.press("a");
  assert.equal(await page.inputValue("#reason"), "written anew after the disk broke", "the last reason is at hand");
  await shown.click("#reason-cancel");
  await shown.press("a");
  await reason(shown, "the lobe is normalised now <b>\"really\"</b>");
  assert.match(await pending(shown), /^3 decisions/);

  await shown.press("u");
  assert.match(await pending(shown), /^2 decisions/);
  assert.equal(await shown.text("h2"), "sg-diffusecornell", "what was taken back is open");
  await shown.press("a");
  await reason(shown, "the lobe is normalised now <b>\"really\"</b>");
  await shown.openCase("spheres/new-method");
  assert.match(await shown.text("#case-foot"), /rejected\s*the light leaks/);
  await shown.click("#takeaway");
  assert.match(await pending(shown), /^2 decisions/);
  await shown.press("u");
  assert.match(await pending(shown), /^3 decisions/);

  // What there is nothing to decide of.
  for (const [name, why] of [["spheres/sg-specular", /holds/], ["cornell/ltc-rectangle", /mend the route/], ["spheres/lost-device", /no new golden/]]) {
    await shown.openCase(name);
    await shown.press("a");
    assert.match(await shown.status(), why);
    await shown.press("r");
    assert.match(await shown.status(), why);
    assert.equal(await shown.count("dialog"), 0);
    assert.equal(await page.getAttribute("#accept", "aria-disabled"), "true");
  }
  // What is restated may be accepted, since its truth can be seen.
  await shown.openCase("spheres/restated");
  assert.equal(await page.getAttribute("#accept", "aria-disabled"), "false");

  // They are kept.
  await page.reload();
  await page.waitForSelector("#export");
  assert.match(await pending(shown), /^3 decisions/);
  for (const [state, found] of [["decided", ["torn", "new-method", "sg-diffuse"]], ["undecided", ["restated"]]]) {
    await shown.open(`#list-state=${state}`);
    assert.deepEqual(await shown.texts(".row .name b"), found, state);
  }
  await exported(shown);
  await dropped(shown);
}

async function exported(shown) {
  const { page } = shown;
  await shown.press("E");
  await shown.click("#download");
  assert.match(await shown.text("#export-note"), /Say who decided/);
  await page.fill("#by", "Ada \"A\" L.");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#download")]);
  assert.equal(download.suggestedFilename(), "golden-decisions.json");
  const file = path.join(shown.folder, "decisions.json");
  copyFileSync(await download.path(), file);
  const text = readFileSync(file, "utf8");
  assert.equal(await page.evaluate(() => document.getElementById("export-text").textContent), text);
  const { items } = JSON.parse(readFileSync(path.join(shown.folder, "report.json"), "utf8"));
  const chain = (method) => items.find((item) => item.method === method).chain.hash;
  const exr = (scene, method) => createHash("sha256").update(readFileSync(path.join(shown.folder, scene, method, "fresh.exr"))).digest("hex");
  const one = (scene, method, action, reason) => ({ scene, method, action, reason, chain: chain(method), exr: exr(scene, method) });
  assert.deepEqual(JSON.parse(text), {
    schema: 1, by: "Ada \"A\" L.",
    decisions: [
      one("cornell", "sg-diffuse", "accept", "the lobe is normalised now <b>\"really\"</b>"),
      one("spheres", "new-method", "reject", "the light leaks"),
      one("spheres", "torn", "accept", "written anew after the disk broke"),
    ],
  });
  await shown.click("#copy");
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), text);
  await shown.click("dialog .close");
  assert.equal(await shown.count("dialog"), 0);
  await shown.click("#export");
  assert.equal(await page.inputValue("#by"), "Ada \"A\" L.");
  await shown.click("#forget");
  assert.match(await pending(shown), /^No decisions/);
  await shown.press("u", "u", "u");
  assert.match(await pending(shown), /^3 decisions/);
}

/** A decision on a golden that is another by now is not taken for one on this. */
async function dropped(shown) {
  const { page } = shown;
  await page.evaluate(() => {
    const key = Object.keys(localStorage).find((key) => key.includes("decisions"));
    const all = JSON.parse(localStorage[key]);
    all.find(([name]) => name === "spheres/torn")[1].chain = "0".repeat(64);
    localStorage[key] = JSON.stringify(all);
  });
  await page.reload();
  await page.waitForSelector("#export");
  await shown.settle();
  assert.match(await pending(shown), /^2 decisions/);
  assert.match(await shown.status(), /1 decision of an earlier visit dropped/);
  await shown.press("E");
  assert.match(await shown.text("dialog"), /Dropped, since the goldens are others by now: spheres\/torn/);
}
