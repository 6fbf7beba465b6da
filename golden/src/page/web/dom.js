// Elements. Text goes in as text only, so nothing that a report says can become markup.

/** The element of the page's frame with this id. */
function byId(id) {
  return document.getElementById(id);
}

/** An element with attributes and children; strings become text. */
function make(tag, attributes = {}, ...children) {
  return fill(document.createElement(tag), attributes, children);
}

/** The same in SVG. */
function draw(tag, attributes = {}, ...children) {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value !== undefined && value !== false && value !== null) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.flat().filter((child) => child !== undefined && child !== null && child !== ""));
  return element;
}

/** A button that does one thing; `key` is shown as its shortcut. */
function button(text, attributes, key) {
  return make("button", { type: "button", ...attributes }, text, key ? make("kbd", { "aria-hidden": "true" }, key) : "");
}

/** A choice of a few, each a button; the one that is chosen is pressed. */
function segments(label, choices, chosen, choose) {
  const one = ([value, text, key, title]) =>
    button(text, { "aria-pressed": String(value === chosen), "data-value": value, title, onclick: () => choose(value) }, key);
  return make("div", { class: "segments", role: "group", "aria-label": label }, choices.map(one));
}

/** A choice of many. */
function choice(label, choices, chosen, choose, attributes = {}) {
  const one = ([value, text]) => make("option", { value, selected: value === chosen }, text);
  return make("label", { class: "field" }, make("span", {}, label),
    make("select", { ...attributes, onchange: (event) => choose(event.target.value) }, choices.map(one)));
}

/** Puts children in place of those that are there, and leaves the focus where it was, if its element has a `data-value` or an id. */
function refill(parent, ...children) {
  const focused = parent.contains(document.activeElement) ? document.activeElement : null;
  const value = focused?.dataset.value;
  const group = focused?.closest("[aria-label]")?.getAttribute("aria-label");
  parent.replaceChildren(...children.flat().filter(Boolean));
  if (!focused || parent.contains(focused)) return;
  const same = (element) => element.closest("[aria-label]")?.getAttribute("aria-label") === group;
  const again = focused.id ? byId(focused.id) : [...parent.querySelectorAll("[data-value]")].find((e) => e.dataset.value === value && same(e));
  again?.focus({ preventScroll: true });
}

/** `1 route`, `2 routes`. */
function count(n, noun) {
  return `${n.toLocaleString("en")} ${noun}${n === 1 ? "" : "s"}`;
}

let statusTimer = 0;

/** Says something in passing, to the eye and to screen readers. */
function say(text) {
  const status = byId("status");
  status.textContent = text;
  status.classList.add("shown");
  clearTimeout(statusTimer);
  statusTimer = setTimeout(() => status.classList.remove("shown"), 3500);
}
