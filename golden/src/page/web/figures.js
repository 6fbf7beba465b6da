// The lane of numbers: what the report says of each route, and the physics of the method.

function numbersLane(found) {
  return [routesTable(found.item), ...physicsPanel(found.item)];
}

const PIXELS = ["inside", "outside", "indeterminate", "equal"];

function routesTable(item) {
  const heads = ["route", "verdict", "change", ...["inside", "outside", "no bound", "equal"], "worst share", "at", "half", "99 %", "99.9 %", "all", "mean ratio", "rel. RMSE", "FLIP HDR", "FLIP LDR"];
  const rows = item.routes.map((route) => {
    const pixels = item.size[0] * item.size[1];
    const { worst, metrics } = route;
    const cells = [
      ...PIXELS.map((name) => [route.pixels[name].toLocaleString("en"), percent(route.pixels[name], pixels)]),
      [worst ? brief(number(worst.share)) : "–"], [worst ? `${worst.x}, ${worst.y} ${worst.channel}` : "–"],
      ...route.shares.map((share) => [brief(number(share))]),
      [brief(number(metrics?.mean_ratio ?? null))], [brief(number(metrics?.relative_rmse ?? null))],
      [brief(metrics?.flip_hdr.mean)], [brief(metrics?.flip_ldr.mean)],
    ];
    return make("tr", {},
      make("th", { scope: "row" }, route.route, make("small", {}, route.driver)),
      make("td", { class: "text" }, make("span", { class: `verdict ${route.verdict}` }, route.verdict), route.why ? make("small", {}, route.why) : ""),
      make("td", { class: `text change-${route.change}` }, route.change),
      ...cells.map(([text, title]) => make("td", { title }, text)));
  });
  return make("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Numbers of each route" },
    make("table", { class: "plain numbers" }, make("caption", {}, "Each route against what is permitted"),
      make("thead", {}, make("tr", {}, ...heads.map((text, at) => make("th", { scope: "col", class: at < 3 ? "text" : undefined }, text)))),
      make("tbody", {}, ...rows)));
}

/** Laws that the method must keep: how far each route is off, and what is permitted. */
function physicsPanel(item) {
  const all = item.physics ?? [];
  const head = make("h3", {}, "Physics of the method");
  if (all.length === 0) return [head, make("p", { class: "dim" }, "The report has no residuals of this method (white furnace, reciprocity, energy, rotation).")];
  const names = [...new Set(all.map((one) => one.name))];
  const routes = [...new Set(all.map((one) => one.route))];
  const cell = (route, name) => {
    const one = all.find((one) => one.route === route && one.name === name);
    if (!one) return make("td", { class: "dim" }, "–");
    const [residual, permitted] = [number(one.residual), number(one.permitted)];
    // Written so that NaN is outside.
    const isKept = permitted === Infinity || Math.abs(residual) <= permitted;
    const kind = permitted === Infinity ? "indeterminate" : isKept ? "inside" : "outside";
    return make("td", { class: kind }, make("span", { class: `verdict ${kind}` }, { inside: "✓", outside: "✗", indeterminate: "◌" }[kind]), brief(residual), make("small", {}, `of ${brief(permitted)}`));
  };
  const rows = routes.map((route) => make("tr", {}, make("th", { scope: "row" }, route), ...names.map((name) => cell(route, name))));
  return [head, make("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": "Physics of the method" },
    make("table", { class: "plain" }, make("thead", {}, make("tr", {}, make("th", { scope: "col" }, "route"), ...names.map((name) => make("th", { scope: "col" }, name.replaceAll("_", " "))))),
      make("tbody", {}, ...rows)))];
}
