// Pictures out of texts: `encode.rs` says how they are written.

/** The bytes of a text in base64. */
function bytesOf(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let at = 0; at < bytes.length; at++) bytes[at] = binary.charCodeAt(at);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** A float's bits as its place in the order of all floats, and back. */
function turned(all) {
  return all < 0 ? all ^ 0x7fffffff : all;
}

/** The floats of a packed picture; `base` is that which it was guessed from. */
async function unpacked(packed, channels, base) {
  const planes = await inflated(bytesOf(packed));
  const n = planes.length / 4;
  const places = new Int32Array(n);
  const guesses = base ? new Int32Array(base.buffer, base.byteOffset, base.length) : null;
  for (let at = 0; at < n; at++) {
    const zigzag = planes[at] | (planes[n + at] << 8) | (planes[2 * n + at] << 16) | (planes[3 * n + at] << 24);
    const guess = guesses ? turned(guesses[at]) : at < channels ? 0 : places[at - channels];
    places[at] = guess + ((zigzag >>> 1) ^ -(zigzag & 1));
  }
  for (let at = 0; at < n; at++) places[at] = turned(places[at]);
  return new Float32Array(places.buffer);
}
