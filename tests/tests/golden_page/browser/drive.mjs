// Shows the page in a folder to a scenario: `drive.mjs SCENARIO FOLDER NODE_MODULES BROWSER`.
//
// Every scenario fails if the page asks for anything outside its folder, or says an error that the scenario does not expect.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import path from "node:path";

const [, , scenario, folder, modules, program] = process.argv;
const require = createRequire(path.join(modules, "/"));
const { chromium } = require("playwright-core");
const base = pathToFileURL(path.join(folder, "/")).href;

/** A page and what a scenario does with it. */
class Shown {
  constructor(page) {
    this.page = page;
    this.folder = folder;
    this.require = require;
    /** Errors that are part of the scenario: all that match are left out. */
    this.expected = [];
    this.said = [];
    this.asked = [];
    page.on("console", (message) => message.type() === "error" && this.said.push(message.text()));
    page.on("pageerror", (error) => this.said.push(error.stack || String(error)));
    page.on("request", (request) => this.asked.push(request.url()));
  }

  /** Opens the page anew at an address. */
  async open(hash = "") {
    await this.page.goto("about:blank");
    await this.page.goto(`${base}index.html${hash}`);
    await this.page.waitForFunction(() => document.querySelector("#summary .outcome"));
    await this.settle();
  }

  /** Opens a case, all of whose pictures are then there. */
  async openCase(name, more = {}) {
    await this.open(`#${new URLSearchParams({ case: name, ...more })}`);
  }

  /** Until nothing is loading, and what was to be drawn is drawn. */
  async settle() {
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));
    await this.page.waitForFunction(() => !document.querySelector('[data-why="Loading"]') && !document.querySelector("#case-head > .dim")?.textContent.startsWith("Loading"));
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  async press(...keys) {
    for (const key of keys) {
      await this.page.keyboard.press(key);
      await this.settle();
    }
  }

  async click(selector) {
    await this.page.click(selector);
    await this.settle();
  }

  text(selector) {
    return this.page.locator(selector).first().innerText();
  }

  texts(selector) {
    return this.page.locator(selector).allInnerTexts();
  }

  count(selector) {
    return this.page.locator(selector).count();
  }

  /** The colour that a pane shows at a place of the picture: `[r, g, b]`. */
  colour(pane, x, y) {
    return this.page.evaluate(([pane, x, y]) => {
      const canvas = document.querySelectorAll("#panes canvas")[pane];
      const place = JSON.parse(canvas.dataset.place);
      const at = (from, n) => Math.floor(from + (n + 0.5) * place.scale);
      return [...canvas.getContext("2d").getImageData(at(place.x, x), at(place.y, y), 1, 1).data.slice(0, 3)];
    }, [pane, x, y]);
  }

  /** The position of a place of the picture on the screen. */
  screen(pane, x, y) {
    return this.page.evaluate(([pane, x, y]) => {
      const canvas = document.querySelectorAll("#panes canvas")[pane];
      const place = JSON.parse(canvas.dataset.place);
      const box = canvas.getBoundingClientRect();
      const on = (from, n) => (from + (n + 0.5) * place.scale) / devicePixelRatio;
      return { x: box.left + on(place.x, x), y: box.top + on(place.y, y), scale: place.scale };
    }, [pane, x, y]);
  }

  /** Words of the address, once it is written. */
  async words() {
    await this.page.waitForTimeout(300);
    return Object.fromEntries(new URLSearchParams(new URL(this.page.url()).hash.slice(1)));
  }

  /** The status line's text. */
  status() {
    return this.text("#status");
  }
}

const browser = await chromium.launch({ executablePath: program, args: ["--no-sandbox", "--disable-gpu"] });
let failure = null;
try {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, acceptDownloads: true, permissions: ["clipboard-read", "clipboard-write"] });
  const shown = new Shown(await context.newPage());
  shown.context = context;
  const { default: run } = await import(`./${scenario}.mjs`);
  await run(shown);
  const outside = shown.asked.filter((url) => !url.startsWith(base) && !/^(about|blob|data):/.test(url));
  assert.deepEqual(outside, [], "the page asked for something outside its folder");
  const said = shown.said.filter((text) => !shown.expected.some((expected) => expected.test(text)));
  assert.deepEqual(said, [], "the page said errors");
} catch (error) {
  failure = error;
} finally {
  await browser.close();
}
if (failure) {
  console.error(failure.stack ?? failure);
  process.exit(1);
}
