// The difference of two texts gives both back, and is the shortest there is. No browser is asked.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

const source = readFileSync(new URL("../../../../golden/src/page/web/lines.js", import.meta.url), "utf8");
const { lineDiff, hunks, marked } = new Function(`${source}; return { lineDiff, hunks, marked };`)();

/** A generator of numbers, 0 up to n. */
function generator(seed) {
  let state = seed;
  return (n) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * n);
  };
}

/** The length of the longest common subsequence. */
function common(a, b) {
  let row = new Array(b.length + 1).fill(0);
  for (const x of a) {
    const next = [0];
    b.forEach((y, at) => next.push(x === y ? row[at] + 1 : Math.max(next[at], row[at + 1])));
    row = next;
  }
  return row.at(-1);
}

export default async function run() {
  const seed = Number(process.env.LOBE_SEED ?? Math.floor(Math.random() * 2 ** 32));
  console.log(`seed ${seed} (LOBE_SEED)`);
  const random = generator(seed);
  for (let round = 0; round < 3000; round++) {
    const lines = () => Array.from({ length: random(14) }, () => "abcd"[random(4)].repeat(random(2)) + random(3));
    const [a, b] = [lines(), lines()];
    const diff = lineDiff(a.join("\n"), b.join("\n"));
    const of = (left) => diff.filter((line) => line.kind !== left).map((line) => line.text);
    const texts = (all) => (all.join("\n") === "" ? [] : all.join("\n").replace(/\n$/, "").split("\n"));
    assert.deepEqual(of("+"), texts(a), `seed ${seed}, round ${round}`);
    assert.deepEqual(of("-"), texts(b), `seed ${seed}, round ${round}`);
    const same = diff.filter((line) => line.kind === " ").length;
    assert.equal(same, common(texts(a), texts(b)), `seed ${seed}, round ${round}`);
    assert.deepEqual(diff.filter((line) => line.before !== null).map((line) => line.before), texts(a).map((_, at) => at + 1));
    assert.equal(hunks(diff).flatMap((part) => part.lines).length, diff.length);
    const [left, right] = [lines().join(""), lines().join("")];
    assert.equal(marked(left, right).join(""), left);
  }
  // Texts of which nothing is the same are not searched to the end.
  const far = (letter) => Array.from({ length: 5000 }, (_, at) => letter + at).join("\n");
  assert.equal(lineDiff(far("a"), far("b")).length, 10000);
}
