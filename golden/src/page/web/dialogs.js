// Dialogs: a reason, the export, help, what ran.

/** Shows a dialog; the promise is kept when it is closed, with its `returnValue`. */
function showDialog(title, attributes, ...children) {
  const label = `${attributes.id}-title`;
  const close = button("✕", { class: "close", "aria-label": "Close", title: "Close (Escape)", onclick: () => dialog.close("") });
  const dialog = make("dialog", { ...attributes, "aria-labelledby": label }, make("div", { class: "bar" }, make("h2", { id: label }, title), close), ...children);
  document.body.append(dialog);
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close(""));
  dialog.showModal();
  return new Promise((resolve) => dialog.addEventListener("close", () => {
    const value = dialog.returnValue;
    dialog.remove();
    resolve(value);
  }));
}

function isDialogOpen() {
  return document.querySelector("dialog[open]") !== null;
}

function closeDialog(value) {
  document.querySelector("dialog[open]")?.close(value);
}

const lastReasons = { accept: "", reject: "" };

/** The reason for a decision; empty if it was not taken. */
async function askReason(action, row) {
  if (isDialogOpen()) return "";
  const verb = action === "accept" ? "Accept" : "Reject";
  const input = make("input", { id: "reason", type: "text", autocomplete: "off", maxlength: 500, required: true, "aria-describedby": "reason-note" });
  input.value = lastReasons[action];
  const note = make("p", { id: "reason-note", class: "dim" }, action === "accept"
    ? "Stands beside the golden, for those who ask later why it is as it is."
    : "Stands in the log of decisions. The golden stays as it is.");
  const take = () => {
    if (input.value.trim() === "") {
      note.textContent = "A decision needs a reason.";
      note.classList.add("wrong");
      input.setAttribute("aria-invalid", "true");
      return input.focus();
    }
    closeDialog(input.value.trim());
  };
  input.addEventListener("keydown", (event) => {
    if (event.key !== "Enter") return;
    event.preventDefault();
    take();
  });
  const answer = showDialog(`${verb} ${nameOf(row)}`, { id: "reason-dialog" },
    make("label", { class: "wide" }, "Reason", input), note,
    make("div", { class: "bar end" }, button("Cancel", { id: "reason-cancel", onclick: () => closeDialog("") }), button(verb, { id: "reason-take", class: action, onclick: take })));
  input.focus();
  input.select();
  const reason = await answer;
  if (reason) lastReasons[action] = reason;
  return reason;
}

const FILE_NAME = "golden-decisions.json";

function showExport() {
  if (isDialogOpen()) return;
  const name = make("input", { id: "by", type: "text", autocomplete: "name", maxlength: 200, placeholder: "who decided" });
  name.value = kept.get("by") ?? "";
  const preview = make("pre", { id: "export-text", tabindex: 0, "aria-label": "The file" });
  const note = make("p", { class: "dim", id: "export-note" });
  const fresh = () => (preview.textContent = decisionFile(name.value.trim()));
  name.addEventListener("input", fresh);
  fresh();
  const take = (how) => {
    const by = name.value.trim();
    if (!by) {
      note.textContent = "Say who decided: it stands beside each golden.";
      note.classList.add("wrong");
      return name.focus();
    }
    kept.set("by", by);
    how(decisionFile(by), note);
  };
  const list = [...decisions].map(([name, { action, reason }]) => make("tr", {},
    make("td", { class: "text" }, make("span", { class: `decided ${action}` }, action)), make("th", { scope: "row" }, name), make("td", { class: "text" }, reason)));
  showDialog(`Export ${count(decisions.size, "decision")}`, { id: "export-dialog" },
    decisions.size ? make("div", { class: "scroll few", tabindex: 0, role: "region", "aria-label": "Decisions" }, make("table", { class: "plain" }, make("tbody", {}, ...list))) : make("p", { class: "dim" }, "No decision has been made yet."),
    stale.length ? make("p", { class: "dim" }, `Dropped, since the goldens are others by now: ${stale.join(", ")}.`) : "",
    run.report.pending ? "" : make("p", { class: "dim" }, "This run kept no new goldens: before these decisions can be carried out, run ", make("code", {}, "lobe golden check"), " where they are to be."),
    kept.isKept ? "" : make("p", { class: "wrong" }, "This browser keeps nothing for this page: export before you close it."),
    make("label", { class: "wide" }, "By", name), preview,
    make("p", { class: "dim" }, "Then: ", make("code", {}, `lobe golden apply ${FILE_NAME}`), ". It carries out all of them, or none."), note,
    make("div", { class: "bar end" },
      button("Forget all", { id: "forget", "aria-disabled": String(decisions.size === 0), onclick: forgetAll }),
      button("Copy", { id: "copy", onclick: () => take(copyText) }),
      button("Download", { id: "download", class: "accept", onclick: () => take(download) })));
  name.focus();
}

async function copyText(text, note) {
  try {
    await navigator.clipboard.writeText(text);
    note.textContent = "Copied.";
  } catch {
    getSelection().selectAllChildren(byId("export-text"));
    note.textContent = "The file is selected: press Ctrl C.";
  }
}

function download(text, note) {
  const url = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  make("a", { href: url, download: FILE_NAME }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
  note.textContent = `Downloaded as ${FILE_NAME}. The decisions stay here until you forget them.`;
}

/** Takes all decisions away; each can be taken back. */
function forgetAll() {
  if (decisions.size === 0) return;
  closeDialog("");
  for (const name of [...decisions.keys()]) record(name, null);
  say("All decisions are forgotten; u takes them back one by one.");
}

const HELP = [
  ["Cases", [["j, k", "next, previous case"], ["/", "search"], ["↓ ↑ Page Home End", "move, in the list"], [".", "next case to decide"]]],
  ["Pictures", [["1 … 9", "a route"], ["p, P", "next, previous route"], ["0", "the new truth"], ["space", "flip between truth and found"], ["d", "difference, by sign"], ["h", "share of the bound"], ["f", "FLIP map"],
    ["v", "side by side"], ["g", "all at once"], ["s", "swipe"], ["b", "blink"], ["o", "onion"], ["x", "against the other truth"]]],
  ["Look", [["+ −", "exposure; gain of a difference"], ["e", "exposure back to 0"], ["t", "next tone map"], ["c", "next channel"], ["[ ]", "zoom out, in"], ["z", "fit"],
    ["arrows", "move the pixel, with Shift by 10"], ["w", "worst pixel"], ["n, N", "next worst, the one before"]]],
  ["Lanes", [["l, L", "next, previous lane"]]],
  ["Decisions", [["a", "accept, with a reason"], ["r", "reject, with a reason"], ["u", "take the last step back"], ["E", "export"]]],
  ["Page", [["?", "this help"], ["Escape", "close; let go of a pixel"]]],
];

function showHelp() {
  if (isDialogOpen()) return;
  const part = ([title, keys]) => make("section", {}, make("h3", {}, title),
    make("dl", {}, ...keys.map(([key, text]) => make("div", {}, make("dt", {}, make("kbd", {}, key)), make("dd", {}, text)))));
  showDialog("Keys", { id: "help-dialog" }, make("div", { class: "columns" }, ...HELP.map(part)),
    make("p", { class: "dim" }, "Drag to pan, turn the wheel to zoom, click to hold a pixel. The address holds what is looked at."));
}

/** What ran, and what did not. */
function showRun() {
  if (isDialogOpen()) return;
  const { report } = run;
  const line = (name, text) => make("div", {}, make("dt", {}, name), make("dd", {}, text));
  const table = (caption, rows) => (rows.length ? make("div", { class: "scroll few", tabindex: 0, role: "region", "aria-label": caption }, make("table", { class: "plain" }, make("caption", {}, caption), make("tbody", {}, ...rows))) : "");
  const row = (...cells) => make("tr", {}, make("th", { scope: "row" }, cells[0]), ...cells.slice(1).map((text) => make("td", { class: "text" }, text)));
  showDialog("This run", { id: "run-dialog" },
    make("dl", { class: "facts" }, line("Lobe", report.lobe ?? ""), line("environment", report.environment ?? ""), line("golden images", `${report.golden ?? ""}, ${(Number(report.bytes ?? 0) / 1e6).toFixed(1)} MB`), line("new goldens", report.pending ?? "none were written")),
    table("Routes", (report.routes ?? []).map(({ route, driver }) => row(route, driver || "no driver"))),
    table("Left out on this machine", (report.skipped ?? []).map(({ route, what, mend }) => row(route, what, mend))),
    table("Goldens of no case", (report.dead ?? []).map((name) => row(name))));
}
