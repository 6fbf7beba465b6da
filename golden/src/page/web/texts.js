// The lanes of texts: what the picture depends on, and how kernels and emitted texts differ from those of the acceptance.

/** Names of targets as people write them. */
const TARGETS = { wgsl: "WGSL", "spir-v": "SPIR-V", spirv: "SPIR-V", hlsl: "HLSL", glsl: "GLSL", msl: "MSL" };
const isKernelText = (text) => text.target === "kernel";

function kernelLane(found) {
  const { item } = found;
  const texts = (item.texts ?? []).filter(isKernelText);
  return [chainTable(item), make("h3", {}, "Kernel sources"), ...diffsOf(texts, "The report has no sources of kernels.")];
}

/** The hashes that the picture depends on, now and when it was accepted. */
function chainTable(item) {
  const before = item.accepted?.chain;
  const line = (what, now, then, note) => {
    const verdict = !before ? "nothing accepted" : now === then ? "same" : then === undefined ? "new" : now === undefined ? "gone" : "changed";
    return make("tr", { class: verdict }, make("th", { scope: "row" }, what, note ? make("small", {}, note) : ""), make("td", {}, short(then)), make("td", {}, short(now)), make("td", { class: "verdict" }, verdict));
  };
  const names = [...new Set([...item.chain.kernels, ...(before?.kernels ?? [])].map((kernel) => kernel.name))];
  const module = (chain, name) => chain?.kernels.find((kernel) => kernel.name === name);
  const kernels = names.map((name) => {
    const [now, then] = [module(item.chain, name), module(before, name)];
    return line(name, now?.module, then?.module, (now ?? then).is_judged ? "" : "not judged");
  });
  const scene = item.chain.scene ?? before?.scene ? [line("scene", item.chain.scene ?? undefined, before?.scene ?? undefined)] : [];
  return make("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "What the picture depends on" },
    make("table", { class: "plain" },
      make("caption", {}, "What the picture depends on"),
      make("thead", {}, make("tr", {}, ...["part", "accepted", "now", "verdict"].map((text) => make("th", { scope: "col" }, text)))),
      make("tbody", {}, ...scene, line("settings", item.chain.settings, before?.settings), ...kernels, line("all", item.chain.hash, before?.hash))));
}

function short(hash) {
  return hash ? make("code", { title: hash }, hash.slice(0, 12)) : "–";
}

function emittedLane(found) {
  const { item } = found;
  const texts = (item.texts ?? []).filter((text) => !isKernelText(text));
  return [emittedTable(item), make("h3", {}, "Emitted texts"), ...diffsOf(texts, "The report has no emitted texts.")];
}

/** Which routes were given another text than when the golden was accepted. */
function emittedTable(item) {
  const rows = item.routes.map((route) => {
    const before = item.accepted?.routes.find((known) => known.route === route.route);
    const verdict = !before ? "nothing accepted" : before.emitted === route.emitted ? "same" : "changed";
    const driver = before && before.driver !== route.driver ? make("small", {}, `was ${before.driver || "without a driver"}`) : "";
    return make("tr", { class: verdict }, make("th", { scope: "row" }, route.route), make("td", {}, short(before?.emitted)), make("td", {}, short(route.emitted)),
      make("td", { class: "verdict" }, verdict), make("td", { class: "text" }, route.driver, driver));
  });
  return make("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Hashes of emitted texts" },
    make("table", { class: "plain" }, make("caption", {}, "What each route was given"),
      make("thead", {}, make("tr", {}, ...["route", "accepted", "now", "verdict", "driver"].map((text) => make("th", { scope: "col", class: text === "driver" ? "text" : undefined }, text)))),
      make("tbody", {}, ...rows)));
}

let chosenTarget = "";

function diffsOf(texts, nothing) {
  if (texts.length === 0) return [make("p", { class: "dim" }, nothing)];
  const targets = [...new Set(texts.map((text) => text.target))];
  const target = targets.includes(chosenTarget) ? chosenTarget : targets[0];
  const pick = (value) => {
    chosenTarget = value;
    changed("item");
  };
  const tabs = targets.length > 1 ? segments("Target", targets.map((name) => [name, TARGETS[name.toLowerCase()] ?? name, "", ""]), target, pick) : "";
  return [tabs, ...texts.filter((text) => text.target === target).map(textDiff)];
}

function textDiff({ kernel, before, after }) {
  const head = make("h4", {}, kernel);
  const whole = (text, note) => make("div", { class: "diff" }, head, make("p", { class: "dim" }, note), diffTable(lineDiff(text, text), false));
  if (before === null || before === undefined) return whole(after ?? "", "No text was kept when the golden was accepted. This is the one of now:");
  if (after === null || after === undefined) return whole(before, "There is no text any more. This is the accepted one:");
  if (before === after) return make("div", { class: "diff" }, head, make("p", { class: "dim" }, "The same text."));
  const lines = lineDiff(before, after);
  const n = (kind) => lines.filter((line) => line.kind === kind).length;
  head.append(make("small", { class: "added" }, `+${n("+")}`), make("small", { class: "gone" }, `−${n("-")}`));
  return make("div", { class: "diff" }, head, diffTable(lines, true));
}

function diffTable(lines, isFolded) {
  const parts = isFolded ? hunks(lines) : [{ isShown: true, lines }];
  return make("div", { class: "scroll code", tabindex: 0, role: "region", "aria-label": "Text" },
    make("table", {}, ...parts.map((part) => (part.isShown ? make("tbody", {}, ...rowsOf(part.lines)) : folded(part.lines)))));
}

/** Lines that are the same in both, which a button shows. */
function folded(lines) {
  const body = make("tbody", {});
  const show = () => body.replaceChildren(...rowsOf(lines));
  body.append(make("tr", { class: "fold" }, make("td", { colspan: 4 }, button(`${count(lines.length, "line")} that ${lines.length === 1 ? "is" : "are"} the same`, { onclick: show }))));
  return body;
}

function rowsOf(lines) {
  return lines.map((line, at) => {
    // A line that takes another's place is marked where it differs.
    const twin = line.kind === "-" && lines[at - 1]?.kind !== "-" && lines[at + 1]?.kind === "+" && lines[at + 2]?.kind !== "+" ? lines[at + 1]
      : line.kind === "+" && lines[at - 1]?.kind === "-" && lines[at - 2]?.kind !== "-" && lines[at + 1]?.kind !== "+" ? lines[at - 1] : null;
    const [head, middle, tail] = twin ? marked(line.text, twin.text) : [line.text, "", ""];
    const text = middle === "" ? [line.text] : [head, make("mark", {}, middle), tail];
    return make("tr", { class: { "+": "added", "-": "gone", " ": "" }[line.kind] },
      make("td", { class: "at" }, line.before ?? ""), make("td", { class: "at" }, line.after ?? ""),
      make("td", { class: "sign" }, { "+": "+", "-": "−", " ": "" }[line.kind]), make("td", { class: "line" }, text));
  });
}
