// The head of the page: what the run came to, and what has been decided.

renderers.summary = () => {
  const { report, rows } = run;
  if (!report) return;
  const open = rows.filter((row) => !isFine(row)).length;
  const outcome = open === 0 && rows.length > 0
    ? make("span", { class: "outcome holds" }, "all hold")
    : make("span", { class: "outcome" }, rows.length ? `${open.toLocaleString("en")} of ${count(rows.length, "case")} to look at` : "no cases");
  const lacking = rows.filter((row) => row.is_lacking).length;
  const left = report.skipped?.length ?? 0;
  refill(byId("summary"),
    make("div", { class: "headline" }, make("h1", {}, "Golden images"), outcome, verdictChips(),
      lacking ? button(`${lacking.toLocaleString("en")} lack${lacking === 1 ? "s" : ""} evidence`, { id: "lacking", class: "chip lacking", "aria-pressed": String(filter.state === "lacking"), onclick: () => setFilter({ state: filter.state === "lacking" ? "" : "lacking" }) }) : "",
      make("span", { class: "room" }),
      button(decisions.size ? count(decisions.size, "decision") : "No decisions", { id: "export", class: decisions.size ? "some" : "", title: "Export the decisions", "aria-keyshortcuts": "E", onclick: showExport }, "E"),
      button(left ? `${count(left, "route")} left out` : "This run", { id: "run", title: "What ran, and what did not", onclick: showRun }),
      button("◐", { id: "theme", "aria-label": `Theme: ${theme()}`, title: `Theme: ${theme()} (auto, light, dark)`, onclick: nextTheme }),
      button("?", { id: "help", "aria-label": "Help: keys", title: "Keys", "aria-keyshortcuts": "?", onclick: showHelp })),
    report.interrupted ? make("p", { class: "problems", role: "alert" }, "An acceptance was broken off and has not been completed: run ", make("code", {}, "lobe golden check"), " where it may write.") : "");
};

function verdictChips() {
  const chosen = filter.verdicts.split(" ").filter(Boolean);
  const n = (verdict) => run.rows.filter((row) => row.verdict === verdict).length;
  const toggle = (verdict) => {
    const next = chosen.includes(verdict) ? chosen.filter((one) => one !== verdict) : [...chosen, verdict];
    setFilter({ verdicts: next.join(" ") });
  };
  const chip = (verdict) => {
    const one = button("", { class: `chip ${verdict}`, "data-value": verdict, "aria-pressed": String(chosen.includes(verdict)), onclick: () => toggle(verdict) });
    one.append(make("b", {}, n(verdict).toLocaleString("en")), ` ${VERDICT_WORDS[verdict]}`);
    return one;
  };
  return make("div", { class: "chips", role: "group", "aria-label": "Verdicts" }, VERDICTS.filter((verdict) => n(verdict) > 0 || chosen.includes(verdict)).map(chip));
}

const THEMES = ["auto", "light", "dark"];

function theme() {
  const name = kept.get("theme");
  return THEMES.includes(name) ? name : "auto";
}

function applyTheme() {
  if (theme() === "auto") delete document.documentElement.dataset.theme;
  else document.documentElement.dataset.theme = theme();
}

function nextTheme() {
  kept.set("theme", THEMES[(THEMES.indexOf(theme()) + 1) % THEMES.length]);
  applyTheme();
  say(`Theme: ${theme()}`);
  changed("summary");
}
