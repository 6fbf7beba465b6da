// Everybody can use it: rules of axe-core in every state of the page, light and dark, wide and narrow; and the focus.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

export default async function run(shown) {
  const { page } = shown;
  const rules = readFileSync(shown.require.resolve("axe-core/axe.min.js"), "utf8");
  const found = [];
  const check = async (where) => {
    await page.evaluate(rules);
    const { violations, passes } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"], preload: false }));
    assert.ok(passes.length > 10, "the rules ran");
    for (const { id, nodes } of violations) found.push(`${where}: ${id}: ${nodes.map((node) => `${node.html.slice(0, 160)} ${node.any[0]?.message ?? ""}`).slice(0, 3).join(" | ")}`);
  };
  for (const colorScheme of ["light", "dark"]) {
    for (const width of [1440, 800]) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 900 });
      const where = `${colorScheme}, ${width}`;
      for (const lane of ["image", "numbers", "kernel", "emitted"]) {
        await shown.openCase("cornell/sg-diffuse", { lane, mode: lane === "image" ? "all" : "single", pixel: "64,64" });
        await check(`${where}, ${lane}`);
      }
      await shown.openCase("lacking/lost-picture", { mode: "swipe" });
      await page.click("#more summary");
      await shown.settle();
      await check(`${where}, a case that lacks evidence`);
      for (const [key, name] of [["?", "help"], ["E", "export"]]) {
        await shown.press(key);
        await check(`${where}, ${name}`);
        await shown.press("Escape");
      }
      await shown.openCase("spheres/torn");
      await shown.press("r");
      await check(`${where}, reason`);
      await shown.press("Escape");
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, `${where}: nothing is cut off at the side`);
    }
  }
  assert.deepEqual(found, []);
  await focus(shown);
  await themes(shown);
}

/** Tab reaches every part in the order in which it stands, and what has the focus is seen. */
async function focus(shown) {
  const { page } = shown;
  await page.setViewportSize({ width: 1440, height: 900 });
  await shown.openCase("cornell/ltc-rectangle");
  const reached = [];
  for (let at = 0; at < 60; at++) {
    await page.keyboard.press("Tab");
    const here = await page.evaluate(() => {
      const { activeElement: element } = document;
      const part = element.closest("#summary, #filters, #list, #lanes, #tools, #panes, #case-foot")?.id ?? "";
      return { part, isSeen: getComputedStyle(element).outlineStyle !== "none" || element === document.body };
    });
    assert.ok(here.isSeen, `the focus in ${here.part} is not seen`);
    if (here.part && reached.at(-1) !== here.part) reached.push(here.part);
    if (here.part === "case-foot") break;
  }
  assert.deepEqual(reached, ["summary", "filters", "list", "lanes", "tools", "panes", "case-foot"]);
  // A choice keeps the focus where it was.
  await page.focus('[aria-label="Layer"] [data-value="share"]');
  await shown.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.dataset.value), "share");
  // A dialog gives it back.
  await page.focus("#help");
  await shown.press("Enter");
  assert.equal(await shown.text("dialog h2"), "Keys");
  await shown.press("Escape");
  assert.equal(await page.evaluate(() => document.activeElement.id), "help");
}

async function themes(shown) {
  const { page } = shown;
  await page.emulateMedia({ colorScheme: "light" });
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await ground();
  await shown.click("#theme");
  assert.equal(await ground(), light);
  await shown.click("#theme");
  const dark = await ground();
  assert.notEqual(dark, light);
  await page.reload();
  await page.waitForSelector("#theme");
  assert.equal(await ground(), dark, "the choice is kept");
  await shown.click("#theme");
  assert.equal(await ground(), light);
}
