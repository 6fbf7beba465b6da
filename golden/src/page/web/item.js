// A case: what became of it and why, and its four lanes.

const LANES = [["image", "Image"], ["numbers", "Numbers"], ["kernel", "Kernel"], ["emitted", "Emitted text"]];

renderers.item = () => {
  const parent = byId("item");
  const found = openCase();
  if (!byId("case-head")) buildCase(parent);
  const isHere = found?.status === "here";
  parent.classList.toggle("empty", !found);
  refill(byId("case-head"), ...(found ? headOf(found) : [make("p", { class: "nothing" }, run.report ? "Choose a case." : "")]));
  refill(byId("lanes"), ...(isHere ? LANES.map((lane) => laneTab(found, lane)) : []));
  const body = byId("lane");
  const wanted = isHere ? `${state.item} ${state.lane} ${state.lane === "image" ? "" : chosenTarget}` : "";
  if (body.dataset.shows !== wanted) fillLane(body, wanted, found, isHere);
  refill(byId("case-foot"), ...(isHere ? decisionBar() : []));
};

function buildCase(parent) {
  parent.replaceChildren(
    make("div", { id: "case-head" }),
    make("div", { id: "lanes", role: "tablist", "aria-label": "Lanes", onkeydown: laneKey }),
    make("div", { id: "lane", role: "tabpanel", tabindex: -1 }),
    make("footer", { id: "case-foot", "aria-label": "Decision" }));
}

function fillLane(body, wanted, found, isHere) {
  body.dataset.shows = wanted;
  body.dataset.lane = state.lane;
  stopBlinking();
  if (!isHere) return body.replaceChildren();
  body.setAttribute("aria-labelledby", `lane-${state.lane}`);
  if (state.lane === "image") {
    // Between cases the pictures stay where they are.
    if (!byId("panes")) {
      const note = make("p", { id: "panes-note", class: "unseen" }, "Arrow keys move the pixel that the inspector shows; question mark lists all keys.");
      const panes = make("div", { id: "panes", tabindex: 0, role: "group", "aria-label": "Pictures", "aria-describedby": "panes-note" });
      new ResizeObserver(() => changed("panes")).observe(panes);
      body.replaceChildren(make("div", { id: "tools", onclick: backToPictures }), panes, note);
    }
    return changed("tools", "panes");
  }
  const lane = { numbers: numbersLane, kernel: kernelLane, emitted: emittedLane }[state.lane];
  refill(body, ...lane(found));
  body.scrollTop = 0;
}

/** After a click with the pointer, keys are for the pictures again, and the space bar is no second click. */
function backToPictures(event) {
  if (event.detail > 0 && event.target.closest("button")) byId("panes").focus({ preventScroll: true });
}

function laneTab(found, [name, text]) {
  const isChosen = state.lane === name;
  const note = { kernel: isChanged(found, "mathematics"), emitted: isChanged(found, "emission") }[name] ? make("span", { class: "dot", role: "img", "aria-label": "changed" }) : "";
  const tab = button(text, { role: "tab", id: `lane-${name}`, "data-value": name, "aria-selected": String(isChosen), "aria-controls": "lane", tabindex: isChosen ? 0 : -1, onclick: () => set({ lane: name }) });
  tab.append(note);
  return tab;
}

function laneKey(event) {
  const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (!by) return;
  event.preventDefault();
  event.stopPropagation();
  nextLane(by);
  requestAnimationFrame(() => requestAnimationFrame(() => byId(`lane-${state.lane}`)?.focus()));
}

function nextLane(by) {
  const at = LANES.findIndex(([name]) => name === state.lane);
  set({ lane: LANES[(at + by + LANES.length) % LANES.length][0] });
}

function headOf(found) {
  const row = openRow();
  const all = problems(found);
  const { item } = found;
  const about = [row.kind, `${row.size?.[0]} × ${row.size?.[1]}`];
  const isFalselyFine = isPassing(row) && all.length > 0;
  const verdict = isFalselyFine
    ? make("span", { class: "verdict lacking" }, "lacks evidence")
    : make("span", { class: `verdict ${row.verdict}` }, VERDICT_WORDS[row.verdict] ?? row.verdict);
  return [
    make("div", { class: "title" }, make("h2", {}, row.method, make("small", {}, row.scene)), verdict, make("span", { class: "dim about" }, about.join(" · "))),
    item?.why ? make("p", { class: "why" }, item.why) : "",
    found.status === "loading" ? make("p", { class: "dim" }, "Loading") : "",
    all.length ? make("div", { class: "problems", role: "alert" }, make("ul", {}, ...all.map((text) => make("li", {}, text)))) : "",
    ...(item ? [classification(found), moreOf(item)] : []),
  ];
}

let isMoreOpen = false;

/** What is asked for seldom, and long: the settings, and why the truth need not be computed again. */
function moreOf(item) {
  const line = (name, text) => make("div", {}, make("dt", {}, name), make("dd", {}, text));
  const lines = Object.entries(item.settings).map(([name, value]) => line(name, value));
  if (item.proof) lines.push(line("proof", item.proof));
  return make("details", { id: "details", open: isMoreOpen, ontoggle: (event) => (isMoreOpen = event.target.open) },
    make("summary", { id: "details-summary" }, "Settings and proof"), make("dl", { class: "facts" }, ...lines));
}

/** Whether mathematics, emission or the driver is another than when the golden was accepted. */
function isChanged(found, what) {
  const { item } = found;
  if (what === "mathematics" && item.truth?.differing > 0) return true;
  return item.routes.some((route) => route.change === what);
}

function classification(found) {
  const { item } = found;
  if (!item.accepted) {
    const why = item.verdict === "missing" ? "Nothing is accepted yet" : "What was accepted cannot be read";
    return make("p", { class: "lamps lamp" }, `${why}: there is nothing to compare with.`);
  }
  const on = (what) => item.routes.filter((route) => route.change === what).length;
  const lamp = (what, text) => {
    const is = isChanged(found, what);
    const where = on(what) ? ` on ${count(on(what), "route")}` : "";
    return make("li", { class: is ? "lamp on" : "lamp" }, make("span", { class: "sign", "aria-hidden": "true" }, is ? "●" : "○"), `${text} ${is ? `changed${where}` : "same"}`);
  };
  const rest = [["unexplained", "other bits, unexplained"], ["new", "not known before"]].filter(([what]) => on(what) > 0);
  return make("div", { class: "lamps" },
    make("ul", { "aria-label": "What changed" }, lamp("mathematics", "Mathematics"), lamp("emission", "Emission"), lamp("driver", "Driver"),
      ...rest.map(([what, text]) => make("li", { class: "lamp on" }, make("span", { class: "sign", "aria-hidden": "true" }, "●"), `${text} on ${count(on(what), "route")}`))),
    make("p", { class: "dim" }, ofTruth(item)));
}

function ofTruth(item) {
  const { truth, accepted } = item;
  const by = `Accepted by ${accepted.by}, ${accepted.at.slice(0, 10)}: ${accepted.why}`;
  if (!truth) return `${item.proof ? "The truth need not be computed again. " : ""}${by}`;
  if (truth.differing === 0) return `The truth was computed again, and is the accepted one to the bit. ${by}`;
  return `${count(truth.differing, "true value")} differ, by up to ${truth.furthest_ulp.toLocaleString("en")} ULP; ${truth.beyond_permitted.toLocaleString("en")} by more than a driver may. ${by}`;
}
