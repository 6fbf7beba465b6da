// Decisions: made here, kept by the browser, exported as the file that `lobe golden apply` carries out.

/** By case: `{ action, reason, chain, exr }`. */
const decisions = new Map();
/** What each decision replaced, the last one last. */
const undone = [];
/** Decisions of an earlier visit that were on goldens which are others by now. */
let stale = [];

/** Whether a case has a new golden that waits to be decided on. */
function isPending(row) {
  return row.is_pending;
}

function keepName() {
  return `decisions ${run.report.golden} ${location.pathname}`;
}

function keepDecisions() {
  kept.set(keepName(), JSON.stringify([...decisions]));
}

/** Takes up the decisions of an earlier visit, but for those on what is another golden by now. */
function readDecisions() {
  let all = [];
  try {
    all = JSON.parse(kept.get(keepName()) ?? "[]");
  } catch {
    say("Decisions of an earlier visit cannot be read.");
  }
  const rows = new Map(run.rows.map((row) => [nameOf(row), row]));
  for (const [name, decision] of Array.isArray(all) ? all : []) {
    const row = rows.get(name);
    const isSame = row && isPending(row) && row.chain === decision?.chain && ["accept", "reject"].includes(decision.action);
    if (isSame) decisions.set(name, decision);
    else stale.push(String(name));
  }
  if (stale.length) say(`${count(stale.length, "decision")} of an earlier visit dropped: the goldens are others by now.`);
}

/** Why the case that is open cannot be accepted, or rejected; empty if it can. */
function whyNot(action) {
  const row = openRow();
  const found = openCase();
  if (!row) return "No case is open.";
  if (!isPending(row)) return { holds: "The golden holds: there is nothing to decide.", falls_short: "It falls short of the golden, whose truth is the same: mend the route.", failed: "It could not be rendered: there is no new golden." }[row.verdict] ?? "There is nothing to decide.";
  if (found.status !== "here") return "Its details are not there.";
  if (action === "reject") return "";
  const names = row.verdict === "restated" ? ["fresh.truth", "accepted.truth"] : ["fresh.truth"];
  const slots = names.filter((name) => name in found.pictures).map((name) => slotOf(found, name));
  if (slots.some((slot) => slot.status === "here")) return "";
  return slots.some((slot) => slot.status === "loading") ? "The new golden is being loaded." : "The new golden cannot be seen here, so it cannot be accepted here.";
}

async function decide(action) {
  const why = whyNot(action);
  if (why) return say(why);
  const row = openRow();
  const reason = await askReason(action, row);
  if (!reason) return;
  const { exr } = openCase();
  record(nameOf(row), { action, reason, chain: row.chain, ...(exr ? { exr } : {}) });
  say(`${action === "accept" ? "Accepted" : "Rejected"}: ${nameOf(row)}`);
  nextUndecided();
}

/** Writes a decision down, or takes it away if it is null. */
function record(name, decision) {
  undone.push([name, decisions.get(name) ?? null]);
  put(name, decision);
}

function put(name, decision) {
  if (decision) decisions.set(name, decision);
  else decisions.delete(name);
  keepDecisions();
  if (filter.state) refilter();
  changed("summary", "filters", "list", "item");
}

/** Takes the last step back, and shows what it was about. */
function undo() {
  const last = undone.pop();
  if (!last) return say("There is nothing to take back.");
  const [name, before] = last;
  put(name, before);
  const at = run.rows.findIndex((row) => nameOf(row) === name);
  if (at >= 0) openItem(at);
  say(`Taken back: ${name}`);
}

/** Opens the next case in the list that waits for a decision. */
function nextUndecided() {
  const from = shownRows.indexOf(state.item);
  const order = [...shownRows.slice(from + 1), ...shownRows.slice(0, Math.max(from, 0))];
  const next = order.find((at) => isPending(run.rows[at]) && !decisions.has(nameOf(run.rows[at])));
  if (next !== undefined) openItem(next);
}

/** The file that `lobe golden apply` reads. */
function decisionFile(by) {
  const order = new Map(run.rows.map((row, at) => [nameOf(row), at]));
  const all = [...decisions].sort(([a], [b]) => order.get(a) - order.get(b));
  const one = ([name, { action, reason, chain, exr }]) => {
    const { scene, method } = run.rows[order.get(name)];
    return { scene, method, action, reason, chain, ...(exr ? { exr } : {}) };
  };
  return `${JSON.stringify({ schema: 1, by, decisions: all.map(one) }, null, 2)}\n`;
}

/** What stands beneath a case: its decision, or what can be decided. */
function decisionBar() {
  const row = openRow();
  const decision = decisions.get(nameOf(row));
  const [noAccept, noReject] = [whyNot("accept"), whyNot("reject")];
  const take = (text, action, key, why) => button(text, {
    id: action, class: action, "aria-disabled": String(Boolean(why)), "aria-keyshortcuts": key, title: why || undefined, onclick: () => decide(action),
  }, key);
  const told = decision
    ? make("span", { class: `decided ${decision.action}` }, decision.action === "accept" ? "accepted" : "rejected", make("small", {}, decision.reason))
    : make("span", { class: "dim" }, noReject || noAccept || "Waits for a decision.");
  const takeAway = decision ? button("Take away", { id: "takeaway", onclick: () => record(nameOf(row), null) }) : "";
  return [take("Accept", "accept", "a", noAccept), take("Reject", "reject", "r", noReject), told, takeAway];
}
