// How a picture stands against a truth: the same judgement as `Golden::judge`, for the eye. The report's own counts decide.

/** The distance over what is permitted; NaN where nothing is promised. */
function shareOf(truth, permitted, found) {
  if (permitted === Infinity) return NaN;
  const distance = Math.abs(found - truth);
  if (distance === 0) return 0;
  const share = distance / permitted;
  return Number.isNaN(share) ? Infinity : share;
}

const INSIDE = 0;
const OUTSIDE = 1;
const INDETERMINATE = 2;

/** The channels that a choice of channel is about. */
function channelsOf(choice) {
  return { r: [0], g: [1], b: [2] }[choice] ?? [0, 1, 2];
}

/** For each pixel the largest share of its channels, and what it is. */
function judged(truth, permitted, found, channel) {
  const pixels = truth.length / 3;
  const judgement = { shares: new Float64Array(pixels), kinds: new Uint8Array(pixels), counts: [0, 0, 0], equal: 0 };
  const channels = channelsOf(channel);
  for (let at = 0; at < pixels; at++) {
    let most = 0;
    let isBounded = true;
    let isEqual = true;
    for (const c of channels) {
      const value = 3 * at + c;
      const share = shareOf(truth[value], permitted[value], found[value]);
      if (Number.isNaN(share)) isBounded = false;
      else if (share > most) most = share;
      if (!Object.is(truth[value], found[value])) isEqual = false;
    }
    const kind = most > 1 ? OUTSIDE : isBounded ? INSIDE : INDETERMINATE;
    judgement.shares[at] = most;
    judgement.kinds[at] = kind;
    judgement.counts[kind]++;
    if (isEqual) judgement.equal++;
  }
  return judgement;
}

/** Pixels that differ, the worst first: by share; those without a bound last, by difference. */
function worstFirst(judgement, difference) {
  const { shares } = judgement;
  const differs = (at) => shares[at] > 0 || difference[at] !== 0;
  const order = Array.from(shares.keys()).filter(differs);
  const size = (at) => (Number.isNaN(difference[at]) ? Infinity : Math.abs(difference[at]));
  return order.sort((a, b) => compared(shares[b], shares[a]) || compared(size(b), size(a)) || a - b);
}

function compared(a, b) {
  return a === b ? 0 : a - b;
}

/** For each pixel the difference of the channel that differs most, with its sign. */
function differences(truth, found, channel) {
  const pixels = truth.length / 3;
  const all = new Float64Array(pixels);
  const channels = channelsOf(channel);
  for (let at = 0; at < pixels; at++) {
    let most = 0;
    for (const c of channels) {
      const difference = found[3 * at + c] - truth[3 * at + c];
      if (Number.isNaN(difference)) {
        // Two infinities of one sign, or two NaN, do not differ.
        if (!Object.is(found[3 * at + c], truth[3 * at + c])) most = NaN;
      } else if (Math.abs(difference) > Math.abs(most)) most = difference;
    }
    all[at] = most;
  }
  return all;
}

/** The largest of them that is a number. */
function furthest(all) {
  let most = 0;
  for (const value of all) if (Number.isFinite(value) && Math.abs(value) > most) most = Math.abs(value);
  return most;
}

const BIN_ENDS = [0, 1 / 64, 1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2, 1];

/** Pixels by share: none of it, up to each end, and beyond. */
function binned(judgement) {
  const bins = new Array(BIN_ENDS.length + 1).fill(0);
  judgement.shares.forEach((share, at) => {
    if (judgement.kinds[at] === INDETERMINATE) return;
    const bin = BIN_ENDS.findIndex((end) => share <= end);
    bins[bin < 0 ? BIN_ENDS.length : bin]++;
  });
  return bins;
}
