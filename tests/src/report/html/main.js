// Events.

const filter = document.getElementById("filter");
const sort = document.getElementById("sort");
const figure = document.getElementById("figure");
const failures = document.getElementById("failures");
const matrix = document.getElementById("matrix");

filter.addEventListener("input", () => ((view.filter = filter.value), showMatrix()));
sort.addEventListener("change", () => ((view.sort = sort.value), showMatrix()));
figure.addEventListener("change", () => ((view.figure = figure.value), showMatrix()));
failures.addEventListener("change", () => ((view.onlyFailures = failures.checked), showMatrix()));

matrix.addEventListener("click", (event) => open(event.target.closest("tbody [data-hash]")));
matrix.addEventListener("keydown", (event) => {
  const cell = event.target.closest("tbody td, tbody th");
  const steps = {
    ArrowDown: [1, 0], ArrowUp: [-1, 0], ArrowRight: [0, 1], ArrowLeft: [0, -1],
    PageDown: [20, 0], PageUp: [-20, 0], Home: [0, -1e9], End: [0, 1e9],
  };
  if (!cell || event.ctrlKey || event.metaKey || event.altKey) return;
  if (steps[event.key]) move(cell, ...steps[event.key]);
  else if (event.key === "Enter" || event.key === " ") open(cell.dataset.hash ? cell : null);
  else return;
  event.preventDefault();
});

function open(cell) {
  if (!cell) return;
  const old = matrix.querySelector("tbody [tabindex='0']");
  if (old && old !== cell) old.tabIndex = -1;
  cell.tabIndex = 0;
  location.hash = cell.dataset.hash;
}

document.addEventListener("keydown", (event) => {
  const isTyping = event.target.matches("input[type=search], select");
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "Escape" && location.hash) close();
  else if (event.key === "/" && !isTyping) filter.focus();
  else if (event.key === "f" && !isTyping) failures.click();
  else return;
  event.preventDefault();
});

addEventListener("hashchange", showDetail);
addEventListener("popstate", showDetail);

showSummary();
showLegend();
showMatrix();
showDetail();
