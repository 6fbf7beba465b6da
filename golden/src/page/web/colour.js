// Colours of pixels.

const SRGB_STEPS = 1 << 14;
const srgbBytes = new Uint8ClampedArray(SRGB_STEPS + 1).map((_, at) => {
  const linear = at / SRGB_STEPS;
  return Math.round(255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055));
});

/** The byte of a linear value as sRGB has it; what is beyond 0 ..= 1 is clipped. */
function srgb(linear) {
  return srgbBytes[Math.round(SRGB_STEPS * Math.min(Math.max(linear, 0), 1))];
}

const TONES = {
  clip: (x) => x,
  reinhard: (x) => x / (1 + x),
  // K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016.
  aces: (x) => (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14),
};

const TONE_NAMES = [["clip", "sRGB, clipped"], ["reinhard", "Reinhard"], ["aces", "ACES fit"], ["stops", "false colour"]];
/** What no screen shows: NaN and infinities. */
const NOT_A_COLOUR = [255, 0, 220];

/** Colours at equal distances, between which is interpolated. */
function ramp(colours) {
  const steps = 256;
  const parsed = colours.map((text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16)));
  return Array.from({ length: steps + 1 }, (_, step) => {
    const at = (step / steps) * (parsed.length - 1);
    const low = Math.min(Math.floor(at), parsed.length - 2);
    return [0, 1, 2].map((c) => Math.round(parsed[low][c] + (at - low) * (parsed[low + 1][c] - parsed[low][c])));
  });
}

function along(ramp, x) {
  return ramp[Math.round(256 * Math.min(Math.max(x, 0), 1))];
}

// Nothing is black, everything is bright, and lightness grows all the way.
const HEAT = ramp(["#000004", "#1d1147", "#51127c", "#832681", "#b73779", "#e75263", "#fc8961", "#fec488", "#fcfdbf"]);
const WITHIN = ramp(["#14633a", "#4f9440", "#a4bb39", "#f4d734"]);
const BEYOND = ramp(["#e0352b", "#8e1020"]);
const LESS = ramp(["#17191d", "#1f5fc0", "#7ec4ff", "#f2faff"]);
const MORE = ramp(["#17191d", "#c2501a", "#ffb454", "#fff7e8"]);
const HATCH = [[118, 120, 124], [160, 162, 166]];
/** Stops below and above 1 that false colour spans. */
const FALSE_STOPS = 8;

/** Fills a picture with colours of pixels, each given as three bytes. */
function painted([width, height], colourOf) {
  const image = new ImageData(width, height);
  for (let at = 0; at < width * height; at++) {
    const colour = colourOf(at);
    image.data[4 * at] = colour[0];
    image.data[4 * at + 1] = colour[1];
    image.data[4 * at + 2] = colour[2];
    image.data[4 * at + 3] = 255;
  }
  const canvas = make("canvas", { width, height });
  canvas.getContext("2d").putImageData(image, 0, 0);
  return canvas;
}

/** A picture as it is looked at: exposure in stops, tone map, and a channel. */
function shown({ size, values }, { exposure, tone, channel }) {
  const factor = 2 ** exposure;
  const curve = TONES[tone];
  const colour = [0, 0, 0];
  const channels = { r: [0, 0, 0], g: [1, 1, 1], b: [2, 2, 2] }[channel] ?? [0, 1, 2];
  return painted(size, (at) => {
    for (let c = 0; c < 3; c++) {
      const value = values[3 * at + channels[c]];
      if (!Number.isFinite(value)) return NOT_A_COLOUR;
      if (curve) colour[c] = srgb(curve(Math.max(value * factor, 0)));
      else colour[c] = value;
    }
    return curve ? colour : along(HEAT, stopsOf(colour, factor));
  });
}

/** Luminance on a logarithmic scale, 0 ..= 1. */
function stopsOf([r, g, b], factor) {
  const luminance = factor * (0.2126 * r + 0.7152 * g + 0.0722 * b);
  return luminance > 0 ? (Math.log2(luminance) + FALSE_STOPS) / (2 * FALSE_STOPS) : 0;
}

/** Differences by sign: less is blue, more is orange. `scale` is the difference at the ramps' ends. */
function shownDifference(size, all, scale) {
  return painted(size, (at) => {
    const difference = all[at];
    if (Number.isNaN(difference)) return NOT_A_COLOUR;
    const x = difference === 0 ? 0 : Math.abs(difference) / scale;
    return along(difference < 0 ? LESS : MORE, x);
  });
}

/** Shares of what is permitted: green to yellow inside, red beyond, hatched grey where nothing is promised. */
function shownShares(size, judgement) {
  const width = size[0];
  return painted(size, (at) => {
    const share = judgement.shares[at];
    if (judgement.kinds[at] === OUTSIDE) return along(BEYOND, Math.log2(share) / 6);
    if (judgement.kinds[at] === INSIDE) return along(WITHIN, share);
    return HATCH[((at % width) + Math.floor(at / width)) % 4 < 2 ? 0 : 1];
  });
}

/** Numbers in 0 ..= 1. */
function shownHeat({ size, values }) {
  return painted(size, (at) => along(HEAT, values[at]));
}
