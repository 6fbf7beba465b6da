// The case that is open: its details, its pictures as they arrive, and what stands against what.

/** Details of cases by index, the last few. */
const opened_cases = new Map();
const MOST_CASES = 6;

/** The case at an index: `{ status, item, pictures, slots, why }`; asked for if it is not there. */
function caseAt(index) {
  let found = opened_cases.get(index);
  if (!found) {
    found = { index, status: "loading", item: null, pictures: {}, doubts: {}, exr: null, slots: new Map(), why: "" };
    opened_cases.set(index, found);
    fillCase(found);
  }
  // The last to be asked for is the last to go.
  opened_cases.delete(index);
  opened_cases.set(index, found);
  for (const key of opened_cases.keys()) {
    if (opened_cases.size <= MOST_CASES) break;
    if (key !== state.item) opened_cases.delete(key);
  }
  return found;
}

async function fillCase(found) {
  try {
    const { item, pictures, doubts, exr } = await load(`${found.index}/item`);
    Object.assign(found, { item, pictures, doubts, exr, status: "here" });
  } catch (error) {
    Object.assign(found, { status: "missing", why: error.message });
  }
  if (found.index === state.item) changed("item", "tools", "panes", "inspector", "pixel");
}

function openCase() {
  return state.item === null ? null : caseAt(state.item);
}

/** A picture of a case by its slot: `{ status: "loading" | "here" | "missing", picture, why }`. */
function slotOf(found, name) {
  if (!found.slots.has(name)) found.slots.set(name, startSlot(found, name));
  return found.slots.get(name);
}

function startSlot(found, name) {
  const why = name in found.pictures ? found.pictures[name] : "there is no such picture";
  if (why !== null) {
    const ready = Promise.reject(new Error(why));
    // The slot says so itself; nobody need wait for it.
    ready.catch(() => {});
    return { status: "missing", why, ready };
  }
  const slot = { status: "loading", why: "" };
  const baseOf = async (base) => (await slotOf(found, base).ready).values;
  slot.ready = loadPicture(`${found.index}/${name}`, baseOf);
  slot.ready.then(
    (picture) => Object.assign(slot, { status: "here", picture }),
    (error) => Object.assign(slot, { status: "missing", why: error.message }),
  ).then(() => {
    if (found.index === state.item) changed("item", "tools", "panes", "inspector", "pixel");
  });
  return slot;
}

/** What a picture may be held against: first that by which the report judged. */
function references(found) {
  return ["fresh", "accepted"].filter((side) => `${side}.truth` in found.pictures);
}

/** What is held against it: the new truth, where there is an accepted one, and all routes. */
function subjects(found) {
  const routes = found.item.routes.map((route, at) => ({ id: route.route, slot: `route.${at}`, flip: `flip.${at}`, route, key: at < 9 ? String(at + 1) : "" }));
  const isTwo = "fresh.truth" in found.pictures && "accepted.truth" in found.pictures;
  return isTwo ? [{ id: "new truth", slot: "fresh.truth", flip: "flip.fresh", route: null, key: "0" }, ...routes] : routes;
}

/** The two that are looked at, with their slots; `null` until the case is there. */
function looked(found) {
  if (!found || found.status !== "here") return null;
  const sides = references(found);
  const all = subjects(found);
  let subject = all.find((subject) => subject.id === state.route) ?? firstSubject(found, all);
  let side = sides.includes(state.against) ? state.against : sides[0];
  if (subject?.slot === "fresh.truth") side = "accepted";
  return { found, side, sides, subjects: all, subject: subject ?? null };
}

/** What asks for a look: a new truth, else the route that is worst off. */
function firstSubject(found, all) {
  if (found.item.verdict === "changed" && all[0]?.slot === "fresh.truth") return all[0];
  const routes = all.filter((subject) => subject.route);
  const rank = ({ route }) => 10 * ["inside", "indeterminate", "failed", "outside"].indexOf(route.verdict);
  const share = ({ route }) => Math.min(number(route.worst?.share ?? 0), 1e300) || 0;
  const isWorse = (a, b) => rank(a) - rank(b) || share(a) - share(b);
  return routes.reduce((worst, one) => (worst && isWorse(one, worst) <= 0 ? worst : one), null) ?? all[0];
}

/** Whether there is a FLIP map of what is looked at: of routes against the truth by which the report judged. */
function hasFlip({ found, subject, side, sides }) {
  return subject !== null && subject.flip in found.pictures && (subject.route === null || side === sides[0]);
}

/** Pictures of what is looked at: `truth`, `permitted`, `found`, `flip`; each a slot. */
function slotsLooked(view) {
  const nothing = { status: "missing", why: "there is no such picture" };
  const slot = (name) => (name ? slotOf(view.found, name) : nothing);
  return {
    truth: slot(view.side && `${view.side}.truth`),
    permitted: slot(view.side && `${view.side}.permitted`),
    found: slot(view.subject?.slot),
    flip: slot(hasFlip(view) ? view.subject.flip : null),
  };
}

/** What is wrong with the evidence of the case that is open, in words; a case with any is never shown as fine. */
function problems(found) {
  if (found.status === "missing") return [`The details cannot be shown: ${found.why}.`];
  if (found.status !== "here") return [];
  const all = [];
  const { item, pictures } = found;
  if (Object.keys(pictures).length === 0) all.push("There is no picture of this case: nothing of it can be seen here.");
  if (item.verdict === "damaged") all.push("The accepted golden cannot be read, so nothing was judged by it.");
  const missing = new Map();
  const note = (name, why) => why && missing.set(why, [...(missing.get(why) ?? []), slotName(item, name)]);
  for (const [name, why] of Object.entries(pictures)) note(name, why ?? found.slots.get(name)?.why);
  for (const [why, names] of missing) all.push(`Not to be seen: ${[...new Set(names)].join(", ")}: ${why}.`);
  for (const route of item.routes) if (route.verdict === "failed") all.push(`${route.route} could not run it: ${route.why || "no reason was given"}.`);
  for (const [name, why] of Object.entries(found.doubts)) all.push(`${slotName(item, name)}: ${why}.`);
  return all;
}

function slotName(item, name) {
  const [what, part] = name.split(".");
  if (what === "route") return item.routes[Number(part)]?.route ?? name;
  if (what === "flip") return "a FLIP map";
  return { accepted: "the accepted golden", fresh: "the new golden" }[what] ?? name;
}
