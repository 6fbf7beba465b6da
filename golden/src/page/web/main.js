// The start: the list is loaded, then what the address names is opened.

async function start() {
  applyTheme();
  document.addEventListener("keydown", keyDown);
  window.addEventListener("hashchange", takeAddress);
  listen();
  try {
    const { report, route_names, rows } = await load("index");
    Object.assign(run, { report, routes: route_names, rows });
  } catch (error) {
    byId("item").replaceChildren(make("p", { class: "problems", role: "alert" }, `The list of cases cannot be shown: ${error.message}.`));
    return;
  }
  for (const row of run.rows) {
    row.text = [row.scene, row.method, row.kind, VERDICT_WORDS[row.verdict], ...row.routes.map(([at]) => run.routes[at])].join(" ").toLowerCase();
  }
  readDecisions();
  takeAddress();
}

/** Shows what the address names; the first case, if it names none. */
function takeAddress() {
  const { isNamed, isFound } = readAddress();
  refilter();
  if (!isNamed && shownRows.length) state.item = shownRows[0];
  if (isNamed && !isFound) say("The report has no case of the address.");
  isPinned = state.pixel !== null;
  if (state.item !== null) reveal(state.item);
  changed("summary", "filters", "list", "item", "tools", "panes", "inspector", "pixel");
}

start();
