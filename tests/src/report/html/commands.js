// Commands that run a row again.

/** A word of a shell's command line. */
function quoted(text) {
  return /^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

/** Commands for the worst row of an answer, each with what it does. */
function commands(kernel, answer, column) {
  if (report.command === "run") {
    return answer.worst?.again ? [["This input", answer.worst.again]] : [];
  }
  const name = quoted(kernel.name);
  const all = [];
  if (answer.worst) {
    const row = quoted(JSON.stringify(answer.worst.args));
    const routes = routesOf(answer, column);
    const only = routes.length === 1 ? ` --route ${quoted(routes[0])}` : "";
    for (const route of routes) {
      all.push([`Result on ${route}`, `echo ${row} | lobe eval ${name} --args - --hex --route ${quoted(route)}`]);
    }
    all.push(["Exact value and derived bound", `echo ${row} | lobe eval ${name} --args - --shadow`]);
    const traced = routes.find((route) => route !== "native");
    if (traced) {
      all.push(["The operation it comes from", `lobe explain ${name} --input ${row} --route ${quoted(traced)}`]);
    }
    for (const [form, ending, what] of EXPORTS) {
      all.push([`Export as ${what}`, `lobe export ${name} --input ${row}${only} --as ${form} -o ${name}.${ending}`]);
    }
  }
  all.push(["Ask this kernel again", checkAgain(kernel, name)]);
  return all;
}

const EXPORTS = [
  ["wgsl", "wgsl", "WGSL with its expected values"],
  ["amber", "amber", "a script for Amber"],
  ["offload", "test", "a test for LLVM's offload test suite"],
];

/** The routes that an answer is about. */
function routesOf(answer, column) {
  // Drivers drawn by chance are no route.
  if (column.route) return report.routes.filter((route) => route === column.route);
  if (answer.question !== "agree") return ["native"];
  const driver = column.label.startsWith("@") ? column.label : null;
  return report.routes.filter((route) => (driver ? route.endsWith(driver) : column.label.split(" = ").includes(route)));
}

function checkAgain(kernel, name) {
  if (report.command !== "check") return `lobe check ${name}`;
  const model = report.model ? ` --model ${report.model}` : "";
  const drawn = kernel.inputs - kernel.listed;
  return `lobe check ${name} --inputs ${drawn} --seed ${report.seed}${model} --worst`;
}
