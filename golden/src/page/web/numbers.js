// Numbers of a report, in words.

/** JSON has no words for these. */
function number(value) {
  return { inf: Infinity, "-inf": -Infinity, nan: NaN }[value] ?? value;
}

const bitsView = new DataView(new ArrayBuffer(4));

/** The bits of an f32. */
function bits(value) {
  bitsView.setFloat32(0, value);
  return bitsView.getUint32(0);
}

/** `3f800000`. */
function hex(value) {
  return bits(value).toString(16).padStart(8, "0");
}

/** The shortest decimals that are this f32. */
function decimal(value) {
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value < 0 ? "−∞" : "∞";
  if (value === 0) return Object.is(value, -0) ? "−0" : "0";
  let digits = 1;
  while (digits < 9 && Math.fround(Number(value.toPrecision(digits))) !== value) digits++;
  const size = Math.abs(value);
  const text = size < 1e-4 || size >= 1e7 ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
  return text.replace("-", "−").replace("e−", "e-").replace("e+", "e");
}

/** Three digits. */
function brief(value) {
  if (value === null || value === undefined) return "–";
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value < 0 ? "−∞" : "∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e4 || size < 1e-3 ? value.toExponential(1).replace(".0e", "e") : String(Number(value.toPrecision(3)));
  return text.replace("-", "−").replace("e−", "e-").replace("e+", "e");
}

/** The place of an f32 among all, for distances in ULP. */
function place(value) {
  const all = bits(value) | 0;
  return all < 0 ? -(all & 0x7fffffff) : all;
}

/** `12.5 %`. */
function percent(part, whole) {
  if (!whole) return "–";
  const share = (100 * part) / whole;
  if (part === 0 || part === whole) return `${share} %`;
  return `${share < 0.1 ? "< 0.1" : share > 99.9 ? "> 99.9" : share.toFixed(1)} %`;
}
