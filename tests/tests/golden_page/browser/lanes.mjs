// The lanes of numbers and texts, and the classification.

import assert from "node:assert/strict";

export default async function run(shown) {
  const { page } = shown;
  await shown.openCase("cornell/sg-diffuse");
  const lamps = await shown.texts(".lamps li");
  assert.deepEqual(lamps.map((text) => text.replace(/^[●○]\s*/, "")), ["Mathematics changed on 4 routes", "Emission same", "Driver same"]);
  assert.match(await shown.text(".lamps p"), /true values differ, by up to 51,234 ULP; [\d,]+ by more than a driver may\. Accepted by Ada, 2026-11-01/);

  const lane = () => page.locator('[role="tab"][aria-selected="true"]').innerText();
  assert.equal(await lane(), "Image");
  await shown.press("l");
  assert.equal(await lane(), "Numbers");
  assert.deepEqual(await shown.texts(".numbers tbody th b, .numbers tbody th"), ["native", "spirv@lavapipe\nllvmpipe, Mesa 25.0.7, LLVM 19, 256 bits", "wgsl+naga@lavapipe\nllvmpipe, Mesa 25.0.7, LLVM 19, 256 bits", "hlsl+dxc@swiftshader\nSwiftShader 5.0.0"]);
  const cells = await shown.texts(".numbers tbody tr >> nth=1 >> td");
  assert.deepEqual(cells.slice(0, 3), ["inside", "mathematics", "16,384"]);
  assert.deepEqual(cells.slice(-4), ["1", "3.1e-7", "0.0125", "0.0125"]);
  assert.deepEqual(await shown.texts("#lane .scroll >> nth=1 >> thead th"), ["route", "white furnace", "reciprocity", "energy", "rotation"]);
  const law = await shown.texts("#lane .scroll >> nth=1 >> tbody tr >> nth=0 >> td");
  assert.deepEqual(law.map((text) => text.replace(/\s+/g, " ")), ["✓0.0021 of 0.005", "✓3.1e-7 of 1e-6", "✓0 of 1e-6", "✗2.4e-6 of 1e-6"]);

  await shown.press("l");
  assert.equal((await lane()).trim(), "Kernel");
  assert.equal((await shown.words()).lane, "kernel");
  const verdicts = await shown.texts("#lane .plain .verdict");
  assert.deepEqual(verdicts, ["same", "same", "changed", "same", "changed"]);
  assert.deepEqual(await shown.texts(".code .gone .line"), ["    let k = 0.5;", "    return k * max(a, 0.0);"]);
  assert.deepEqual(await shown.texts(".code .added mark"), ["1", " + 0.01"]);
  assert.deepEqual(await shown.texts(".code tbody tr >> nth=1 >> .at"), ["2", ""]);

  await shown.click("#lane-emitted");
  assert.deepEqual(await shown.texts('[aria-label="Target"] button'), ["WGSL", "HLSL", "SPIR-V"]);
  await shown.click('[aria-label="Target"] [data-value="HLSL"]');
  assert.equal(await shown.text(".diff p"), "The same text.");
  await shown.click('[aria-label="Target"] [data-value="SPIR-V"]');
  assert.deepEqual(await shown.texts(".code .fold"), ["87 lines that are the same", "106 lines that are the same"]);
  assert.equal(await shown.count(".code .line"), 8);
  await shown.click(".code .fold button >> nth=0");
  assert.equal(await shown.count(".code .line"), 95);

  // Tabs by arrows, as tabs are.
  await page.focus("#lane-emitted");
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => document.activeElement?.id === "lane-image");
  await shown.press("L");
  assert.equal(await lane(), "Emitted text");

  // What is long is folded, and stays open from case to case.
  await shown.openCase("spheres/sg-specular");
  assert.equal(await page.locator("#details dl").isVisible(), false);
  await shown.click("#details summary");
  assert.match(await shown.text("#details dl"), /samples\s*64\s*proof\s*the scene, the settings/);
  await shown.press("j");
  assert.equal(await page.locator("#details dl").isVisible(), true);

  // Another route's emitted text, and another driver.
  await shown.openCase("spheres/undefined-edge", { lane: "emitted" });
  assert.deepEqual(await shown.texts("#lane .plain .verdict"), ["changed"]);
  assert.match((await shown.texts(".lamps li"))[1], /Emission changed on 1 route$/);
  assert.match(await shown.text("#lane"), /no emitted texts/);
  await shown.openCase("spheres/sg-specular", { lane: "numbers" });
  assert.match((await shown.texts(".lamps li"))[2], /Driver changed on 1 route$/);
  assert.match(await shown.text("#lane"), /no residuals of this method/);
}
